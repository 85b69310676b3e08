// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "on_building_axis.hpp"
#include "power_series.hpp"

namespace glissade::block_detail {

/// What shakes the building over a piece of time: the ground's axes, linear, and the roof's
/// vertical acceleration, a polynomial in the piece's share.
struct Shaking {
  double length_s = 0.0;
  std::array<Ramp, 2> ground{};
  std::array<double, 5> vertical{};  ///< coefficients of the share's powers
  int vertical_terms = 0;            ///< 0: none, 2: linear, 5

  double w(double share) const {
    double sum = 0.0;
    for (int k = vertical_terms; k-- > 0;)
      sum = sum * share + vertical[static_cast<std::size_t>(k)];
    return sum;
  }
  double coefficient(int k) const {
    return k < vertical_terms ? vertical[static_cast<std::size_t>(k)] : 0.0;
  }
  /// At most how far w leaves the line between its values at both ends.
  double w_sag() const {
    double sum = 0.0;
    for (std::size_t k = 2; k < 5; ++k) sum += std::abs(vertical[k]);
    return vertical_terms > 2 ? sum : 0.0;
  }
  /// No |w| is larger.
  double largest_w() const {
    double sum = 0.0;
    for (int k = 0; k < vertical_terms; ++k) sum += std::abs(coefficient(k));
    return sum;
  }
  /// Leaves what comes after y.
  void cut(double y) { part(y, 1.0); }
  /// Leaves what is between two shares.
  void part(double from, double to) {
    const double share = to - from;
    for (Ramp& g : ground) g = {g.at(from), to == 1.0 ? g.end : g.at(to)};
    // Horner's shift to `from`, then a change of scale.
    for (int i = 0; i < vertical_terms; ++i)
      for (int k = vertical_terms - 1; k-- > i;)
        vertical[static_cast<std::size_t>(k)] += from * vertical[static_cast<std::size_t>(k) + 1];
    double scale = 1.0;
    for (double& c : vertical) {
      c *= scale;
      scale *= share;
    }
    length_s *= share;
  }
};

}  // namespace glissade::block_detail
