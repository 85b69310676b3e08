// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/analyses.hpp"
#include "analysis/standards/section.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// What the histories do that need shaking.
std::string fit_sentence(const Results& results, const FitSummary& fit,
                         const std::string& clearance) {
  const std::string others = fit.curve.floor > 0 ? " by the others" : "";
  if (fit.converged()) {
    const double p50 = fit.curve.intensity_at(0.5);
    if (p50 == 0)
      return fmt::format(
          "A clearance of {} has a chance of 50 % or more of being exceeded at any intensity.",
          clearance);
    return fmt::format(
        "A clearance of {} has a 50 % chance of being exceeded at {}{}{}.", clearance,
        at_intensity(results, p50),
        std::isnan(fit.p50_interval.low)
            ? ""
            : fmt::format(" (95 % interval {})",
                          with_unit(results, format_interval(fit.p50_interval))),
        p50 > results.levels.back() ? ", which extrapolates beyond the highest level studied" : "");
  }
  if (fit.status == FitStatus::upper_bound) {
    return fmt::format(
        "A clearance of {} was exceeded by every history at every level; its median is below {} "
        "(95 % confidence).",
        clearance, at_intensity(results, fit.curve.median));
  }
  if (fit.status == FitStatus::lower_bound) {
    return fmt::format(
        "A clearance of {} was never exceeded{}; {} median is above {} (95 % confidence).",
        clearance, others, others.empty() ? "its" : "their",
        at_intensity(results, fit.curve.median));
  }
  if (fit.status == FitStatus::one_capacity) {
    return fmt::format(
        "A clearance of {} is exceeded from {} on{}: one capacity, of which no log standard "
        "deviation can be determined.",
        clearance, at_intensity(results, fit.curve.median), others);
  }
  return fmt::format("For a clearance of {} no fragility could be fitted{}.", clearance,
                     fit.note.empty() ? "" : " (" + fit.note + ")");
}

std::string threshold_sentence(const Results& results, const ThresholdFragility& fragility) {
  const FitSummary& fit = preferred_fit(fragility);
  const std::string clearance = format_length(fragility.threshold_m);
  if (fit.status == FitStatus::always_exceeds) {
    return fmt::format(
        "Every history slides freely and exceeds a clearance of {} at any intensity, even without "
        "shaking.",
        clearance);
  }
  const std::string free = fit.curve.floor > 0 ? fmt::format(
                                                     " {} of the histories slide freely: they "
                                                     "exceed it at any intensity and are counted.",
                                                     format_share(fit.curve.floor))
                                               : "";
  return fit_sentence(results, fit, clearance) + free;
}

/// The slip statistics at the level nearest to the DBE, or where it is not known to 1 g.
const SlipStatistics* shown_slip(const Results& results, const RunResults& run) {
  const double level = results.model.dbe_level > 0.0 ? results.model.dbe_level : 1.0;
  const auto nearest = std::ranges::min_element(
      run.slip, {}, [&](const SlipStatistics& slip) { return std::abs(slip.level - level); });
  return nearest == run.slip.end() ? nullptr : &*nearest;
}

std::string slip_sentence(const Results& results, const SlipStatistics& slip) {
  // Infinite: beyond the largest clearance, and not run.
  const auto length = [&](double slip_m) {
    return std::isinf(slip_m) ? "more than " + format_length(results.thresholds_m.back())
                              : format_length(slip_m);
  };
  const std::string mean =
      std::isinf(slip.mean_m) ? "" : ", and " + format_length(slip.mean_m) + " on average";
  return fmt::format(
      "At {} the slip is {} in the median, {} at the 84th and {} at the 95th percentile{}.",
      at_intensity(results, slip.level), length(slip.median_m), length(slip.p84_m),
      length(slip.p95_m), mean);
}

