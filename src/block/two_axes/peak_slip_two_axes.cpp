// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "block/full_model/building_axis.hpp"
#include "block/two_axes/pool/pool.hpp"
#include "block/two_axes/scene.hpp"
#include "glissade/block/two_axis_lanes.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"

namespace glissade {

namespace two_axes = block_detail::two_axes;

struct TwoAxisLanes::State : two_axes::UnderMotion {};

TwoAxisLanes::TwoAxisLanes(const BuildingGround& ground, double tolerance)
    : state_(std::make_unique<State>(State{{ground, tolerance}})) {
  require_tolerance(tolerance, 1e-9);
}

TwoAxisLanes::~TwoAxisLanes() = default;

const BuildingGround& TwoAxisLanes::ground() const { return state_->ground; }

void TwoAxisLanes::slide(std::span<const TwoAxisScene> scenes, std::span<BuildingPeak> peaks,
                         std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  GLISSADE_EXPECTS(scenes.size() == peaks.size());
  GLISSADE_EXPECTS(crossings.size() == scenes.size() * thresholds_m.size());
  const double dt_s = state_->ground.horizontal[0]->step_s();
  std::vector<TwoAxisScene> of_modes;  // all, if there are modes
  if (std::ranges::any_of(scenes,
                          [](const TwoAxisScene& s) { return two_axes::modes_of(s) > 1; })) {
    of_modes.assign(scenes.begin(), scenes.end());
    for (TwoAxisScene& scene : of_modes)
      for (Modes& axis : scene.building.horizontal)
        if (axis.size() > 1) axis = block_detail::responding(axis, dt_s);
    scenes = of_modes;
  }
  const two_axes::Batch batch{scenes, peaks, thresholds_m, crossings};
  std::map<std::pair<two_axes::RoofKind, two_axes::Friction>, std::vector<std::size_t>> tasks;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const TwoAxisScene& s = scenes[k];
    require_finite_scene(s.building, s.block, s.factors);
    GLISSADE_EXPECTS(s.block.directions == SlipDirections::both);
    if (two_axes::fits_lanes(s, state_->ground))
      tasks[{two_axes::roof_of(s), two_axes::friction_of(s)}].push_back(k);
    else
      state_->by_reference(batch, k);
  }
  for (auto& [kind, of_kind] : tasks) {
    std::ranges::stable_sort(of_kind, {},
                             [&](std::size_t k) { return two_axes::key_of(scenes[k].building); });
    two_axes::Pool(*state_, kind.first, kind.second, batch).run(of_kind);
  }
}

void peak_slip_two_axes(const BuildingGround& ground, std::span<const TwoAxisScene> scenes,
                        std::span<BuildingPeak> peaks, double tolerance) {
  TwoAxisLanes(ground, tolerance).slide(scenes, peaks);
}

}  // namespace glissade
