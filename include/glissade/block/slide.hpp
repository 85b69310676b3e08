// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "glissade/core/units.hpp"

namespace glissade {

/// Whether the block may slip upslope. `downslope_only` is the classical Newmark convention.
enum class SlipDirections { both, downslope_only };

/// A rigid block on a Coulomb plane.
struct Block {
  double friction = 0.0;   ///< mu >= 0
  double slope_rad = 0.0;  ///< in (-pi/2, pi/2); positive: the surface falls toward +x
  SlipDirections directions = SlipDirections::both;
  double gravity_mps2 = standard_gravity_mps2;
};

/// Absolute acceleration of the roof at equally spaced samples, piecewise linear between them, times `scale`.
struct RoofAcceleration {
  double dt_s = 0.0;
  std::span<const double> horizontal_mps2;  ///< +x
  std::span<const double> vertical_mps2;    ///< up; empty: none; else as long as the horizontal
  double scale = 1.0;
};

/// What a history did. Displacements and velocities of the block relative to the roof, in plan (slip times cos of slope),
/// downslope positive; on a flat roof +x positive.
struct SlipResult {
  double peak_displacement_m = 0.0;      ///< max |slip|
  double residual_displacement_m = 0.0;  ///< signed
  double peak_downslope_m = 0.0;         ///< >= 0
  double peak_upslope_m = 0.0;           ///< >= 0
  double peak_velocity_mps = 0.0;        ///< max |velocity|
  double slip_duration_s = 0.0;
  std::size_t slip_phases = 0;           ///< runs of sliding one way
  bool uplift = false;                   ///< the normal force went below zero: outside the model
  bool free_sliding = false;             ///< tan(slope) > mu: never stops; displacement at the last sample
};

/// The sliding block, event by event: exact to rounding for piecewise-linear input (theory on a page: README).
/// The readable reference; cost is one short step per sample.
SlipResult slide(const RoofAcceleration& roof, const Block& block);

/// A point of a slip history, at samples and at the events between them.
struct SlipPoint {
  double time_s, slip_m, velocity_mps;
};
SlipResult slide(const RoofAcceleration& roof, const Block& block, std::vector<SlipPoint>& history);

}  // namespace glissade