/// The run, of the friction value of the first, whose histories exceed a prescribed displacement
/// most often; of several the one that slips farther. @param row of RunResults::standards
const RunResults& most_exceeding(const Results& results, std::size_t row) {
  return results.runs[run_of_largest(results, [&](std::size_t i) {
    const RunResults& run = results.runs[i];
    if (row >= run.standards.size()) return std::pair(-1.0, 0.0);  // a file may lack them
    const StandardComparison& comparison = run.standards[row];
    const SlipStatistics* slip = slip_at(run, comparison.sds_g);
    return std::pair(comparison.exceedance_probability, slip != nullptr ? slip->p95_m : 0.0);
  })];
}

std::string standard_sentence(const Results& results, std::size_t row) {
  const RunResults& run = most_exceeding(results, row);
  const StandardComparison& comparison = run.standards[row];
  const std::string combination =
      lists_more_than_friction_value(results)
          ? fmt::format(", in the combination where most do ({})", run_name(results, run))
          : "";
  return fmt::format("{} prescribes {} at {}{}; {} of the histories slip more{}{}.",
                     standard_name(comparison.standard),
                     format_length(comparison.prescribed.value_m),
                     at_intensity(results, comparison.sds_g),
                     recalled_in_brackets(comparison.prescribed.provenance),
                     format_share(comparison.exceedance_probability),
                     in_brackets(comparison.exceedance_interval), combination);
}

std::string other_run_sentence(const Results& results, const RunResults& run) {
  std::string medians;
  for (const ThresholdFragility& fragility : run.fragilities) {
    const FitSummary& fit = preferred_fit(fragility);
    if (!fit.converged()) continue;
    medians += fmt::format("{}{} for {}", medians.empty() ? "" : ", ",
                           with_unit(results, format_number(fit.curve.intensity_at(0.5))),
                           format_length(fragility.threshold_m));
  }
  if (medians.empty()) return "";
  return fmt::format("The 50 % intensities with friction {} are {}.",
                     friction_and_listed(results, run), medians);
}

/// The standards table at a handful of levels, narrow enough for a terminal: the rest is in
/// standards.csv.
std::string brief_standards(const Results& results) {
  std::string recalled;
  using S = SlipStatistics;
  TableOf<StandardComparison, S> t(
      "standards_brief", fmt::format("Standards and computed slip ({}; displacements in plan)",
                                     lists_more_than_friction_value(results)
                                         ? "each row of the combination that exceeds it most often"
                                         : friction_of(results, results.runs.front())));
  t.put_all(standard_column, sds_column, prescribed_column);
  t.length("median_slip", "Median", "", &S::median_m);
  t.length("p95_slip", "95th", "", &S::p95_m);
  t.share("exceedance_share", "Slip > prescribed", "", &StandardComparison::exceedance_probability);
  const std::vector<double> chosen = some_levels(results.levels, 5);
  for (std::size_t row = 0; row < results.runs.front().standards.size(); ++row) {
    const RunResults& run = most_exceeding(results, row);
    const StandardComparison& comparison = run.standards[row];
    const S* slip = slip_at(run, comparison.sds_g);
    if (slip == nullptr || std::ranges::count(chosen, comparison.sds_g) == 0) continue;
    t.add(comparison, *slip);
    if (comparison.prescribed.provenance != Provenance::checked)
      recalled += fmt::format("{}{} at {:g} g", recalled.empty() ? "" : "; ",
                              standard_name(comparison.standard), comparison.sds_g);
  }
  std::string text = to_text(t);
  if (!recalled.empty())
    text +=
        wrapped("Recalled, to be verified against the standard: " + recalled, terminal_width, 2) +
        "\n";
  return text;
}

/// The rows whose fit is not an ordinary one.
std::string fit_remarks(const Table& fits) {
  const auto column = [&](const char* stem) {
    return static_cast<std::size_t>(std::ranges::find(fits.columns, stem, &Column::stem) -
                                    fits.columns.begin());
  };
  const std::size_t threshold = column("threshold"), status = column("status");
  std::string text;
  for (const std::vector<Cell>& row : fits.rows) {
    const std::string fit = cell_text(fits.columns[status], row[status]);
    if (fit == to_string(FitStatus::maximum_likelihood)) continue;
    std::string label;
    for (std::size_t c = 0; c < threshold; ++c) label += cell_text(fits.columns[c], row[c]) + ", ";
    label += format_length(std::get<double>(row[threshold]));
    text += wrapped("  Fit of " + label + ": " + fit, terminal_width, 4) + "\n";
  }
  return text;
}

