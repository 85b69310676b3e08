// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/coupled.hpp"

namespace glissade::bench {

/// slide_coupled()'s problem as a structural program has it: the array on its roof by a friction
/// isolator, an elastic spring and a slider in series (as tests/elastic_link, with that stiffness:
/// 100 N/mm for a weight of 1 N), both masses stepped by Newmark's average acceleration. Per mass
/// of building and of array:
///   (1 + r) (u'' + ag) + r cos(slope) s'' + 2 zeta omega u' + omega^2 u = 0
///   s'' + cos(slope) (u'' + ag) + f = g' sin(slope),   |f| <= mu N
/// A step is tried with the spring elastic, and where f is then too large made again with the
/// slider slipping. From static equilibrium; after the record until nothing can slip any more.
///
/// @param building linear, not rigid
/// @param block slips both ways, with tan(slope) < mu
/// @param substeps >= 1: each sample interval is cut into so many by linear interpolation
/// @return largest |displacement| of the slider, in plan, m
double coupled_link_peak_m(const GroundMotion& ground, const MotionFactors& factors,
                           const CoupledBuilding& building, const Block& block, int substeps);

}  // namespace glissade::bench
