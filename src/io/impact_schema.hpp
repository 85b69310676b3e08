// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results_archive.hpp"

namespace glissade {

template <class Archive, class Statistics>
void exchange_impact_statistics(const Archive& archive, Statistics& rows) {
  make_rows(archive, "threshold_m", rows);
  column(
      archive, "threshold_m", {"m", "clearance threshold"}, rows,
      [](auto& s) -> auto& { return s.threshold_m; });
  column(
      archive, "level_g", {"g", "intensity level"}, rows, [](auto& s) -> auto& { return s.level; });
  column(
      archive, "reached_share", {"-", "share of histories that get there"}, rows,
      [](auto& s) -> auto& { return s.reached_share; });
  interval_column(
      archive, "reached_share", {"-", "95 % interval of that share"}, rows,
      [](auto& s) -> auto& { return s.reached_interval; });
  column(
      archive, "speed_median_mps",
      {"m/s", "median speed in plan at the first crossing, of the histories that get there"}, rows,
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
      {"s", "median time of the first crossing from the record's begin, of those that get there"},
      rows, [](auto& s) -> auto& { return s.time_median_s; });
  column(
      archive, "time_p16_s", {"s", "16th percentile of that time"}, rows,
      [](auto& s) -> auto& { return s.time_p16_s; });
  column(
      archive, "time_p84_s", {"s", "84th percentile"}, rows,
      [](auto& s) -> auto& { return s.time_p84_s; });
}

/// First crossings of a run and their statistics. Absent where the study does not ask for them.
template <class Archive, class Run>
void exchange_impact(const Archive& run_archive, Run& run) {
  if constexpr (Archive::reads) {
    if (!run_archive.has("impact")) return;
  } else {
    if (run.crossing_time_s.empty() && run.impact.empty()) return;
  }
  const auto archive = run_archive.group("impact");
  const auto& shape = run.peak_displacement_m;
  const std::size_t histories = shape.data.size();
  const auto crossings = [&](const std::string& name, const Label& label, auto& values) {
    Dims dims{shape.rows, shape.columns, shape.depth,
              histories > 0 ? values.size() / histories : 0};
    archive.array(name, label, dims, values);
    const bool fits = dims.size() == 4 && dims[0] == shape.rows && dims[1] == shape.columns &&
                      dims[2] == shape.depth;
    if (!fits) throw Hdf5Error("fit " + name + " to the peak displacements");
  };
  crossings("crossing_time_s",
            {"s",
             "time of the first crossing from the record's begin, by (record, sample, level, "
             "threshold); nan: not reached"},
            run.crossing_time_s);
  crossings("crossing_speed_mps",
            {"m/s",
             "speed then, in plan and relative to the roof, by (record, sample, level, threshold); "
             "nan: not reached"},
            run.crossing_speed_mps);
  exchange_impact_statistics(archive, run.impact);
}

}  // namespace glissade
