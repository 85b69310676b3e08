// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/analyses.hpp"
#include "analysis/hazard/hazard.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/report/format.hpp"
#include "page/page.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// From this share of a rate on a reader must know of it.
constexpr double notable_share = 0.1;

std::string share_range(const Estimate& share) {
  return format_share(share.value) + in_brackets(share.interval);
}

std::string threshold_sentence(const HazardResults& hazard, const ThresholdRate& row) {
  const std::string clearance = format_length(row.threshold_m);
  if (std::isinf(row.annual_rate.value))
    return "Some histories slide freely: " + clearance +
           " is exceeded without any earthquake, and has no annual rate.";
  const bool bound = row.is_mostly_assumed();
  std::string text = fmt::format(
      "{} is exceeded {} once in {} years (annual rate {}): in {} with a probability of {}{}.",
      clearance, bound ? "less than" : "about", format_number(1.0 / row.annual_rate.value),
      format_rate(row.annual_rate.value), life_text(hazard), bound ? "less than " : "",
      share_range(row.life_probability));
  if (row.beyond_share > notable_share)
    text += fmt::format(
        " {} of that rate is from histories that do not reach it at the highest level: any "
        "stronger shaking counts as if they did, and higher levels would show less.",
        format_share(row.beyond_share));
  return text;
}

/// @param target of HazardRun::targets
std::string target_sentence(const Results& results, std::size_t target) {
  const std::size_t at = run_of_largest(results, [&](std::size_t run) {
    return results.hazard->runs[run].targets[target].displacement_m.value;
  });
  const HazardRun& run = results.hazard->runs[at];
  const TargetDisplacement& row = run.targets[target];
  const auto& [displacement_m, interval] = row.displacement_m;
  const std::string of_run = lists_more_than_friction_value(results)
                                 ? " (largest: " + run_name(results, results.runs[at]) + ")"
                                 : "";
  const std::string rate = rate_text(row.annual_rate) + of_run;
  if (std::isnan(displacement_m))
    return fmt::format(
        "The displacement of {} is not known: {} has that rate, and the array slides at the lowest "
        "level already; begin the levels lower.",
        rate, at_intensity(results, row.intensity));
  if (std::isinf(displacement_m))
    return fmt::format(
        "The displacement of {} is beyond the levels: {} has that rate; give levels well above it.",
        rate, at_intensity(results, row.intensity));
  if (displacement_m == run.curve.front().displacement_m)
    return fmt::format("The displacement of {} is {} or less.", rate,
                       format_length(displacement_m));
  if (row.below_share > 0.0)
    return fmt::format(
        "The displacement of {} is {} or more: in {} of the histories the array slides farther at "
        "the lowest level already; begin the levels lower.",
        rate, format_length(displacement_m), format_share(row.below_share));
  return fmt::format("The displacement of {} is {} (95 % interval {}).", rate,
                     format_length(displacement_m), format_length_interval(interval));
}

/// @param standard of HazardRun::prescribed; of the run that exceeds it most often
std::string prescribed_sentence(const Results& results, std::size_t standard) {
  const std::vector<HazardRun>& runs = results.hazard->runs;
  const std::size_t most = run_of_largest(
      results, [&](std::size_t run) { return runs[run].prescribed[standard].annual_rate.value; });
  const PrescribedRate& row = runs[most].prescribed[standard];
  const TargetDisplacement target = target_displacement(rate_of(0.01, 50.0), runs[most]);
  const double target_m = target.displacement_m.value;
  return fmt::format(
      "{} prescribes {}{} at the S_DS of the site, {:g} g: it is exceeded with a probability of "
      "{}{} "
      "in 50 years{}; {}{} is exceeded with 1 % in 50 years.",
      standard_name(row.standard), format_length(row.prescribed.value_m),
      recalled_in_brackets(row.prescribed.provenance), row.sds_g,
      row.below_share > 0.0 ? "at least " : "",
      share_range({probability_in(50.0, row.annual_rate.value),
                   {probability_in(50.0, row.annual_rate.interval.low),
                    probability_in(50.0, row.annual_rate.interval.high)}}),
      lists_more_than_friction_value(results)
          ? " (most often: " + run_name(results, results.runs[most]) + ")"
          : "",
      target.below_share > 0.0 && std::isfinite(target_m) ? "at least " : "",
      std::isnan(target_m)   ? "an unknown displacement (the levels begin too high)"
      : std::isinf(target_m) ? "more than the levels reach"
                             : format_length(target_m));
}

/// @param at_least it is a lower bound
std::string length_or_none(const Estimate& length_m, bool at_least) {
  return std::isinf(length_m.value) ? "without bound"
                                    : (at_least ? "at least " : "") + format_length(length_m.value);
}

