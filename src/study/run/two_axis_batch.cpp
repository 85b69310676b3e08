// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/two_axis_batch.hpp"

#include <algorithm>

namespace glissade {

void TwoAxisBatch::add(const std::shared_ptr<TwoAxisLanes>& lanes, const TwoAxisScene& scene,
                       double level, std::map<double, TwoAxisRun>& known) {
  const auto [run, is_new] = known.try_emplace(level);
  if (!is_new) return;
  auto group = std::ranges::find(groups_, lanes, &Group::lanes);
  if (group == groups_.end()) group = groups_.insert(group, Group{lanes});
  group->scenes.push_back(scene);
  group->wanted.push_back(&run->second);
}

void TwoAxisBatch::run() {
  const std::size_t n = thresholds_m_.size();
  for (Group& group : groups_) {
    std::vector<BuildingPeak> peaks(group.scenes.size());
    std::vector<Crossing> crossings(group.scenes.size() * n);
    group.lanes->slide(group.scenes, peaks, thresholds_m_, crossings);
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      const auto first = crossings.begin() + static_cast<std::ptrdiff_t>(i * n);
      *group.wanted[i] = {true, peaks[i], {first, first + static_cast<std::ptrdiff_t>(n)}};
    }
    group.scenes.clear();
    group.wanted.clear();
  }
}

}  // namespace glissade
