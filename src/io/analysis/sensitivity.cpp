// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/in_files.hpp"
#include "glissade/study/cases/sample_points.hpp"

namespace glissade {
namespace {

template <class Archive, class Rows>
void exchange_spread(const Archive& archive, const IntensityScale& scale, Rows& rows) {
  const Columns column(archive, rows, "threshold_m");
  column("threshold_m", {"m", "clearance threshold"}, &SpreadRow::threshold_m);
  column("first_case", {"-", "position in `cases` of the combination's first"},
         &SpreadRow::first_case);
  column("condition", {"-", "which combination of what the study lists"}, &SpreadRow::condition);
  column(scale.level,
         {scale.unit,
          "of whether displacement reaches the threshold there, 0 or 1; nan: of ln capacity, "
          "limited to the range of the levels"},
         &SpreadRow::level);
  column("mean", {"-", "mean"}, &SpreadRow::mean);
  column("std", {"-", "standard deviation over records and samples"}, &SpreadRow::std);
  column("share_below", {"-", "capacities limited to the lowest level"}, &SpreadRow::share_below);
  column("share_above", {"-", "capacities limited to the highest level"}, &SpreadRow::share_above);
  column("first", {"-", "first-order Sobol indices, by (row, factor)"}, &SpreadRow::first);
  column("first", {"-", "95 % intervals of these"}, &SpreadRow::first_interval);
  column("total", {"-", "total Sobol indices, by (row, factor)"}, &SpreadRow::total);
  column("total", {"-", "95 % intervals of these"}, &SpreadRow::total_interval);
  column("record_error", {"-", "standard error of the mean from the number of records"},
         &SpreadRow::record_error);
  column("sample_error", {"-", "standard error of the mean from as many independent samples"},
         &SpreadRow::sample_error);
}

template <class Archive, class Rows>
void exchange_design_friction(const Archive& archive, const IntensityScale& scale, Rows& rows) {
  const Columns column(archive, rows, scale.level);
  column(scale.level, {scale.unit, "intensity level"}, &DesignFrictionRow::level);
  column("first_case", {"-", "position in `cases` of the first with drawn friction"},
         &DesignFrictionRow::first_case);
  column("condition", {"-", "which combination of what the study lists"},
         &DesignFrictionRow::condition);
  column("same_motion",
         {"-",
          "probability that displacement with drawn friction exceeds that with mean - 2 std, of "
          "the same record and sample"},
         &DesignFrictionRow::same_motion);
  column("same_motion_error", {"-", "standard error of that from the samples"},
         &DesignFrictionRow::same_motion_error);
  column("design_mean_m", {"m", "mean displacement with mean - 2 std"},
         &DesignFrictionRow::design_mean_m);
  column("above_mean",
         {"-", "probability that a displacement with drawn friction exceeds that mean"},
         &DesignFrictionRow::above_mean);
  column("above_mean_error", {"-", "standard error of that from the samples"},
         &DesignFrictionRow::above_mean_error);
}

bool has_one_orientation(const TomlTable&, const StudyConfig& study) {
  const OrientationConfig& o = study.orientation;
  return (o.choice == OrientationChoice::random || o.choice == OrientationChoice::as_recorded) &&
         o.slope_axis.size() == 1;
}

void check_sensitivity(const SensitivityResults& found, const Results& results) {
  const std::size_t factors = found.factors.size();
  expect_fit(factors > 2, "factor", "sensitivity");
  expect_fit(!found.rows.empty(), "spread", "sensitivity");
  for (const SpreadRow& row : found.rows) {
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.first.size() == factors && row.first_interval.size() == factors &&
                   row.total.size() == factors && row.total_interval.size() == factors,
               "first and total", "factor");
  }
  expect_fit(std::ranges::any_of(found.rows,
                                 [&](const SpreadRow& row) {
                                   return row.is_capacity() &&
                                          row.first_case == found.rows.front().first_case;
                                 }),
             "capacity", "first combination");
  for (const DesignFrictionRow& row : found.design_friction)
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
}

}  // namespace

AnalysisInFiles SensitivityAnalysis::in_files() {
  return {
      .table = "sensitivity",
      .read = [](const TomlTable&, StudyConfig& study) { study.sensitivity = true; },
      .keys =
          {{"", "an empty table", "absent",
            "where the spread comes from: Sobol indices of the records and of each drawn quantity; "
            "runs samples x (2 + drawn quantities) samples. Added to finished results: first order "
            "alone, needs 32 samples or more in 8 scrambles or more, or by method monte_carlo"}},
      .needs = {needs_fragility,
                {"a quantity that is drawn",
                 [](const TomlTable&, const StudyConfig& s) { return !drawn_factors(s).empty(); }},
                {"sampling.samples of 2 or more",
                 [](const TomlTable&, const StudyConfig& s) { return s.sampling.samples >= 2; }},
                {"one orientation of a sample (orientation.choice = \"random\" or \"as_recorded\", "
                 "one slope_axis)",
                 has_one_orientation}},
      .of_any_run = true,
      .exchange = Exchange::in_group<&Results::sensitivity>([](const auto& archive,
                                                               const auto& scale, auto& found) {
        archive.attribute("samples", found.samples);
        archive.attribute("matrices", found.matrices);
        list(archive, "factor", {"-", "what the spread comes from"}, found.factors);
        exchange_spread(archive.group("spread"), scale, found.rows);
        exchange_design_friction(archive.group("design_friction"), scale, found.design_friction);
      }),
      .check = if_found<&Results::sensitivity, check_sensitivity>};
}

}  // namespace glissade
