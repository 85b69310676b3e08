// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "block/polynomial/power_series.hpp"

namespace glissade::block_detail::two_axes {

/// One axis of a building of one mass over a piece of time, tau in [0, 1] the elapsed fraction:
///   x' = stiffness phase (y - b),   y' = phase (a - a_ground),
///   a = -(2 zeta (y - b) + x) / (1 + r)
/// with b of the block, omega rho times its velocity, and the ground linear in tau.
struct OneMassSeries {
  using Terms = decltype(Series::c);
  double phase, stiffness, twice_zeta, per_mass;
  std::array<double, 2> ground, block = {};  ///< at the begin, and their rise

  /// @param x, y their first terms are given
  void expand(std::size_t terms, Terms& x, Terms& y, Terms& a) const {
    for (std::size_t k = 0; k < terms; ++k) {
      const double rate = k < 2 ? y[k] - block[k] : y[k];
      a[k] = -(twice_zeta * rate + x[k]) * per_mass;
      if (k + 1 == terms) break;
      const double factor = phase * Series::inverse[k + 1];
      x[k + 1] = stiffness * (factor * rate);
      y[k + 1] = factor * (k < 2 ? a[k] - ground[k] : a[k]);
    }
  }
};

}  // namespace glissade::block_detail::two_axes
