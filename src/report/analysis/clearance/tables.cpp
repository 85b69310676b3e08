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
  MeansByCondition of{results, conditions_of(results), below_roof(results, governing_column), {}};
  for (const RequiredClearance& required : results.clearance->required)
    of.means.push_back(required.largest);
  return of;
}

MeansByCondition means_by_period(const Results& results) {
  return {results, conditions_of(results), below_roof(results, period_column),
          results.clearance->by_period};
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
  struct Row {
    const RecordSummary& record;
    std::size_t suite, orientation;
    Condition at;
    ConditionHistory history;
  };
  TableOf<Row> t(
      "histories",
      std::string("Every history of the required clearance, in plan, by the roof's axes: "
                  "along the slope (positive where it falls)") +
          (slides_on_two_axes(results) ? " and across it" : "") +
          (shear ? "; base shear over the building's weight without the array" : ""));
  t.is_of_inputs = true;
  t.text("record", "Record", "", [](const Row& row) { return row.record.id; });
  t.text("orientation", "Orientation", "", [&](const Row& row) {
    return orientation_text(results, orientation_at(results, row.orientation));
  });
  conditions.put_in(t);
  t.length("displacement", "Displacement", "",
           [](const Row& row) { return row.history.displacement_m(); });
  t.length("vector_peak", "Vector peak", "", [](const Row& row) { return row.history.peak_m(); });
  const auto mean = [](HistoryValues<double> HistoryFields::*of) {
    return [=](const Row& row) { return row.history.mean(of); };
  };
  t.length("peak_along", "Peak along", "", mean(&HistoryFields::peak_along_m));
  t.length("peak_across", "Peak across", "", mean(&HistoryFields::peak_across_m));
  t.length("residual_along", "Residual along", "", mean(&HistoryFields::residual_along_m));
  t.length("residual_across", "Residual across", "", mean(&HistoryFields::residual_across_m));
  if (shear) {
    t.number("shear_along", "Base shear along", "", mean(&HistoryFields::shear_along));
    t.number("shear_across", "Base shear across", "", mean(&HistoryFields::shear_across));
  }
  t.count("uplift", "Uplift", "", [](const Row& row) { return row.history.lifts_off() ? 1 : 0; });
  for (std::size_t r = 0; r < results.records.size(); ++r) {
    const RecordSummary& record = results.records[r];
    for (std::size_t o = 0; o < same.size(); ++o)
      for (const Condition& at : places)
        if (same[o] == o) t.add({record, record.suite, o, at, grid.history(r, o, at)});
  }
  return t;
}

}  // namespace glissade
