// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "by_record/resampling.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/fragility/bootstrap.hpp"

namespace glissade {
namespace {

using namespace fragility;

/// ln of the mean, and its standard error by the coefficient of variation.
EstimateWithError log_mean(const std::vector<double>& values, const std::vector<double>& weights) {
  const auto n = static_cast<double>(values.size());
  const double mean = std::inner_product(values.begin(), values.end(), weights.begin(), 0.0) / n;
  double squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
    squares += weights[i] * (values[i] - mean) * (values[i] - mean);
  return {std::log(mean), std::sqrt(squares / (n - 1) / n) / mean};
}

/// Of a t without a standard error only the sign is known.
double signed_t(EstimateWithError replicate, double center) {
  const double departure = replicate.value - center;
  const double t = departure / replicate.standard_error;
  return std::isfinite(t) ? t : std::copysign(infinity, departure);
}

/// What lognormal values of a variance s^2 of their logarithms add to ln of their mean on either
/// side (Olsson 2005, J. Statistics Education 13(1), for Cox's interval).
double cox_reach(double variance, double n, double level) {
  const double t = student_quantile(n - 1, 0.5 + 0.5 * level);
  return t * std::sqrt(variance / n + variance * variance / (2 * (n - 1)));
}

/// Cox's interval of ln mean, and the reach that is the measure for the bootstrap's.
struct Lognormal {
  Interval log_mean;
  double reach;

  Lognormal(const std::vector<double>& values, EstimateWithError all, double level) {
    const auto n = static_cast<double>(values.size());
    const double of_moments = std::log1p(n * all.standard_error * all.standard_error);
    log_mean = {all.value, all.value};
    reach = cox_reach(of_moments, n, level);
    if (std::ranges::any_of(values, [](double v) { return v == 0; })) return;
    double mean = 0.0, variance = 0.0;
    for (const double v : values) mean += std::log(v) / n;
    for (const double v : values) variance += std::pow(std::log(v) - mean, 2) / (n - 1);
    const double of_logs = cox_reach(variance, n, level);
    log_mean = {mean + 0.5 * variance - of_logs, mean + 0.5 * variance + of_logs};
    reach = std::max(reach, of_logs);
  }
};

}  // namespace

Interval positive_mean_interval(const std::vector<double>& values,
                                const BootstrapOptions& options) {
  GLISSADE_EXPECTS(
      std::ranges::all_of(values, [](double v) { return v >= 0 && std::isfinite(v); }));
  if (values.size() < 2) return {};
  const EstimateWithError all = log_mean(values, std::vector<double>(values.size(), 1.0));
  const double mean = std::exp(all.value);
  if (!(mean > 0) || std::ranges::minmax(values).min == std::ranges::minmax(values).max)
    return {values.front(), values.front()};
  std::vector<double> logs, ts;
  for (const EstimateWithError one : resampled(values.size(), options, [&](const auto& weights) {
         return log_mean(values, weights);
       })) {
    logs.push_back(one.value);
    ts.push_back(signed_t(one, all.value));
  }
  const Lognormal cox(values, all, options.level);
  const Interval percentile =
      percentile_interval(std::move(logs), expanded_tail(values.size(), options.level));
  const Interval t = percentile_interval(std::move(ts), 0.5 - 0.5 * options.level);
  const double most = 1.5 * cox.reach;
  const double down = std::min(t.high * all.standard_error, most),
               up = std::min(-t.low * all.standard_error, most);
  return {std::exp(std::min({all.value, percentile.low, cox.log_mean.low, all.value - down})),
          std::exp(std::max({all.value, percentile.high, cox.log_mean.high, all.value + up}))};
}

}  // namespace glissade
