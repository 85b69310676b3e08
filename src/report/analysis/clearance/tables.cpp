// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/conditions/means.hpp"
#include "analysis/conditions/view.hpp"
#include "glissade/report/clearance_report.hpp"

namespace glissade {
namespace {

ConditionColumns conditions_of(const Results& results) {
  return ConditionColumns(results, {ConditionAxis::period, ConditionAxis::support});
}

const Column governing_column{"governing_period", "s", "At T, s", ColumnKind::number,
                              "building period at which the mean is largest; nan: drawn"},
    period_column{"period", "s", "T, s", ColumnKind::number, "building period; nan: drawn"};

/// Nothing of motions of a roof, below which no building is computed.
const Column* below_roof(const Results& results, const Column& column) {
  return results.suites.front().of_roof ? nullptr : &column;
}

MeansByCondition largest_means(const Results& results) {
  MeansByCondition of{results,
                      conditions_of(results),
                      below_roof(results, governing_column),
                      sliding_conditions(ConditionGrid(results), Periods::largest),
                      {}};
  for (const RequiredClearance& required : results.clearance->required)
    of.means.push_back(required.largest);
  return of;
}

MeansByCondition means_by_period(const Results& results) {
  return {results, conditions_of(results), below_roof(results, period_column),
          sliding_conditions(ConditionGrid(results), Periods::one), results.clearance->by_period};
}

}  // namespace

Table clearance_table(const Results& results) {
  Table table =
      means_table(largest_means(results), "clearances",
                  std::string("The suite's mean displacement") + over_building_periods(results) +
                      ", over the orientations; and the clearance" + rule_text(results));
  append(table.columns, {range_column("clearance", "Clearance", "required clearance by the rule"),
                         range_column("clearance_median", "By the median",
                                      "the factor on the median of the orientations"),
                         range_column("clearance_highest", "By the largest",
                                      "the factor on the largest of the orientations")});
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const RequiredClearance& required = results.clearance->required[i];
    append(table.rows[i], {required.clearance_m, required.median_m, required.highest_m});
  }
  return table;
}

Table clearance_periods_table(const Results& results) {
  return means_table(means_by_period(results), "by_period",
                     results.suites.front().of_roof
                         ? "The suite's mean displacement, over the orientations"
                         : "The suite's mean displacement by building period, over the "
                           "orientations");
}

Table clearance_yielding_table(const Results& results) {
  const ConditionGrid grid(results);
  std::vector<Condition> places = sliding_conditions(grid, Periods::one);
  if (!covers(results, ClearanceTopic::yielding)) places.clear();
  return ratios_table({results,
                       {},
                       ConditionColumns(results, {ConditionAxis::support}),
                       places,
                       [&](const Condition& at) { return with_reference_strength(grid, at); }},
                      "yielding",
                      "The suite's mean displacement over that on " +
                          reference_strength_text(grid) + ", over the orientations");
}

std::vector<Table> clearance_by_orientation_tables(const Results& results) {
  return {
      means_by_orientation_table(
          means_by_period(results), "by_orientation",
          "The suite's mean displacement by building period, in each orientation"),
      means_by_orientation_table(largest_means(results), "clearances_by_orientation",
                                 std::string("The suite's mean displacement in each orientation") +
                                     over_building_periods(results))};
}

Table clearance_orientations_table(const Results& results) {
  const bool of_roof = results.suites.front().of_roof;
  Table table{"orientations",
              "The suite's mean displacement in each orientation of all records" +
                  std::string(of_roof ? "; " : ", by building period; ") +
                  results.suites.front().name + ", " +
                  conditions_text(results, shown_condition(ConditionGrid(results)),
                                  {ConditionAxis::period, ConditionAxis::support}),
              {text_column("orientation", "Orientation", "orientation of all records"),
               {"same_as", "", "Gives the same as", ColumnKind::count,
                "number of the first orientation with the same histories"}},
              {},
              {}};
  table.suite = 0;
  const ConditionGrid grid(results);
  const Places periods = shown_along(grid, ConditionAxis::period);
  for (const Condition& at : periods) {
    const double period = grid.value(ConditionAxis::period, at);
    table.columns.push_back(
        {of_roof ? "mean" : fmt::format("t_{:g}s", period), "m",
         of_roof ? "Mean, m (in)" : fmt::format("T {:g} s, m (in)", period), ColumnKind::length,
         of_roof ? "mean over the suite" : "mean over the suite at this building period"});
  }
  append(table.columns, {range_column("largest", "Largest", "largest of the building periods"),
                         range_column("clearance", "Clearance", "required clearance by the rule")});
  const std::vector<CaseNumber> same = same_orientations(results);
  for (std::size_t o = 0; o < same.size(); ++o) {
    std::vector<Cell> row{
        fmt::format("{}: {}", o + 1, orientation_text(results, orientation_at(results, o))),
        static_cast<double>(same[o] + 1)};
    double largest = 0.0;
    for (const Condition& at : periods) {
      const double mean = suite_mean(results, {}, o, at);
      largest = std::max(largest, mean);
      row.emplace_back(mean);
    }
    append(row, {largest, results.clearance->factor * largest});
    table.add(std::move(row));
  }
  return table;
}

Table clearance_histories_table(const Results& results) {
  const ConditionGrid grid(results);
  const Places places = all_conditions(grid);
  const std::vector<CaseNumber> same = same_orientations(results);
  const ConditionColumns conditions(results);
  const bool shear = results.base_shear.has_value();
  Table table{"histories",
              std::string("Every history of the required clearance, in plan, by the roof's axes: "
                          "along the slope (positive where it falls)") +
                  (slides_on_two_axes(results) ? " and across it" : "") +
                  (shear ? "; base shear over the building's weight without the array" : ""),
              {text_column("record", "Record"), text_column("orientation", "Orientation")},
              {},
              {}};
  table.is_of_inputs = true;
  append(table.columns, conditions.columns());
  append(table.columns,
         {range_column("displacement", "Displacement"), range_column("vector_peak", "Vector peak"),
          range_column("peak_along", "Peak along"), range_column("peak_across", "Peak across"),
          range_column("residual_along", "Residual along"),
          range_column("residual_across", "Residual across")});
  if (shear) {
    append(table.columns,
           {{"shear_along", "", "Base shear along"}, {"shear_across", "", "Base shear across"}});
  }
  append(table.columns, {{"uplift", "", "Uplift", ColumnKind::count}});
  std::vector<HistoryValues<double> HistoryFields::*> fields{
      &HistoryFields::peak_along_m, &HistoryFields::peak_across_m, &HistoryFields::residual_along_m,
      &HistoryFields::residual_across_m};
  if (shear)
    fields.insert(fields.end(), {&HistoryFields::shear_along, &HistoryFields::shear_across});
  for (std::size_t record = 0; record < results.records.size(); ++record) {
    for (std::size_t o = 0; o < same.size(); ++o) {
      if (same[o] != o) continue;
      for (const Condition& at : places) {
        const ConditionHistory h = grid.history(record, o, at);
        std::vector<Cell> row{results.records[record].id,
                              orientation_text(results, orientation_at(results, o))};
        append(row, conditions.cells(results.records[record].suite, at));
        append(row, {h.displacement_m(), h.peak_m()});
        for (const auto field : fields) row.emplace_back(h.mean(field));
        append(row, {h.lifts_off() ? 1.0 : 0.0});
        table.add(std::move(row));
      }
    }
  }
  return table;
}

}  // namespace glissade
