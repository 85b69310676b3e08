// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <bit>
#include <memory>
#include <optional>
#include <tuple>
#include <vector>

#include "glissade/block/two_axis_lanes.hpp"
#include "glissade/core/contract.hpp"
#include "history.hpp"
#include "scene.hpp"

namespace glissade {
namespace {

using block_detail::two_axes::Constants;
using block_detail::two_axes::GroundNodes;
using block_detail::two_axes::GroundRows;
using block_detail::two_axes::LaneBank;
using block_detail::two_axes::LaneHistory;
using block_detail::two_axes::RestTable;
using block_detail::two_axes::RoofKind;
using block_detail::two_axes::Spot;

/// What histories on one table have in common.
using BuildingKey = std::tuple<double, double, double, double, double>;

BuildingKey key_of(const BiaxialBuilding& building) {
  const auto& [first, second] = building.horizontal;
  if (first.period_s == 0.0) return {};
  return {first.period_s, first.damping_ratio, second.period_s, second.damping_ratio,
          building.mass_ratio};
}

TwoAxisPeak by_reference(const BuildingGround& ground, const TwoAxisScene& scene,
                         double tolerance) {
  const TwoAxisResult r =
      slide_on_building(ground, scene.factors, scene.building, scene.block, tolerance).slip;
  return {r.peak_displacement_m, r.peak_by_axis, r.peak_downslope_m, r.peak_upslope_m, r.residual,
          r.slip_phases,         r.uplift,       r.free_sliding};
}

/// The histories of one kind of roof, as many at a time as there are lanes.
class Pool {
 public:
  Pool(const BuildingGround& ground, const GroundNodes& nodes, RoofKind roof,
       std::span<const TwoAxisScene> scenes, std::span<TwoAxisPeak> peaks, double tolerance)
      : ground_(ground),
        nodes_(nodes),
        roof_(roof),
        scenes_(scenes),
        peaks_(peaks),
        tolerance_(tolerance) {}

  /// @param tasks those on one building are neighbours
  void run(std::span<const std::size_t> tasks) {
    tasks_ = tasks;
    for (std::size_t lane = 0; lane < LaneBank::lanes; ++lane) fill(lane);
    const double longest_s =
        static_cast<double>(nodes_.quiet) * nodes_.dt_s + RoofMotionOptions{}.longest_ring_down_s;
    const GroundRows ground{nodes_.nodes.data(), static_cast<std::int64_t>(nodes_.quiet),
                            static_cast<std::int64_t>(longest_s / nodes_.dt_s), nodes_.dt_s,
                            ground_.vertical != nullptr};
    while (bank_.active != 0) {
      for (std::uint64_t left = block_detail::two_axes::step(bank_, ground, roof_); left != 0;
           left &= left - 1)
        resolve(static_cast<std::size_t>(std::countr_zero(left)));
    }
  }

 private:
  /// Puts the next history that slides into a lane.
  void fill(std::size_t lane) {
    bank_.active &= ~(std::uint64_t{1} << lane);
    while (next_ < tasks_.size()) {
      const std::size_t scene = tasks_[next_++];
      scene_[lane] = scene;
      LaneHistory& history =
          histories_[lane].emplace(block_detail::two_axes::constants_of(scenes_[scene], tolerance_),
                                   roof_, nodes_, table_of(scene));
      Spot spot;
      if (!settle(lane, history.begin(spot), spot)) continue;
      LaneBank::store(bank_.constants, lane, history.constants());
      put(lane, spot);
      bank_.active |= std::uint64_t{1} << lane;
      return;
    }
  }

  /// Tables live as long as a history needs them.
  std::shared_ptr<const RestTable> table_of(std::size_t scene) {
    const BuildingKey key = key_of(scenes_[scene].building);
    if (table_ == nullptr || key != table_key_) {
      table_ = std::make_shared<const RestTable>(
          nodes_, block_detail::two_axes::constants_of(scenes_[scene], tolerance_), roof_);
      table_key_ = key;
    }
    return table_;
  }

  void resolve(std::size_t lane) {
    Spot spot;
    LaneBank::load(bank_.motion, lane, spot.motion);
    spot.node = bank_.node[lane];
    if (settle(lane, histories_[lane]->event(spot), spot))
      put(lane, spot);
    else
      fill(lane);
  }

  void put(std::size_t lane, const Spot& spot) {
    LaneBank::store(bank_.motion, lane, spot.motion);
    bank_.node[lane] = spot.node;
  }

  /// True where it slides on.
  bool settle(std::size_t lane, LaneHistory::Next next, const Spot& spot) {
    const std::size_t scene = scene_[lane];
    if (next == LaneHistory::Next::over) peaks_[scene] = histories_[lane]->result(spot);
    if (next == LaneHistory::Next::leaves)
      peaks_[scene] = by_reference(ground_, scenes_[scene], tolerance_);
    return next == LaneHistory::Next::slides;
  }

  const BuildingGround& ground_;
  const GroundNodes& nodes_;
  RoofKind roof_;
  std::span<const TwoAxisScene> scenes_;
  std::span<TwoAxisPeak> peaks_;
  double tolerance_;
  std::span<const std::size_t> tasks_;
  BuildingKey table_key_;
  std::shared_ptr<const RestTable> table_;
  std::size_t next_ = 0;
  LaneBank bank_;
  std::size_t scene_[LaneBank::lanes] = {};
  std::optional<LaneHistory> histories_[LaneBank::lanes];
};

}  // namespace

double srss_of_maxima_m(const TwoAxisPeak& peak) {
  TwoAxisResult r;
  r.peak_by_axis = peak.peak_by_axis;
  return srss_of_maxima_m(r);
}

void slide_two_axes(const BuildingGround& ground, std::span<const TwoAxisScene> scenes,
                    std::span<TwoAxisPeak> peaks, double tolerance) {
  GLISSADE_EXPECTS(scenes.size() == peaks.size());
  GLISSADE_EXPECTS(tolerance >= 1e-9 && tolerance <= 1e-2);
  std::array<std::vector<std::size_t>, 3> tasks;  // by roof
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    if (block_detail::two_axes::fits_lanes(scenes[k], ground))
      tasks[static_cast<std::size_t>(block_detail::two_axes::roof_of(scenes[k]))].push_back(k);
    else
      peaks[k] = by_reference(ground, scenes[k], tolerance);
  }
  const GroundNodes nodes(ground);
  for (const RoofKind roof : {RoofKind::rigid, RoofKind::building, RoofKind::coupled}) {
    std::vector<std::size_t>& on_roof = tasks[static_cast<std::size_t>(roof)];
    if (on_roof.empty()) continue;
    std::stable_sort(on_roof.begin(), on_roof.end(), [&](std::size_t a, std::size_t b) {
      return key_of(scenes[a].building) < key_of(scenes[b].building);
    });
    Pool(ground, nodes, roof, scenes, peaks, tolerance).run(on_roof);
  }
}

}  // namespace glissade
