// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "block/polynomial/power_series.hpp"

namespace glissade::block_detail {

/// How far a power series on [0, 1] leaves its chord, at most.
inline double chord_deviation(std::span<const double> c) {
  static const auto most = [] {
    std::array<double, Series::most_terms> of{};  // of tau - tau^k
    for (std::size_t k = 2; k < of.size(); ++k) {
      const auto order = static_cast<double>(k);
      of[k] = (order - 1.0) / std::pow(order, order / (order - 1.0));
    }
    return of;
  }();
  double sum = 0.0;
  for (std::size_t k = 2; k < c.size(); ++k) sum += most[k] * std::abs(c[k]);
  return sum;
}

/// Largest departure of the resisting acceleration E and of the spring force s from their chords
/// over a piece at rest: 1/8 of the largest second derivative. With z = a - a_ground, mass m, '
/// over the piece:
///   s' = phase y,  y' = phase z,  z' = -phase (y + 2 zeta z) / m - a_ground',
/// so that |z| <= (|z_0| + phase |y_0| / m + |a_ground'|) / (1 - (phase^2 + 2 zeta phase) / m).
struct ChordDeviation {
  double e = 0.0, s = 0.0;

  /// @param per_left the inverse of the divisor; @param z0, y0 |z| and |y| at the begin of the
  /// piece
  /// @param rise |a_ground'|
  ChordDeviation(double phase, double twice_zeta, double per_mass, double per_left, double z0,
                 double y0, double rise) {
    const double z = (z0 + phase * y0 * per_mass + rise) * per_left;
    const double z_rate = phase * (y0 + (phase + twice_zeta) * z) * per_mass + rise;
    s = 0.125 * phase * phase * z;
    e = s + 0.125 * phase * twice_zeta * z_rate;
  }
};

}  // namespace glissade::block_detail
