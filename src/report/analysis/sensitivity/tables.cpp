// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <ranges>

#include "analysis/sensitivity/sensitivity.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

Estimate alone(const SpreadRow& row, std::size_t factor) {
  return {row.first[factor], row.first_interval[factor]};
}
Estimate with_interactions(const SpreadRow& row, std::size_t factor) {
  return {row.total[factor], row.total_interval[factor]};
}

const Column first_column{"first", "", "Alone [95 %]", ColumnKind::share, "first-order Sobol index",
                          true};
const Column total_column{
    "total", "", "With interactions [95 %]", ColumnKind::share, "total Sobol index", true};

const Column mean_column = detail({"mean", "", "Mean", ColumnKind::number, "mean of ln capacity"}),
             std_column = detail({"std", "", "Standard deviation", ColumnKind::number,
                                  "standard deviation over records and samples"}),
             record_error_column =
                 detail({"record_error", "", "Its error by records", ColumnKind::number,
                         "standard error of the mean from the number of records"}),
             sample_error_column =
                 detail({"sample_error", "", "by samples", ColumnKind::number,
                         "standard error of the mean from as many independent samples"});

std::vector<std::string> notes_on(const SensitivityResults& found) {
  const std::string alone =
      "Alone: the reduction of the variance, on average, if the factor is known (first-order Sobol "
      "index). With interactions: the share that remains if all others are known (total index)";
  if (found.matrices == 1)
    return {
        alone + ", which these samples show of the records and of all that is drawn only.",
        "Given data: " + std::to_string(found.samples) +
            " samples that were not drawn for this, with all records, in groups by each factor."};
  return {alone + ".",
          fmt::format("{} samples in each of {} pick-freeze matrices, each with all records.",
                      found.samples, found.matrices)};
}

}  // namespace

std::vector<const SpreadRow*> capacity_rows(const SensitivityResults& found) {
  std::vector<const SpreadRow*> rows;
  for (const SpreadRow& row : found.rows) {
    if (row.is_capacity()) rows.push_back(&row);
  }
  return rows;
}

std::vector<const SpreadRow*> first_capacity_rows(const SensitivityResults& found,
                                                  std::size_t count) {
  std::vector<const SpreadRow*> first, some;  // of one combination
  for (const SpreadRow* row : capacity_rows(found)) {
    if (row->first_case == found.rows.front().first_case) first.push_back(row);
  }
  for (const std::size_t i : evenly(first.size(), count)) some.push_back(first[i]);
  return some;
}

Table spread_table(const Results& results) {
  const SensitivityResults& found = *results.sensitivity;
  Table table{"sensitivity",
              "Where the spread of ln capacity comes from: shares of its variance",
              {condition_column,
               threshold_column,
               {"log_std", "", "Log std", ColumnKind::number,
                "standard deviation of ln capacity over records and samples"},
               text_column("factor", "Factor", "what the spread comes from"),
               first_column,
               total_column,
               {"share_below", "", "At the lowest level", ColumnKind::share,
                "share of capacities limited to the lowest level"},
               {"share_above", "", "At the highest level", ColumnKind::share,
                "share of capacities limited to the highest level"},
               mean_column,
               record_error_column,
               sample_error_column},
              {}};
  for (const SpreadRow* row : capacity_rows(found)) {
    for (std::size_t f = 0; f < found.factors.size(); ++f)
      table.add({row->condition, row->threshold_m, row->std, found.factors[f], alone(*row, f),
                 with_interactions(*row, f), row->share_below, row->share_above, row->mean,
                 row->record_error, row->sample_error});
  }
  table.notes = notes_on(found);
  const bool noisy = std::ranges::any_of(capacity_rows(found), [](const SpreadRow* row) {
    return std::ranges::any_of(std::views::iota(std::size_t{0}, row->total.size()),
                               [&](std::size_t f) { return row->total[f] < row->first[f]; });
  });
  if (noisy)
    table.notes.emplace_back(
        "A share with interactions below that alone cannot be: the difference is the error of the "
        "estimates. The factor interacts with no other that these samples show.");
  table.notes.emplace_back(
      "Capacities below the lowest level and above the highest are taken as these levels; the last "
      "columns are their shares.");
  return table;
}

Table exceedance_spread_table(const Results& results) {
  const SensitivityResults& found = *results.sensitivity;
  Table table{"sensitivity_levels",
              "Where the spread of exceedance (0 or 1) comes from, at each level",
              {condition_column,
               threshold_column,
               level_column(results),
               {"probability", "", "Exceeded", ColumnKind::share,
                "share of histories that reach the threshold"},
               text_column("factor", "Factor", "what the spread comes from"),
               first_column,
               total_column,
               std_column,
               record_error_column,
               sample_error_column},
              {}};
  for (const SpreadRow& row : found.rows) {
    if (row.is_capacity() || !(row.std > 0.0)) continue;
    for (std::size_t f = 0; f < found.factors.size(); ++f)
      table.add({row.condition, row.threshold_m, row.level, row.mean, found.factors[f],
                 alone(row, f), with_interactions(row, f), row.std, row.record_error,
                 row.sample_error});
  }
  table.notes = notes_on(found);
  return table;
}

Table design_friction_table(const Results& results) {
  Table table{"design_friction",
              "How often slip with drawn friction exceeds slip with the design value, mean - 2 std",
              {condition_column,
               level_column(results),
               {"same_motion", "", "Same motion and building [95 %]", ColumnKind::share,
                "probability that displacement with drawn friction exceeds that with mean - 2 std, "
                "of the same record and sample",
                true},
               {"same_motion_error", "", "Standard error of the samples", ColumnKind::share,
                "standard error from the samples"},
               {"design_mean", "m", "Mean slip with mean - 2 std, m (in)", ColumnKind::length,
                "mean displacement with mean - 2 std"},
               {"above_mean", "", "Any slip above that mean [95 %]", ColumnKind::share,
                "probability that a displacement with drawn friction exceeds design_mean", true},
               {"above_mean_error", "", "Standard error of the samples", ColumnKind::share,
                "standard error from the samples"}},
              {}};
  for (const DesignFrictionRow& row : results.sensitivity->design_friction)
    table.add({row.condition, row.level, row.same_motion, row.same_motion_error, row.design_mean_m,
               row.above_mean, row.above_mean_error});
  table.notes = {"Normal friction is below mean - 2 std with a probability of 2.3 %.",
                 "Intervals are over records, with the error of the samples added, which all "
                 "records share. Without the latter they are, but for the same motion, never "
                 "narrower than that of a binomial with one trial for each record."};
  return table;
}

}  // namespace glissade
