// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "glissade/block/crossing.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/building/yielding.hpp"

namespace glissade {

/// A building that feels the array on its roof, linear unless its spring yields. The vertical is
/// the ground's own.
struct CoupledBuilding {
  Oscillator horizontal;    ///< of the building alone, without the array
  double mass_ratio = 0.0;  ///< m/M, the array's mass over the building's, >= 0
  Yielding yielding;        ///< a rigid building has none: it would have no yield displacement
};

/// The coupled equations have one solution, and only one, while the block is in contact with the
/// roof: 1 + (m/M) sin(slope) (sin(slope) - mu cos(slope)) > 0 on the side the roof falls to.
/// Beyond it friction locks the block against the roof as in Painleve's rod (1895). It holds for
/// every slope where sqrt(1 + mu^2) < 1 + 2 M/m: for mu up to 2.8 at m/M = 1, 4.8 at 0.5.
bool coupling_is_regular(const Block& block, double mass_ratio);

/// Per unit mass of the building, J/kg = m2/s2, with velocities relative to the ground (Uang &
/// Bertero 1990, Earthquake Engng Struct. Dyn. 19:77-90, "relative" energy), from rest to the
/// history's end (or to 120 s after the record, where an undamped building is given up on):
/// input + gravity = kinetic + strain + damped + hysteretic + friction, to 1e-10 of the largest.
struct CoupledEnergy {
  double input_m2ps2 = 0.0;       ///< work of the inertia forces the ground's acceleration causes
  double gravity_m2ps2 = 0.0;     ///< work of the array's weight, positive where it slid down
  double kinetic_m2ps2 = 0.0;     ///< of building and array, at the end
  double strain_m2ps2 = 0.0;      ///< at the end, what the spring can give back
  double damped_m2ps2 = 0.0;      ///< by the building's damping
  double friction_m2ps2 = 0.0;    ///< below the array
  double hysteretic_m2ps2 = 0.0;  ///< by the spring's yielding
};

struct CoupledResult {
  SlipResult slip;
  double peak_base_shear = 0.0;  ///< max |c u' + spring| / (M g), per weight of the building alone
  double peak_roof_displacement_m = 0.0;     ///< max |u|, relative to the ground
  double peak_roof_acceleration_mps2 = 0.0;  ///< max |a|, absolute
  double ductility = 0.0;  ///< max |u| over the yield displacement, below 1 where it stays elastic;
                           ///< 0 where there is no yield force
  double residual_roof_displacement_m = 0.0;  ///< where the spring pulls nothing in the end; +x
  CoupledEnergy energy;
};

/// A point of a coupled history: at each sample and each event between samples.
struct CoupledPoint {
  double time_s = 0.0;
  double displacement_m = 0.0;       ///< of the block, in plan, downslope positive
  double velocity_mps = 0.0;         ///< the same
  double roof_displacement_m = 0.0;  ///< relative to the ground, +x
  double roof_acceleration_mps2 =
      0.0;  ///< absolute, +x; after the event where the event changes it
  double spring_acceleration_mps2 = 0.0;  ///< the spring's force over M: its loop against u
};

/// The sliding block on a building that feels it, from rest, event by event. With r = m/M,
/// g' = g + w, sigma = sgn v, and E = -(2 zeta omega u' + omega^2 u) of the building alone, the
/// free bodies of block and roof give (theory.md, 2.2)
///   stuck:    (1 + r) a = E
///   sliding:  D a = E - r cos(slope) q g',   q = sin(slope) - sigma mu cos(slope),
///             D = 1 + r sin(slope) q,        v' = q g' - a (cos(slope) + sigma mu sin(slope))
///   N/m = g' cos(slope) + a sin(slope)
/// Put into v', the first two give v' = (1 + r)/D times the v' the uncoupled block would have at
/// the stuck a. So with D > 0 the uncoupled rule decides: at v = 0 the block starts downslope where
/// that v' is positive for sigma = +1, upslope where it is negative for sigma = -1, and is held
/// otherwise; while N >= 0 exactly one of the three is true. Where N < 0 there is no friction; the
/// block is flagged as lifted and kept on the roof's plane.
///
/// A spring that yields has the force M f, f = alpha omega^2 u + (1 - alpha) z in place of omega^2
/// u: z follows omega^2 u, but no further than the yield acceleration; it is held there from the
/// instant it reaches it until u' changes sign. Between these events f is linear in u.
///
/// With a static_ratio above 1 the block starts where it would with static_ratio mu, and then at
/// once with the v' that mu gives. Where tan(slope) lies between the two, it rests until it is
/// shaken loose, and its history ends with the record.
///
/// Each phase is a linear oscillator of mass D M under a forcing linear in time, solved by its
/// power series over pieces of at most 1/16 period (exact to rounding); slip and its speed are the
/// series' integrals; events are the first roots of series, found without missing any and taken to
/// rounding. Accuracy 1e-11 of the peak against 50 digits (tests/unit/block/coupled_test.cpp).
///
/// After the last sample the ground goes linearly to zero over one more interval and the building
/// rings on, until the block rests and can no longer start, the spring can no longer yield and the
/// building's own peaks are past, or for 120 s; a block still on its way then stops as on a roof at
/// rest. Blocks that friction cannot stop end with the record.
///
/// This is the readable reference. m/M = 0 is the uncoupled block; period 0 a rigid building.
/// @param ground its vertical acceleration is the roof's
/// @pre coupling_is_regular(block, building.mass_ratio); friction that does not depend on speed; a
/// spring that yields: yield acceleration > 0, hardening ratio in [0, 1), and a period the record's
/// step can show (above 1/50 of it)
CoupledResult slide_coupled(const GroundMotion& ground, const MotionFactors& factors,
                            const CoupledBuilding& building, const Block& block);

/// The same, and what happened on the way.
CoupledResult slide_coupled(const GroundMotion& ground, const MotionFactors& factors,
                            const CoupledBuilding& building, const Block& block,
                            std::vector<CoupledPoint>& history);

/// The same, and when the displacement first has each of these sizes: exact, to rounding. One that
/// is reached only where a phase of sliding ends is reached with speed 0.
/// @param thresholds_m > 0, increasing
/// @param crossings as many
CoupledResult slide_coupled(const GroundMotion& ground, const MotionFactors& factors,
                            const CoupledBuilding& building, const Block& block,
                            std::span<const double> thresholds_m, std::span<Crossing> crossings);

}  // namespace glissade
