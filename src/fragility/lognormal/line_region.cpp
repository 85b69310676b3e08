// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/line_region.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <numbers>
#include <utility>

#include "glissade/core/finite.hpp"
#include "glissade/core/root.hpp"

namespace glissade::fragility {
namespace {

constexpr int steps = 96;
constexpr double step = 2 * std::numbers::pi / steps;
constexpr int bits = 36;  // of the boundary

}  // namespace

LineRegion::LineRegion(LogLikelihood log_likelihood, const ProbitLine& maximum,
                       const Eigen::Matrix2d& scale, LogLikelihood allowed)
    : log_likelihood_(std::move(log_likelihood)),
      allowed_(std::move(allowed)),
      maximum_(maximum),
      greatest_(log_likelihood_(maximum)),
      scale_(scale) {
  for (int i = 0; i < steps; ++i) boundary_.push_back(boundary(i * step));
}

/// Outward from the maximum, as far as the line rises.
ProbitLine LineRegion::boundary(double angle) const {
  const Eigen::Vector2d direction = scale_ * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  const double level = direction[1] < 0 ? -maximum_[1] / direction[1] : infinity;
  const auto excess = [&](double r) {
    const ProbitLine line = maximum_ + r * direction;
    const double fall = 2 * (greatest_ - log_likelihood_(line));
    return std::min(fall, 1e30) - allowed_(line);
  };
  const double last = std::isinf(level) ? 1e9 : (1 - 1e-9) * level;
  double from = 0, to = std::min(2.0, 0.5 * last), at_from = -1, at_to = excess(to);
  while (at_to < 0 && to < last) {
    from = std::exchange(to, std::min(1.5 * to, last));
    at_from = std::exchange(at_to, excess(to));
  }
  if (at_to < 0) return {maximum_[0] + to * direction[0], 0.0};
  if (from == 0) at_from = excess(from = 1e-6 * to);
  return maximum_ + root_between(excess, from, to, at_from, at_to, bits) * direction;
}

Interval LineRegion::range(const std::function<double(const ProbitLine&)>& quantity) const {
  /// The least of `sign` times the quantity, refined between the neighbours of the least step.
  const auto least = [&](double sign) {
    double found = infinity;
    int at = 0;
    for (int i = 0; i < steps; ++i) {
      const double value = sign * quantity(boundary_[static_cast<std::size_t>(i)]);
      if (value < found) found = value, at = i;
    }
    if (std::isinf(found)) return found;
    std::uintmax_t iterations = 60;
    const auto [angle, refined] = boost::math::tools::brent_find_minima(
        [&](double a) { return sign * quantity(boundary(a)); }, (at - 1) * step, (at + 1) * step,
        18, iterations);  // of the angle: twice as many bits of the quantity, which is level there
    return std::min(found, refined);
  };
  return {least(1), -least(-1)};
}

double median_bound(const LogLikelihood& log_outcome_probability, double log_std, double center) {
  const auto excess = [&](double m) {
    return log_outcome_probability(ProbitLine(-m, 1) / log_std) - std::log(0.05);
  };
  double reach = log_std;
  while ((excess(-reach) > 0) == (excess(reach) > 0) && reach < 1e3) reach *= 2;
  return std::exp(center + root_between(excess, -reach, reach, bits));
}

}  // namespace glissade::fragility
