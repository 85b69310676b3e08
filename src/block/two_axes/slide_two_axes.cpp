// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "glissade/block/two_axis_lanes.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/not_converged.hpp"
#include "history.hpp"
#include "scene.hpp"

namespace glissade {
namespace {

using block_detail::DistanceCrossings;
using block_detail::two_axes::Constants;
using block_detail::two_axes::GroundNodes;
using block_detail::two_axes::GroundRows;
using block_detail::two_axes::HistoryState;
using block_detail::two_axes::LaneHistory;
using block_detail::two_axes::LaneStates;
using block_detail::two_axes::RestTable;
using block_detail::two_axes::RoofKind;
using block_detail::two_axes::Stepped;

/// What histories on one table have in common.
using BuildingKey = std::tuple<double, double, double, double, double>;

BuildingKey key_of(const BiaxialBuilding& building) {
  const auto& [first, second] = building.horizontal;
  if (first.period_s == 0.0) return {};
  return {first.period_s, first.damping_ratio, second.period_s, second.damping_ratio,
          building.mass_ratio};
}

/// The tables of the last buildings. One that a history still needs lives on; the memory of others
/// is used again.
class RestTables {
 public:
  std::shared_ptr<const RestTable> of(const TwoAxisScene& scene, const GroundNodes& nodes,
                                      RoofKind roof) {
    const BuildingKey key = key_of(scene.building);
    for (const auto& [other, table] : kept_)
      if (key == other) return table;
    std::shared_ptr<RestTable> table;
    if (kept_.size() >= most_kept(nodes)) {
      if (kept_.front().second.use_count() == 1) table = std::move(kept_.front().second);
      kept_.erase(kept_.begin());
    }
    if (table == nullptr) table = std::make_shared<RestTable>();
    table->tabulate(nodes, block_detail::two_axes::constants_of(scene, 1.0), roof);
    return kept_.emplace_back(key, std::move(table)).second;
  }

 private:
  /// Each search for a capacity needs the tables of its batch again.
  static std::size_t most_kept(const GroundNodes& nodes) {
    constexpr std::size_t most_bytes = 32 << 20, rows = 6;
    const std::size_t bytes = rows * sizeof(double) * (nodes.quiet + 1);
    return std::clamp<std::size_t>(most_bytes / bytes, 2, 64);
  }
  std::vector<std::pair<BuildingKey, std::shared_ptr<RestTable>>> kept_;
};

/// Scenes under one motion, and where their results go.
struct Batch {
  std::span<const TwoAxisScene> scenes;
  std::span<TwoAxisPeak> peaks;
  std::span<const double> thresholds_m;
  std::span<Crossing> crossings;

  std::span<Crossing> crossings_of(std::size_t scene) const {
    return crossings.subspan(scene * thresholds_m.size(), thresholds_m.size());
  }
};

}  // namespace

struct TwoAxisLanes::State {
  BuildingGround ground;
  GroundNodes nodes;
  double tolerance;
  RestTables tables;

  void by_reference(const Batch& batch, std::size_t k) const {
    const TwoAxisScene& scene = batch.scenes[k];
    try {
      const TwoAxisResult r =
          slide_on_building(ground, scene.factors, scene.building, scene.block, batch.thresholds_m,
                            batch.crossings_of(k), tolerance)
              .slip;
      batch.peaks[k] = {r.peak_displacement_m,
                        r.peak_by_axis,
                        r.peak_downslope_m,
                        r.peak_upslope_m,
                        r.residual,
                        r.slip_phases,
                        r.uplift,
                        r.free_sliding,
                        false};
    } catch (const NotConverged&) {
      batch.peaks[k] = {.failed = true};
    }
  }
};

namespace {

/// The histories of one kind of roof, as many at a time as there are lanes.
template <class State>
class Pool {
 public:
  Pool(State& state, RoofKind roof, const Batch& batch)
      : state_(state), roof_(roof), batch_(batch) {}

  /// @param tasks those on one building are neighbours
  void run(std::span<const std::size_t> tasks) {
    tasks_ = tasks;
    for (std::size_t lane = 0; lane < LaneStates::count; ++lane) fill(lane);
    const GroundNodes& nodes = state_.nodes;
    const GroundRows ground{nodes.nodes.data(), static_cast<std::int64_t>(nodes.quiet),
                            static_cast<std::int64_t>(nodes.end), nodes.dt_s,
                            state_.ground.vertical != nullptr};
    while (lanes_.active != 0) {
      const Stepped stepped = block_detail::two_axes::step(lanes_, ground, roof_);
      for (std::uint64_t passed = stepped.passed; passed != 0; passed &= passed - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(passed));
        histories_[lane]->crossed(lanes_, lane);
        lanes_.next2[lane] = histories_[lane]->next2();
      }
      for (std::uint64_t left = stepped.left; left != 0; left &= left - 1)
        resolve(static_cast<std::size_t>(std::countr_zero(left)));
      if (next_ == tasks_.size()) close_up();
    }
  }

