// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/coupled_slip.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "block/contact/scaled_block.hpp"
#include "block/coupled_tables/coupled_history.hpp"
#include "block/events/coupled_walk.hpp"
#include "glissade/core/contract.hpp"

namespace glissade {

using block_detail::CoupledContact;
using block_detail::CoupledHistory;
using block_detail::CoupledLanes;
using block_detail::CoupledNodes;
using block_detail::CoupledTable;
using block_detail::LanesDone;
using block_detail::subdivide;
using block_detail::Subdivision;

namespace {

/// All that a table depends on but the motion.
struct Shared {
  double period_s, damping_ratio, mass_ratio, slope_rad, friction, static_over_sliding,
      gravity_mps2, sign, vertical_ratio;

  Shared(const CoupledScene& s, const Oscillator& oscillator, bool vertical)
      : period_s(oscillator.period_s),
        damping_ratio(oscillator.damping_ratio),
        mass_ratio(s.building.mass_ratio),
        slope_rad(std::abs(s.block.slope_rad)),
        friction(s.block.friction),
        static_over_sliding(s.block.law.static_over_sliding),
        gravity_mps2(s.block.gravity_mps2),
        sign((s.block.slope_rad < 0.0) == (s.factors.horizontal < 0.0) ? 1.0 : -1.0),
        vertical_ratio(vertical ? s.factors.vertical / std::abs(s.factors.horizontal) : 0.0) {}
  bool operator==(const Shared&) const = default;
};

/// Of gravity. On a flat roof the block lifts under a larger vertical acceleration downward; on a
/// slope the horizontal decides too, and the history finds out.
constexpr double most_vertical_if_flat = 0.9999;

/// A period that its vibration shows between samples, and underdamped in every regime.
bool can_be_tabulated(const Subdivision& subdivision, const CoupledContact& contact, double dt_s) {
  constexpr double least_phase = 1e-3, most_damping = 0.95;
  if (subdivision.building.rigid()) return false;
  for (const double mass :
       {contact.stuck().mass, contact.sliding_down().mass, contact.sliding_up().mass}) {
    const double root = std::sqrt(mass), phase = subdivision.building.omega_radps / root * dt_s;
    if (!(phase >= least_phase && phase <= block_detail::RegimeOscillator::most_phase &&
          subdivision.building.damping_ratio / root <= most_damping))
      return false;
  }
  return true;
}

CoupledPeak by_reference(const GroundMotion& ground, const CoupledScene& scene,
                         std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  return {block_detail::in_metres(
              block_detail::walk_coupled(
                  ground, scene.factors, scene.building, scene.block,
                  {block_detail::CoupledBody::Keeps::peaks, thresholds_m, crossings})
                  .slip,
              1.0),
          true};
}

}  // namespace

struct CoupledGround::Tables {
  /// The last table.
  struct Last {
    std::optional<Shared> shared;  ///< what it is of
    CoupledTable table;

