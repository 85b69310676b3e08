// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace glissade {

/// A linear single-degree-of-freedom oscillator on fixed ground. period_s = 0: rigid, the motion
/// goes through unchanged.
struct Oscillator {
  double period_s = 0.0;        ///< >= 0
  double damping_ratio = 0.05;  ///< >= 0
};

/// What lies between ground and roof: one oscillator along the slope, one for the vertical (Walters
/// et al. 2012 take the vertical rigid). The array's mass is neglected.
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

/// Absolute acceleration of the roof at equally spaced samples.
struct RoofMotion {
  double dt_s = 0.0;
  std::vector<double> horizontal_mps2;
  std::vector<double> vertical_mps2;  ///< empty: none
  std::size_t record_samples = 0;  ///< those up to the record's last sample; the rest is ring-down
  double peak_horizontal_mps2 = 0.0;
  double peak_vertical_mps2 = 0.0;
};

/// How far a building's free vibration is followed after the record, and how finely the roof
/// motion is sampled.
struct RoofMotionOptions {
  /// The building rings down until its roof accelerations can no longer exceed these, so that
  /// nothing at rest begins to slide; 0: the roof motion ends with the record.
  double quiet_horizontal_mps2 = 0.0;
  double quiet_vertical_mps2 = 0.0;
  /// > 0: a block that is still sliding then, and loses speed at this rate, is followed until it
  /// has stopped, or until the roof moves with less than 1e-4 of the quiet accelerations.
  double settle_deceleration_mps2 = 0.0;
  /// An undamped building never rings down: it is followed for this long.
  double longest_ring_down_s = 120.0;
  /// roof_motion() only: the record's step is divided (at most 1,024 times) until a period has at
  /// least this many: between samples the roof motion is taken linear, which is off by at most (2
  /// pi / n)^2 / 8 of its amplitude: 5e-6 for 1,000.
  int steps_per_period = 1000;
};

/// The same for a vertical tabulated by itself: its quiet acceleration stands where a single
/// component's is read, quiet_horizontal_mps2.
inline RoofMotionOptions for_vertical(RoofMotionOptions follow) {
  follow.quiet_horizontal_mps2 = follow.quiet_vertical_mps2;
  return follow;
}

/// Roof motion of the building, exact at its samples (core/oscillator.hpp): for a history to be
/// walked through sample by sample, and the reference beside motion_table.hpp.
RoofMotion roof_motion(const GroundMotion& ground, const Building& building,
                       const RoofMotionOptions& options);

}  // namespace glissade
