// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <bit>
#include <memory>
#include <vector>

#include "block/two_axes/history/history.hpp"

namespace glissade::block_detail::two_axes {

/// A history that has begun.
struct Underway {
  LaneHistory history;
  HistoryState state;  ///< between lanes
  std::size_t scene;
  std::uint32_t implicit_steps = 0;  ///< so far
};

/// Lanes, and whose they are.
struct OwnedLanes {
  StepKind kind;
  bool of_springs;  ///< RoofKind::yielding
  LaneStates lanes = {};
  std::unique_ptr<Underway> owners[LaneStates::count] = {};
  std::uint32_t steps[LaneStates::count] = {};          ///< Underway::implicit_steps
  std::vector<std::unique_ptr<Underway>> waiting = {};  ///< for a lane

  bool full() const { return lanes.active == (std::uint64_t{1} << LaneStates::count) - 1; }
  std::size_t size() const { return static_cast<std::size_t>(std::popcount(lanes.active)); }

  void put(std::unique_ptr<Underway> next) {
    const auto lane = static_cast<std::size_t>(std::countr_one(lanes.active));
    LaneStates::store(lanes.constants, lane, next->history.constants());
    LaneStates::store(lanes.motion, lane, next->state.motion);
    if (lanes.modes > 0) {
      LaneStates::store(lanes.mode_constants, lane, next->history.constants().modes);
      LaneStates::store(lanes.mode_motion, lane, next->state.modes);
    }
    if (of_springs) {
      LaneStates::store(lanes.spring_constants, lane, next->history.constants().springs);
      LaneStates::store(lanes.spring_motion, lane, next->state.springs);
    }
    lanes.node[lane] = next->state.node;
    lanes.next2[lane] = next->history.next2();
    lanes.limit[lane] = next->history.limit();
    lanes.rows[lane] = next->history.rows();
    keep_shear(lane, next->history);
    steps[lane] = next->implicit_steps;
    lanes.active |= std::uint64_t{1} << lane;
    owners[lane] = std::move(next);
  }
  void keep_shear(std::size_t lane, const LaneHistory& history) {
    for (std::size_t n = 0; n < 2; ++n) lanes.shear.largest[n][lane] = history.largest_a()[n];
  }
  std::unique_ptr<Underway> take(std::size_t lane) {
    LaneStates::load(lanes.motion, lane, owners[lane]->state.motion);
    if (lanes.modes > 0) LaneStates::load(lanes.mode_motion, lane, owners[lane]->state.modes);
    if (of_springs) LaneStates::load(lanes.spring_motion, lane, owners[lane]->state.springs);
    owners[lane]->state.node = lanes.node[lane];
    lanes.node[lane] = lanes.rows[lane] = 0;  // its vector may still read there
    owners[lane]->implicit_steps = steps[lane];
    lanes.active &= ~(std::uint64_t{1} << lane);
    return std::move(owners[lane]);
  }
  /// Counts a step of every lane; the lanes, as bits, that have made more than `most`.
  std::uint64_t count(std::uint32_t most) {
    std::uint64_t beyond = 0;
    for (std::size_t lane = 0; lane < LaneStates::count; ++lane)
      beyond |= std::uint64_t{++steps[lane] > most} << lane;
    return beyond;
  }
  /// Fills the lanes; where nobody waits, moves the last to the first, so that no SIMD vector is
  /// run for one of them.
  void fill() {
    for (; !full() && !waiting.empty(); waiting.pop_back()) put(std::move(waiting.back()));
    while (static_cast<std::size_t>(std::bit_width(lanes.active)) > size())
      put(take(static_cast<std::size_t>(std::bit_width(lanes.active)) - 1));
  }
};

}  // namespace glissade::block_detail::two_axes
