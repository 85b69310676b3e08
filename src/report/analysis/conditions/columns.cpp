// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/columns.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/conditions/view.hpp"
#include "glissade/motion/roof_words.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

Column condition_level_column(const Results& results) {
  const ConditionGrid& grid = results.conditions->grid;
  if (grid.level_symbol.empty())
    return {"fraction_of_mce", "", "Of MCE", ColumnKind::number, "intensity over the MCE"};
  const std::string suffix = unit_suffix(grid.level_unit);
  std::string names;
  for (const double level : grid.level) {
    const std::string name = earthquake_name(level, grid.dbe_level);
    if (!name.empty())
      names += fmt::format("{}{} {}", names.empty() ? "" : ", ", name, format_number(level));
  }
  return {"level", suffix.empty() ? "" : suffix.substr(1),
          grid.level_symbol + (names.empty() ? "" : " (" + names + ")"), ColumnKind::number,
          "intensity level"};
}

}  // namespace

Cell condition_cell(const Results& results, ConditionAxis axis, std::size_t place) {
  const ConditionGrid& grid = results.conditions->grid;
  switch (axis) {
    case ConditionAxis::response_modification:
      return grid.response_modification[place];
    case ConditionAxis::mass:
      return grid.mass_ratio[place];
    case ConditionAxis::slope:
      return grid.slope_deg[place];
    case ConditionAxis::level:
      return grid.level[place];
    case ConditionAxis::period:
      return grid.period_s[place];
    default:
      return results.suites.front().of_roof ? in_words_of_roof(label_of(grid, axis, place))
                                            : label_of(grid, axis, place);
  }
}

ConditionColumns::ConditionColumns(const Results& results, std::vector<ConditionAxis> without)
    : results_(results) {
  for (const ConditionAxis axis : condition_axes) {
    if (has_several(results.conditions->grid, axis) &&
        std::ranges::find(without, axis) == without.end())
      axes_.push_back(axis);
  }
}

std::vector<Column> ConditionColumns::columns() const {
  std::vector<Column> columns;
  if (results_.suites.size() > 1)
    columns.push_back(text_column("suite", "Suite", "name of the suite"));
  for (const ConditionAxis axis : axes_) columns.push_back(condition_column_of(results_, axis));
  return columns;
}

std::vector<Cell> ConditionColumns::cells(std::size_t suite, const Condition& at) const {
  std::vector<Cell> cells;
  if (results_.suites.size() > 1) cells.emplace_back(results_.suites[suite].name);
  for (const ConditionAxis axis : axes_) cells.push_back(condition_cell(results_, axis, at[axis]));
  return cells;
}

Column condition_column_of(const Results& results, ConditionAxis axis) {
  switch (axis) {
    case ConditionAxis::listed:
      return condition_column;
    case ConditionAxis::support:
      return text_column("support", "Array", "how the array stands on the building");
    case ConditionAxis::vertical:
      return text_column("vertical", "Vertical motion", "whether the vertical ground motion acts");
    case ConditionAxis::response_modification:
      return listed_column("building", "response_modification");
    case ConditionAxis::mass:
      return listed_column("building", "mass_ratio");
    case ConditionAxis::slope:
      return listed_column("roof", "slope_deg");
    case ConditionAxis::level:
      return condition_level_column(results);
    case ConditionAxis::period:
      return listed_column("building", "period_s");
  }
  return {};
}

Where rows_at(const Results& results, const Table& table, const Condition& at, ConditionAxis but) {
  Where rows;
  for (const ConditionAxis axis : condition_axes) {
    const std::string stem = condition_column_of(results, axis).stem;
    if (axis != but && has_several(results.conditions->grid, axis) &&
        std::ranges::count(table.columns, stem, &Column::stem) > 0)
      rows.emplace_back(stem, condition_cell(results, axis, at[axis]));
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
