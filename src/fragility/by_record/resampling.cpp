// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/resampling.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"
#include "glissade/core/random.hpp"

namespace glissade {
namespace fragility {
namespace {

double t_of(EstimateWithError replicate, EstimateWithError center) {
  const double t = (replicate.value - center.value) / replicate.standard_error;
  return std::isfinite(t) ? t : infinity;
}

}  // namespace

std::vector<double> draw_records(std::size_t records, const BootstrapOptions& options,
                                 int replicate) {
  std::vector<double> weights(records, 0.0);
  for (std::size_t i = 0; i < records; ++i) {
    const double u =
        keyed_uniform(options.seed, RandomPurpose::bootstrap, static_cast<std::uint64_t>(replicate),
                      static_cast<std::uint32_t>(i));
    weights[static_cast<std::size_t>(u * static_cast<double>(records))] += 1;
  }
  return weights;
}

Interval percentile_interval(std::vector<double> values, double tail) {
  std::erase_if(values, [](double value) { return std::isnan(value); });
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const auto rank = static_cast<std::size_t>(tail * static_cast<double>(values.size() + 1));
  const std::size_t cut = rank > 0 ? rank - 1 : 0;
  return {values[cut], values[values.size() - 1 - cut]};
}

double expanded_tail(std::size_t records, double level) {
  const double n = static_cast<double>(records);
  return normal_cdf(-std::sqrt(n / (n - 1)) * student_quantile(n - 1, 0.5 + 0.5 * level));
}

Interval t_interval(EstimateWithError estimate, const std::vector<EstimateWithError>& replicates,
                    double tail) {
  std::vector<double> t;
  for (const EstimateWithError& replicate : replicates) t.push_back(t_of(replicate, estimate));
  const Interval range = percentile_interval(t, tail);
  return {estimate.value - range.high * estimate.standard_error,
          estimate.value - range.low * estimate.standard_error};
}

Interval log_std_interval(EstimateWithError log_log_std,
                          const std::vector<EstimateWithError>& replicates, std::size_t records,
                          double level) {
  const auto [value, error] = log_log_std;
  if (std::isnan(error)) return {};
  const Interval by_t = t_interval(log_log_std, replicates, 0.5 - 0.5 * level);
  const double freedom = std::min(0.5 / (error * error), static_cast<double>(records) - 1);
  const auto by_chi_squared = [&](double probability) {
    return value + 0.5 * std::log(freedom / chi_squared_quantile(freedom, probability));
  };
  return {std::max(by_t.low, by_chi_squared(0.5 + 0.5 * level)),
          std::min(by_t.high, by_chi_squared(0.5 - 0.5 * level))};
}

}  // namespace fragility

std::vector<Interval> bootstrap_intervals(
    std::size_t records, std::size_t count,
    const std::function<std::vector<double>(const std::vector<double>&)>& statistics,
    const BootstrapOptions& options) {
  if (records < 2) return std::vector<Interval>(count);
  std::vector<std::vector<double>> values(count);  // [statistic][replicate]
  for (const std::vector<double>& found : fragility::resampled(records, options, statistics)) {
    GLISSADE_EXPECTS(found.size() == count);
    for (std::size_t i = 0; i < count; ++i) values[i].push_back(found[i]);
  }
  std::vector<Interval> intervals;
  for (const std::vector<double>& of_one : values)
    intervals.push_back(
        fragility::percentile_interval(of_one, fragility::expanded_tail(records, options.level)));
  return intervals;
}

Interval bootstrap_interval(std::size_t records,
                            const std::function<double(const std::vector<double>&)>& statistic,
                            const BootstrapOptions& options) {
  return bootstrap_intervals(
             records, 1,
             [&](const std::vector<double>& weights) { return std::vector{statistic(weights)}; },
             options)
      .front();
}

}  // namespace glissade
