// SPDX-License-Identifier: GPL-3.0-or-later
#include "run/two_axis_batch.hpp"

#include <algorithm>

namespace glissade {

const TwoAxisKnown::Entry* TwoAxisKnown::find(double level) const {
  const auto found =
      std::ranges::find_if(entries, [&](const Entry& entry) { return entry.level == level; });
  return found != entries.end() ? &*found : nullptr;
}

void TwoAxisBatch::add(const std::shared_ptr<TwoAxisLanes>& lanes, const TwoAxisScene& scene,
                       double level, TwoAxisKnown& known) {
  auto group = std::ranges::find(groups_, lanes, &Group::lanes);
  if (group == groups_.end()) group = groups_.insert(group, Group{lanes});
  group->scenes.push_back(scene);
  group->wanted.emplace_back(level, &known);
}

void TwoAxisBatch::run() {
  const std::size_t n = thresholds_m_.size();
  for (Group& group : groups_) {
    std::vector<TwoAxisPeak> peaks(group.scenes.size());
    std::vector<Crossing> crossings(group.scenes.size() * n);
    group.lanes->slide(group.scenes, peaks, thresholds_m_, crossings);
    for (std::size_t i = 0; i < peaks.size(); ++i) {
      const auto first = crossings.begin() + static_cast<std::ptrdiff_t>(i * n);
      group.wanted[i].second->entries.push_back(
          {group.wanted[i].first, peaks[i], {first, first + static_cast<std::ptrdiff_t>(n)}});
    }
    group.scenes.clear();
    group.wanted.clear();
  }
}

}  // namespace glissade
