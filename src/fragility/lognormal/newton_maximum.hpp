// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <cmath>
#include <optional>

namespace glissade::fragility {

/// Newton's method with step halving, of an objective that gives value, gradient and a positive
/// definite `information` at a point. Empty if it has no finite maximum at a finite point.
template <class Objective, class Point>
std::optional<Point> newton_maximum(const Objective& objective, const Point& start) {
  Point line = start;
  auto here = objective(line);
  for (int iteration = 0; iteration < 200; ++iteration) {
    Point step = here.information.ldlt().solve(here.gradient);
    const double decrement = step.dot(here.gradient);  // twice the gain to expect
    if (!step.allFinite() || !(decrement >= 0)) return std::nullopt;
    if (decrement < 1e-20 || step.norm() < 1e-14 * line.norm())
      return std::isfinite(here.value) ? std::optional<Point>(line + step) : std::nullopt;
    auto there = objective(line + step);
    const double rounding = 1e-12 * (1 + std::abs(here.value));
    for (int halving = 0; decrement > rounding && !(there.value > here.value - rounding);
         ++halving) {
      if (halving == 60) return std::nullopt;
      step *= 0.5;
      there = objective(line + step);
    }
    line += step;
    here = there;
  }
  return std::nullopt;
}

}  // namespace glissade::fragility
