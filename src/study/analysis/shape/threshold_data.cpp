// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/shape/threshold_data.hpp"

#include <cmath>

#include "glissade/study/cases/case_scene.hpp"

namespace glissade {

ThresholdData threshold_data(const Results& results, CaseSlice cases, std::size_t threshold) {
  const HistoryTable& table = results.histories;
  const double threshold_m = results.thresholds_m[threshold];
  ThresholdData data{std::vector<RecordStripes>(table.records),
                     std::vector<RecordCapacities>(table.records)};
  for (std::size_t record = 0; record < table.records; ++record) {
    RecordStripes& stripes = data.stripes[record];
    RecordCapacities& capacities = data.capacities[record];
    stripes.exceedances.assign(table.levels, 0.0);
    for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
      const double capacity = table.capacity(record, i, threshold);
      if (capacity == 0.0) {
        capacities.free += 1.0;
        continue;
      }
      if (std::isinf(capacity)) {
        capacities.censored += 1.0;
      } else {
        capacities.capacities.push_back(capacity);
      }
      for (std::size_t level = 0; level < table.levels; ++level) {
        if (table.displacement_m(record, i, level) >= threshold_m)
          stripes.exceedances[level] += 1.0;
      }
    }
    stripes.free = capacities.free;
    stripes.trials.assign(table.levels, static_cast<double>(cases.count) - stripes.free);
  }
  return data;
}

namespace {

/// By record and level; empty where a displacement is not known.
std::vector<std::vector<SlipSums>> slips_of(const Results& results, CaseSlice cases) {
  const HistoryTable& table = results.histories;
  std::vector<std::vector<SlipSums>> slips(table.records);
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t level = 0; level < table.levels; ++level) {
      SlipSums& sums = slips[record].emplace_back(SlipSums{.intensity = results.levels[level]});
      for (std::size_t i = cases.first; i < cases.first + cases.count; ++i) {
        if (slides_freely(results.cases.cases[i])) continue;
        const double displacement_m = table.displacement_m(record, i, level);
        if (std::isinf(displacement_m)) return {};
        sums.add(displacement_m);
      }
    }
  }
  return slips;
}

}  // namespace

ShapeData shape_data(const Results& results, CaseSlice cases) {
  ShapeData data{.intensities = results.levels,
                 .thresholds_m = results.thresholds_m,
                 .censored_at = results.levels.back(),
                 .slips = slips_of(results, cases)};
  for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
    ThresholdData of = threshold_data(results, cases, t);
    data.stripes.push_back(std::move(of.stripes));
    data.capacities.push_back(std::move(of.capacities));
  }
  return data;
}

}  // namespace glissade
