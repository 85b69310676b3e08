// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/two_axes/lanes/lane_states.hpp"
#include "block/two_axes/roof/tables.hpp"
#include "glissade/block/two_axis_lanes.hpp"

namespace glissade::block_detail::two_axes {

/// Whether the lanes can take a history: friction that stops the block at any speed, a
/// building of periods that the ground's step resolves, a rigid vertical.
bool fits_lanes(const TwoAxisScene& scene, const BuildingGround& ground);

Friction friction_of(const TwoAxisScene& scene);

RoofKind roof_of(const TwoAxisScene& scene);

SceneConstants constants_of(const TwoAxisScene& scene, double tolerance);

}  // namespace glissade::block_detail::two_axes
