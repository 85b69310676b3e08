// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "glissade/block/two_axis_lanes.hpp"

namespace glissade {

/// A history that a batch has run, or is to run.
struct TwoAxisRun {
  bool is_run = false;
  BuildingPeak peak = {};
  std::vector<Crossing> crossings = {};
};

/// Histories of several cases under one record, collected and run together. What a history gives
/// does not depend on the others.
class TwoAxisBatch {
 public:
  explicit TwoAxisBatch(std::span<const double> thresholds_m = {}) : thresholds_m_(thresholds_m) {}

  /// Nothing where the level is known or added already.
  /// @param known those of the case by level; gets the result at the next run()
  void add(const std::shared_ptr<TwoAxisLanes>& lanes, const TwoAxisScene& scene, double level,
           std::map<double, TwoAxisRun>& known);
  void run();

 private:
  /// Those under one ground motion.
  struct Group {
    std::shared_ptr<TwoAxisLanes> lanes;
    std::vector<TwoAxisScene> scenes = {};
    std::vector<TwoAxisRun*> wanted = {};  ///< by scene
  };

  std::span<const double> thresholds_m_;
  std::vector<Group> groups_;
};

}  // namespace glissade
