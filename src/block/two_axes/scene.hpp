// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/two_axes/roof/tables.hpp"
#include "glissade/block/two_axis_lanes.hpp"
#include "lane_states.hpp"

namespace glissade::block_detail::two_axes {

/// Whether the lanes can take a history: a circle of Coulomb friction that
/// stops the block, an elastic building of periods the ground's step resolves,
/// a rigid vertical, and no uplift while the block rests.
bool fits_lanes(const TwoAxisScene& scene, const BuildingGround& ground, const GroundNodes& nodes);

RoofKind roof_of(const TwoAxisScene& scene);

Constants<double> constants_of(const TwoAxisScene& scene, double tolerance);

}  // namespace glissade::block_detail::two_axes
