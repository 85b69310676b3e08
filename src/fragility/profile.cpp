// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile.hpp"

#include <algorithm>
#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

namespace glissade::fragility {
namespace {

/// Greatest value of a unimodal f(ln v) for v within a factor exp(reach) of `center`.
double greatest(const std::function<double(double)>& f, double center, double reach) {
  const auto negative = [&](double log_v) { return -std::max(f(std::exp(log_v)), -1e30); };
  const double log_center = std::log(center);
  const auto [where, least] =
      boost::math::tools::brent_find_minima(negative, log_center - reach, log_center + reach, 40);
  return -least;
}

/// Where f(v) is zero, searched outward from `start` with a first step `factor` (below 1: downward) that grows; 0 or
/// infinity if f keeps its sign over a factor of 1e6.
double zero_from(const std::function<double(double)>& f, double start, double factor) {
  const auto of_log = [&](double log_v) { return f(std::exp(log_v)); };
  double from = std::log(start), f_from = f(start);
  for (double step = std::log(factor); std::abs(from - std::log(start)) < std::log(1e6); step *= 1.5) {
    const double to = from + step, f_to = of_log(to);
    if ((f_from > 0) != (f_to > 0)) {
      std::uintmax_t iterations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          of_log, std::min(from, to), std::max(from, to), step > 0 ? f_from : f_to, step > 0 ? f_to : f_from,
          boost::math::tools::eps_tolerance<double>(45), iterations);
      return std::exp(0.5 * (low + high));
    }
    from = to;
    f_from = f_to;
  }
  return factor > 1 ? std::numeric_limits<double>::infinity() : 0.0;
}

}  // namespace

ProfileIntervals profile_intervals(const CurveObjective& objective, const LognormalCurve& maximum) {
  const double drop = 0.5 * boost::math::quantile(boost::math::chi_squared(1), 0.95);
  const double floor = objective(maximum) - drop;
  const auto above_floor_at_median = [&](double median) {
    const auto of_log_std = [&](double log_std) { return objective({median, log_std}); };
    return greatest(of_log_std, maximum.log_std, 7.0) - floor;
  };
  const auto above_floor_at_log_std = [&](double log_std) {
    const auto of_median = [&](double median) { return objective({median, log_std}); };
    return greatest(of_median, maximum.median, 3.0 + 10.0 * std::max(log_std, maximum.log_std)) - floor;
  };
  const double step = std::exp(0.1 * maximum.log_std);
  return {{zero_from(above_floor_at_median, maximum.median, 1 / step),
           zero_from(above_floor_at_median, maximum.median, step)},
          {zero_from(above_floor_at_log_std, maximum.log_std, 1 / 1.1),
           zero_from(above_floor_at_log_std, maximum.log_std, 1.1)}};
}

double median_bound(const CurveObjective& log_outcome_probability, const LognormalCurve& start) {
  const auto excess = [&](double median) {
    return log_outcome_probability({median, start.log_std}) - std::log(0.05);
  };
  const double step = std::exp(start.log_std);
  const double upward = zero_from(excess, start.median, step);
  return std::isfinite(upward) ? upward : zero_from(excess, start.median, 1 / step);
}

}  // namespace glissade::fragility
