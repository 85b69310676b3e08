// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "block/full_model/sdirk4.hpp"
#include "block/full_model/stop.hpp"
#include "block/slip_record/distance_crossings.hpp"
#include "block/slip_record/path_piece.hpp"
#include "block/slip_record/two_axis_extremes.hpp"
#include "glissade/block/two_axis.hpp"

namespace glissade::block_detail {

/// Path of a block, with the results of a history. Displacements are in plan.
class TwoAxisTrack {
 public:
  /// @param crossings as many as thresholds, which increase
  TwoAxisTrack(Vector to_plan, std::span<const double> thresholds_m, std::span<Crossing> crossings)
      : to_plan_(to_plan), crossings_(thresholds_m, crossings) {}

  /// The pieces of the path are appended to `path`.
  void keep(std::vector<PathPiece>* path) { pieces_ = path; }

  Vector displacement() const { return displacement_; }
  double path_length() const { return path_length_; }

  /// A step of sliding.
  void slide(const Sliding& from, const Sliding& to, double length_s, double begin_s);
  /// The path to the stop, straight or short enough to be taken as straight.
  void stop(const Stop& stop, double speed, double begin_s);
  /// Whether a path of this length must be resolved: it is kept, or may reach a threshold.
  bool is_wanted(double path_length) const;
  /// In SlipResult: all but phases and flags.
  SlipResult result() const;

 private:
  Vector to_plan_;
  std::vector<PathPiece>* pieces_ = nullptr;
  DistanceCrossings crossings_;
  Vector displacement_;
  Extremes extremes_;
  double path_length_ = 0.0, duration_s_ = 0.0;
};

}  // namespace glissade::block_detail
