// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/run/history_table.hpp"

namespace glissade {

/// How the array first gets a threshold's distance from where it lay, at one level: over those
/// records' samples that reach it (percentiles by Hyndman & Fan 1996, type 7; NaN where none
/// does). Speed is that of the array relative to the roof, in plan. Where fewer than three records
/// have any that does there is no interval.
struct ImpactStatistics {
  double level = 0.0, threshold_m = 0.0;
  Estimate reached_share;  ///< of all histories at the level; interval over records, as all here
  Estimate speed_median_mps, speed_p84_mps;
  double speed_p16_mps = 0.0, speed_p95_mps = 0.0, speed_largest_mps = 0.0;
  double time_median_s = 0.0, time_p16_s = 0.0, time_p84_s = 0.0;  ///< from the record's begin
};

/// First crossings of some cases, by (threshold, level). Records are the independent unit
/// of the intervals; percentiles of speed are over those histories that reach it.
std::vector<ImpactStatistics> impact_statistics(const HistoryTable& histories, CaseSlice cases,
                                                std::span<const double> levels,
                                                std::span<const double> thresholds_m);

struct ImpactAnalysis {
  struct InStudy {
    bool impact = false;
  };
  struct InResults {};
  static constexpr auto keeps = &KeptFields::crossings;
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
