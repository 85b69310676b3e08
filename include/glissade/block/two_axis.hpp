// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glissade/block/friction_law.hpp"
#include "glissade/core/units.hpp"

namespace glissade {

/// A coefficient of friction for each axis of the slope. Friction lies on an ellipse with these
/// half-axes; on a circle where they are equal.
struct EllipticFriction {
  double along = 0.0;   ///< in the direction the surface falls; >= 0
  double across = 0.0;  ///< >= 0, and zero only where the other is
};

/// A rigid block, which does not turn, held on a sloping roof by Coulomb friction alone.
struct TwoAxisBlock {
  EllipticFriction friction;
  double slope_rad = 0.0;    ///< in [0, pi/2)
  double azimuth_rad = 0.0;  ///< from the roof's first axis to where the surface falls, toward the
                             ///< second axis. On a flat roof it turns the axes of friction.
  double gravity_mps2 = standard_gravity_mps2;  ///< > 0
  FrictionLaw law = {};                         ///< slide_two_axis(): Coulomb's only
};

/// Absolute acceleration of the roof along two horizontal axes at right angles, and up; piecewise
/// linear between equally spaced samples.
struct TwoAxisAcceleration {
  double dt_s = 0.0;                                            ///< > 0
  std::array<std::span<const double>, 2> horizontal_mps2 = {};  ///< the second may be empty: none
  std::span<const double> vertical_mps2 = {};  ///< empty: none; else as long as the first
  double horizontal_factor = 1.0;              ///< on both axes
  double vertical_factor = 1.0;
};

/// A vector in plan, in the axes of the slope.
struct PlanVector {
  double along_m = 0.0;   ///< positive where the surface falls
  double across_m = 0.0;  ///< positive a quarter turn on, from the first axis toward the second
};

/// What a history did: displacement and velocity of the block relative to the roof, in plan.
struct TwoAxisResult {
  double peak_displacement_m = 0.0;  ///< largest length of the displacement vector
  PlanVector peak_by_axis;           ///< largest |displacement| along each axis, whenever
  double peak_downslope_m = 0.0;     ///< >= 0
  double peak_upslope_m = 0.0;       ///< >= 0
  PlanVector residual;               ///< signed, when the block has come to rest
  double path_length_m = 0.0;
  double peak_velocity_mps = 0.0;  ///< largest length of the velocity vector
  double slip_duration_s = 0.0;    ///< time spent sliding
  std::size_t slip_phases = 0;     ///< runs of sliding from rest to rest
  bool uplift = false;             ///< see SlipResult
  bool free_sliding = false;       ///< see SlipResult
};

/// The SRSS of the two axes' separate maxima: the displacement of a history by Walters et al.
/// (2012). Not less than the vector's own peak, and at most sqrt(2) times that.
double srss_of_maxima_m(const TwoAxisResult& result);

/// The sliding block on two axes, from rest. With the slip (s, y) in the roof's plane, s where it
/// falls, and v = (s', y') (theory.md, 3.1):
///   N/m = (g + w) cos(slope) + a_s sin(slope)
///   v'  = d - N/m (mu_s^2 v_s, mu_y^2 v_y) / sqrt(mu_s^2 v_s^2 + mu_y^2 v_y^2)
///   d   = ((g + w) sin(slope) - a_s cos(slope), -a_y)
///   stick while v = 0 and (d_s / mu_s)^2 + (d_y / mu_y)^2 <= (N/m)^2
/// d and N are linear in time over a sample interval, and the states in which the block may rest
/// are a convex cone of (d, N): between two of them it rests, and it leaves them at the root of a
/// quadratic.
///
/// Sliding is integrated by SDIRK4 (Hairer & Wanner 1996, Solving ODEs II, section IV.6: order 4,
/// L-stable) with error control. Friction makes v contract: |v1 - v2| of two solutions never grows,
/// so local errors only add up; and it is stiff where |v| is small, which an L-stable method passes
/// without small steps. Its stages need no iteration on the circle: each is v = p - h N f(v),
/// solved by shortening p (Moreau 1988; the return mapping of plasticity). Displacement and its
/// peaks are those of the cubic through the velocities and accelerations at a step's ends.
///
/// A block comes to rest with its velocity turning toward d, by a law too singular for any step:
/// with d and N constant on the circle (n = mu N/m > |d|), n |v| + v.d is linear in time, and the
/// block rests after
///   T = (n |v| + v.d) / (n^2 - |d|^2),   displaced by beta v + gamma d,
///   beta = (2 n |v| + v.d) / (4 n^2 - |d|^2),   gamma = (|v|^2 + 3 beta v.d) / (4 (n^2 - |d|^2)).
/// A straight path ends at the root of a quadratic, as in slide(). Steps shrink toward the stop
/// until one of the two is as exact as asked.
///
/// What moves along one line agrees with slide() to rounding (tests/unit/block). The end of the
/// record and uplift are as in slide().
///
/// @param tolerance allowed error of the velocity a step, relative to the largest speed so far; in
///   [1e-9, 1e-2]. Displacements are then off by about as much, relative to the peak: on recorded
///   motions 96 scenes gave a median of 0.1 and at most 3 tolerances. Where slip is a hundred short
///   phases of rough noise, up to 30 (tests/unit/block/two_axis_truth_test.cpp).
TwoAxisResult slide_two_axis(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                             double tolerance = 1e-6);

/// A point of a history: at each start, step and stop.
struct TwoAxisPoint {
  double time_s = 0.0;
  PlanVector displacement;
};

/// The same, and what happened on the way.
TwoAxisResult slide_two_axis(const TwoAxisAcceleration& roof, const TwoAxisBlock& block,
                             std::vector<TwoAxisPoint>& history, double tolerance = 1e-6);

}  // namespace glissade
