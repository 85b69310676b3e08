// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "results/archive.hpp"
#include "results/envelope.hpp"
#include "results/shared_schema.hpp"

namespace glissade {

/// Means over a suite by condition, in `rows` of which `mean(row)` is a SuiteMean. `what` is their
/// mean, its unit in the names of the datasets: {"displacement_m", "m", "displacement"}.
struct MeanLabel {
  std::string name;
  const char* unit;
  std::string what;
};
template <class Archive, class Rows, class Mean>
void exchange_suite_means(const Archive& archive, const IntensityScale& scale,
                          const MeanLabel& label, Rows& rows, Mean mean) {
  const Columns column(archive, rows, "suite");
  column("suite", {"-", "position of the suite"}, member(mean, &SuiteMean::suite));
  column("first_case",
         {"-", "position in `cases` of the condition's first; one for each sample and orientation"},
         member(mean, &SuiteMean::first_case));
  column("condition", {"-", "what the study lists of it"}, member(mean, &SuiteMean::condition));
  column(scale.level, {scale.unit, "intensity level"}, member(mean, &SuiteMean::level));
  column("period_s", {"s", "building period; nan: drawn"}, member(mean, &SuiteMean::period_s));
  const auto number = [&](const std::string& which, const std::string& text, auto field) {
    const std::string description = label.what + ", " + text;
    column(which + label.name, {label.unit, description.c_str()}, member(mean, field));
  };
  const auto of_range = [](auto which) { return member(&SuiteMean::range, which); };
  const auto of_bounds = [](auto which) { return member(&SuiteMean::bounds, which); };
  number("lowest_", "mean over the suite, all records in the least orientation",
         of_range(&OrientationRange::lowest));
  number("median_", "mean over the suite, median over the orientations",
         of_range(&OrientationRange::median));
  number("median_", "95 % interval of that median", of_range(&OrientationRange::interval));
  number("highest_", "mean over the suite, all records in the largest orientation",
         of_range(&OrientationRange::highest));
  number("highest_", "95 % interval of that largest",
         of_range(&OrientationRange::highest_interval));
  number("lower_bound_", "mean over the suite, each record in its least orientation",
         of_bounds(&PerRecordBounds::lowest));
  number("upper_bound_", "mean over the suite, each record in its largest orientation",
         of_bounds(&PerRecordBounds::highest));
  number("largest_", "largest of all records and orientations", &SuiteMean::largest);
  number("by_orientation_", "mean over the suite, by (row, orientation of all records)",
         &SuiteMean::by_orientation);
}

/// Of conditions that the results have.
inline void check_suite_means(const Results& results, const std::vector<Condition>& places,
                              auto& rows, auto mean) {
  const ConditionTable& conditions = *results.conditions;
  expect_fit(rows.size() == results.suites.size() * places.size(), "suite", "conditions");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const SuiteMean& row = std::invoke(mean, rows[i]);
    expect_fit(row.suite == i / places.size(), "suite", "conditions");
    expect_fit(row.first_case < results.cases.size(), "first_case", "cases");
    expect_fit(row.by_orientation.size() == conditions.orientations.size(), "by_orientation",
               "orientations");
  }
}

}  // namespace glissade
