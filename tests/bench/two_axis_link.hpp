// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "glissade/block/on_building.hpp"

namespace glissade::bench {

/// What shakes the building, as sampled.
struct SampledGround {
  double dt_s = 0.0;
  std::array<std::span<const double>, 2> horizontal_mps2;
  std::span<const double> vertical_mps2;  ///< empty: none
};

/// slide_on_building()'s problem as a structural program has it: the array on its roof by a
/// friction isolator whose shear is elastic in any direction up to a circle of radius mu N (as
/// tests/elastic_link, with that stiffness: 100 N/mm for a weight of 1 N), all stepped by Newmark's
/// method with gamma = 1/2 and beta = 0; stable where a substep is below 2 ms. The isolator's force
/// and the building's damping are taken at the motion predicted, the normal force from the step
/// before. From static equilibrium; after the record until nothing can slip any more.
///
/// @param building linear; both its axes rigid or neither
/// @param block a circle of Coulomb friction, tan(slope) < mu
/// @param substeps >= 1: each sample interval is cut into so many by linear interpolation
/// @return largest length of the slider's displacement, in plan, m
double two_axis_link_peak_m(const SampledGround& ground, const MotionFactors& factors,
                            const BiaxialBuilding& building, const Block& block, int substeps);

}  // namespace glissade::bench