std::string fragility_summary(const Results& results) {
  constexpr std::size_t most = 24;
  const Table fits = fragility_summary_table(results).first_rows(most, "fragility"),
              at = without_run_key(results, earthquakes_table(results))
                       .first_rows(most, "earthquakes");
  std::string text = to_text(fits) + fit_remarks(fits);
  if (!at.rows.empty()) text += "\n" + to_text(at);
  if (!results.runs.empty() && !results.runs.front().standards.empty()) {
    text += "\n" + brief_standards(results);
  }
  return text;
}

std::vector<std::string> sentences(const Results& results) {
  std::vector<std::string> sentences;
  const std::size_t shown = governing_run(results);
  const RunResults& run = results.runs[shown];
  if (lists_more_than_friction_value(results))
    sentences.push_back("Of " + governing_text(results) + ":");
  for (const ThresholdFragility& fragility : run.fragilities)
    sentences.push_back(threshold_sentence(results, fragility));
  if (const SlipStatistics* slip = shown_slip(results, run)) {
    sentences.push_back(slip_sentence(results, *slip));
    for (std::size_t row = 0; row < run.standards.size(); ++row)
      if (run.standards[row].sds_g == slip->level)
        sentences.push_back(standard_sentence(results, row));
  }
  if (results.runs.size() < results.cases.combinations())
    sentences.push_back(
        "An array that is anchored does not slide: fragility is of the isolated array.");
  for (std::size_t r = 0; r < results.runs.size(); ++r)
    if (r != shown) sentences.push_back(other_run_sentence(results, results.runs[r]));
  std::erase(sentences, "");
  return sentences;
}

std::vector<Figure> figures(const Results& results) {
  std::vector<Figure> figures;
  constexpr std::size_t most = 8;  // the tables have all
  for (std::size_t i = 0; i < std::min(results.runs.size(), most); ++i)
    figures.push_back(fragility_figure(results, results.runs[i]));
  const RunResults& run = results.runs.front();
  if (results.measure == IntensityMeasure::sds_g)
    figures.push_back(slip_vs_sds_figure(results, run));
  if (!results.by_stripes) figures.push_back(ida_figure(results, run));
  return figures;
}

std::vector<Table> tables(const Results& results) {
  std::vector<Table> tables = {fragility_table(results)};
  if (!results.by_stripes) tables.push_back(goodness_of_fit_table(results));
  tables.push_back(fragility_band_table(results, results.runs));
  if (!results.by_stripes) tables.push_back(recrossing_table(results));
  for (Table& table : std::array{combinations_table(results), earthquakes_table(results),
                                 slip_table(results), standards_table(results),
                                 stripes_table(results, results.runs), samples_table(results)})
    tables.push_back(std::move(table));
  return tables;
}

Html section(const Results& results) {
  const Table at = without_run_key(results, earthquakes_table(results));
  Table fits = fragility_table(results);
  for (const char* stem : {"interval_method", "fit_method", "log_likelihood"})
    fits = fits.without(stem);
  return heading("Fragility") + wide_table(fragility_summary_table(results)) +
         (at.rows.empty() ? Html() : wide_table(at)) +
         standards_html(results, without_run_key(results, standards_table(results))) +
         heading("Slip by level") + wide_table(without_run_key(results, slip_table(results))) +
         heading("Fits in full") + wide_table(without_run_key(results, fits));
}

}  // namespace

AnalysisReport FragilityAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return !results.runs.empty(); },
          .summary = fragility_summary,
          .sentences = sentences,
          .figures = figures,
          .tables = tables,
          .section = section};
}

}  // namespace glissade
