// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "glissade/building/modes.hpp"

namespace glissade {

/// The building: one oscillator along the slope, one for the vertical (rigid in Walters et al.
/// 2012). The mass of the array is neglected.
struct Building {
  Oscillator horizontal;
  Oscillator vertical;
};

/// Ground acceleration on a common clock, piecewise linear, going linearly to zero over one
/// interval after the last sample.
struct GroundMotion {
  double dt_s = 0.0;
  std::span<const double> horizontal_mps2;
  std::span<const double> vertical_mps2 = {};  ///< empty: none; else as long as the horizontal
};

/// Factors on the components of a motion, of the ground or of a roof.
struct MotionFactors {
  std::array<double, 2> horizontal{1.0, 1.0};  ///< one axis: the first; < 0: reversed
  double vertical = 1.0;

  MotionFactors() = default;
  MotionFactors(const std::array<double, 2>& by_axis, double up)
      : horizontal(by_axis), vertical(up) {}
  MotionFactors(double both_axes, double up) : MotionFactors({both_axes, both_axes}, up) {}
};

/// Absolute acceleration of the roof at equally spaced samples.
struct RoofMotion {
  double dt_s = 0.0;
  std::vector<double> horizontal_mps2;
  std::vector<double> vertical_mps2;  ///< empty: none
  std::size_t record_samples = 0;  ///< up to the last sample of the record; the rest is ring-down
  double peak_horizontal_mps2 = 0.0;
  double peak_vertical_mps2 = 0.0;
};

/// Length of the ring-down after the record, and time step of the roof motion (theory.md, 1.6).
struct RoofMotionOptions {
  /// The ring-down is followed until the roof accelerations can no longer exceed these, so that a
  /// block at rest cannot start to slide; 0: the roof motion ends with the record.
  double quiet_horizontal_mps2 = 0.0;
  double quiet_vertical_mps2 = 0.0;
  /// > 0: a block that then still slides, with this deceleration, is followed until it has stopped,
  /// or until the roof accelerations are below 1e-4 of the quiet accelerations.
  double settle_deceleration_mps2 = 0.0;
  /// Limit of the ring-down, reached by undamped buildings.
  double longest_ring_down_s = 120.0;
  /// roof_motion() only: the time step of the record is divided (at most by 1,024) until a period
  /// has at least this many steps n. Linear interpolation between samples has an error of at most
  /// (2 pi / n)^2 / 8 of the amplitude: 5e-6 for 1,000.
  int steps_per_period = 1000;
};

/// The same for a vertical that is tabulated separately: its quiet acceleration is put into
/// quiet_horizontal_mps2, which is read for a single component.
inline RoofMotionOptions for_vertical(RoofMotionOptions follow) {
  follow.quiet_horizontal_mps2 = follow.quiet_vertical_mps2;
  return follow;
}

/// Roof motion of the building, exact at its samples (core/oscillator.hpp): for analyses sample by
/// sample, and the reference for motion_table.hpp. @throw InputError above 2^27 steps
RoofMotion roof_motion(const GroundMotion& ground, const Building& building,
                       const RoofMotionOptions& options);

}  // namespace glissade
