// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "block/polynomial/power_series.hpp"
#include "block/slip_record/distance_crossings.hpp"

namespace glissade::block_detail {

/// The block sliding in one direction, from slip `begin` to `end` along the slope, over time from
/// `time_s` on.
struct SlipPath {
  int direction = 0;  ///< +1 down, -1 up
  double begin_m = 0.0, end_m = 0.0;
  double time_s = 0.0;
};

/// Notes when the block first has given distances, in plan, from where it lay.
class CoupledCrossings {
 public:
  CoupledCrossings() = default;
  CoupledCrossings(std::span<const double> thresholds_m, std::span<Crossing> crossings,
                   double cos_slope)
      : crossings_(thresholds_m, crossings), cos_slope_(cos_slope) {}

  bool reached(double slip_m) const { return crossings_.may_reach(std::abs(slip_m) * cos_slope_); }
  /// Over a fraction of a piece; at its end the block may have no speed.
  void follow(const SlipPath& path, const Series& speed, double length_s, double fraction,
              bool stops);
  /// Slowing down to rest.
  void follow_to_rest(const SlipPath& path, double speed_mps, double deceleration_mps2);

 private:
  /// How far the next threshold is along a path.
  double ahead_m(const SlipPath& path) const;
  void note(double time_s, double speed_mps);

  DistanceCrossings crossings_;
  double cos_slope_ = 1.0;
};

}  // namespace glissade::block_detail
