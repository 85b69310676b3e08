// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <bit>
#include <map>
#include <memory>
#include <tuple>
#include <utility>
#include <vector>

#include "block/full_model/building_axis.hpp"
#include "block/two_axes/history/history.hpp"
#include "glissade/block/two_axis_lanes.hpp"
#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/not_converged.hpp"
#include "scene.hpp"

namespace glissade {
namespace {

using block_detail::DistanceCrossings;
using block_detail::two_axes::Constants;
using block_detail::two_axes::fits_lanes;
using block_detail::two_axes::Friction;
using block_detail::two_axes::friction_of;
using block_detail::two_axes::GroundNodes;
using block_detail::two_axes::GroundRows;
using block_detail::two_axes::HistoryState;
using block_detail::two_axes::LaneHistory;
using block_detail::two_axes::LaneStates;
using block_detail::two_axes::RestTable;
using block_detail::two_axes::roof_of;
using block_detail::two_axes::RoofKind;
using block_detail::two_axes::StepKind;
using block_detail::two_axes::Stepped;

/// What histories on one table have in common.
using BuildingKey = std::tuple<Modes, Modes, double>;

BuildingKey key_of(const BiaxialBuilding& building) {
  const auto& [first, second] = building.horizontal;
  if (first.rigid()) return {};
  return {first, second, building.mass_ratio};
}

/// Of an axis, at most.
std::size_t modes_of(const TwoAxisScene& scene) {
  const auto& [first, second] = scene.building.horizontal;
  return std::max(first.size(), second.size());
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
    const bool of_modes = roof == RoofKind::modes;
    while (kept_.size() >= most_kept(nodes, rows_of(scene, roof))) {
      auto& [other, oldest] = kept_.front();
      if (oldest.use_count() == 1 && of_modes == !oldest->rows.empty()) table = std::move(oldest);
      kept_.erase(kept_.begin());
    }
    if (table == nullptr) table = std::make_shared<RestTable>();
    if (of_modes)
      table->tabulate(nodes, scene.building.horizontal);
    else
      table->tabulate(nodes, block_detail::two_axes::constants_of(scene, 1.0), roof);
    return kept_.emplace_back(key, std::move(table)).second;
  }

 private:
  /// Each search for a capacity needs the tables of its batch again.
  static std::size_t most_kept(const GroundNodes& nodes, std::size_t rows) {
    constexpr std::size_t most_bytes = 32 << 20;
    const std::size_t bytes = rows * sizeof(double) * (nodes.quiet + 1);
    return std::clamp<std::size_t>(most_bytes / bytes, 2, 64);
  }
  /// Numbers at a node.
  static std::size_t rows_of(const TwoAxisScene& scene, RoofKind roof) {
    if (roof == RoofKind::modes) return 2 + 2 * block_detail::two_axes::row_terms;
    return roof == RoofKind::coupled_modes ? 2 + 4 * modes_of(scene) : 6;
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
      const BuildingSlip on_building =
          slide_on_building(ground, scene.factors, scene.building, scene.block, batch.thresholds_m,
                            batch.crossings_of(k), tolerance);
      const TwoAxisResult& r = on_building.slip;
      batch.peaks[k] = {r.peak_displacement_m,
                        r.peak_by_axis,
                        r.peak_downslope_m,
                        r.peak_upslope_m,
                        r.residual,
                        r.slip_phases,
                        r.uplift,
                        r.free_sliding,
                        scene.base_shear ? on_building.peak_base_shear : std::array{0.0, 0.0},
                        false};
    } catch (const NotConverged&) {
      batch.peaks[k] = {.failed = true};
    }
  }
};

namespace {

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

/// The histories of one kind of roof and of friction.
template <class State>
class Pool {
 public:
  Pool(State& state, RoofKind roof, Friction friction, const Batch& batch)
      : state_(state), roof_(roof), friction_(friction), batch_(batch) {}

  /// @param tasks those on one building are neighbours
  void run(std::span<const std::size_t> tasks) {
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

 private:
  static constexpr std::size_t most_underway = 64;
  /// Lanes with an implicit step to do that are worth doing it: those of the widest vectors.
  static constexpr std::size_t enough = 24;

  void begin(std::size_t scene) {
    const TwoAxisScene& s = batch_.scenes[scene];
    auto table = state_.tables.of(s, state_.nodes, roof_);
    if (!table->usable()) return state_.by_reference(batch_, scene);
    ++underway_;
    auto next = std::make_unique<Underway>(
        Underway{LaneHistory(block_detail::two_axes::constants_of(s, state_.tolerance), roof_,
                             state_.nodes, std::move(table),
                             DistanceCrossings(batch_.thresholds_m, batch_.crossings_of(scene)),
                             s.base_shear),
                 {},
                 scene});
    go_on(std::move(next), &LaneHistory::begin);
  }

  void step(OwnedLanes& owned) {
    const GroundNodes& nodes = state_.nodes;
    const GroundRows ground{nodes.nodes.data(), static_cast<std::int64_t>(nodes.quiet), nodes.dt_s,
                            state_.ground.vertical != nullptr};
    LaneStates& lanes = owned.lanes;
    const Stepped stepped =
        block_detail::two_axes::step(lanes, ground, roof_, friction_, owned.kind);
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
      if (owned.kind == StepKind::taylor) next->state.motion.trial = block_detail::never;
      go_on(std::move(next), &LaneHistory::event);
    });
    OwnedLanes& other = owned.kind == StepKind::taylor ? implicit_ : taylor_;
    for_each(stepped.other, [&](std::size_t lane) {
      std::unique_ptr<Underway> next = owned.take(lane);
      next->state.motion.trial = block_detail::never;
      next->state.motion.forced = 1.0;
      other.waiting.push_back(std::move(next));
    });
    const std::uint64_t unsupported = too_long | (owned.of_springs ? stepped.lifted : 0);
    for_each(unsupported & lanes.active,
             [&](std::size_t lane) { leave_to_reference(owned.take(lane)); });
  }

