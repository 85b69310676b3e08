// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {
namespace {

template <class Archive, class Statistics>
void exchange_impact(const Archive& archive, const IntensityScale& scale, Statistics& rows) {
  const Columns column(archive, rows, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &ImpactStatistics::threshold_m);
  column(scale.level, {scale.unit, "intensity level"}, &ImpactStatistics::level);
  column("reached_share", {"-", "share of histories that reach it"},
         &ImpactStatistics::reached_share);
  column("reached_share", {"-", "95 % interval of that share"},
         &ImpactStatistics::reached_interval);
  column("speed_median_mps",
         {"m/s", "median speed in plan at the first crossing, of the histories that reach it"},
         &ImpactStatistics::speed_median_mps);
  column("speed_p84_mps", {"m/s", "84th percentile of that speed"},
         &ImpactStatistics::speed_p84_mps);
  column("speed_p95_mps", {"m/s", "95th percentile"}, &ImpactStatistics::speed_p95_mps);
  column("speed_largest_mps", {"m/s", "largest"}, &ImpactStatistics::speed_largest_mps);
  column("speed_median_mps", {"m/s", "95 % interval of the median"},
         &ImpactStatistics::speed_median_interval);
  column("speed_p84_mps", {"m/s", "95 % interval of the 84th percentile"},
         &ImpactStatistics::speed_p84_interval);
  column("time_median_s",
         {"s", "median time of the first crossing from the record's begin, of those that reach it"},
         &ImpactStatistics::time_median_s);
  column("time_p16_s", {"s", "16th percentile of that time"}, &ImpactStatistics::time_p16_s);
  column("time_p84_s", {"s", "84th percentile"}, &ImpactStatistics::time_p84_s);
}

void check_impact(Results& results) {
  for (const RunResults& run : results.runs)
    expect_fit(run.impact.empty() ||
                   (run.impact.size() == results.levels.size() * results.thresholds_m.size() &&
                    !results.histories.fields.crossing_time_s.empty()),
               "impact", "levels and thresholds");
}

}  // namespace

AnalysisInFiles ImpactAnalysis::in_files() {
  return {.table = "impact",
          .read = [](const TomlTable&, StudyConfig& study) { study.impact = true; },
          .keys = {{"", "an empty table", "absent",
                    "when and how fast each threshold is first reached"}},
          .needs = {needs_fragility},
          .needs_every_history = true,
          .exchange = Exchange::of_runs([](const auto& of_run, const char* table, const auto& scale,
                                           auto& run) {
            if_there(of_run, table, run.impact,
                     [&](const auto& group, auto& rows) { exchange_impact(group, scale, rows); });
          }),
          .check = check_impact};
}

}  // namespace glissade
