// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "block/two_axes/roof/tables.hpp"

namespace glissade::block_detail::two_axes {

/// One axis of a building with the block at rest on it over a sample interval, its spring elastic
/// or yielding throughout: linear in its state and in the ground at both ends.
class SpringStep {
 public:
  SpringStep() = default;
  SpringStep(double phase, double stiffness, double twice_zeta, double per_mass);

  struct Begin {
    OscillatorState state;
    std::array<double, 2> ground;  ///< at both ends
  };
  OscillatorState end(const Begin& b) const { return {value(to_x_, b), value(to_y_, b)}; }
  /// By how much the roof's acceleration, and x and y, leave their chords, at most.
  double a_deviation(const Begin& b) const { return bound(a_deviation_, b); }
  double x_deviation(const Begin& b) const { return bound(x_deviation_, b); }
  double y_deviation(const Begin& b) const { return bound(y_deviation_, b); }

 private:
  using Row = std::array<double, 4>;  // of x, y, and the ground at both ends
  static double value(const Row& row, const Begin& b) {
    return row[0] * b.state.x + row[1] * b.state.y + row[2] * b.ground[0] + row[3] * b.ground[1];
  }
  static double bound(const Row& row, const Begin& b) {
    return row[0] * std::abs(b.state.x) + row[1] * std::abs(b.state.y) +
           row[2] * std::abs(b.ground[0]) + row[3] * std::abs(b.ground[1]);
  }
  Row to_x_{}, to_y_{}, a_deviation_{}, x_deviation_{}, y_deviation_{};
};

}  // namespace glissade::block_detail::two_axes
