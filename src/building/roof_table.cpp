// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/roof_table.hpp"

#include <algorithm>

#include "glissade/core/contract.hpp"

namespace glissade {
namespace {

std::shared_ptr<MotionTable> tabulate(const Oscillator& oscillator, double dt_s,
                                      std::span<const double> ground_mps2, int parts,
                                      const RoofMotionOptions& follow) {
  const auto ground = std::make_shared<GroundTable>(dt_s, ground_mps2, parts);
  if (parts_needed(oscillator, dt_s) == 0)
    return std::make_shared<MotionTable>(tabulate_rigid(ground));
  return std::make_shared<MotionTable>(tabulate_response(ground, oscillator, follow));
}

}  // namespace

RoofTable::RoofTable(std::shared_ptr<const MotionTable> along,
                     std::shared_ptr<const MotionTable> up)
    : horizontal(std::move(along)), vertical(std::move(up)) {
  GLISSADE_EXPECTS(horizontal && (!vertical || (vertical->step_s() == horizontal->step_s() &&
                                                vertical->nodes > horizontal->end &&
                                                horizontal->nodes > vertical->end)));
}

RoofTable::RoofTable(double dt_s, std::span<const double> horizontal_mps2,
                     std::span<const double> vertical_mps2)
    : RoofTable(tabulate_roof({dt_s, horizontal_mps2, vertical_mps2}, {}, {})) {}

RoofTable tabulate_roof(const GroundMotion& ground, const Building& building,
                        const RoofMotionOptions& follow) {
  const bool both = !ground.vertical_mps2.empty();
  const int parts = std::max({1, parts_needed(building.horizontal, ground.dt_s),
                              both ? parts_needed(building.vertical, ground.dt_s) : 1});
  const auto along =
      tabulate(building.horizontal, ground.dt_s, ground.horizontal_mps2, parts, follow);
  if (!both) return {along, nullptr};
  const auto up =
      tabulate(building.vertical, ground.dt_s, ground.vertical_mps2, parts, for_vertical(follow));
  extend(*along, up->nodes);
  extend(*up, along->nodes);
  return {along, up};
}

}  // namespace glissade
