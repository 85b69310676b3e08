// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/clearance/view.hpp"
#include "glissade/report/clearance_report.hpp"

namespace glissade {
namespace {

/// The columns that name a condition: only those whose axis has several values.
class ConditionColumns {
 public:
  ConditionColumns(const ClearanceResults& results, std::vector<ClearanceAxis> without)
      : results_(results) {
    for (const ClearanceAxis axis : clearance_axes) {
      if (has_several(results.grid, axis) && std::ranges::find(without, axis) == without.end())
        axes_.push_back(axis);
    }
  }

  std::vector<Column> columns() const {
    std::vector<Column> columns;
    if (results_.suites.size() > 1) columns.push_back(text_column("suite", "Suite"));
    for (const ClearanceAxis axis : axes_) columns.push_back(column(axis));
    return columns;
  }
  std::vector<Cell> cells(std::size_t suite, const ClearancePosition& at) const {
    std::vector<Cell> cells;
    if (results_.suites.size() > 1) cells.emplace_back(results_.suites[suite].name);
    for (const ClearanceAxis axis : axes_) cells.push_back(cell(axis, at[axis]));
    return cells;
  }

 private:
  Column level_column() const {
    const ClearanceGrid& grid = results_.grid;
    if (grid.level_symbol.empty()) return {"fraction_of_mce", "", "Of MCE"};
    const std::string suffix = unit_suffix(grid.level_unit);
    return {"level", suffix.empty() ? "" : suffix.substr(1), grid.level_symbol};
  }

  Column column(ClearanceAxis axis) const {
    switch (axis) {
      case ClearanceAxis::listed:
        return {"condition", "", "Condition", ColumnKind::text};
      case ClearanceAxis::support:
        return text_column("support", "Array");
      case ClearanceAxis::vertical:
        return text_column("vertical", "Vertical");
      case ClearanceAxis::response_modification:
        return {"response_modification", "", "R"};
      case ClearanceAxis::mass:
        return {"mass_ratio", "", "m/M"};
      case ClearanceAxis::slope:
        return {"slope", "deg", "Slope, deg"};
      case ClearanceAxis::level:
        return level_column();
      case ClearanceAxis::period:
        return {"period", "s", "T, s"};
    }
    return {};
  }
  Cell cell(ClearanceAxis axis, std::size_t place) const {
    const ClearanceGrid& grid = results_.grid;
    switch (axis) {
      case ClearanceAxis::response_modification:
        return grid.response_modification[place];
      case ClearanceAxis::mass:
        return grid.mass_ratio[place];
      case ClearanceAxis::slope:
        return grid.slope_deg[place];
      case ClearanceAxis::level:
        return grid.level[place];
      case ClearanceAxis::period:
        return grid.period_s[place];
      default:
        return label_of(grid, axis, place);
    }
  }