    const CoupledTable& of(const CoupledNodes& motion, const Shared& wanted,
                           const CoupledContact& contact, const Subdivision& subdivision) {
      if (!(shared == wanted))
        table.tabulate(motion, contact, subdivision.building, wanted.sign, wanted.vertical_ratio);
      shared = wanted;
      return table;
    }
  };
  std::shared_ptr<const CoupledNodes> nodes;
  Last elastic, yielding;
};

namespace {

/// The building while its spring yields is an elastic one of the lower stiffness (theory.md, 2.3).
Oscillator while_yielding(const CoupledBuilding& building) {
  const double root = std::sqrt(building.yielding.hardening_ratio);
  return {building.horizontal.period_s / root, building.horizontal.damping_ratio / root};
}

}  // namespace

CoupledGround::CoupledGround(const GroundMotion& motion)
    : motion_(motion),
      tables_(std::make_unique<Tables>(Tables{std::make_shared<CoupledNodes>(motion), {}, {}})) {}
CoupledGround::CoupledGround(const CoupledGround& other)
    : motion_(other.motion_),
      tables_(std::make_unique<Tables>(Tables{other.tables_->nodes, {}, {}})) {}
CoupledGround::~CoupledGround() = default;

namespace {

bool can_be_tabulated(const CoupledScene& scene, const CoupledContact& contact,
                      const CoupledNodes& nodes) {
  const bool law_fits = scene.block.law.is_coulomb() ||
                        (contact.stops_at_rest() && !scene.block.law.depends_on_speed());
  return scene.block.directions == SlipDirections::both && law_fits &&
         scene.factors.horizontal != 0.0 && (contact.slides_at_rest() || contact.stops_at_rest()) &&
         contact.up().a > 0.0 &&
         (contact.sin_slope() > 0.0 || -nodes.lowest_w(scene.factors.vertical) <
                                           most_vertical_if_flat * scene.block.gravity_mps2);
}

Shared shared_of(const CoupledScene& scene, const GroundMotion& motion) {
  return {scene, scene.building.horizontal, !motion.vertical_mps2.empty()};
}

const CoupledTable& table_of(CoupledGround& ground, const CoupledScene& scene,
                             const CoupledContact& contact) {
  const Oscillator& oscillator = scene.building.horizontal;
  CoupledGround::Tables& tables = ground.tables();
  return tables.elastic.of(*tables.nodes, shared_of(scene, ground.motion()), contact,
                           subdivide(oscillator, contact, ground.motion().dt_s));
}

/// Of the building while its spring yields; none if it has no such table.
const CoupledTable* yielding_table(CoupledGround& ground, const CoupledScene& scene,
                                   const CoupledContact& contact) {
  const Yielding& spring = scene.building.yielding;
  if (!spring.yields() || spring.hardening_ratio == 0.0) return nullptr;
  const Oscillator oscillator = while_yielding(scene.building);
  const GroundMotion& motion = ground.motion();
  const Subdivision subdivision = subdivide(oscillator, contact, motion.dt_s);
  if (!can_be_tabulated(subdivision, contact, motion.dt_s)) return nullptr;
  CoupledGround::Tables& tables = ground.tables();
  return &tables.yielding.of(*tables.nodes,
                             Shared(scene, oscillator, !motion.vertical_mps2.empty()), contact,
                             subdivision);
}

/// Scenes under one ground, and where their results go.
struct CoupledBatch {
  CoupledGround& ground;
  std::span<const CoupledScene> scenes;
  std::span<CoupledPeak> peaks;
  std::span<const double> thresholds_m;
  std::span<Crossing> crossings;

  std::span<Crossing> crossings_of(std::size_t scene) const {
    return crossings.subspan(scene * thresholds_m.size(), thresholds_m.size());
  }
  void by_reference(std::size_t k) const {
    peaks[k] = glissade::by_reference(ground.motion(), scenes[k], thresholds_m, crossings_of(k));
  }
};

/// The histories of scenes on the same tables, as many at a time as there are lanes.
class CoupledPool {
 public:
  CoupledPool(const CoupledBatch& batch, std::vector<std::size_t> tasks,
              const CoupledContact& contact)
      : batch_(batch),
        tasks_(std::move(tasks)),
        contact_(contact),
        subdivision_(subdivide(scene(tasks_.front()).building.horizontal, contact,
                               batch.ground.motion().dt_s)),
        elastic_(table_of(batch.ground, scene(tasks_.front()), contact)),
        yielding_(yielding_table(batch.ground, scene(tasks_.front()), contact)) {
    // The strongest slide most often: they begin first, so that all end at about the same time.
    std::ranges::stable_sort(tasks_, std::greater(), [&](std::size_t k) { return intensity(k); });
    lane_tables_ = elastic_.lanes(yielding_, scene(tasks_.front()).building.yielding);
    lane_tables_.static_friction = scene(tasks_.front()).block.law.static_over_sliding > 1.0;
  }

  void run() {
    for (std::size_t lane = 0; lane < CoupledLanes::count; ++lane) fill(lane);
    while (active_ != 0) {
      const LanesDone done = block_detail::step(lanes_, lane_tables_, active_);
      const std::uint64_t all =
          batch_.thresholds_m.empty() ? done.searching | done.undecided : active_;
      for (std::uint64_t left = all; left != 0; left &= left - 1) {
        const auto lane = static_cast<std::size_t>(std::countr_zero(left));
        if (!go_on(lane, histories_[lane]->go_on(lanes_, lane, done))) fill(lane);
      }
    }
  }

