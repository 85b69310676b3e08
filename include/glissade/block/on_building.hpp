// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <span>

#include "glissade/block/crossing.hpp"
#include "glissade/block/two_axis.hpp"
#include "glissade/building/motion_table.hpp"
#include "glissade/building/yielding.hpp"

namespace glissade {

/// A building below the array: an oscillator along each of its two horizontal axes, which do not
/// feel each other but through the array.
struct BiaxialBuilding {
  std::array<Oscillator, 2> horizontal;  ///< of the building alone; period 0: rigid along that axis
  std::array<Yielding, 2> yielding;      ///< of each axis' spring
  double mass_ratio = 0.0;               ///< m/M, the array's mass over the building's, [0, 1]
};

/// What moves the building: the ground along its two axes, and the roof's own vertical motion. All
/// of one step.
struct BuildingGround {
  std::array<std::shared_ptr<const GroundTable>, 2> horizontal;  ///< the second may be null: none
  std::shared_ptr<const MotionTable> vertical;                   ///< null: none
};

struct BuildingFactors {
  std::array<double, 2> horizontal{1.0, 1.0};  ///< a negative one turns the component round
  double vertical = 1.0;
};

struct BuildingSlip {
  TwoAxisResult slip;
  // By the building's axes:
  std::array<double, 2> peak_base_shear{};           ///< max |damping + spring force| / (M g), per
                                                     ///< weight of the building alone
  std::array<double, 2> peak_roof_displacement_m{};  ///< max |u|, relative to the ground
};

/// The equations have one solution, and only one, in whatever direction the block slides: in the
/// axes of the slope, with R = (m/M) times the identity where both axes of the building can move,
///   1 + sin(slope) (sin(slope) R_ss - cos(slope) |(mu_s R_ss, mu_y R_sy / cos(slope))|) > 0,
/// mu that of the fastest sliding. On one axis it is the condition of coupled.hpp.
bool coupling_is_regular(const TwoAxisBlock& block, const BiaxialBuilding& building);

/// The full model: slide_two_axis() on a building that may feel the array's mass, may yield, and
/// whose vertical may be an oscillator's; with any FrictionLaw of the block.
BuildingSlip slide_on_building(const BuildingGround& ground, const BuildingFactors& factors,
                               const BiaxialBuilding& building, const TwoAxisBlock& block,
                               double tolerance = 1e-6);

/// The same, and when the displacement vector first has each of these lengths.
/// @param thresholds_m > 0, increasing
/// @param crossings as many
BuildingSlip slide_on_building(const BuildingGround& ground, const BuildingFactors& factors,
                               const BiaxialBuilding& building, const TwoAxisBlock& block,
                               std::span<const double> thresholds_m, std::span<Crossing> crossings,
                               double tolerance = 1e-6);

}  // namespace glissade
