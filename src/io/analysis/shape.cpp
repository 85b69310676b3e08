// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {
namespace {

EnumNames<ComparisonStatus> comparison_status_names() {
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

void check_shape(const ShapeResults& shape, const Results& results) {
  expect_fit(shape.runs.size() == results.runs.size(), "shape", "runs");
  for (const ShapeRun& run : shape.runs) {
    expect_fit(run.thresholds.size() == results.thresholds_m.size(), "shape", "thresholds");
    for (const ThresholdShape& t : run.thresholds) {
      const std::size_t models = t.status == ComparisonStatus::compared ? shape_model_count : 0;
      expect_fit(t.score.size() == models && t.difference.size() == models &&
                     t.standard_error.size() == models,
                 "score", "models");
      expect_fit(t.probability.size() == models * results.levels.size() &&
                     t.recrossed.size() == results.levels.size(),
                 "probability", "models and levels");
    }
  }
}

}  // namespace

AnalysisInFiles ShapeAnalysis::in_files() {
  return {
      .table = "shape",
      .read = [](const TomlTable&, StudyConfig& study) { study.shape = true; },
      .keys = {{"", "an empty table", "absent",
                "whether the fragilities are lognormal and what else they could be"}},
      .needs = {needs_fragility},
      .of_any_run = true,
      .exchange = Exchange::in_group<&Results::shape>([](const auto& archive, const auto& scale,
                                                         auto& shape) {
        const Columns column(archive, shape.runs, "label");
        column("label", {"-", "the combinations, as in /runs; each is a group"}, &ShapeRun::label);
        for (auto& run : shape.runs) {
          expect_file_name(run.label);
          const auto group = archive.group(run.label);
          exchange_threshold_shapes(group.group("thresholds"), run.thresholds);
          exchange_crossings(group.group("crossings"), scale, run.crossings);
          exchange_surface(group.group("surface"), scale, run);
        }
      }),
      .check = if_found<&Results::shape, check_shape>};
}

}  // namespace glissade
