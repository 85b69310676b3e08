// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/pool/pool.hpp"

#include "block/two_axes/scene.hpp"
#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail::two_axes {
namespace {

/// Of lanes, as bits.
template <class What>
void for_each(std::uint64_t lanes, const What& what) {
  for (; lanes != 0; lanes &= lanes - 1) what(static_cast<std::size_t>(std::countr_zero(lanes)));
}

}  // namespace

void UnderMotion::by_reference(const Batch& batch, std::size_t k) const {
  const TwoAxisScene& scene = batch.scenes[k];
  try {
    const BuildingSlip on_building =
        slide_on_building(ground, scene.factors, scene.building, scene.block, batch.thresholds_m,
                          batch.crossings_of(k), tolerance);
    batch.peaks[k] = {on_building.slip,
                      scene.base_shear ? on_building.peak_base_shear : std::array{0.0, 0.0}};
  } catch (const NotConverged&) {
    batch.peaks[k] = {};
    batch.peaks[k].failed = true;
  }
}

void Pool::run(std::span<const std::size_t> tasks) {
  tasks_ = tasks;
  for (const std::size_t k : tasks) {
    if (roof_ == RoofKind::coupled_modes)
      taylor_.lanes.modes = std::max(taylor_.lanes.modes, modes_of(batch_.scenes[k]));
    taylor_.lanes.follows_shear |= batch_.scenes[k].base_shear;
  }
  implicit_.lanes.modes = taylor_.lanes.modes;
  implicit_.lanes.follows_shear = taylor_.lanes.follows_shear;
  for (;;) {
    while (next_ < tasks_.size() && underway_ < most_underway) begin(tasks_[next_++]);
    for (OwnedLanes* lanes : {&taylor_, &implicit_}) lanes->fill();
    if (underway_ == 0) return;
    const bool many = implicit_.size() >= std::min(enough, taylor_.size());
    step(many ? implicit_ : taylor_);
  }
}

void Pool::begin(std::size_t scene) {
  const TwoAxisScene& s = batch_.scenes[scene];
  auto table = motion_.tables.of(s, motion_.nodes, roof_);
  if (!table->usable()) return motion_.by_reference(batch_, scene);
  ++underway_;
  auto next = std::make_unique<Underway>(Underway{
      LaneHistory(constants_of(s, motion_.tolerance), roof_, motion_.nodes, std::move(table),
                  DistanceCrossings(batch_.thresholds_m, batch_.crossings_of(scene)), s.base_shear),
      {},
      scene});
  go_on(std::move(next), &LaneHistory::begin);
}

void Pool::step(OwnedLanes& owned) {
  const GroundNodes& nodes = motion_.nodes;
  const GroundRows ground{nodes.nodes.data(), static_cast<std::int64_t>(nodes.quiet), nodes.dt_s,
                          motion_.ground.vertical != nullptr};
  LaneStates& lanes = owned.lanes;
  const Stepped stepped = two_axes::step(lanes, ground, roof_, friction_, owned.kind);
  const std::uint64_t too_long =
      owned.kind == StepKind::implicit ? owned.count(most_implicit_steps()) : 0;
  for_each(stepped.lifted, [&](std::size_t lane) { owned.owners[lane]->history.lifted(); });
  for_each(stepped.shear, [&](std::size_t lane) {
    LaneHistory& history = owned.owners[lane]->history;
    history.raise_shear(lanes, lane);
    owned.keep_shear(lane, history);
  });
  for_each(stepped.passed, [&](std::size_t lane) {
    LaneHistory& history = owned.owners[lane]->history;
    history.crossed(lanes, lane);
    lanes.next2[lane] = history.next2();
  });
  for_each(stepped.event, [&](std::size_t lane) {
    std::unique_ptr<Underway> next = owned.take(lane);
    if (owned.kind == StepKind::taylor) next->state.motion.trial = never;
    go_on(std::move(next), &LaneHistory::event);
  });
  OwnedLanes& other = owned.kind == StepKind::taylor ? implicit_ : taylor_;
  for_each(stepped.other, [&](std::size_t lane) {
    std::unique_ptr<Underway> next = owned.take(lane);
    next->state.motion.trial = never;
    next->state.motion.forced = 1.0;
    other.waiting.push_back(std::move(next));
  });
  const std::uint64_t unsupported = too_long | (owned.of_springs ? stepped.lifted : 0);
  for_each(unsupported & lanes.active,
           [&](std::size_t lane) { leave_to_reference(owned.take(lane)); });
}

void Pool::go_on(std::unique_ptr<Underway> next,
                 LaneHistory::Next (LaneHistory::*to_next)(HistoryState&)) {
  LaneHistory::Next found = LaneHistory::Next::unsupported;
  try {
    found = (next->history.*to_next)(next->state);
  } catch (const NotConverged&) {  // slide_on_building() says what it is
  }
  const bool is_too_long = next->implicit_steps > most_implicit_steps();
  const bool lifted_on_springs = roof_ == RoofKind::yielding && next->history.uplift();
  if (found == LaneHistory::Next::unsupported || lifted_on_springs ||
      (found == LaneHistory::Next::slides && is_too_long))
    return leave_to_reference(std::move(next));
  if (found == LaneHistory::Next::slides) return implicit_.waiting.push_back(std::move(next));
  --underway_;
  batch_.peaks[next->scene] = next->history.result(next->state);
}

void Pool::leave_to_reference(std::unique_ptr<Underway> next) {
  --underway_;
  motion_.by_reference(batch_, next->scene);
}

}  // namespace glissade::block_detail::two_axes
