// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "convergence/text.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/convergence_report.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/html.hpp"
#include "page.hpp"

namespace glissade {
namespace {

std::string what_was_run(const ConvergenceResults& r) {
  const std::size_t cases = r.exact.size();
  const std::size_t rests = count_at_rest(r);
  const std::size_t counted = error_summary(r, 0, ErrorMeasure::finest).counted;
  std::string text = fmt::format(
      "{} scenes on {} records of {}, each at {} values of P from {} to {}: {} histories. In {} of "
      "the {} cases nothing slides: they have no relative error and are left out.",
      r.scenes.size(), r.records.size(), r.suite_name, r.substeps.size(), r.substeps.front(),
      r.substeps.back(), r.residual_m.data.size(), rests, cases);
  if (counted + rests < cases) {
    text += fmt::format(" {} more have no residual at P = {} to compare with.",
                        cases - rests - counted, r.substeps.back());
  }
  return text;
}

/// What the paper states is of P = 64 against P = 256.
bool is_the_papers(const ConvergenceResults& r, std::size_t step) {
  return r.substeps[step] == published::substeps && r.substeps.back() == published::finest;
}

std::string error_by_the_papers_measure(const ConvergenceResults& r, std::size_t step) {
  const ErrorSummary error = error_summary(r, step, ErrorMeasure::finest);
  const ExactSlip& slip = r.exact_at(error.worst.record, error.worst.scene);
  std::string text =
      fmt::format("Largest error at P = {} against P = {}: {} (median {}).", r.substeps[step],
                  r.substeps.back(), percent(error.largest), percent(error.median));
  if (is_the_papers(r, step)) {
    text += fmt::format(
        " The paper states {} at P = {}, on one record, Tokachi-Oki 2003, which is not available "
        "here. {} of the cases are within that.",
        stated_percent(published::largest_error), published::substeps,
        format_share(share_within(r, step, ErrorMeasure::finest, published::largest_error)));
  }
  text += fmt::format(
      " Where the residual is {} of the peak displacement or more, the largest is {}. Worst of all "
      "is {}: its residual is {} m where the peak is {} m.",
      stated_percent(clear_residual), percent(clear_error(r, step).largest),
      scene_text(r, error.worst), format_number(slip.residual_m), format_number(slip.peak_m));
  if (std::abs(slip.residual_m) < clear_residual * slip.peak_m)
    text += " Relative to a residual so near to zero an error says little.";
  return text;
}

std::string error_against_exact(const ConvergenceResults& r, std::size_t step) {
  const std::size_t finest = r.substeps.size() - 1;
  const ErrorSummary residual = error_summary(r, step, ErrorMeasure::exact_residual),
                     peak = error_summary(r, step, ErrorMeasure::exact_peak);
  return fmt::format(
      "Against the exact solution it is {} of the residual (median {}) and {} of the peak "
      "displacement (median {}). P = {}, the truth by that convention, is itself off by up to {} "
      "of the residual and {} of the peak.",
      percent(residual.largest), percent(residual.median), percent(peak.largest),
      percent(peak.median), r.substeps.back(),
      percent(error_summary(r, finest, ErrorMeasure::exact_residual).largest),
      percent(error_summary(r, finest, ErrorMeasure::exact_peak).largest));
}

std::string error_by_record(const ConvergenceResults& r, std::size_t step) {
  std::vector<double> largest;
  for (std::size_t i = 0; i < r.records.size(); ++i) {
    const ErrorSummary error = error_summary(r, step, ErrorMeasure::finest, {i, i + 1});
    if (error.counted > 0) largest.push_back(error.largest);
  }
  const auto below = std::count_if(largest.begin(), largest.end(),
                                   [](double e) { return e <= published::largest_error; });
  const auto [low, high] = std::minmax_element(largest.begin(), largest.end());
  return fmt::format("The record decides: its largest error at P = {} is from {} to {}{}.",
                     r.substeps[step], percent(*low), percent(*high),
                     is_the_papers(r, step) ? fmt::format(", and {} or less on {} of {} records",
                                                          stated_percent(published::largest_error),
                                                          below, largest.size())
                                            : "");
}

std::string times_taken(const ConvergenceResults& r, std::size_t step,
                        const ConvergenceTimes& times) {
  const TimeSummary& scheme = times.published[step];
  return fmt::format(
      "Longest time of a history at P = {}: {} (median {}){}. The exact solution takes {} at most "
      "(median {}) event by event, and {} (median {}) over tables that take {} a record at most to "
      "make.",
      r.substeps[step], duration(scheme.longest_s), duration(scheme.median_s),
      r.substeps[step] == published::substeps
          ? fmt::format("; the paper states less than {} s", published::longest_s)
          : "",
      duration(times.exact.longest_s), duration(times.exact.median_s),
      duration(times.kernel.longest_s), duration(times.kernel.median_s),
      duration(times.table.longest_s));
}

std::vector<std::string> how_it_was_done(const ConvergenceResults& r) {
  return {
      fmt::format("The roof is rigid and moves horizontally only, by the {} component of each "
                  "record, scaled to the scene's peak acceleration.",
                  r.component == HorizontalComponent::first ? "first" : "second"),
      "Displacements are in plan.",
      "The paper's runs end with the record. Here both the scheme and the exact solution go on "
      "until the block has stopped, by one rule: after the last sample the roof's acceleration "
      "goes "
      "to zero over one interval. A block that friction cannot stop ends with the record.",
      "An error relative to the residual is large where the block comes back near to where it "
      "began, however small it is in metres. Relative to the peak displacement it says how far off "
      "the scheme is.",
      "Histories are timed by the wall clock, those of a few milliseconds three times, the "
      "shortest "
      "told: the longest time of the others is also what the machine did besides. Times are in "
      "run.json and not in results.h5."};
}

std::string uplift_warning(const ConvergenceResults& r) {
  const auto uplift = std::count_if(r.exact.begin(), r.exact.end(),
                                    [](const ExactSlip& slip) { return slip.uplift != 0; });
  if (uplift == 0) return {};
  return fmt::format(
      "In {} of {} cases the array lifts off, which is outside the model: the paper's scheme would "
      "stop there.",
      uplift, r.exact.size());
}

std::string html_page(const ConvergenceResults& results, const std::vector<std::string>& sentences,
                      const std::vector<Table>& tables, const DrawnFigure& drawn) {
  Html html = page_head({results.study_name, "convergence"});
  if (!results.study_description.empty()) html += paragraph(results.study_description);
  html += "<div class=\"answer\">\n";
  for (const std::string& sentence : sentences) html += paragraph(sentence);
  html += "</div>\n" + figure_html(drawn, 1);
  for (const Table& table : tables) html += wide_table(table);
  html += heading("How it was done") + list(how_it_was_done(results));
  html += heading("The study") + study_file(results.study_text);
  html += paragraph(fmt::format("glissade {}, plan {}; suite {}: {}.", results.program_version,
                                results.plan_hash, results.suite_name, results.suite_description));
  return (html + page_foot()).str();
}

}  // namespace

std::vector<std::string> convergence_sentences(const ConvergenceResults& results,
                                               const MaybeTimes& times) {
  const std::size_t step = chosen_step(results.substeps);
  std::vector<std::string> sentences{what_was_run(results)};
  if (error_summary(results, step, ErrorMeasure::finest).counted > 0) {
    sentences.push_back(error_by_the_papers_measure(results, step));
    sentences.push_back(error_against_exact(results, step));
    if (results.records.size() > 1) sentences.push_back(error_by_record(results, step));
  }
  if (times) sentences.push_back(times_taken(results, step, *times));
  const std::string warning = uplift_warning(results);
  if (!warning.empty()) sentences.push_back(warning);
  return sentences;
}

std::string convergence_summary(const ConvergenceResults& results, const MaybeTimes& times) {
  std::string text = results.study_name + "\n\n";
  for (const std::string& sentence : convergence_sentences(results, times))
    text += wrapped(sentence);
  Table table = convergence_table(results, times);
  for (const char* stem : {"worst_of_finest", "worst_of_exact_residual", "worst_of_exact_peak",
                           "median_error_of_finest", "median_error_of_exact_residual",
                           "median_error_of_exact_peak", "counted", "median_time"})
    table = table.without(stem);
  return text + "\n" + to_text(table);
}

void write_convergence_report(const ConvergenceResults& results, const MaybeTimes& times,
                              const std::filesystem::path& out_dir) {
  const std::vector<Table> shown{convergence_table(results, times),
                                 convergence_records_table(results)};
  std::vector<Table> all = shown;
  all.push_back(convergence_scenes_table(results));
  for (const Table& table : all)
    write_text_file(out_dir / "tables" / (table.name + ".csv"), to_csv(table));
  Figure figure = convergence_figure(results, times);
  render_figure(figure, out_dir / "figures");
  std::string svg = read_text_file(out_dir / "figures" / (figure.name + ".svg"));
  write_text_file(out_dir / "report.html", html_page(results, convergence_sentences(results, times),
                                                     shown, {std::move(figure), std::move(svg)}));
}

}  // namespace glissade
