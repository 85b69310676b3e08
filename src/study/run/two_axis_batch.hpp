// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "glissade/block/two_axis_lanes.hpp"

namespace glissade {

/// The histories of one case that a batch has run, by level.
struct TwoAxisKnown {
  struct Entry {
    double level;
    TwoAxisPeak peak;
    std::vector<Crossing> crossings;
  };
  std::vector<Entry> entries;

  const Entry* find(double level) const;
};

/// Histories of several cases under one record, collected and run together. What a history gives
/// does not depend on the others.
class TwoAxisBatch {
 public:
  explicit TwoAxisBatch(std::span<const double> thresholds_m = {}) : thresholds_m_(thresholds_m) {}

  /// @param known gets the result at the next run()
  void add(const std::shared_ptr<TwoAxisLanes>& lanes, const TwoAxisScene& scene, double level,
           TwoAxisKnown& known);
  void run();

 private:
  /// Those under one ground motion.
  struct Group {
    std::shared_ptr<TwoAxisLanes> lanes;
    std::vector<TwoAxisScene> scenes = {};
    std::vector<std::pair<double, TwoAxisKnown*>> wanted = {};  // by scene: which level, where to
  };

  std::span<const double> thresholds_m_;
  std::vector<Group> groups_;
};

}  // namespace glissade
