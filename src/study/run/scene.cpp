// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/scene.hpp"

#include <algorithm>
#include <cmath>

namespace glissade {

void LeastAccelerations::include(const Block& block) {
  const double at_rest = resting_deceleration_mps2(block);
  if (at_rest == 0.0) return;
  yield_mps2 = std::min(yield_mps2, yield_acceleration_mps2(block));
  deceleration_mps2 = std::min(deceleration_mps2, at_rest);
}

RoofMotionOptions follow_roof(std::span<const Block> blocks, double largest_factor) {
  LeastAccelerations least;
  for (const Block& block : blocks) least.include(block);
  return follow_roof(least, largest_factor);
}

RoofMotionOptions follow_roof(const LeastAccelerations& least, double largest_factor) {
  if (std::isinf(least.deceleration_mps2)) return {};
  // The yield acceleration is in proportion to g + w, so leaving 2 % of g to the vertical's
  // ring-down takes 2 % off the horizontal's limit.
  return {.quiet_horizontal_mps2 = 0.98 * least.yield_mps2 / largest_factor,
          .quiet_vertical_mps2 = 0.02 * standard_gravity_mps2 / largest_factor,
          .settle_deceleration_mps2 = least.deceleration_mps2 / largest_factor};
}

RoofAcceleration excitation_of(const Block& block, const RoofMotion& roof,
                               const MotionFactors& factors) {
  RoofAcceleration excitation{roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2,
                              factors.horizontal[0], factors.vertical};
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
  ground.vertical = std::make_shared<MotionTable>(
      own_parts == 0 ? tabulate_rigid(up) : tabulate_response(up, vertical, for_vertical(follow)));
  return ground;
}

}  // namespace glissade
