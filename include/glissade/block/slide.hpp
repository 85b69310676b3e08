// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <span>
#include <vector>

#include "glissade/block/crossing.hpp"
#include "glissade/block/friction_law.hpp"
#include "glissade/block/slip_result.hpp"
#include "glissade/core/units.hpp"

namespace glissade {

/// Whether the block may slip upslope. `downslope_only` is the classical Newmark convention.
enum class SlipDirections { both, downslope_only };

/// A coefficient of friction for each axis of the slope. Friction is on an ellipse with these
/// half-axes (theory.md, 3.2); on a circle if they are equal.
struct EllipticFriction {
  double along = 0.0;   ///< in the direction in which the surface falls; >= 0
  double across = 0.0;  ///< >= 0, and zero only if the other is

  EllipticFriction() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): one coefficient is a circle.
  EllipticFriction(double circle) : along(circle), across(circle) {}
  EllipticFriction(double of_along, double of_across) : along(of_along), across(of_across) {}
};

/// A rigid block, which does not turn, on a sloping roof.
struct Block {
  EllipticFriction friction;  ///< one axis: that along the slope
  double slope_rad = 0.0;     ///< in (-pi/2, pi/2); positive: the surface falls toward +x, that is
                              ///< toward the azimuth; negative: the opposite way
  double azimuth_rad = 0.0;   ///< two axes: from the first axis of the roof toward the second. On a
                              ///< flat roof it rotates the axes of friction
  SlipDirections directions = SlipDirections::both;  ///< two axes: both
  double gravity_mps2 = standard_gravity_mps2;       ///< > 0
  FrictionLaw law = {};  ///< Coulomb's law, except in slide_coupled(), which accepts a
                         ///< static_over_sliding, and slide_on_building()

  /// Of the direction in which the surface falls.
  double fall_azimuth_rad() const {
    return slope_rad < 0.0 ? azimuth_rad + std::numbers::pi : azimuth_rad;
  }
};

/// Absolute acceleration of the roof, piecewise linear between equally spaced samples. One table of
/// samples serves every intensity and orientation through its two factors.
struct RoofAcceleration {
  double dt_s = 0.0;                           ///< > 0
  std::span<const double> horizontal_mps2;     ///< +x; at least one sample
  std::span<const double> vertical_mps2 = {};  ///< up; empty: none; else as long as the horizontal
  double horizontal_factor = 1.0;
  double vertical_factor = 1.0;
};

/// The sliding block from rest, event by event. Within a sample interval the acceleration is
/// linear, so slip starts at the root of a line and stops at the root of a quadratic; both have a
/// closed form. Exact for the piecewise-linear input up to rounding: 1e-12 relative against long
/// double (tests/unit/block). After the last sample the roof acceleration goes linearly to zero
/// over one more interval, and the block coasts until it stops.
///
/// Equations (theory.md, 1.1; Rodriguez-Nikl et al. 2019, eqs 6-18, extended by the vertical
/// w):
///   N/m = (g + w) cos(slope) + a sin(slope)
///   v'  = (g + w) sin(slope) - a cos(slope) - mu sgn(v) N/m         while sliding
///   stick while v = 0 and |(g + w) sin(slope) - a cos(slope)| <= mu N/m
///
/// This is the scalar reference: one short step per sample.
SlipResult slide(const RoofAcceleration& roof, const Block& block);

/// A point of a slip history: at each sample and at each start and stop between samples.
struct SlipPoint {
  double time_s = 0.0;
  double displacement_m = 0.0;  ///< in plan, downslope positive
  double velocity_mps = 0.0;    ///< in plan, downslope positive
};

/// The same, with the history.
SlipResult slide(const RoofAcceleration& roof, const Block& block, std::vector<SlipPoint>& history);

/// The same, with the first crossing of each distance from the initial position. Slip is a cubic of
/// time between events; its root is found to rounding: times to 1e-13 s and speeds to 1e-11
/// relative against 50 digits, up to 0.9 of the peak (tests/unit/block). Close to a stop the speed,
/// and its rounding error, is proportional to the square root of the remaining distance. A
/// threshold is crossed exactly if peak_displacement_m is at least as large; if it is reached only
/// at a stop, the speed is zero.
/// @param thresholds_m > 0, ascending; in plan
/// @param crossings one for each
SlipResult slide(const RoofAcceleration& roof, const Block& block,
                 std::span<const double> thresholds_m, std::span<Crossing> crossings);

/// True if the block cannot slide for any phase between horizontal and vertical: the largest |a|
/// and |w| together are too small to start sliding. Then slide() gives exactly zero and is not
/// necessary.
bool cannot_slip(const Block& block, double peak_horizontal_mps2, double peak_vertical_mps2);

/// Yield acceleration: horizontal acceleration, m/s2, below which the block does not slide without
/// vertical: min(|a_d|, a_u) with a_d = g tan(slope - phi), a_u = g tan(slope + phi) (theory.md,
/// 1.2). Zero in free sliding.
double yield_acceleration_mps2(const Block& block);

/// Deceleration along the slope of a block that slides down a roof at rest, m/s2:
/// g (mu cos(slope) - sin(slope)), zero if that is negative.
double resting_deceleration_mps2(const Block& block);

}  // namespace glissade