 private:
  using Next = CoupledHistory::Next;

  const CoupledScene& scene(std::size_t k) const { return batch_.scenes[k]; }
  double intensity(std::size_t k) const { return std::abs(scene(k).factors.horizontal); }

  /// Puts the next history in which an event is possible into a lane.
  void fill(std::size_t lane) {
    active_ |= std::uint64_t{1} << lane;
    while (next_ < tasks_.size()) {
      const std::size_t k = task_[lane] = tasks_[next_++];
      histories_[lane].emplace(elastic_, yielding_, contact_, subdivision_, scene(k), intensity(k),
                               batch_.thresholds_m, batch_.crossings_of(k));
      if (go_on(lane, histories_[lane]->begin(lanes_, lane))) return;
    }
    active_ &= ~(std::uint64_t{1} << lane);
  }

  /// False where the history ends.
  bool go_on(std::size_t lane, Next next) {
    if (next == Next::finished)
      batch_.peaks[task_[lane]] = {block_detail::in_metres(histories_[lane]->result(), 1.0), false};
    if (next == Next::lifts) batch_.by_reference(task_[lane]);
    return next == Next::interval;
  }

  const CoupledBatch& batch_;
  std::vector<std::size_t> tasks_;  ///< scenes
  const CoupledContact& contact_;
  Subdivision subdivision_;
  const CoupledTable& elastic_;
  const CoupledTable* yielding_;
  block_detail::LaneTables lane_tables_;
  std::size_t next_ = 0;
  std::uint64_t active_ = 0;  ///< lanes, as bits
  CoupledLanes lanes_ = {};
  std::array<std::size_t, CoupledLanes::count> task_{};
  std::array<std::optional<CoupledHistory>, CoupledLanes::count> histories_;
};

/// Those of neighbouring scenes that share tables, from one on.
/// @return the first scene that does not
std::size_t solve(const CoupledBatch& batch, std::size_t first) {
  const CoupledScene& scene = batch.scenes[first];
  const GroundMotion& motion = batch.ground.motion();
  const auto is_like_first = [&, shared = shared_of(scene, motion)](const CoupledScene& other) {
    return shared_of(other, motion) == shared &&
           other.building.yielding.yield_acceleration_mps2 ==
               scene.building.yielding.yield_acceleration_mps2 &&
           other.building.yielding.hardening_ratio == scene.building.yielding.hardening_ratio &&
           other.block.directions == scene.block.directions &&
           other.block.law.depends_on_speed() == scene.block.law.depends_on_speed();
  };
  std::vector<std::size_t> tasks;
  std::size_t k = first;
  const CoupledContact contact(scene.block, scene.building.mass_ratio);
  const bool has_tables = can_be_tabulated(
      subdivide(scene.building.horizontal, contact, motion.dt_s), contact, motion.dt_s);
  do {  // the first one without comparison: what it has of a motion scaled to zero is no number
    if (has_tables && can_be_tabulated(batch.scenes[k], contact, *batch.ground.tables().nodes))
      tasks.push_back(k);
    else
      batch.by_reference(k);
  } while (++k < batch.scenes.size() && is_like_first(batch.scenes[k]));
  if (!tasks.empty()) CoupledPool(batch, std::move(tasks), contact).run();
  return k;
}

}  // namespace

void coupled_slip(CoupledGround& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m,
                  std::span<Crossing> crossings) {
  GLISSADE_EXPECTS(scenes.size() == peaks.size());
  GLISSADE_EXPECTS(crossings.size() == scenes.size() * thresholds_m.size());
  for (const CoupledScene& scene : scenes) {
    block_detail::require_finite_scene(scene.building, scene.block, scene.factors);
    GLISSADE_EXPECTS(coupling_is_regular(scene.block, scene.building.mass_ratio));
  }
  const CoupledBatch batch{ground, scenes, peaks, thresholds_m, crossings};
  for (std::size_t k = 0; k < scenes.size();) k = solve(batch, k);
}

void coupled_slip(const GroundMotion& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m,
                  std::span<Crossing> crossings) {
  CoupledGround shared(ground);
  coupled_slip(shared, scenes, peaks, thresholds_m, crossings);
}

}  // namespace glissade
