// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/convergence_error.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace glissade {
namespace {

constexpr double nan_value = std::numeric_limits<double>::quiet_NaN();

double median(std::vector<double> values) {
  if (values.empty()) return nan_value;
  std::sort(values.begin(), values.end());
  const std::size_t upper = values.size() / 2;
  return values.size() % 2 == 1 ? values[upper] : 0.5 * (values[upper - 1] + values[upper]);
}

TimeSummary summary_of(const std::vector<double>& seconds) {
  if (seconds.empty()) return {};
  return {*std::max_element(seconds.begin(), seconds.end()), median(seconds)};
}

struct HistoryError {
  double error = 0.0;
  HistoryIndex history;
};

/// The errors that count, in the order of records and scenes.
std::vector<HistoryError> errors_at(const ConvergenceResults& results, std::size_t step,
                                    ErrorMeasure measure, const Selection& selection) {
  std::vector<HistoryError> errors;
  const std::size_t last = std::min(selection.last_record, results.records.size());
  for (std::size_t i = selection.first_record; i < last; ++i) {
    for (std::size_t j = 0; j < results.scenes.size(); ++j) {
      const ExactSlip& exact = results.exact_at(i, j);
      if (std::abs(exact.residual_m) < selection.least_residual_of_peak * exact.peak_m) continue;
      const double error = scheme_error(results, {i, j, step}, measure);
      if (!std::isnan(error)) errors.push_back({error, {i, j, step}});
    }
  }
  return errors;
}

}  // namespace

double scheme_error(const ConvergenceResults& results, const HistoryIndex& history,
                    ErrorMeasure measure) {
  const double residual = results.residual_m(history.record, history.scene, history.step);
  const ExactSlip& exact = results.exact_at(history.record, history.scene);
  const double truth =
      measure == ErrorMeasure::finest
          ? results.residual_m(history.record, history.scene, results.substeps.size() - 1)
          : exact.residual_m;
  const double scale = measure == ErrorMeasure::exact_peak ? exact.peak_m : std::abs(truth);
  return scale == 0.0 ? nan_value : std::abs(residual - truth) / scale;
}

ErrorSummary error_summary(const ConvergenceResults& results, std::size_t step,
                           ErrorMeasure measure, const Selection& selection) {
  const std::vector<HistoryError> errors = errors_at(results, step, measure, selection);
  if (errors.empty()) return {};
  const auto worst = std::max_element(
      errors.begin(), errors.end(), [](const auto& a, const auto& b) { return a.error < b.error; });
  std::vector<double> values;
  for (const HistoryError& e : errors) values.push_back(e.error);
  return {worst->error, median(std::move(values)), worst->history, errors.size()};
}

double share_within(const ConvergenceResults& results, std::size_t step, ErrorMeasure measure,
                    double limit) {
  const std::vector<HistoryError> errors = errors_at(results, step, measure, {});
  const auto within = std::count_if(errors.begin(), errors.end(),
                                    [&](const HistoryError& e) { return e.error <= limit; });
  return static_cast<double>(within) / static_cast<double>(errors.size());
}

std::size_t count_at_rest(const ConvergenceResults& results) {
  return static_cast<std::size_t>(
      std::count_if(results.exact.begin(), results.exact.end(),
                    [](const ExactSlip& slip) { return slip.peak_m == 0.0; }));
}

std::size_t chosen_step(const std::vector<int>& substeps) {
  const auto nearest = std::min_element(substeps.begin(), substeps.end() - 1, [](int a, int b) {
    return std::abs(a - 64) < std::abs(b - 64);
  });
  return static_cast<std::size_t>(nearest - substeps.begin());
}

ConvergenceTimes time_summary(const std::vector<ConvergenceUnit>& units, std::size_t steps) {
  std::vector<std::vector<double>> published(steps);
  std::vector<double> exact, kernel, table;
  for (const ConvergenceUnit& unit : units) {
    const HistoryTimes& times = unit.times;
    for (std::size_t i = 0; i < times.published_s.size(); ++i)
      published[i % steps].push_back(times.published_s[i]);
    exact.insert(exact.end(), times.exact_s.begin(), times.exact_s.end());
    kernel.insert(kernel.end(), times.kernel_s.begin(), times.kernel_s.end());
    table.push_back(times.table_s);
  }
  ConvergenceTimes summary{{}, summary_of(exact), summary_of(kernel), summary_of(table)};
  for (const std::vector<double>& seconds : published)
    summary.published.push_back(summary_of(seconds));
  return summary;
}

}  // namespace glissade
