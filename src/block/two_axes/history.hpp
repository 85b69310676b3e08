// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>

#include "block/full_model/sdirk4.hpp"
#include "block/full_model/two_axis_stop.hpp"
#include "block/slip_record/two_axis_extremes.hpp"
#include "block/two_axes/roof/roof_piece.hpp"
#include "block/two_axes/roof/tables.hpp"
#include "glissade/block/two_axis_lanes.hpp"
#include "lane_crossings.hpp"

namespace glissade::block_detail::two_axes {

class RoofAtRest;

/// One history: all of it but its smooth sliding, which the lanes do.
class LaneHistory {
 public:
  LaneHistory(const Constants<double>& constants, RoofKind roof, const GroundNodes& ground,
              std::shared_ptr<const RestTable> table, const LaneCrossings& crossings);

  enum class Next {
    slides,  ///< in a lane, from the spot on
    over,
    leaves,  ///< something the lanes do not cover: it is for the scalar scheme
  };
  /// From rest at the first node.
  Next begin(Spot& spot);
  /// A lane could not go on: its next stop, or a step that is too stiff for it.
  Next event(Spot& spot);
  TwoAxisPeak result(const Spot& spot) const;
  const Constants<double>& constants() const { return constants_; }
  /// LaneCrossings::next2
  double next2() const { return crossings_.next2(); }
  /// A lane's step reached it.
  void crossed(const LaneBank& bank, std::size_t lane);

 private:
  // Rest (history_rest.cpp).
  Next rest(Spot& spot);
  Next rest_from_node(Spot& spot);
  double release(const RoofPiece& piece) const;
  bool starts_after(std::size_t node, const RoofAtRest& roof, Spot& spot);
  Spot resting_at(std::int64_t node, const std::array<AxisState, 2>& state) const;
  void start(Spot& spot, bool smoothly);
  void start_smoothly(Spot& spot);  // history_start.cpp

  // Slide (history_slide.cpp).
  Next slide(Spot& spot, bool from_lane);
  bool stop(Spot& spot, const RoofPiece& piece);
  bool reverse(Spot& spot, const RoofPiece& piece);
  double deceleration(const Load& load, Vector v) const;
  void take_stop(Spot& spot, const RoofPiece& piece, const Stop& stop);
  void raise_peaks(const Path& path, LaneMotion<double>& motion) const;
  double time_s(const Spot& spot) const {
    return (static_cast<double>(spot.node + 1) - spot.motion.left) * ground_.dt_s;
  }
  void stiff_step(Spot& spot);
  double stiff_trial_s(const RoofPiece& rest_of_interval, Vector v, double fastest) const;
  void take_step(Spot& spot, const RoofPiece& piece, double share, double length_s,
                 const Sliding& begin, const Sliding& end);
  RoofPiece::Push push_of(Vector v) const;
  RoofPiece::Push push_between(const Sliding& begin, const Sliding& end, double length_s,
                               double share) const;
  RoofPiece piece(const Spot& spot, const RoofPiece::Push& push) const {
    return RoofPiece(spot, ground_, constants_, roof_, push);
  }
  template <class At>
  void move_way(Spot& spot, Vector way, const At& at, double begin_s, double length_s);

  Constants<double> constants_;
  FrictionEllipse ellipse_;
  RoofKind roof_;
  const GroundNodes& ground_;
  std::shared_ptr<const RestTable> table_;
  double step_s_ = never;  // the longest worth trying
  std::size_t phases_ = 0;
  LaneCrossings crossings_;
};

/// The block has moved by `way`, as `at` says (LaneCrossings::pass).
template <class At>
void LaneHistory::move_way(Spot& spot, Vector way, const At& at, double begin_s, double length_s) {
  LaneMotion<double>& m = spot.motion;
  m.at_s += way.s;
  m.at_y += way.y;
  m.farthest2 = std::max(m.farthest2, m.at_s * m.at_s + m.at_y * m.at_y);
  m.ahead_s = std::max(m.ahead_s, m.at_s);
  m.back_s = std::max(m.back_s, -m.at_s);
  m.ahead_y = std::max(m.ahead_y, m.at_y);
  m.back_y = std::max(m.back_y, -m.at_y);
  if (m.farthest2 >= next2()) crossings_.pass(at, begin_s, length_s, std::sqrt(m.farthest2));
}

}  // namespace glissade::block_detail::two_axes
