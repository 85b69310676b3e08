// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/coupled_slip.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <vector>

#include "coupled_lane.hpp"
#include "coupled_walk.hpp"
#include "glissade/core/contract.hpp"

namespace glissade {
namespace {

using block_detail::CoupledBank;
using block_detail::CoupledLane;
using block_detail::Cut;
using block_detail::LaneGround;

/// Nodes between looks at which histories are over.
constexpr std::size_t stretch = 64;

/// What is to be watched for: in a scene, its own crossings.
struct Watched {
  std::span<const double> thresholds_m;
  std::span<Crossing> crossings;
  std::span<Crossing> of(std::size_t scene) const {
    return crossings.subspan(scene * thresholds_m.size(), thresholds_m.size());
  }
};

struct LaneTask {
  std::size_t scene;
  Cut cut;
};

/// Up to CoupledBank::lanes histories, side by side.
class Batch {
 public:
  Batch(LaneGround& ground, std::span<const LaneTask> tasks, std::span<const CoupledScene> scenes,
        std::span<CoupledPeak> peaks, const Watched& watched)
      : ground_(ground), tasks_(tasks), peaks_(peaks) {
    for (std::size_t lane = 0; lane < tasks.size(); ++lane) {
      const std::size_t scene = tasks[lane].scene;
      lanes_[lane].emplace(scenes[scene], tasks[lane].cut, ground, watched.thresholds_m,
                           watched.of(scene));
      lanes_[lane]->load(bank_, lane);
    }
    for (std::size_t lane = tasks.size(); lane < CoupledBank::lanes; ++lane) idle(lane);
    left_ = tasks.size();
  }

  void run() {
    const std::size_t last = ground_.a.last_sample();
    walk_to(last);
    for (std::size_t lane = 0; lane < tasks_.size(); ++lane)
      if (lanes_[lane]->ends_with_record()) finish(lane, last);
    const std::size_t end = ground_.longest_end();
    for (std::size_t node = std::max(last, ground_.quiet_from()); left_ > 0;
         node = std::min(node + stretch, end)) {
      walk_to(node);
      for (std::size_t lane = 0; lane < tasks_.size(); ++lane)
        if (lanes_[lane] && (node >= end || lanes_[lane]->is_over(bank_, lane, node)))
          finish(lane, node);
    }
  }

 private:
  void walk_to(std::size_t node) {
    ground_.extend(node + 1);
    while (at_ < node) {
      block_detail::Flags flags;
      at_ = block_detail::walk(bank_, ground_.nodes(), at_, node, flags);
      const auto for_each = [&](std::uint32_t bits, const auto& what) {
        for (; bits != 0; bits &= bits - 1) {
          const auto lane = static_cast<std::size_t>(std::countr_zero(bits));
          what(*lanes_[lane], lane);
        }
      };
      for_each(flags.peaks & ~flags.moves,
               [&](CoupledLane& l, std::size_t lane) { l.note_turn(bank_, lane, at_); });
      for_each(flags.moves, [&](CoupledLane& l, std::size_t lane) { l.resolve(bank_, lane, at_); });
    }
  }

  void finish(std::size_t lane, std::size_t node) {
    peaks_[tasks_[lane].scene] = lanes_[lane]->result(bank_, lane, node);
    lanes_[lane].reset();
    idle(lane);
    --left_;
  }

  /// A lane in which nothing moves and nothing can happen.
  void idle(std::size_t lane) {
    CoupledBank::State& s = bank_.state[bank_.now];
    for (double* values :
         {bank_.xx,       bank_.xy,        bank_.yx,      bank_.yy,      bank_.x_start,
          bank_.x_end,    bank_.y_start,   bank_.y_end,   bank_.ground,  bank_.vertical,
          bank_.constant, bank_.speed_y,   bank_.speed_a, bank_.speed_w, bank_.speed_g,
          bank_.lowest_w, bank_.highest_w, bank_.sag,     s.x,           s.y,
          s.elastic,      s.turn,          s.forcing,     s.speed})
      values[lane] = 0.0;
    bank_.lowest[lane] = bank_.least_speed[lane] = -1.0;
    bank_.highest[lane] = bank_.y_bound[lane] = s.peak[lane] = s.peak_x[lane] = 1.0;
  }

  LaneGround& ground_;
  std::span<const LaneTask> tasks_;
  std::span<CoupledPeak> peaks_;
  CoupledBank bank_;
  std::optional<CoupledLane> lanes_[CoupledBank::lanes];
  std::size_t left_ = 0, at_ = 0;
};

CoupledPeak by_reference(const GroundMotion& ground, const CoupledScene& scene,
                         std::span<const double> thresholds_m, std::span<Crossing> crossings) {
  return block_detail::peak_of(block_detail::walk_coupled(
      ground, scene.factors, scene.building, scene.block,
      {block_detail::CoupledBody::Keeps::peaks, thresholds_m, crossings}));
}

/// Of a building that went through the lanes elastic.
double elastic_ductility(const CoupledBuilding& building, const CoupledPeak& peak) {
  const double omega = 2.0 * std::numbers::pi / building.horizontal.period_s;
  return peak.peak_roof_displacement_m * omega * omega / building.yielding.yield_acceleration_mps2;
}

}  // namespace

void coupled_slip(const GroundMotion& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks) {
  coupled_slip(ground, scenes, peaks, {}, {});
}

void coupled_slip(const GroundMotion& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m,
                  std::span<Crossing> crossings) {
  GLISSADE_EXPECTS(scenes.size() == peaks.size());
  GLISSADE_EXPECTS(crossings.size() == scenes.size() * thresholds_m.size());
  const Watched watched{thresholds_m, crossings};
  std::map<int, std::vector<LaneTask>> tasks;  // by how the ground is cut
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const CoupledScene& scene = scenes[k];
    GLISSADE_EXPECTS(coupling_is_regular(scene.block, scene.building.mass_ratio));
    if (!block_detail::fits_lane(scene, ground)) {
      peaks[k] = by_reference(ground, scene, thresholds_m, watched.of(k));
      continue;
    }
    const block_detail::CoupledContact contact(scene.block, std::abs(scene.block.slope_rad),
                                               scene.building.mass_ratio);
    const Cut cut = block_detail::cut(scene.building.horizontal, contact, ground.dt_s);
    tasks[cut.pieces].push_back({k, cut});
  }
  for (const auto& [pieces, all] : tasks) {
    LaneGround cut_ground(ground, pieces);
    for (std::size_t first = 0; first < all.size(); first += CoupledBank::lanes) {
      const std::size_t count = std::min(CoupledBank::lanes, all.size() - first);
      Batch(cut_ground, std::span(all).subspan(first, count), scenes, peaks, watched).run();
    }
    for (const LaneTask& task : all) {
      const CoupledScene& scene = scenes[task.scene];
      CoupledPeak& peak = peaks[task.scene];
      if (scene.building.yielding.yields())
        peak.ductility = elastic_ductility(scene.building, peak);
      if (peak.ductility > 1.0 - 1e-9)
        peak = by_reference(ground, scene, thresholds_m, watched.of(task.scene));
    }
  }
}

}  // namespace glissade
