// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "glissade/block/two_axis_lanes.hpp"
#include "roof_piece.hpp"
#include "tables.hpp"

namespace glissade::block_detail::two_axes {

class RoofAtRest;

/// One history: all of it but its smooth sliding, which the lanes do.
class LaneHistory {
 public:
  LaneHistory(const Constants<double>& constants, RoofKind roof, const GroundNodes& ground,
              std::shared_ptr<const RestTable> table);

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
  void stiff_step(Spot& spot);
  RoofPiece::Push push_of(Vector v) const;
  RoofPiece piece(const Spot& spot, const RoofPiece::Push& push) const {
    return RoofPiece(spot, ground_, constants_, roof_, push);
  }
  void move_way(Spot& spot, Vector way) const;

  Constants<double> constants_;
  RoofKind roof_;
  const GroundNodes& ground_;
  std::shared_ptr<const RestTable> table_;
  double step_s_ = never;  // the longest worth trying
  std::size_t phases_ = 0;
};

}  // namespace glissade::block_detail::two_axes