 private:
  /// Puts the next history that slides into a lane.
  void fill(std::size_t lane) {
    lanes_.active &= ~(std::uint64_t{1} << lane);
    while (next_ < tasks_.size()) {
      const std::size_t k = scene_[lane] = tasks_[next_++];
      const TwoAxisScene& scene = batch_.scenes[k];
      LaneHistory& history = histories_[lane].emplace(
          block_detail::two_axes::constants_of(scene, state_.tolerance), roof_, state_.nodes,
          state_.tables.of(scene, state_.nodes, roof_),
          DistanceCrossings(batch_.thresholds_m, batch_.crossings_of(k)));
      HistoryState state;
      if (!settle(
              lane, [&] { return history.begin(state); }, state))
        continue;
      LaneStates::store(lanes_.constants, lane, history.constants());
      put(lane, state);
      lanes_.active |= std::uint64_t{1} << lane;
      return;
    }
  }

  void resolve(std::size_t lane) {
    HistoryState state;
    LaneStates::load(lanes_.motion, lane, state.motion);
    state.node = lanes_.node[lane];
    if (settle(
            lane, [&] { return histories_[lane]->event(state); }, state))
      put(lane, state);
    else
      fill(lane);
  }

  void put(std::size_t lane, const HistoryState& state) {
    LaneStates::store(lanes_.motion, lane, state.motion);
    lanes_.node[lane] = state.node;
    lanes_.next2[lane] = histories_[lane]->next2();
  }

  /// Where no history is left for the lanes that are done: those that go on are moved to the first
  /// lanes, so that no SIMD vector is run for one of them.
  void close_up() {
    for (;;) {
      const auto done = static_cast<std::size_t>(std::countr_one(lanes_.active));
      const auto end = static_cast<std::size_t>(std::bit_width(lanes_.active));
      if (done >= end) return;
      move(end - 1, done);
    }
  }

  void move(std::size_t from, std::size_t to) {
    HistoryState state;
    LaneStates::load(lanes_.motion, from, state.motion);
    state.node = lanes_.node[from];
    histories_[to].emplace(std::move(*histories_[from]));
    scene_[to] = scene_[from];
    LaneStates::store(lanes_.constants, to, histories_[to]->constants());
    put(to, state);
    lanes_.active ^= std::uint64_t{1} << from | std::uint64_t{1} << to;
  }

  /// Takes a history to where a lane can go on. True where it slides on.
  template <class ToNext>
  bool settle(std::size_t lane, const ToNext& to_next, const HistoryState& state) {
    const std::size_t k = scene_[lane];
    LaneHistory::Next next = LaneHistory::Next::unsupported;
    try {
      next = to_next();
    } catch (const NotConverged&) {  // the scalar scheme may
    }
    if (next == LaneHistory::Next::finished) batch_.peaks[k] = histories_[lane]->result(state);
    if (next == LaneHistory::Next::unsupported) state_.by_reference(batch_, k);
    return next == LaneHistory::Next::slides;
  }

  State& state_;
  RoofKind roof_;
  Batch batch_;
  std::span<const std::size_t> tasks_;
  std::size_t next_ = 0;
  LaneStates lanes_;
  std::size_t scene_[LaneStates::count] = {};
  std::optional<LaneHistory> histories_[LaneStates::count];
};

}  // namespace

double srss_of_maxima_m(const TwoAxisPeak& peak) {
  TwoAxisResult r;
  r.peak_by_axis = peak.peak_by_axis;
  return srss_of_maxima_m(r);
}

TwoAxisLanes::TwoAxisLanes(const BuildingGround& ground, double tolerance)
    : state_(std::make_unique<State>(State{ground, GroundNodes(ground), tolerance, {}})) {
  GLISSADE_EXPECTS(tolerance >= 1e-9 && tolerance <= 1e-2);
}

TwoAxisLanes::~TwoAxisLanes() = default;

const BuildingGround& TwoAxisLanes::ground() const { return state_->ground; }

void TwoAxisLanes::slide(std::span<const TwoAxisScene> scenes, std::span<TwoAxisPeak> peaks,
                         std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  GLISSADE_EXPECTS(scenes.size() == peaks.size());
  GLISSADE_EXPECTS(crossings.size() == scenes.size() * thresholds_m.size());
  const Batch batch{scenes, peaks, thresholds_m, crossings};
  std::array<std::vector<std::size_t>, 3> tasks;  // by roof
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    require_finite_scene(scenes[k].building, scenes[k].block, scenes[k].factors);
    if (block_detail::two_axes::fits_lanes(scenes[k], state_->ground))
      tasks[static_cast<std::size_t>(block_detail::two_axes::roof_of(scenes[k]))].push_back(k);
    else
      state_->by_reference(batch, k);
  }
  for (const RoofKind roof : {RoofKind::rigid, RoofKind::building, RoofKind::coupled}) {
    std::vector<std::size_t>& on_roof = tasks[static_cast<std::size_t>(roof)];
    if (on_roof.empty()) continue;
    std::ranges::stable_sort(on_roof, {},
                             [&](std::size_t k) { return key_of(scenes[k].building); });
    Pool(*state_, roof, batch).run(on_roof);
  }
}

void slide_two_axes(const BuildingGround& ground, std::span<const TwoAxisScene> scenes,
                    std::span<TwoAxisPeak> peaks, double tolerance) {
  TwoAxisLanes(ground, tolerance).slide(scenes, peaks);
}

}  // namespace glissade
