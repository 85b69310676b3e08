// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/shape/threshold_data.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "glissade/study/cases/case_scene.hpp"

namespace glissade {

namespace {

/// Whether two records are one motion: all that is known of it as recorded is the same.
bool is_same_motion(const RecordSummary& a, const RecordSummary& b) {
  const auto known = [](const RecordSummary& r) {
    return std::tuple(r.pga_g, r.pgv_mps, r.pgd_m, r.duration_s, r.dt_s, r.samples);
  };
  return known(a) == known(b);
}

}  // namespace

std::vector<RecordStripes> multiple_stripes(const Results& results, CaseSlice cases,
                                            double threshold_m) {
  const HistoryTable& table = results.histories;
  double free = 0.0;
  for (std::size_t i = cases.first; i < cases.first + cases.count; ++i)
    free += slides_freely(results.cases.cases[i]) ? 1.0 : 0.0;
  std::vector<RecordStripes> motions;
  std::vector<std::size_t> first_of;  // by motion: the first record that is it
  for (std::size_t record = 0; record < table.records; ++record) {
    const auto same = std::ranges::find_if(first_of, [&](std::size_t first) {
      return is_same_motion(results.records[first], results.records[record]);
    });
    const auto motion = static_cast<std::size_t>(same - first_of.begin());
    if (same == first_of.end()) {
      first_of.push_back(record);
      const std::vector<double> none(results.levels.size(), 0.0);
      motions.push_back({none, none, free});
    }
    const std::size_t level = table.stripe_of[record];
    motions[motion].trials[level] += static_cast<double>(cases.count) - free;
    for (std::size_t i = cases.first; i < cases.first + cases.count; ++i)
      if (!slides_freely(results.cases.cases[i]) &&
          table.displacement_m(record, i, level) >= threshold_m)
        motions[motion].exceedances[level] += 1.0;
  }
  return motions;
}

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
