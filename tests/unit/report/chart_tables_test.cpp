// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

using test::states;
using testing::ElementsAre;
using testing::Not;

/// The row of chart.csv at level 1 g of the made-up chart, by places on its axes.
std::size_t row_at_1g(std::size_t slope, std::size_t friction) {
  return (1 * 15 + slope) * 15 + friction;
}

TEST(chart_tables, are_those_the_chart_can_fill) {
  EXPECT_THAT(names(csv_tables(made_up_chart_results())),
              ElementsAre("chart", "chart_by_period", "chart_readings", "chart_standards",
                          "records", "spectra"));
  Results results = made_up_one_record_chart();
  EXPECT_THAT(names(csv_tables(results)), ElementsAre("chart", "chart_readings", "records"));
  results.chart->readings.clear();
  EXPECT_THAT(names(csv_tables(results)), ElementsAre("chart", "records"));
}

TEST(chart_tables, give_the_slip_of_a_flat_roof_at_1_g) {
  // 0.25 m (1 - 0.5)^2 / 0.5 = 0.125 m in the mean; x 1.1, x 1.306, x 1.405, x 1.45.
  const Table table = table_named(made_up_chart_results(), "chart");
  const std::size_t row = row_at_1g(0, 8);
  EXPECT_DOUBLE_EQ(number(table, row, "mu"), 0.5);
  EXPECT_NEAR(number(table, row, "mean_slip"), 0.125, 1e-12);
  EXPECT_NEAR(number(table, row, "clearance"), 0.1375, 1e-12);
  EXPECT_NEAR(number(table, row, "p84_slip"), 0.16325, 1e-12);
  EXPECT_NEAR(number(table, row, "p95_slip"), 0.175625, 1e-12);
  EXPECT_NEAR(number(table, row, "envelope"), 0.18125, 1e-12);
  EXPECT_EQ(number(table, row, "governing_period"), 0.5);
  EXPECT_EQ(number(table, row, "free_sliding"), 0.0);
}

TEST(chart_tables, say_how_to_interpolate_and_have_whole_rows_with_units) {
  for (const Table& table : csv_tables(made_up_chart_results()))
    EXPECT_THAT(to_csv(table), test::has_rows_as_wide_as_its_header()) << table.name.text();
  const Table chart = table_named(made_up_chart_results(), "chart");
  EXPECT_THAT(to_csv(chart), testing::StartsWith("level_g,slope_deg,mu,clearance_m,mean_slip_m,"
                                                 "mean_slip_low95_m,"));
  EXPECT_THAT(to_csv(columns_table({chart})), states("Between rows: interpolate"));
}

TEST(chart_tables, report_free_sliding_as_infinite) {
  // tan(6 degrees) = 0.105 > 0.1.
  const Table table = table_named(made_up_chart_results(), "chart");
  const std::size_t row = row_at_1g(12, 0);
  EXPECT_EQ(number(table, row, "free_sliding"), 1.0);
  EXPECT_EQ(number(table, row, "clearance"), std::numeric_limits<double>::infinity());
  EXPECT_THAT(to_csv(table), states("\n1,6,0.1,inf,inf,,,inf,inf,inf,0.5,1,"));
}

TEST(chart_tables, give_standards_only_where_they_apply) {
  // 60 (1 - 0.4)^2 = 21.6 in at S_DS = 1 g, for slopes of 3 degrees or less and mu of 0.4 or more;
  // ASCE 7-16 5 (1 - 0.4)^2 = 1.8 ft is below its floor of 24 in, for slopes of 1 in 20 or less.
  const Table table = table_named(made_up_chart_results(), "chart");
  EXPECT_NEAR(number(table, row_at_1g(5, 7), "seaoc_pv1_2012"), 0.54864, 1e-12);  // 2.5, 0.45
  EXPECT_NEAR(number(table, row_at_1g(6, 6), "seaoc_pv1_2012"), 0.54864, 1e-12);  // 3, 0.4
  EXPECT_TRUE(std::isnan(number(table, row_at_1g(7, 7), "seaoc_pv1_2012")));      // 3.5 degrees
  EXPECT_TRUE(std::isnan(number(table, row_at_1g(5, 5), "seaoc_pv1_2012")));      // mu = 0.35
  EXPECT_NEAR(number(table, row_at_1g(5, 6), "asce7_16"), 0.6096, 1e-12);         // 2.5, 0.4
  EXPECT_TRUE(std::isnan(number(table, row_at_1g(5, 5), "asce7_16")));            // mu = 0.35
  EXPECT_TRUE(std::isnan(number(table, row_at_1g(6, 7), "asce7_16")));            // 3 degrees
}

