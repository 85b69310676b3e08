// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

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
  column("same_motion", {"-", "95 % interval of that"}, &DesignFrictionRow::same_motion_interval);
  column("same_motion_error", {"-", "standard error of that from the samples"},
         &DesignFrictionRow::same_motion_error);
  column("design_mean_m", {"m", "mean displacement with mean - 2 std"},
         &DesignFrictionRow::design_mean_m);
  column("above_mean",
         {"-", "probability that a displacement with drawn friction exceeds that mean"},
         &DesignFrictionRow::above_mean);
  column("above_mean", {"-", "95 % interval of that"}, &DesignFrictionRow::above_mean_interval);
  column("above_mean_error", {"-", "standard error of that from the samples"},
         &DesignFrictionRow::above_mean_error);
}

template <class Archive, class S>
void exchange_sensitivity(const Archive& archive, const IntensityScale& scale, S& found) {
  archive.attribute("samples", found.samples);
  archive.attribute("matrices", found.matrices);
  list(archive, "factor", {"-", "what the spread comes from"}, found.factors);
  exchange_spread(archive.group("spread"), scale, found.rows);
  exchange_design_friction(archive.group("design_friction"), scale, found.design_friction);
}

}  // namespace glissade