  /// Of a history, which has some hundreds: more are steps that a load near to friction makes
  /// shorter and shorter.
  std::uint32_t most_implicit_steps() const {
    return 20000 + 2 * static_cast<std::uint32_t>(state_.nodes.end);
  }

  template <class What>
  static void for_each(std::uint64_t lanes, const What& what) {
    for (; lanes != 0; lanes &= lanes - 1) what(static_cast<std::size_t>(std::countr_zero(lanes)));
  }

  /// Takes a history to where a lane can go on, or to its end.
  void go_on(std::unique_ptr<Underway> next,
             LaneHistory::Next (LaneHistory::*to_next)(HistoryState&)) {
    const LaneHistory::Next found = (next->history.*to_next)(next->state);
    const bool is_too_long = next->implicit_steps > most_implicit_steps();
    const bool lifted_on_springs = roof_ == RoofKind::yielding && next->history.uplift();
    if (found == LaneHistory::Next::unsupported || lifted_on_springs ||
        (found == LaneHistory::Next::slides && is_too_long))
      return leave_to_reference(std::move(next));
    if (found == LaneHistory::Next::slides) return implicit_.waiting.push_back(std::move(next));
    --underway_;
    batch_.peaks[next->scene] = next->history.result(next->state);
  }

  void leave_to_reference(std::unique_ptr<Underway> next) {
    --underway_;
    state_.by_reference(batch_, next->scene);
  }

  State& state_;
  RoofKind roof_;
  Friction friction_;
  Batch batch_;
  std::span<const std::size_t> tasks_;
  std::size_t next_ = 0, underway_ = 0;
  OwnedLanes taylor_{StepKind::taylor, roof_ == RoofKind::yielding};
  OwnedLanes implicit_{StepKind::implicit, roof_ == RoofKind::yielding};
};

}  // namespace

double srss_of_maxima_m(const TwoAxisPeak& peak) {
  TwoAxisResult r;
  r.peak_by_axis = peak.peak_by_axis;
  return srss_of_maxima_m(r);
}

TwoAxisLanes::TwoAxisLanes(const BuildingGround& ground, double tolerance)
    : state_(std::make_unique<State>(State{ground, GroundNodes(ground), tolerance, {}})) {
  require_tolerance(tolerance, 1e-9);
}

TwoAxisLanes::~TwoAxisLanes() = default;

const BuildingGround& TwoAxisLanes::ground() const { return state_->ground; }

void TwoAxisLanes::slide(std::span<const TwoAxisScene> scenes, std::span<TwoAxisPeak> peaks,
                         std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  GLISSADE_EXPECTS(scenes.size() == peaks.size());
  GLISSADE_EXPECTS(crossings.size() == scenes.size() * thresholds_m.size());
  const double dt_s = state_->ground.horizontal[0]->step_s();
  std::vector<TwoAxisScene> of_modes;  // all, if there are modes
  if (std::ranges::any_of(scenes, [](const TwoAxisScene& s) { return modes_of(s) > 1; })) {
    of_modes.assign(scenes.begin(), scenes.end());
    for (TwoAxisScene& scene : of_modes)
      for (Modes& axis : scene.building.horizontal)
        if (axis.size() > 1) axis = block_detail::responding(axis, dt_s);
    scenes = of_modes;
  }
  const Batch batch{scenes, peaks, thresholds_m, crossings};
  std::map<std::pair<RoofKind, Friction>, std::vector<std::size_t>> tasks;
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const TwoAxisScene& s = scenes[k];
    require_finite_scene(s.building, s.block, s.factors);
    if (fits_lanes(s, state_->ground))
      tasks[{roof_of(s), friction_of(s)}].push_back(k);
    else
      state_->by_reference(batch, k);
  }
  for (auto& [kind, of_kind] : tasks) {
    std::ranges::stable_sort(of_kind, {},
                             [&](std::size_t k) { return key_of(scenes[k].building); });
    Pool(*state_, kind.first, kind.second, batch).run(of_kind);
  }
}

void peak_slip_two_axes(const BuildingGround& ground, std::span<const TwoAxisScene> scenes,
                        std::span<TwoAxisPeak> peaks, double tolerance) {
  TwoAxisLanes(ground, tolerance).slide(scenes, peaks);
}

}  // namespace glissade
