// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glissade/block/slide.hpp"

namespace glissade {

/// Absolute acceleration of the roof along two horizontal axes at right angles, and up; piecewise
/// linear between equally spaced samples.
struct TwoAxisAcceleration {
  double dt_s = 0.0;                                            ///< > 0
  std::array<std::span<const double>, 2> horizontal_mps2 = {};  ///< the second may be empty: none
  std::span<const double> vertical_mps2 = {};  ///< empty: none; else as long as the first
  double horizontal_factor = 1.0;              ///< on both axes
  double vertical_factor = 1.0;
};

/// The sliding block on two axes, from rest. With the slip (s, y) in the plane of the roof, s down
/// the slope, and v = (s', y') (theory.md, 3.1):
///   N/m = (g + w) cos(slope) + a_s sin(slope)
///   v'  = d - N/m (mu_s^2 v_s, mu_y^2 v_y) / sqrt(mu_s^2 v_s^2 + mu_y^2 v_y^2)
///   d   = ((g + w) sin(slope) - a_s cos(slope), -a_y)
///   stick while v = 0 and (d_s / mu_s)^2 + (d_y / mu_y)^2 <= (N/m)^2
/// d and N are linear in time over a sample interval, and the states (d, N) in which the block
/// sticks form a convex cone: between two of them it sticks, and it starts at the root of a
/// quadratic.
///
/// Sliding is integrated by SDIRK4 (Hairer & Wanner 1996, Solving ODEs II, section IV.6: order 4,
/// L-stable) with error control. Friction is contractive: |v1 - v2| of two solutions never grows,
/// so local errors only add; and the equation is stiff for small |v|, where an L-stable method does
/// not require small steps. Its stages need no iteration on the circle: each is v = p - h N f(v),
/// solved by shortening p (Moreau 1988; the return mapping of plasticity). Displacement and its
/// peaks are those of the cubic through the velocities and accelerations at the ends of a step.
///
/// Near a stop the velocity turns toward d, singularly for any step (theory.md, 3.3): with d and N
/// constant on the circle (n = mu N/m > |d|), n |v| + v.d is linear in time, and the block stops
/// after
///   T = (n |v| + v.d) / (n^2 - |d|^2),   displaced by beta v + gamma d,
///   beta = (2 n |v| + v.d) / (4 n^2 - |d|^2),   gamma = (|v|^2 + 3 beta v.d) / (4 (n^2 - |d|^2)).
/// A straight path ends at the root of a quadratic, as in slide(). Steps are reduced toward the
/// stop until one of the two is within the tolerance.
///
/// Sliding along one line agrees with slide() to rounding (tests/unit/block). The end of the record
/// and uplift are as in slide(). It is slide_on_building() (on_building.hpp) on a rigid building
/// with a mass ratio of 0, with the same bits.
///
/// @param block Coulomb friction
/// @param tolerance permitted error of the velocity for each step, relative to the largest speed so
///   far; in [1e-11, 1e-2]. The error of displacements is measured in on_building.hpp.
SlipResult slide_two_axis(const TwoAxisAcceleration& roof, const Block& block,
                          double tolerance = 1e-6);

/// A point of a history: at each start, step and stop.
struct TwoAxisPoint {
  double time_s = 0.0;
  PlanVector displacement;
};

/// The same, with the history.
SlipResult slide_two_axis(const TwoAxisAcceleration& roof, const Block& block,
                          std::vector<TwoAxisPoint>& history, double tolerance = 1e-6);

}  // namespace glissade
