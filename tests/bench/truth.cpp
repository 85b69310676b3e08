// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth.hpp"

#include <algorithm>
#include <thread>

#include "unit/block/oscillator_reference.hpp"
#include "unit/block/reference.hpp"

namespace glissade::bench {
namespace {

using test::Component;
using test::StandardScene;
using test::StandardScenes;

/// The oscillator's truth follows the ring-down by so much longer than the schemes do.
constexpr double longer_s = 20.0;

Truth truth_of(const StandardScene& scene, const StandardScenes& all) {
  const Component& component = all.components[scene.component];
  const test::RoofInput input = test::roof_input(component, scene.period_s);
  const RoofMotion roof = roof_motion(input.ground, input.building, input.follow);
  RoofAcceleration excitation = scene.excitation(all.components, roof);
  Block block = scene.block;
  double factor = scene.factor(all.components);
  const test::Reference exact(excitation, block);
  if (block.slope_rad < 0.0) {  // mirrored: the oscillator's reference takes slopes >= 0
    block.slope_rad = -block.slope_rad;
    excitation.horizontal_factor = -excitation.horizontal_factor;
    factor = -factor;
  }
  Truth truth{.samples_m = static_cast<double>(exact.down > exact.up ? exact.down : exact.up),
              .uplift = exact.uplift};
  if (scene.period_s == 0.0) {
    truth.oscillator_m = truth.samples_m;
  } else if (!scene.vertical && resting_deceleration_mps2(block) > 0.0) {
    const double ring_down_s =
        static_cast<double>(roof.horizontal_mps2.size() - roof.record_samples) * roof.dt_s;
    const test::OscillatorReference smooth(component.dt_s, component.horizontal_mps2,
                                           scene.period_s, 0.05, factor, block,
                                           ring_down_s + longer_s);
    truth.oscillator_m = std::max(smooth.down, smooth.up);
  }
  block.directions = SlipDirections::downslope_only;
  truth.one_way_m = slide(excitation, block).peak_displacement_m;
  return truth;
}

}  // namespace

std::vector<Truth> truths_of(const StandardScenes& all, const std::vector<bool>& chosen) {
  std::vector<std::size_t> wanted;
  for (std::size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i]) wanted.push_back(i);
  std::vector<Truth> truths(all.scenes.size());
  const auto work = [&](std::size_t first) {
    for (std::size_t k = first; k < wanted.size(); k += 2)
      truths[wanted[k]] = truth_of(all.scenes[wanted[k]], all);
  };
  std::thread other(work, 1);
  work(0);
  other.join();
  return truths;
}

}  // namespace glissade::bench