TEST(chart_tables, give_every_period_by_itself) {
  // 0.7, 1 and 0.4 of 0.125 m on a flat roof with mu = 0.5 at 1 g.
  const Table table = table_named(made_up_chart_results(), "chart_by_period");
  const std::size_t row = 3 * row_at_1g(0, 8);
  EXPECT_NEAR(number(table, row, "mean_slip"), 0.0875, 1e-12);
  EXPECT_NEAR(number(table, row + 1, "mean_slip"), 0.125, 1e-12);
  EXPECT_NEAR(number(table, row + 2, "mean_slip"), 0.05, 1e-12);
  EXPECT_EQ(number(table, row + 2, "period"), 1.0);
}

TEST(chart_tables, give_readings_with_the_given_and_the_computed_in_their_own_columns) {
  const std::string csv = to_csv(table_named(made_up_chart_results(), "chart_readings"));
  EXPECT_THAT(
      csv, states("\n1,2,displacement,clearance,0.5,0.275\n", "\n1,2,friction,clearance,0.45,0.5\n",
                  "\n1,2,friction,envelope,inf,0.5\n"));
}

TEST(chart_tables, show_of_one_record_its_peak_alone) {
  const Results results = made_up_one_record_chart();
  const Table table = table_named(results, "chart");
  // 0.25 m (1.5 - 0.5)^2 / 0.5 at 1.5 g.
  EXPECT_NEAR(number(table, (15 * 15 + 0) * 15 + 8, "peak_slip"), 0.5, 1e-12);
  for (const Column& column : table.columns) EXPECT_NE(column.stem, "clearance");
  EXPECT_EQ(table_named(results, "chart_readings").rows.size(), 2u);  // one number a question
}

TEST(chart_tables, count_the_points_that_need_more_than_is_prescribed) {
  Results results = made_up_chart_results();
  // Everywhere SEAOC applies at 1 g, 0.17 to 0.2 m at most: less than its 0.549 m.
  const Table table = table_named(results, "chart_standards");
  EXPECT_EQ(number(table, 1, "above_share"), 0.0);
  EXPECT_NEAR(number(table, 1, "prescribed"), 0.54864, 1e-12);
  // Flat and mu = 0.45 made to need more: 1 of 7 slopes (to 3) x 9 frictions (0.4 to 0.8).
  results.chart->points[row_at_1g(0, 7)].clearance_m = 0.6;
  EXPECT_NEAR(number(table_named(results, "chart_standards"), 1, "above_share"), 1.0 / 63.0, 1e-12);
}

// A flat roof with mu = 0.5 at 1 g: 0.1375 m.
TEST(chart_tables, of_a_study_in_inches_have_inches_first_on_pages_and_metres_in_files) {
  Results results = made_up_chart_results();
  results.records.front().pgv_mps = 0.254;
  results.records.front().pgd_m = 0.127;
  results.units = UnitSystem::us_customary;
  const std::string matrix = summary_text(results, {});
  EXPECT_THAT(matrix, states("1.1 x mean", "5.4"));
  EXPECT_THAT(matrix, Not(states("0.138")));
  const LengthUnits units(results.units);
  const Table records = records_table(results);
  EXPECT_THAT(to_html(records).str(), states(">PGV, in/s<", ">PGD, in<", ">10.0<", ">5.00<"));
  EXPECT_THAT(to_csv(records), states("pgv_mps,pgd_m,", ",0.254,0.127,"));
}

}  // namespace
}  // namespace glissade
