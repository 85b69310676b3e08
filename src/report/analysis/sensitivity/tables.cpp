// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>

#include "analysis/sensitivity/sensitivity.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// Of a row of the spread and a factor.
struct SpreadTable : TableOf<SpreadRow, std::size_t> {
  using TableOf::TableOf;

  void put_indices(const SensitivityResults& found) {
    text("factor", "Factor", "what the spread comes from",
         [&](const SpreadRow&, std::size_t f) { return found.factors[f]; });
    share("first", "Alone", "first-order Sobol index", [](const SpreadRow& row, std::size_t f) {
      return Estimate{row.first[f], row.first_interval[f]};
    });
    share("total", "With interactions", "total Sobol index",
          [](const SpreadRow& row, std::size_t f) {
            return Estimate{row.total[f], row.total_interval[f]};
          });
  }
  void put_errors() {
    number("record_error", "Its error by records",
           "standard error of the mean from the number of records", &SpreadRow::record_error)
        .detail = true;
    number("sample_error", "by samples",
           "standard error of the mean from as many independent samples", &SpreadRow::sample_error)
        .detail = true;
  }
};

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
  using R = SpreadRow;
  SpreadTable t("sensitivity",
                "Where the spread of ln capacity comes from: shares of its variance");
  t.put_all(condition_column, threshold_column);
  t.number("log_std", "Log std", "standard deviation of ln capacity over records and samples",
           &R::std);
  t.put_indices(found);
  t.share("share_below", "At the lowest level", "share of capacities limited to the lowest level",
          &R::share_below);
  t.share("share_above", "At the highest level", "share of capacities limited to the highest level",
          &R::share_above);
  t.number("mean", "Mean", "mean of ln capacity", &R::mean).detail = true;
  t.put_errors();
  t.notes = notes_on(found);
  bool noisy = false;
  for (const R* row : capacity_rows(found)) {
    for (std::size_t f = 0; f < found.factors.size(); ++f) {
      t.add(*row, f);
      noisy = noisy || row->total[f] < row->first[f];
    }
  }
  if (noisy)
    t.notes.emplace_back(
        "A share with interactions below that alone cannot be: the difference is the error of the "
        "estimates. The factor interacts with no other that these samples show.");
  t.notes.emplace_back(
      "Capacities below the lowest level and above the highest are taken as these levels; the last "
      "columns are their shares.");
  return t;
}

Table exceedance_spread_table(const Results& results) {
  const SensitivityResults& found = *results.sensitivity;
  using R = SpreadRow;
  SpreadTable t("sensitivity_levels",
                "Where the spread of exceedance (0 or 1) comes from, at each level");
  t.put_all(condition_column, threshold_column, level_column(results));
  t.share("probability", "Exceeded", "share of histories that reach the threshold", &R::mean);
  t.put_indices(found);
  t.number("std", "Standard deviation", "standard deviation over records and samples", &R::std)
      .detail = true;
  t.put_errors();
  for (const R& row : found.rows)
    for (std::size_t f = 0; f < found.factors.size(); ++f)
      if (!row.is_capacity() && row.std > 0.0) t.add(row, f);
  t.notes = notes_on(found);
  return t;
}

Table design_friction_table(const Results& results) {
  using R = DesignFrictionRow;
  TableOf<R> t(
      "design_friction",
      "How often slip with drawn friction exceeds slip with the design value, mean - 2 std");
  t.put_all(condition_column, level_column(results));
  t.share("same_motion", "Same motion and building",
          "probability that displacement with drawn friction exceeds that with mean - 2 std, of "
          "the same record and sample",
          &R::same_motion);
  t.share("same_motion_error", "Standard error of the samples", "standard error from the samples",
          &R::same_motion_error);
  t.length("design_mean", "Mean slip with mean - 2 std", "mean displacement with mean - 2 std",
           &R::design_mean_m);
  t.share("above_mean", "Any slip above that mean",
          "probability that a displacement with drawn friction exceeds design_mean",
          &R::above_mean);
  t.share("above_mean_error", "Standard error of the samples", "standard error from the samples",
          &R::above_mean_error);
  t.add_each(results.sensitivity->design_friction);
  t.notes = {"Normal friction is below mean - 2 std with a probability of 2.3 %.",
             "Intervals are over " + units_name(results) +
                 ", with the error of the samples added, which all records share. Without the "
                 "latter they are, but for the same motion, never narrower than "
                 "that of a binomial with one trial for each of the " +
                 units_name(results) + "."};
  return t;
}

}  // namespace glissade
