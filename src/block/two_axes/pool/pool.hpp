// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <span>

#include "block/two_axes/pool/owned_lanes.hpp"
#include "block/two_axes/pool/rest_tables.hpp"
#include "glissade/block/two_axis_lanes.hpp"

namespace glissade::block_detail::two_axes {

/// Scenes under one motion, and where their results go.
struct Batch {
  std::span<const TwoAxisScene> scenes;
  std::span<BuildingPeak> peaks;
  std::span<const double> thresholds_m;
  std::span<Crossing> crossings;

  std::span<Crossing> crossings_of(std::size_t scene) const {
    return crossings.subspan(scene * thresholds_m.size(), thresholds_m.size());
  }
};

/// All histories under one motion.
struct UnderMotion {
  BuildingGround ground;
  GroundNodes nodes;
  double tolerance;
  RestTables tables;

  UnderMotion(const BuildingGround& of, double permitted)
      : ground(of), nodes(of), tolerance(permitted) {}
  /// A scene of the batch, by slide_on_building().
  void by_reference(const Batch& batch, std::size_t scene) const;
};

/// The histories of one kind of roof and of friction.
class Pool {
 public:
  Pool(UnderMotion& motion, RoofKind roof, Friction friction, const Batch& batch)
      : motion_(motion), roof_(roof), friction_(friction), batch_(batch) {}

  /// @param tasks those on one building are neighbours
  void run(std::span<const std::size_t> tasks);

 private:
  static constexpr std::size_t most_underway = 64;
  /// Lanes with an implicit step to do that are worth doing it: those of the widest vectors.
  static constexpr std::size_t enough = 24;

  void begin(std::size_t scene);
  void step(OwnedLanes& owned);
  /// Of a history, which has some hundreds: more are steps that a load near to friction makes
  /// shorter and shorter.
  std::uint32_t most_implicit_steps() const {
    return 20000 + 2 * static_cast<std::uint32_t>(motion_.nodes.end);
  }
  /// Takes a history to where a lane can go on, or to its end.
  void go_on(std::unique_ptr<Underway> next,
             LaneHistory::Next (LaneHistory::*to_next)(HistoryState&));
  void leave_to_reference(std::unique_ptr<Underway> next);

  UnderMotion& motion_;
  RoofKind roof_;
  Friction friction_;
  Batch batch_;
  std::span<const std::size_t> tasks_;
  std::size_t next_ = 0, underway_ = 0;
  OwnedLanes taylor_{StepKind::taylor, roof_ == RoofKind::yielding};
  OwnedLanes implicit_{StepKind::implicit, roof_ == RoofKind::yielding};
};

}  // namespace glissade::block_detail::two_axes
