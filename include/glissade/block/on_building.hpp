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

/// A building below the array: one mass or some modes along each of its two horizontal axes,
/// coupled only through the array.
struct BiaxialBuilding {
  std::array<Modes, 2> horizontal;   ///< of the building alone; is_rigid(): along that axis
  std::array<Yielding, 2> yielding;  ///< of the spring of each axis, which is then of one mass
  double mass_ratio = 0.0;           ///< m/M, mass of the array over mass of the building, [0, 1]
};

/// Excitation: the ground motion along the two axes of the building, and the vertical roof motion.
/// All of one time step.
struct BuildingGround {
  std::array<std::shared_ptr<const GroundTable>, 2> horizontal;  ///< the second may be null: none
  std::shared_ptr<const MotionTable> vertical;                   ///< null: none

  /// The same tables.
  bool operator==(const BuildingGround&) const = default;
};

/// @throw std::invalid_argument if a number of these is not finite; only a yield acceleration may
/// be infinite
void require_finite_scene(const BiaxialBuilding& building, const Block& block,
                          const MotionFactors& factors);

struct BuildingSlip {
  SlipResult slip;
  // By the axes of the building:
  std::array<double, 2> peak_base_shear{};           ///< max |damping + spring force| / (M g), per
                                                     ///< weight of the building alone; with the
                                                     ///< inertia of modes that are left out
  std::array<double, 2> peak_roof_displacement_m{};  ///< max |u|, relative to the ground; 0: rigid
};

/// The equations have exactly one solution for every direction of sliding: in the axes of the
/// slope, with R = (m/M) times the identity if both axes of the building can move,
///   1 + sin(slope) (sin(slope) R_ss - cos(slope) |(mu_s R_ss, mu_y R_sy / cos(slope))|) > 0,
/// mu that of the fastest sliding. On one axis it is the condition of coupled.hpp.
bool coupling_is_regular(const Block& block, const BiaxialBuilding& building);

/// The full model, from rest: slide_two_axis() on a building that may be coupled with the array and
/// may yield, with or without a vertical oscillator, and with any FrictionLaw of the block. With r
/// = m/M, g' = g + w, f the friction per normal force, and E = -(2 zeta omega u' + spring) of the
/// building alone along each of its axes, the free bodies of block and roof give
/// (theory.md, 3.4)
///   stuck:    (1 + r) a = E
///   sliding:  N/m = g' cos(slope) + a_s sin(slope)
///             a   = E - r N/m (sin(slope) - f_s cos(slope), -f_y)
///             v'  = (g' sin(slope) - a_s cos(slope), -a_y) - f N/m
/// in the axes of the slope; along a rigid axis a is that of the ground. On modes E is their sum
/// and r = (m/M) sum of gamma^2 / e along each axis (theory.md, 3.4). While N < 0 there is no
/// friction; the history is flagged as uplift and the block stays in the plane of the roof, as in
/// slide_coupled().
///
/// While the block sticks the building is stepped exactly (Nigam & Jennings 1969; power series
/// where an event is possible), and sliding starts at the first root of a series: no excursion
/// between samples is missed. Sliding is SDIRK4 of block and building together with error control
/// (two_axis.hpp): the response of the building alone is exact over each step, and only the effect
/// of the block on it is integrated. So with m/M = 0 the building is exact. A step ends where a
/// spring yields or unloads, to the order of the scheme; while the block sticks those are exact. A
/// block stops as in slide_two_axis(), its lost momentum acting on the building.
///
/// The end of the record, free sliding and ring-down (until the block can no longer start and the
/// springs stay elastic, or 120 s) are as in slide_coupled(). The vertical is followed to the end
/// of its table (MotionTable::end), that of an oscillator then linearly to zero over one interval.
/// A block that only static friction holds (mu < tan(slope) <= mu_static) never stops once it
/// slides: its history ends with the record, flagged as free sliding.
///
/// With static friction above sliding friction slip is discontinuous in its parameters: a block
/// whose speed becomes almost zero may stick; it does if its speed is below a tenth of the
/// tolerance. If friction decreases with speed (fast_over_slow < 1) steps are short enough for
/// the stages to have one solution.
///
/// @param block its friction so that coupling_is_regular()
/// @param tolerance as for slide_two_axis(), in [1e-11, 1e-2]. Errors of displacements, relative to
///   the peak, against an independent solver (tests/two_axis_truth) for some 90 scenes of rough
///   noise of each law that slide more than 10 um, on elastic buildings with m/M up to 0.5, at the
///   default (the test default_tolerance): the median is below 3e-7; the largest is below 1.1e-5 on
///   a circle or an ellipse and with friction that depends on speed, at rates up to 1,000 s/m, and
///   below 2e-5 with static friction but for one scene in a hundred. With a rate of 100,000 s/m the
///   median is below 1e-5, the largest below 3e-4. At 1e-10 all are below 1e-9. Yielding buildings
///   and uplift are compared with a midpoint rule to 1e-3 only (on_building_truth_test). On modes r
///   counts in place of m/M: errors are the same up to 0.5, and 2e-5 at 1.8; on one axis 1e-6 up to
///   12, where the phases are as many as between exact events. Their base shear is accurate to
///   1e-3: the friction of a block that turns as it stops acts on it at once
///   (on_building_modes_test). Each step may have its own error, so that many short phases of
///   little slip have more than one tolerance.
/// @throw NotConverged after 100,000 steps and fifty a sample: a law that is nearly a jump in speed
BuildingSlip slide_on_building(const BuildingGround& ground, const MotionFactors& factors,
                               const BiaxialBuilding& building, const Block& block,
                               double tolerance = 1e-6);

/// The same, with the first crossing of each length of the displacement vector: to the order of the
/// scheme.
/// @param thresholds_m > 0, increasing
/// @param crossings as many
BuildingSlip slide_on_building(const BuildingGround& ground, const MotionFactors& factors,
                               const BiaxialBuilding& building, const Block& block,
                               std::span<const double> thresholds_m, std::span<Crossing> crossings,
                               double tolerance = 1e-6);

/// By how much the gap between two arrays on one roof, under one motion, closes at most (theory.md,
/// 4.3): the largest displacement of `block` ahead of `neighbour` at any time, in plan, in the axes
/// of the block's slope, at least 0. Along that slope the neighbour lies below the block, on the
/// same slope or on one of any other azimuth (half a turn: it faces the block across a valley);
/// across it, at its positive side. Each slides
/// as by slide_on_building(), alone on the building, with the mass ratio of the building. The
/// displacements are the polynomials of the scheme, and their difference is searched on the union
/// of both blocks' steps, to 1e-12 of them. So the error is that of two displacements
/// (largest of the 60 scenes of closing_test 3.2e-7 of the peak, at the default tolerance); of
/// equal blocks on one slope the gap closes by exactly 0.
PlanVector closing_on_building(const BuildingGround& ground, const MotionFactors& factors,
                               const BiaxialBuilding& building, const Block& block,
                               const Block& neighbour, double tolerance = 1e-6);

}  // namespace glissade
