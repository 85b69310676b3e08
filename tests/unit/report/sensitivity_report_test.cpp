// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

using test::states;
using testing::Not;

/// Records 60 % alone, friction 20 %, slope 10 %; at one threshold and one level.
Results made_up() {
  Results r = made_up_results();
  SensitivityResults& found = r.sensitivity.emplace();
  found.factors = {"records", "all that is drawn", "slope", "friction"};
  found.samples = 64;
  SpreadRow row;
  row.threshold_m = 0.3;
  row.std = 0.5;
  row.first = {0.6, 0.3, 0.1, 0.2};
  row.total = {0.7, 0.4, 0.15, 0.25};
  row.first_interval = {{0.4, 0.8}, {0.2, 0.4}, {0.0, 0.2}, {0.1, 0.3}};
  row.total_interval = row.first_interval;
  row.share_above = 0.125;
  row.record_error = 0.25;
  row.sample_error = 0.0625;
  found.rows = {row, row};
  found.rows[1].level = r.levels.front();
  found.rows[1].mean = 0.5;
  found.design_friction = {{0, "", 1.0, 0.02, {0.01, 0.03}, 0.004, 0.4, 0.3, {0.2, 0.4}, 0.05}};
  return r;
}

TEST(sensitivity_report, has_a_row_for_each_factor) {
  const Results r = made_up();
  const auto rows = table_named(r, "sensitivity").rows;
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(std::get<std::string>(rows[3][3]), "friction");
  EXPECT_EQ(std::get<NumberCell>(rows[3][4]).value, 0.2);
  EXPECT_EQ(std::get<NumberCell>(rows[3][5]).value, 0.25);
  EXPECT_EQ(table_named(r, "sensitivity_levels").rows.size(), 4u);
  EXPECT_EQ(table_named(r, "design_friction").rows.size(), 1u);
}

TEST(sensitivity_report, states_shares_errors_and_limits) {
  const std::string text = summary_text(made_up());
  EXPECT_THAT(text, states("60 %", "0.250", "0.062", "12 %", "mean - 2 std", "30 %"));
  EXPECT_THAT(summary_text(made_up_results()), Not(states("Spread")));
}

TEST(sensitivity_report, draws_the_largest_factor_first) {
  const std::vector<Figure> figures = make_figures(made_up());
  const auto figure = std::ranges::find(figures, FileName("sensitivity"), &Figure::name);
  ASSERT_NE(figure, figures.end());
  EXPECT_THAT(figures_of_tables(figures, csv_tables(made_up())),
              testing::Contains("sensitivity_levels"));
  ASSERT_EQ(figure->panels.size(), 1u);
  const std::vector<Tick>& ticks = figure->panels[0].y.ticks;
  ASSERT_EQ(ticks.size(), 3u);
  EXPECT_EQ(ticks[0].label, "records");
  EXPECT_EQ(ticks[1].label, "friction");
  EXPECT_GT(ticks[0].at, ticks[1].at);
  EXPECT_THAT(figure->below, states("capacity", "friction normal, mean 0.55"));
  EXPECT_THAT(figure->below, Not(states("error of the samples")));
}

TEST(sensitivity_report, draws_both_intervals_and_says_that_no_share_is_larger_alone) {
  Results r = made_up();
  r.sensitivity->rows.front().first.back() = 0.375;  // total: 0.25
  const std::vector<Figure> figures = make_figures(r);
  const Figure figure = *std::ranges::find(figures, FileName("sensitivity"), &Figure::name);
  EXPECT_THAT(figure.below, states("more alone", "error of the samples"));
  for (const char* label : {"95 % interval of alone", "95 % interval with interactions"})
    EXPECT_EQ(std::ranges::count(figure.panels.at(0).series, label, &DataSeries::label), 3)
        << label;
}

}  // namespace
}  // namespace glissade
