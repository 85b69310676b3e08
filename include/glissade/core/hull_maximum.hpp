// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace glissade {

/// Raises `largest` to the largest size(point) of a curve given by its Bernstein coefficients, to
/// 1e-12 of it: a curve stays in the hull of its coefficients, and is halved where they allow more.
/// @tparam Size convex; @param slack by which `largest` may stay too small
/// @param halvings after which the hull is off by less than rounding
template <class Point, std::size_t n, class Size>
void raise_to_largest(const std::array<Point, n>& curve, double& largest, const Size& size,
                      double slack = 0.0, int halvings = 24) {
  largest = std::max({largest, size(curve.front()), size(curve.back())});
  double hull = 0.0;
  for (const Point& point : curve) hull = std::max(hull, size(point));
  if (halvings == 0 || hull <= largest * (1.0 + 1e-12) || hull <= largest + slack) return;
  std::array<Point, n> left, right = curve;
  for (std::size_t level = 0; level < n; ++level) {  // de Casteljau, in the middle
    left[level] = right[0];
    for (std::size_t k = 0; k + level + 1 < n; ++k) right[k] = 0.5 * (right[k] + right[k + 1]);
  }
  raise_to_largest(left, largest, size, slack, halvings - 1);
  raise_to_largest(right, largest, size, slack, halvings - 1);
}

}  // namespace glissade
