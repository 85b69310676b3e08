// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "glissade/block/crossing.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/building/yielding.hpp"

namespace glissade {

/// A building coupled with the array on its roof, linear unless its spring yields. The vertical
/// acceleration of the roof is that of the ground.
struct CoupledBuilding {
  Oscillator horizontal;    ///< of the building alone, without the array
  double mass_ratio = 0.0;  ///< m/M, mass of the array over mass of the building, >= 0
  Yielding yielding;        ///< none for a rigid building, which has no yield displacement
};

/// The coupled equations have one solution, and only one, while the block is in contact with the
/// roof: 1 + (m/M) sin(slope) (sin(slope) - mu cos(slope)) > 0 on the side to which the roof falls.
/// Otherwise friction can lock the block against the roof (Painleve 1895). It is true for every
/// slope if sqrt(1 + mu^2) < 1 + 2 M/m: for mu up to 2.8 at m/M = 1, 4.8 at 0.5.
bool coupling_is_regular(const Block& block, double mass_ratio);

/// Per unit mass of the building, J/kg = m2/s2, with velocities relative to the ground (Uang &
/// Bertero 1990, Earthquake Engng Struct. Dyn. 19:77-90, "relative" energy), from rest to the
/// end of the history (for an undamped building to 120 s after the record):
/// input + gravity = kinetic + strain + damped + hysteretic + friction, to 1e-10 of the largest.
struct CoupledEnergy {
  double input_m2ps2 = 0.0;       ///< work of the inertia forces due to the ground acceleration
  double gravity_m2ps2 = 0.0;     ///< work of the weight of the array, positive if it slid down
  double kinetic_m2ps2 = 0.0;     ///< of building and array, at the end
  double strain_m2ps2 = 0.0;      ///< elastic energy of the spring, at the end
  double damped_m2ps2 = 0.0;      ///< dissipated by the damping of the building
  double friction_m2ps2 = 0.0;    ///< dissipated between array and roof
  double hysteretic_m2ps2 = 0.0;  ///< dissipated by yielding of the spring
};

struct CoupledResult {
  SlipResult slip;
  double peak_base_shear = 0.0;  ///< max |c u' + spring| / (M g), per weight of the building alone
  double peak_roof_displacement_m = 0.0;     ///< max |u|, relative to the ground
  double peak_roof_acceleration_mps2 = 0.0;  ///< max |a|, absolute
  double ductility = 0.0;  ///< max |u| over the yield displacement, below 1 if it stays elastic;
                           ///< 0 if there is no yield force
  double residual_roof_displacement_m = 0.0;  ///< where the spring force is zero at the end; +x
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

/// The sliding block on a coupled building, from rest, event by event. With r = m/M,
/// g' = g + w, sigma = sgn v, and E = -(2 zeta omega u' + omega^2 u) of the building alone, the
/// free bodies of block and roof give (theory.md, 2.2)
///   stuck:    (1 + r) a = E
///   sliding:  D a = E - r cos(slope) q g',   q = sin(slope) - sigma mu cos(slope),
///             D = 1 + r sin(slope) q,        v' = q g' - a (cos(slope) + sigma mu sin(slope))
///   N/m = g' cos(slope) + a sin(slope)
/// From the first two, v' is (1 + r)/D times the v' of the uncoupled block at the stuck a. So with
/// D > 0 the uncoupled condition decides: at v = 0 the block starts downslope if that v' is
/// positive for sigma = +1, upslope if it is negative for sigma = -1, and sticks otherwise; while N
/// >= 0 exactly one of the three is true. While N < 0 there is no friction; the history is flagged
/// as uplift and the block stays in the plane of the roof.
///
/// A yielding spring (theory.md, 2.3) has the force M f, f = alpha omega^2 u + (1 - alpha) z in
/// place of omega^2 u: z follows omega^2 u up to the yield acceleration and is constant from then
/// on until u' changes sign. Between these events f is linear in u.
///
/// With a static_over_sliding above 1 the block starts when static_over_sliding mu is exceeded, and
/// then has the v' of mu. If tan(slope) is between the two, the block rests until it first moves,
/// and its history ends with the record.
///
/// Each phase is a linear oscillator of mass D M under a forcing linear in time, solved by its
/// power series over pieces of at most 1/16 period (exact to rounding); slip and its speed are the
/// integrals of the series; events are the first roots of series, none is missed, and they are
/// exact to rounding. Accuracy 1e-11 of the peak against 50 digits
/// (tests/unit/block/coupled_test.cpp).
///
/// End of the record (theory.md, 1.6): the ring-down of the building is followed until the block
/// rests and can no longer start, the spring can no longer yield and the peaks of the building are
/// past, or for 120 s; a block that still slides then stops as on a roof at rest. Free sliding ends
/// with the record.
///
/// This is the scalar reference. m/M = 0 is the uncoupled block; is_rigid() of rigid.hpp
/// decides what is a rigid building, which cannot yield (InputError).
/// @param ground its vertical acceleration is that of the roof
/// @pre coupling_is_regular(block, building.mass_ratio); friction that does not depend on speed;
/// for a yielding spring: yield acceleration > 0, hardening ratio in [0, 1)
///
/// The first crossing of each threshold is exact to rounding. One that is reached only at the end
/// of a phase of sliding is reached with speed 0.
/// @param thresholds_m > 0, increasing
/// @param crossings as many
CoupledResult slide_coupled(const GroundMotion& ground, const MotionFactors& factors,
                            const CoupledBuilding& building, const Block& block,
                            std::span<const double> thresholds_m = {},
                            std::span<Crossing> crossings = {});

/// The same, with the history.
CoupledResult slide_coupled(const GroundMotion& ground, const MotionFactors& factors,
                            const CoupledBuilding& building, const Block& block,
                            std::vector<CoupledPoint>& history);

}  // namespace glissade