  const ClearanceResults& results_;
  std::vector<ClearanceAxis> axes_;
};

void append(std::vector<Column>& columns, std::initializer_list<Column> more) {
  columns.insert(columns.end(), more);
}

/// Conditions in which the array may slide.
bool slides(const ClearanceGrid& grid, const ClearancePosition& at) {
  return grid.support[at[ClearanceAxis::support]] == ArraySupport::isolated;
}

Column range_column(const char* stem, const char* heading, ColumnKind kind = ColumnKind::length) {
  return {stem, kind == ColumnKind::length ? "m" : "", heading, kind};
}

Column median_column(const char* heading, ColumnKind kind = ColumnKind::length) {
  Column column = range_column("median", heading, kind);
  column.with_interval = true;
  return column;
}

/// The suite's mean displacement over the orientations, at each of some places where the array may
/// slide: a period's own or the largest over the periods, then with the clearance.
Table displacements_table(const ClearanceResults& results, Table table, const Places& places,
                          Periods periods) {
  const ConditionColumns conditions(results, {ClearanceAxis::period, ClearanceAxis::support});
  const bool largest = periods == Periods::largest;
  table.notes = {"[ ]: 95 % interval of the median, from resampling records",
                 "bounds: with the orientation chosen record by record"};
  table.columns = conditions.columns();
  append(table.columns,
         {{largest ? "governing_period" : "period", "s", largest ? "At T, s" : "T, s"},
          range_column("lowest", "Lowest, m (in)"),
          median_column("Median, m (in)"),
          range_column("highest", "Highest, m (in)"),
          range_column("bound_lowest", "Lower bound, m (in)"),
          range_column("bound_highest", "Upper bound, m (in)")});
  if (largest) {
    append(table.columns, {range_column("clearance_median", "Clearance, median, m (in)"),
                           range_column("clearance_highest", "Clearance, highest, m (in)")});
  }
  for (std::size_t suite = 0; suite < results.suites.size(); ++suite) {
    const ClearanceQuestion question{.suite = suite};
    for (const ClearancePosition& at : places) {
      if (!slides(results.grid, at)) continue;
      const OrientationRange range = over_orientations(results, question, at, periods);
      const PerRecordBounds bounds = per_record_bounds(results, question, at, periods);
      const std::size_t period =
          largest ? governing_period(results, question, at) : at[ClearanceAxis::period];
      std::vector<Cell> row = conditions.cells(suite, at);
      row.insert(row.end(), {results.grid.period_s[period], range.lowest,
                             Estimate{range.median, range.interval, {}}, range.highest,
                             bounds.lowest, bounds.highest});
      if (largest) {
        row.insert(row.end(), {results.clearance_factor * range.median,
                               results.clearance_factor * range.highest});
      }
      table.add(std::move(row));
    }
  }
  return table;
}

Places all_places(const ClearanceGrid& grid) {
  Places places;
  for (std::size_t i = 0; i < grid.count(); ++i) places.push_back(grid.position(i));
  return places;
}

}  // namespace

Table clearance_table(const ClearanceResults& results) {
  return displacements_table(results,
                             {"clearances",
                              "The suite's mean displacement, the largest over the building "
                              "periods, over the orientations; and the clearance"},
                             all_but(results.grid, ClearanceAxis::period), Periods::largest);
}

Table clearance_periods_table(const ClearanceResults& results) {
  return displacements_table(
      results,
      {"by_period", "The suite's mean displacement by building period, over the orientations"},
      all_places(results.grid), Periods::one);
}

Table clearance_orientations_table(const ClearanceResults& results) {
  Table table{"orientations",
              "The suite's mean displacement in each orientation of all records, by building "
              "period; " +
                  results.suites.front().name + ", " +
                  conditions_text(results, {}, {ClearanceAxis::period, ClearanceAxis::support}),
              {text_column("orientation", "Orientation"),
               {"same_as", "", "Gives the same as", ColumnKind::count}},
              {},
              {}};
  for (const double period : results.grid.period_s) {
    table.columns.push_back({fmt::format("t_{:g}s", period), "m",
                             fmt::format("T {:g} s, m (in)", period), ColumnKind::length});
  }
  append(table.columns, {range_column("largest", "Largest, m (in)"),
                         range_column("clearance", "Clearance, m (in)")});
  for (std::size_t o = 0; o < results.orientations.size(); ++o) {
    std::vector<Cell> row{fmt::format("{}: {}", o + 1, to_string(results.orientations[o])),
                          static_cast<double>(results.same_as[o] + 1)};
    double largest = 0.0;
    for (const ClearancePosition& at : along(results.grid, ClearanceAxis::period)) {
      const double mean = suite_mean(results, {}, o, at);
      largest = std::max(largest, mean);
      row.emplace_back(mean);
    }
    row.insert(row.end(), {largest, results.clearance_factor * largest});
    table.add(std::move(row));
  }
  return table;
}

Table clearance_base_shear_table(const ClearanceResults& results) {
  const ConditionColumns conditions(results, {});
  Table table{"base_shear",
              "Base shear over the bare building's weight: the suite's mean of the SRSS of the "
              "peaks along both axes, over the orientations",
              conditions.columns(),
              {},
              {}};
  append(table.columns, {range_column("lowest", "Lowest", ColumnKind::number),
                         median_column("Median", ColumnKind::number),
                         range_column("highest", "Highest", ColumnKind::number)});
  for (std::size_t suite = 0; suite < results.suites.size(); ++suite) {
    const ClearanceQuestion question{.suite = suite, .number = HistoryNumber::base_shear};
    for (std::size_t i = 0; i < results.grid.count(); ++i) {
      const ClearancePosition at = results.grid.position(i);
      const OrientationRange range = over_orientations(results, question, at, Periods::one);
      std::vector<Cell> row = conditions.cells(suite, at);
      row.insert(row.end(),
                 {range.lowest, Estimate{range.median, range.interval, {}}, range.highest});
      table.add(std::move(row));
    }
  }
  return table;
}

Table clearance_histories_table(const ClearanceResults& results) {
  const ConditionColumns conditions(results, {});
  Table table{"histories",
              "Every history that was run, in plan, by the roof's axes: along the slope (positive "
              "where it falls) and across it; base shear over the bare building's weight",
              {text_column("record", "Record"), text_column("orientation", "Orientation")},
              {},
              {}};
  for (Column& column : conditions.columns()) table.columns.push_back(std::move(column));
  append(table.columns, {range_column("displacement", "Displacement"),
                         range_column("vector_peak", "Vector peak"),
                         range_column("peak_along", "Peak along"),
                         range_column("peak_across", "Peak across"),
                         range_column("residual_along", "Residual along"),
                         range_column("residual_across", "Residual across"),
                         {"shear_along", "", "Base shear along"},
                         {"shear_across", "", "Base shear across"},
                         {"uplift", "", "Uplift", ColumnKind::count}});
  for (std::size_t record = 0; record < results.records.size(); ++record) {
    for (std::size_t o = 0; o < results.orientations.size(); ++o) {
      if (results.same_as[o] != o) continue;
      for (std::size_t i = 0; i < results.grid.count(); ++i) {
        const ClearanceHistory& h = results.at(record, o, i);
        std::vector<Cell> row{results.records[record].id, to_string(results.orientations[o])};
        for (Cell& cell : conditions.cells(results.records[record].suite, results.grid.position(i)))
          row.push_back(std::move(cell));
        row.insert(row.end(), {h.displacement_m, h.peak_m, h.peak_along_m, h.peak_across_m,
                               h.residual_along_m, h.residual_across_m, h.shear_along,
                               h.shear_across, static_cast<double>(h.uplift)});
        table.add(std::move(row));
      }
    }
  }
  return table;
}

}  // namespace glissade
