// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/scene.hpp"

#include <algorithm>
#include <limits>
#include <span>

namespace glissade {

RoofMotionOptions follow_roof(std::span<const Block> blocks, double largest_factor) {
  double yield = std::numeric_limits<double>::infinity(), deceleration = yield;
  for (const Block& block : blocks) {
    const double at_rest = resting_deceleration_mps2(block);
    if (at_rest == 0.0) continue;
    yield = std::min(yield, yield_acceleration_mps2(block));
    deceleration = std::min(deceleration, at_rest);
  }
  if (deceleration == std::numeric_limits<double>::infinity()) return {};
  // The yield acceleration is in proportion to g + w, so leaving 2 % of g to the vertical's
  // ring-down takes 2 % off the horizontal's limit.
  return {.quiet_horizontal_mps2 = 0.98 * yield / largest_factor,
          .quiet_vertical_mps2 = 0.02 * standard_gravity_mps2 / largest_factor,
          .settle_deceleration_mps2 = deceleration / largest_factor};
}

RoofAcceleration excitation_of(const Block& block, const RoofMotion& roof,
                               const MotionFactors& factors) {
  RoofAcceleration excitation{roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2,
                              factors.horizontal, factors.vertical};
  if (resting_deceleration_mps2(block) == 0.0) {
    excitation.horizontal_mps2 = excitation.horizontal_mps2.first(roof.record_samples);
    if (!excitation.vertical_mps2.empty())
      excitation.vertical_mps2 = excitation.vertical_mps2.first(roof.record_samples);
  }
  return excitation;
}

BuildingGround building_ground(const Motion& motion, const Oscillator& vertical,
                               const RoofMotionOptions& follow) {
  const int own_parts = motion.vertical_mps2.empty() ? 0 : parts_needed(vertical, motion.dt_s);
  const int parts = std::max(1, own_parts);
  const auto tabulated = [&](std::span<const double> component) {
    return component.empty() ? nullptr
                             : std::make_shared<GroundTable>(motion.dt_s, component, parts);
  };
  BuildingGround ground{
      {tabulated(motion.horizontal_mps2[0]), tabulated(motion.horizontal_mps2[1])}, nullptr};
  const std::shared_ptr<GroundTable> up = tabulated(motion.vertical_mps2);
  if (!up) return ground;
  const auto table = std::make_shared<MotionTable>();
  if (own_parts == 0) {
    *table = tabulate_rigid(up);
  } else {
    const RoofMotionOptions options = for_vertical(follow);
    tabulate_responses(up, {&vertical, 1}, {&options, 1}, {table.get(), 1});
  }
  ground.vertical = table;
  return ground;
}

}  // namespace glissade
