// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/sampling_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/shape/threshold_data.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

constexpr double width_of_95_percent = 3.92;  // standard errors

/// ln median of the fit on some cases; NaN: no fit.
double log_median(const HistoryTable& histories, const std::vector<std::size_t>& cases,
                  std::size_t threshold, double highest_level) {
  const FitSummary fit =
      fit_brackets(capacities_of(histories, cases, threshold, highest_level), Independent::rows);
  return fit.converged() ? std::log(fit.curve.median) : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

void BlockMedians::add(const CaseGrid& cases, const std::function<Case(std::size_t)>& case_of,
                       const HistoryTable& histories, double highest_level, SampleBlocks blocks) {
  std::size_t row = 0;
  for (std::size_t combination = 0; combination < cases.combinations(); ++combination) {
    const std::size_t first = cases.index(combination, 0, 0);
    if (case_of(first).support != ArraySupport::isolated) continue;
    std::vector<std::size_t> of_block;
    for (std::size_t i = first; i < first + cases.per_combination(); ++i)
      if (cases.block(i, blocks) == blocks_) of_block.push_back(i);
    for (std::size_t t = 0; t < histories.thresholds; ++t, ++row) {
      if (row == by_row_.size()) by_row_.emplace_back();
      by_row_[row].push_back(log_median(histories, of_block, t, highest_level));
    }
  }
  ++blocks_;
}

double BlockMedians::standard_error(std::size_t row) const {
  const std::vector<double>& medians = by_row_[row];
  const double count = static_cast<double>(medians.size()),
               mean = std::accumulate(medians.begin(), medians.end(), 0.0) / count;
  double spread = 0.0;
  for (const double m : medians) spread += (m - mean) * (m - mean);
  return std::sqrt(spread / (count * (count - 1.0)));
}

double half_width(double standard_error, std::uint64_t blocks) {
  if (std::isnan(standard_error)) return std::numeric_limits<double>::infinity();
  return student_quantile(static_cast<double>(blocks) - 1.0, 0.975) * standard_error;
}

std::vector<SamplingErrorRow> SamplingErrorAnalysis::find(const StudyConfig& config,
                                                          const Results& results) {
  std::vector<SamplingErrorRow> rows;
  const std::uint64_t blocks = config.sampling.scrambles;
  if (blocks < 2 || !config.draws() || results.runs.empty()) return rows;
  BlockMedians medians;
  while (medians.blocks() < blocks)
    medians.add(
        results.cases, [&](std::size_t i) { return results.cases.cases[i]; }, results.histories,
        results.levels.back(), config.sampling.blocks());
  for (const RunResults& run : results.runs) {
    for (const ThresholdFragility& fragility : run.fragilities) {
      const FitSummary& fit = fragility.capacities;
      rows.push_back(
          {run.label, fragility.threshold_m,
           fit.converged() ? fit.curve.median : std::numeric_limits<double>::quiet_NaN(),
           std::log(fit.median_interval.high / fit.median_interval.low) / width_of_95_percent,
           medians.standard_error(rows.size())});
    }
  }
  return rows;
}

ReachedTarget reached_target(const StudyConfig& study, const std::vector<SamplingErrorRow>& rows) {
  const SamplingConfig& sampling = study.sampling;
  ReachedTarget reached{sampling.target->error, 0.0, sampling.scrambles,
                        sampling.target->most_scrambles};
  for (const SamplingErrorRow& row : rows)
    reached.error = std::max(reached.error, half_width(row.sampling_error, sampling.scrambles));
  return reached;
}

/// The samples that the target would take: plain Monte Carlo, on the safe side. Or an error of the
/// samples that the intervals, which are over records, leave out.
std::vector<std::string> SamplingErrorAnalysis::warnings(const Results& results,
                                                         const StudyConfig& study) {
  constexpr std::size_t few = 8;
  constexpr double small = 0.5;  // beside the error of the records: adds 12 % to an interval
  if (study.fragility && study.draws() && results.cases.samples < few)
    return {fmt::format(
        "{} sample(s) of the quantities that are drawn: the intervals are over records, and the "
        "error of so few samples, which is not known, is not in them. Give sampling.samples = 64 "
        "or more",
        results.cases.samples)};
  const auto large = std::ranges::find_if(results.sampling_errors, [](const SamplingErrorRow& row) {
    return row.sampling_error > small * row.record_error;
  });
  if (large != results.sampling_errors.end() && !results.reached_target)
    return {fmt::format(
        "the standard error of a median is {:.2g} % from the samples, {:.2g} % from the records: "
        "the intervals are over records, and leave the former out. Give more samples",
        100.0 * large->sampling_error, 100.0 * large->record_error)};
  if (!results.reached_target || results.reached_target->is_reached()) return {};
  const ReachedTarget& target = *results.reached_target;
  const std::string reached =
      std::isinf(target.error)
          ? "some scrambles have no fit: give higher levels, or more samples"
          : fmt::format("the error of the samples is {:.2g}; some {:.0f} samples would be required",
                        target.error,
                        static_cast<double>(results.cases.samples) *
                            std::pow(target.error / target.target_error, 2));
  return {fmt::format("sampling.target_error = {:g} is not reached after all {} scrambles: {}",
                      target.target_error, target.scrambles, reached)};
}

}  // namespace glissade
