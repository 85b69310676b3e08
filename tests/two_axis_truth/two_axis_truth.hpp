// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "glissade/block/on_building.hpp"
#include "two_axis_truth/radau.hpp"

namespace glissade::test {

/// A building along an axis by the masses of its floors and the stiffnesses of the storeys below
/// them, from the ground up, at most three, with this damping ratio in every mode. Without floors
/// it is the one mass of the scene.
struct ShearBuilding {
  std::vector<double> masses = {}, stiffnesses = {};
  double damping_ratio = 0.05;
};

/// One history: samples of the ground along the axes of the building and of the rigid vertical,
/// each times its factor. An empty component is zero.
struct TruthScene {
  double dt_s = 0.0;
  std::array<std::span<const double>, 2> ground_mps2;
  std::span<const double> vertical_mps2 = {};
  MotionFactors factors = {};
  BiaxialBuilding building = {};  ///< of one mass along each axis, or by storeys
  Block block = {};
  std::array<ShearBuilding, 2> storeys = {};
};

/// The sliding block on two axes and its building in long double, from the free bodies of
/// theory.md, 3.1 to 3.5, and by other methods than src/block, with which it shares no code.
///
/// Block and building are one system, y = (u, u', v), with u of every floor and the full matrices
/// of mass, damping and stiffness: sliding is Radau IIA with five stages (order
/// 9). The stages are found by Newton's method for the velocity of the block and by substitution
/// for the building. A step is accepted when two halves agree with it. At rest the building is a
/// power series, and sliding starts at the first root of a polynomial that bounds on its second
/// derivative leave no room to miss. A block stops at 1e-13 of its largest speed, on a straight
/// line. Elastic buildings with any friction law; blocks that friction stops.
struct TwoAxisTruth {
  Long peak_m = 0, peak_along_m = 0, peak_across_m = 0;  ///< in plan, largest at any time
  Long along_m = 0, across_m = 0;                        ///< in plan, at the end
  /// Of the building, at the ends of steps while the block slides; |base shear| over its mass.
  std::array<Long, 2> sliding_shear{}, sliding_roof_m{};
  int phases = 0;
  bool uplift = false;

  /// @param tolerance of the velocity for each step, relative to the largest speed so far
  explicit TwoAxisTruth(const TruthScene& scene, double tolerance = 1e-11);
};

}  // namespace glissade::test
