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
  std::array<double, 2> peak_roof_displacement_m{};  ///< max |u|, relative to the ground; 0: rigid
};

/// The equations have one solution, and only one, in whatever direction the block slides: in the
/// axes of the slope, with R = (m/M) times the identity where both axes of the building can move,
///   1 + sin(slope) (sin(slope) R_ss - cos(slope) |(mu_s R_ss, mu_y R_sy / cos(slope))|) > 0,
/// mu that of the fastest sliding. On one axis it is the condition of coupled.hpp.
bool coupling_is_regular(const TwoAxisBlock& block, const BiaxialBuilding& building);

/// The full model, from rest: slide_two_axis() on a building that may feel the array's mass, may
/// yield, and whose vertical may be an oscillator's; with any FrictionLaw of the block. With r =
/// m/M, g' = g + w, f the friction per normal force, and E = -(2 zeta omega u' + spring) of the
/// building alone along each of its axes, the free bodies of block and roof give
/// (theory.md, 3.4)
///   stuck:    (1 + r) a = E
///   sliding:  N/m = g' cos(slope) + a_s sin(slope)
///             a   = E - r N/m (sin(slope) - f_s cos(slope), -f_y)
///             v'  = (g' sin(slope) - a_s cos(slope), -a_y) - f N/m
/// by the axes of the slope; along a rigid axis a is the ground's. Where N < 0 there is no
/// friction; the block is flagged as lifted and kept on the roof's plane, as in slide_coupled().
///
/// At rest the building is stepped exactly (Nigam & Jennings 1969; power series where something may
/// happen), and what ends the rest is the first root of a series: no excursion between samples is
/// missed. Sliding is SDIRK4 of block and building together with error control (two_axis.hpp): what
/// the building does by itself is exact over each step, and only what the block adds to it is
/// integrated. So with m/M = 0 the building is exact. A step ends where a spring yields or unloads,
/// to the order of the scheme; at rest those are exact. A block comes to rest as in
/// slide_two_axis(), the building pushed on meanwhile by the momentum it loses.
///
/// The end of the record, free sliders and ring-down (until nothing can move the block again and
/// the springs stay elastic, or 120 s) are as in slide_coupled(). The vertical goes on as far as
/// its table is followed (MotionTable::end), an oscillator's from there linearly to zero over one
/// interval. A block that static friction alone holds (mu < tan(slope) <= mu_static) never stops
/// once it slides: it ends with the record, flagged as sliding freely.
///
/// Static friction above that of sliding makes slip a function with jumps: a block that all but
/// stops on its way may stick, and where its speed falls below a tenth of the tolerance it does.
/// Where friction falls with speed (fast_ratio < 1) steps are kept short enough for the stages to
/// have one solution.
///
/// @param block its friction so that coupling_is_regular()
/// @param tolerance as slide_two_axis()'s, in [1e-9, 1e-2]: on recorded motions 700 scenes gave
/// peaks
///   off by a median of 0.1, nine in ten by less than 0.5 and one by 12 tolerances; base shear and
///   roof displacement by less. Against slide_coupled() on rough noise up to 20.
BuildingSlip slide_on_building(const BuildingGround& ground, const BuildingFactors& factors,
                               const BiaxialBuilding& building, const TwoAxisBlock& block,
                               double tolerance = 1e-6);

/// The same, and when the displacement vector first has each of these lengths, and how fast the
/// block is then: to the order of the scheme.
/// @param thresholds_m > 0, increasing
/// @param crossings as many
BuildingSlip slide_on_building(const BuildingGround& ground, const BuildingFactors& factors,
                               const BiaxialBuilding& building, const TwoAxisBlock& block,
                               std::span<const double> thresholds_m, std::span<Crossing> crossings,
                               double tolerance = 1e-6);

}  // namespace glissade