std::vector<std::string> life_sentences(const Results& results, const HazardRun& run) {
  const HazardResults& hazard = *results.hazard;
  const LifeDisplacement &single = run.life.at(0), &sum = run.life.at(1), &far = run.life.at(2);
  const DisplacementRate& least = run.curve.front();
  const auto text_of = [&](const Estimate& length_m) {
    return length_or_none(length_m, run.moving_share > 0.0);
  };
  std::vector<std::string> all = {fmt::format(
      "In {} the array slides more than {} in one earthquake or more with a probability of {}{}.",
      life_text(hazard), format_length(least.displacement_m),
      least.below_share > 0.0 ? "at least " : "",
      format_share(probability_in(hazard.design_life_years, least.annual_rate.value)))};
  all.push_back(far.p95_m.value == 0.0 && run.moving_share == 0.0
                    ? "The 95th percentile of the slip over " + life_text(hazard) + " is none."
                    : fmt::format("Slip over {}, {}: median {}, 95th percentile {} at the end; the "
                                  "largest peak of one earthquake: {} and {}; the largest distance "
                                  "from the initial position at any time: {} and {}.",
                                  life_text(hazard), not_returned, text_of(sum.median_m),
                                  text_of(sum.p95_m), text_of(single.median_m),
                                  text_of(single.p95_m), text_of(far.median_m),
                                  text_of(far.p95_m)));
  if (!hazard.residual_vectors)
    all.push_back(
        "These results have no residual displacements (those of one axis "
        "have none): every peak counts as slip down the slope, which is more than adds up.");
  const double beyond = probability_in(hazard.design_life_years, hazard.beyond_rate);
  if (beyond > 0.01)
    all.push_back(fmt::format(
        "In {} of design lives of {} shaking is above the highest level at least once; slip is "
        "then counted as without bound.",
        format_share(beyond), life_text(hazard)));
  if (run.moving_share > 0.0)
    all.push_back(fmt::format(
        "In {} of the histories the array slides at the lowest level, {}, already. Slip in "
        "earthquakes below it is NOT in the accumulated slip: begin the levels lower.",
        format_share(run.moving_share), at_intensity(results, run.from_intensity)));
  return all;
}

std::string summary(const Results& results) {
  Table rates = without_run_key(results, hazard_table(results)).first_rows(12, "hazard");
  const auto rate = std::ranges::find(rates.columns, "annual_rate", &Column::stem);
  rate->heading = "Annual rate";  // the interval of the return period says as much
  rate->with_interval = false;
  for (std::vector<Cell>& row : rates.rows) {
    Cell& cell = row[static_cast<std::size_t>(rate - rates.columns.begin())];
    std::get<NumberCell>(cell).interval = {};
  }
  std::string text = to_text(rates) + "\n";
  const std::size_t shown = governing_run(results);
  const HazardRun& run = results.hazard->runs[shown];
  for (std::size_t i = 0; i < run.targets.size(); ++i) text += wrapped(target_sentence(results, i));
  for (std::size_t i = 0; i < run.prescribed.size(); ++i)
    text += wrapped(prescribed_sentence(results, i));
  if (results.runs.size() > 1) text += wrapped("Of " + governing_text(results) + ":");
  return text + paragraphs(life_sentences(results, run));
}

Html section(const Results& results) {
  const HazardResults& hazard = *results.hazard;
  const Table standards = hazard_standards_table(results);
  return heading("Annual rates") +
         paragraph(
             "The annual rate is the mean of the hazard curve over the capacities of the "
             "histories: what the share that has reached the clearance gives when integrated over "
             "the hazard, without a fit. The curve is a power law between its points, and goes on "
             "beyond either end as in the last interval.") +
         wide_table(without_run_key(results, hazard_table(results))) +
         wide_table(without_run_key(results, hazard_targets_table(results))) +
         (standards.rows.empty() ? Html() : wide_table(without_run_key(results, standards))) +
         heading("Slip over " + life_text(hazard)) +
         paragraph(
             "Earthquakes are a Poisson process with the rates of the hazard curve. Residual "
             "displacements add up as vectors: what slides down the slope adds up, while slip of "
             "different records across it partly cancels. A record that comes twice in a life "
             "moves the array the same way both times. The array is not damaged, and is not "
             "returned to its initial position.") +
         wide_table(without_run_key(results, shown_design_life_table(results))) +
         paragraph("The rate of every displacement: tables/hazard_curve.csv.");
}

}  // namespace

std::vector<std::string> hazard_sentences(const Results& results) {
  const std::size_t shown = governing_run(results);
  const HazardRun& run = results.hazard->runs[shown];
  const std::string at = lists_more_than_friction_value(results)
                             ? "At " + run_name(results, results.runs[shown]) + ": "
                             : "";
  std::vector<std::string> all;
  for (const ThresholdRate& row : run.thresholds)
    all.push_back(at + threshold_sentence(*results.hazard, row));
  if (!at.empty())
    all.front() = "Combination with the highest annual rates overall. " + all.front();
  for (std::size_t i = 0; i < run.targets.size(); ++i) all.push_back(target_sentence(results, i));
  for (std::size_t i = 0; i < run.prescribed.size(); ++i)
    all.push_back(prescribed_sentence(results, i));
  for (const std::string& sentence : life_sentences(results, run)) all.push_back(at + sentence);
  return all;
}

AnalysisReport HazardAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return results.hazard.has_value(); },
          .summary = summary,
          .sentences = hazard_sentences,
          .figures = each<hazard_figure, life_figure>,
          .tables = each<[](const Results& r) { return hazard_table(r); }, hazard_targets_table,
                         design_life_table, life_distribution_table, hazard_curve_table,
                         hazard_standards_table, hazard_ground_table>,
          .section = section};
}

}  // namespace glissade
