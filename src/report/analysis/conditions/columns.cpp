// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/conditions/view.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

Column condition_level_column(const Results& results) {
  if (results.measure == IntensityMeasure::mce_fraction)
    return {"fraction_of_mce", "", "Of MCE", ColumnKind::number, "intensity over the MCE"};
  const std::string suffix = unit_suffix(results.measure.unit());
  std::string names;
  for (const double level : results.levels) {
    const std::string name = level_name(results, level);
    if (!name.empty())
      names += fmt::format("{}{} {}", names.empty() ? "" : ", ", name, format_number(level));
  }
  return {"level", suffix.empty() ? "" : suffix.substr(1),
          results.intensity_symbol + (names.empty() ? "" : " (" + names + ")"), ColumnKind::number,
          "intensity level"};
}

}  // namespace

Cell condition_cell(const ConditionGrid& grid, ConditionAxis axis, std::size_t place) {
  if (axis == ConditionAxis::level || parameter_of(axis) != nullptr) return grid.value(axis, place);
  return label_of(grid, axis, place);
}

ConditionColumns::ConditionColumns(const Results& results, std::vector<ConditionAxis> without)
    : grid_(results) {
  for (const ConditionAxis axis : condition_axes) {
    if (grid_.has_several(axis) && std::ranges::find(without, axis) == without.end())
      axes_.push_back(axis);
  }
}

Column condition_column_of(const Results& results, ConditionAxis axis) {
  switch (axis) {
    case ConditionAxis::listed:
      return condition_column;
    case ConditionAxis::support:
      return text_column("support", "Array", "how the array stands on the building");
    case ConditionAxis::vertical:
      return text_column("vertical", "Vertical motion", "whether the vertical ground motion acts");
    case ConditionAxis::level:
      return condition_level_column(results);
    default:
      return listed_column(*parameter_of(axis));
  }
}

Where rows_at(const Results& results, const Table& table, const Condition& at, ConditionAxis but) {
  const ConditionGrid grid(results);
  Where rows;
  for (const ConditionAxis axis : condition_axes) {
    const std::string stem = condition_column_of(results, axis).stem;
    if (axis != but && grid.has_several(axis) &&
        std::ranges::count(table.columns, stem, &Column::stem) > 0)
      rows.emplace_back(stem, condition_cell(grid, axis, at[axis]));
  }
  return rows;
}

Column range_column(const char* stem, const char* heading, const std::string& description,
                    ColumnKind kind) {
  const bool length = kind == ColumnKind::length;
  return {stem, length ? "m" : "", heading + std::string(length ? ", m (in)" : ""), kind,
          description};
}

}  // namespace glissade
