// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

template <class Archive, class Statistics>
void exchange_impact_statistics(const Archive& archive, const IntensityScale& scale,
                                Statistics& rows) {
  make_rows(archive, "threshold_m", rows);
  column(
      archive, "threshold_m", {"m", "clearance threshold"}, rows,
      [](auto& s) -> auto& { return s.threshold_m; });
  column(
      archive, scale.level, {scale.unit, "intensity level"}, rows,
      [](auto& s) -> auto& { return s.level; });
  column(
      archive, "reached_share", {"-", "share of histories that reach it"}, rows,
      [](auto& s) -> auto& { return s.reached_share; });
  interval_column(
      archive, "reached_share", {"-", "95 % interval of that share"}, rows,
      [](auto& s) -> auto& { return s.reached_interval; });
  column(
      archive, "speed_median_mps",
      {"m/s", "median speed in plan at the first crossing, of the histories that reach it"}, rows,
      [](auto& s) -> auto& { return s.speed_median_mps; });
  column(
      archive, "speed_p84_mps", {"m/s", "84th percentile of that speed"}, rows,
      [](auto& s) -> auto& { return s.speed_p84_mps; });
  column(
      archive, "speed_p95_mps", {"m/s", "95th percentile"}, rows,
      [](auto& s) -> auto& { return s.speed_p95_mps; });
  column(
      archive, "speed_largest_mps", {"m/s", "largest"}, rows,
      [](auto& s) -> auto& { return s.speed_largest_mps; });
  interval_column(
      archive, "speed_median_mps", {"m/s", "95 % interval of the median"}, rows,
      [](auto& s) -> auto& { return s.speed_median_interval; });
  interval_column(
      archive, "speed_p84_mps", {"m/s", "95 % interval of the 84th percentile"}, rows,
      [](auto& s) -> auto& { return s.speed_p84_interval; });
  column(
      archive, "time_median_s",
      {"s", "median time of the first crossing from the record's begin, of those that reach it"},
      rows, [](auto& s) -> auto& { return s.time_median_s; });
  column(
      archive, "time_p16_s", {"s", "16th percentile of that time"}, rows,
      [](auto& s) -> auto& { return s.time_p16_s; });
  column(
      archive, "time_p84_s", {"s", "84th percentile"}, rows,
      [](auto& s) -> auto& { return s.time_p84_s; });
}

/// Absent where the study has no [impact].
template <class Archive, class Run>
void exchange_impact(const Archive& run_archive, const IntensityScale& scale, Run& run) {
  if constexpr (Archive::reads) {
    if (!run_archive.has("impact")) return;
  } else {
    if (run.impact.empty()) return;
  }
  exchange_impact_statistics(run_archive.group("impact"), scale, run.impact);
}

}  // namespace glissade
