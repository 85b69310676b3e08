// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/conditions/means.hpp"

#include <utility>

#include "analysis/conditions/view.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"

namespace glissade {
namespace {

const char* what_is_averaged(ColumnKind kind) {
  return kind == ColumnKind::length
             ? "mean over the suite of the peak displacement in plan"
             : "mean over the suite of the base shear over the weight of the building";
}

std::vector<Column> range_columns(ColumnKind kind) {
  const std::string mean = what_is_averaged(kind);
  std::vector<Column> columns{
      range_column("lowest", "Lowest", mean + ", all records in the least orientation", kind),
      range_column("median", "Median", mean + ", median over the orientations", kind),
      range_column("highest", "Highest", mean + ", all records in the largest orientation", kind),
      range_column("bound_lowest", "Lower bound", mean + ", each record in its least orientation",
                   kind),
      range_column("bound_highest", "Upper bound",
                   mean + ", each record in its largest orientation", kind),
      range_column("largest", "Largest history", "largest of all records and orientations", kind)};
  columns[1].with_interval = columns[2].with_interval = true;
  // A terminal has no room for all: displacements have their bounds, shears their largest.
  columns[3].detail = columns[4].detail = kind != ColumnKind::length;
  columns[5].detail = kind == ColumnKind::length;
  return columns;
}

std::vector<Cell> range_cells(const SuiteMean& mean) {
  const OrientationRange& range = mean.range;
  return {range.lowest,
          Estimate{range.median, range.interval},
          Estimate{range.highest, range.highest_interval},
          mean.bounds.lowest,
          mean.bounds.highest,
          mean.largest};
}

std::vector<Column> place_columns(const MeansByCondition& of) {
  std::vector<Column> columns = of.conditions.columns();
  if (of.period != nullptr) columns.push_back(*of.period);
  return columns;
}

std::vector<Cell> place_cells(const MeansByCondition& of, std::size_t i) {
  std::vector<Cell> cells = of.conditions.cells(of.means[i].suite, of.places[i % of.places.size()]);
  if (of.period != nullptr) {
    constexpr ConditionAxis period = ConditionAxis::period;
    cells.emplace_back(ConditionGrid(of.results).value(period, of.means[i].at[period]));
  }
  return cells;
}

}  // namespace

Table means_table(const MeansByCondition& of, FileName name, std::string title) {
  Table table{std::move(name), std::move(title), place_columns(of), {}, {}};
  append(table.columns, range_columns(of.kind));
  for (std::size_t i = 0; i < of.means.size(); ++i) {
    std::vector<Cell> row = place_cells(of, i);
    append(row, range_cells(of.means[i]));
    table.add(std::move(row));
  }
  table.notes = {"[ ]: 95 % interval, from resampling records",
                 "bounds: with the orientation chosen record by record"};
  return table;
}

Table means_by_orientation_table(const MeansByCondition& of, FileName name, std::string title) {
  Table table{std::move(name), std::move(title), place_columns(of), {}, {}};
  append(table.columns, {{"orientation", "", "Orientation", ColumnKind::count,
                          "orientation of all records: from 1, as in `cases`"},
                         range_column("mean", "Mean", what_is_averaged(of.kind), of.kind)});
  for (std::size_t i = 0; i < of.means.size(); ++i) {
    for (std::size_t o = 0; o < of.means[i].by_orientation.size(); ++o) {
      std::vector<Cell> row = place_cells(of, i);
      append(row, {static_cast<double>(o + 1), of.means[i].by_orientation[o]});
      table.add(std::move(row));
    }
  }
  return table;
}

Table ratios_table(const RatiosByCondition& of, FileName name, std::string title) {
  Table table{std::move(name), std::move(title), of.conditions.columns(), {}, {}};
  constexpr ColumnKind number = ColumnKind::number;
  append(table.columns, {range_column("lowest", "Lowest", "least orientation", number),
                         range_column("median", "Median", "median over the orientations", number),
                         range_column("highest", "Highest", "largest orientation", number)});
  for (const Condition& at : of.places) {
    const std::vector<double> ratios =
        ratios_by_orientation(of.results, of.question, at, of.reference(at));
    std::vector<Cell> row = of.conditions.cells(of.question.suite, at);
    append(row, {ratios.empty() ? nan : ratios.front(), quantile_of(ratios, 0.5),
                 ratios.empty() ? nan : ratios.back()});
    table.add(std::move(row));
  }
  return table;
}

}  // namespace glissade
