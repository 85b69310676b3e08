// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/profile.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <limits>

#include "glissade/core/distributions.hpp"

namespace glissade::fragility {
namespace {

using Function = std::function<double(double)>;

/// Greatest value of a unimodal function within `reach` of `center`.
double greatest(const Function& f, double center, double reach) {
  const auto negative = [&](double v) { return -std::max(f(v), -1e30); };
  std::uintmax_t iterations = 200;
  return -boost::math::tools::brent_find_minima(negative, center - reach, center + reach, 40,
                                                iterations)
              .second;
}

/// Where f is zero, searched outward from `start` with a first `step` that grows; infinite, with
/// the sign of the step, if f keeps its sign as far as ln(1e6).
double zero_from(const Function& f, double start, double step) {
  const double open_end = std::copysign(std::numeric_limits<double>::infinity(), step);
  double from = start, f_from = f(start);
  for (; std::abs(from - start) < std::log(1e6); step *= 1.5) {
    const double to = from + step, f_to = f(to);
    if (!std::isfinite(f_to)) break;
    if ((f_from > 0) != (f_to > 0)) {
      std::uintmax_t iterations = 100;
      const auto [low, high] = boost::math::tools::toms748_solve(
          f, std::min(from, to), std::max(from, to), step > 0 ? f_from : f_to,
          step > 0 ? f_to : f_from, boost::math::tools::eps_tolerance<double>(45), iterations);
      return 0.5 * (low + high);
    }
    from = to;
    f_from = f_to;
  }
  return open_end;
}

}  // namespace

ProfileIntervals profile_intervals(const LogLikelihood& log_likelihood, const ProbitLine& maximum,
                                   double center) {
  // m = ln median - center and s = ln log_std: the line is (-m, 1) exp(-s).
  const double m_hat = -maximum[0] / maximum[1], s_hat = -std::log(maximum[1]);
  const double floor = log_likelihood(maximum) - 0.5 * chi_squared_quantile(1, 0.95);
  const Function above_floor_at_m = [&](double m) {
    return greatest([&](double s) { return log_likelihood(ProbitLine(-m, 1) * std::exp(-s)); },
                    s_hat, 7.0) -
           floor;
  };
  const Function above_floor_at_s = [&](double s) {
    const double b1 = std::exp(-s);
    return greatest(
               [&](double b0) {
                 return log_likelihood({b0, b1});
               },
               -m_hat * b1, 10.0 + 3.0 * b1) -
           floor;
  };
  const double step = 0.1 * std::exp(s_hat);
  return {{std::exp(center + zero_from(above_floor_at_m, m_hat, -step)),
           std::exp(center + zero_from(above_floor_at_m, m_hat, step))},
          {std::exp(zero_from(above_floor_at_s, s_hat, -0.1)),
           std::exp(zero_from(above_floor_at_s, s_hat, 0.1))}};
}

double median_bound(const LogLikelihood& log_outcome_probability, double log_std, double center) {
  const Function excess = [&](double m) {
    return log_outcome_probability(ProbitLine(-m, 1) / log_std) - std::log(0.05);
  };
  const double upward = zero_from(excess, 0.0, log_std);
  return std::exp(center + (std::isfinite(upward) ? upward : zero_from(excess, 0.0, -log_std)));
}

}  // namespace glissade::fragility
