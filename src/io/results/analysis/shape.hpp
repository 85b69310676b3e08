// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "enum_names.hpp"
#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

inline EnumNames<ComparisonStatus> comparison_status_names() {
  static constexpr EnumNames<ComparisonStatus> names = {
      {"compared", ComparisonStatus::compared},
      {"few_records", ComparisonStatus::few_records},
      {"no_overlap", ComparisonStatus::no_overlap},
      {"no_rise", ComparisonStatus::no_rise},
      {"always_exceeds", ComparisonStatus::always_exceeds}};
  return names;
}

template <class Archive, class Rows>
void exchange_threshold_shapes(const Archive& archive, Rows& rows) {
  const Columns column(archive, rows, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &ThresholdShape::threshold_m);
  column("comparison", {"-", "whether models were compared"}, &ThresholdShape::status,
         comparison_status_names());
  column("score",
         {"-",
          "ln probability of a record by a model fitted on the others, per history and level; by "
          "(threshold, model): lognormal, logit, complementary log-log, two-part, monotone, one "
          "surface"},
         &ThresholdShape::score);
  column("difference", {"-", "to the lognormal's score"}, &ThresholdShape::difference);
  column("standard_error", {"-", "of the difference, over records"},
         &ThresholdShape::standard_error);
  column("probability", {"-", "fitted on all records, by (threshold, model x level)"},
         &ThresholdShape::probability);
  column("recrossed",
         {"-",
          "share of histories that reached the threshold at a lower level and do not here, by "
          "(threshold, level)"},
         &ThresholdShape::recrossed);
}

template <class Archive, class Rows>
void exchange_crossings(const Archive& archive, const IntensityScale& scale, Rows& rows) {
  const Columns column(archive, rows, "threshold_m");
  column("threshold_m", {"m", "the smaller of two neighbouring thresholds"},
         &ShapeCrossing::threshold_m);
  column("next_threshold_m", {"m", "the larger one"}, &ShapeCrossing::next_threshold_m);
  column("intensity" + scale.suffix, {scale.unit, "where their lognormals cross"},
         &ShapeCrossing::intensity);
  column("probability", {"-", "of both there"}, &ShapeCrossing::probability);
  column("within_levels", {"-", "1: between the lowest and the highest level"},
         &ShapeCrossing::within_levels);
}

template <class Archive, class Run>
void exchange_surface(const Archive& archive, const IntensityScale& scale, Run& run) {
  archive.attribute("log_std", run.surface_log_std);
  archive.attribute("log_std_low", run.surface_log_std_interval.low);
  archive.attribute("log_std_high", run.surface_log_std_interval.high);
  const Columns column(archive, run.surface, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &SurfaceMedian::threshold_m);
  column("median", {scale.unit, "median with one log_std for all thresholds"},
         &SurfaceMedian::median);
  column("median", {scale.unit, "95 % interval of the median"}, &SurfaceMedian::median_interval);
}

template <class Archive, class Shape>
void exchange_shape(const Archive& archive, const IntensityScale& scale, Shape& shape) {
  const Columns column(archive, shape.runs, "label");
  column("label", {"-", "the combinations, as in /runs; each is a group"}, &ShapeRun::label);
  if constexpr (Archive::reads) {
    for (const auto& run : shape.runs) expect_file_name(run.label);
  }
  for (auto& run : shape.runs) {
    const auto group = archive.group(run.label);
    exchange_threshold_shapes(group.group("thresholds"), run.thresholds);
    exchange_crossings(group.group("crossings"), scale, run.crossings);
    exchange_surface(group.group("surface"), scale, run);
  }
}

}  // namespace glissade
