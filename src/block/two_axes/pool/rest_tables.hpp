// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "block/two_axes/roof/tables.hpp"
#include "glissade/block/two_axis_lanes.hpp"

namespace glissade::block_detail::two_axes {

/// What histories on one table have in common.
using BuildingKey = std::tuple<Modes, Modes, double>;
BuildingKey key_of(const BiaxialBuilding& building);

/// Of an axis, at most.
std::size_t modes_of(const TwoAxisScene& scene);

/// The tables of the last buildings. One that a history still needs lives on; the memory of others
/// is used again.
class RestTables {
 public:
  std::shared_ptr<const RestTable> of(const TwoAxisScene& scene, const GroundNodes& nodes,
                                      RoofKind roof);

 private:
  std::vector<std::pair<BuildingKey, std::shared_ptr<RestTable>>> kept_;
};

}  // namespace glissade::block_detail::two_axes
