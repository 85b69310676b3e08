// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <limits>
#include <set>
#include <sstream>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

using test::states;
using testing::Contains;
using testing::HasSubstr;

/// 12 records, capacities C sqrt(c / 0.3 m), C of median 0.9 g.
Results made_up_hazard() {
  Results results = made_up_results();
  StudyConfig config;
  config.sampling.bootstrap_replicates = 100;
  config.hazard = HazardConfig{
      HazardCurve::power_law(1e-3, 2.0), "0.001 x^-2", 25.0, {1.0 / 700, rate_of(0.01, 50.0)}};
  results.hazard = HazardAnalysis::find(config, results);
  return results;
}

TEST(hazard_report, has_a_row_for_each_run_and_threshold_target_and_quantity) {
  const Results r = made_up_hazard();
  const std::size_t runs = r.runs.size();
  EXPECT_EQ(table_named(r, "hazard").rows.size(), runs * r.thresholds_m.size());
  EXPECT_EQ(table_named(r, "hazard_targets").rows.size(), runs * 2);
  EXPECT_EQ(table_named(r, "design_life").rows.size(), runs * 3);
  EXPECT_EQ(table_named(r, "hazard_curve").rows.size(), runs * r.hazard->runs[0].curve.size());
  EXPECT_THAT(html_report(r, {}), states("25 years"));
}

TEST(hazard_report, has_rows_as_wide_as_the_header_in_every_file) {
  Results r = made_up_hazard();
  for (HazardRun& run : r.hazard->runs)
    run.prescribed = {
        {Standard::seaoc_pv1_2012, 1.0, {0.5, Provenance::checked, ""}, {1e-3, {5e-4, 2e-3}}}};
  for (const Table& table : csv_tables(r))
    EXPECT_THAT(to_csv(table), test::has_rows_as_wide_as_its_header()) << table.name.text();
}

TEST(hazard_report, compares_what_is_prescribed_with_the_displacement_of_1_percent_in_50_years) {
  Results r = made_up_hazard();
  const auto has_table = [&] {
    return std::ranges::count(csv_tables(r), FileName("hazard_standards"), &Table::name) == 1;
  };
  EXPECT_FALSE(has_table());
  for (HazardRun& run : r.hazard->runs) {
    run.curve = {{0.1, {1e-3, {}}}, {1.0, {1e-5, {}}}};  // 2.01e-4 at 0.1 x (1e-3 / 2.01e-4)^(1/2)
    run.prescribed = {
        {Standard::seaoc_pv1_2012, 1.0, {0.5, Provenance::checked, ""}, {1e-3, {5e-4, 2e-3}}}};
  }
  ASSERT_TRUE(has_table());
  const Table table = table_named(r, "hazard_standards");
  const double target_m = 0.1 * std::sqrt(1e-3 / rate_of(0.01, 50.0));
  EXPECT_NEAR(std::get<NumberCell>(table.rows[0][7]).value, target_m, 1e-12);
  EXPECT_NEAR(std::get<double>(table.rows[0][8]), target_m / 0.5, 1e-12);
  EXPECT_THAT(answer_sentences(r), Contains(states("SEAOC PV1-2012", format_length(0.5), "4.9 %",
                                                   format_length(target_m))));
}

// Histories slide at the lowest level: what is read there is a lower bound, in every table and
// sentence.
TEST(hazard_report, marks_what_rests_on_shaking_below_the_levels) {
  Results r = made_up_hazard();
  for (HazardRun& run : r.hazard->runs) {
    run.curve = {{0.1, {1e-3, {}}, 0.4}, {1.0, {1e-5, {}}, 0.2}};
    run.targets = {{2e-3, {std::numeric_limits<double>::quiet_NaN(), {}}, 0.1, 0.4},
                   {1e-4, {0.3, {}}, 0.5, 0.2}};
    run.prescribed = {
        {Standard::seaoc_pv1_2012, 1.0, {0.5, Provenance::checked, ""}, {1e-3, {}}, 0.2}};
    run.moving_share = 0.4;
  }
  for (const char* name : {"hazard_curve", "hazard_targets", "hazard_standards", "design_life",
                           "design_life_distribution"}) {
    const std::string columns = to_csv(columns_table({table_named(r, name)}));
    EXPECT_THAT(columns, HasSubstr("> is a lower bound")) << name;
    EXPECT_THAT(columns, HasSubstr("below_share")) << name;
  }
  const Table curve = table_named(r, "hazard_curve");
  EXPECT_EQ(cell_text(curve.columns[2], curve.rows[0][2]).substr(0, 2), "> ");
  EXPECT_THAT(answer_sentences(r), Contains(states("is not known", "lowest level already")));
  EXPECT_THAT(answer_sentences(r), Contains(states("or more", "20 %", "begin the levels lower")));
  EXPECT_THAT(answer_sentences(r),
              Contains(states("SEAOC PV1-2012", "at least 4.9 %", "at least")));
  for (HazardRun& run : r.hazard->runs) run.curve.front() = {0.1, {1e-4, {}}, 0.4};
  EXPECT_THAT(answer_sentences(r), Contains(states("SEAOC PV1-2012", "an unknown displacement")));
  const Figure figure = figure_named(make_figures(r), "hazard");
  for (const DataSeries& line : figure.panels.at(0).series) EXPECT_TRUE(line.x.empty());
}

TEST(hazard_report, draws_decades_of_rates_above_zero_only) {
  Results r = made_up_hazard();
  for (HazardRun& run : r.hazard->runs) run.targets.back().annual_rate = 0.0;  // log10: -inf
  const Axis axis = figure_named(make_figures(r), "hazard").panels.at(0).y;
  EXPECT_TRUE(std::isfinite(axis.low));
  EXPECT_EQ(axis.ticks.size(), std::round(std::log10(axis.high / axis.low)) + 1.0);
  for (HazardRun& run : r.hazard->runs) run.curve.clear();
  EXPECT_EQ(figure_named(make_figures(r), "hazard").panels.at(0).y.ticks.size(), 2u);
}

TEST(hazard_report, draws_the_distribution_over_the_design_life) {
  const Figure figure = figure_named(make_figures(made_up_hazard()), "design_life");
  ASSERT_EQ(figure.panels.size(), 1u);
  ASSERT_EQ(figure.panels[0].series.size(), 3u);
  std::set<int> dashes;  // by which lines that coincide differ
  for (const DataSeries& line : figure.panels[0].series) {
    EXPECT_TRUE(std::ranges::is_sorted(line.y, std::greater<>()));
    dashes.insert(line.look.dash);
  }
  EXPECT_EQ(dashes.size(), 3u);
}

TEST(hazard_report, states_what_is_kept_over_a_design_life) {
  const Results r = made_up_hazard();
  for (const char* name : {"design_life", "design_life_distribution"})
    EXPECT_THAT(table_named(r, name).notes,
                Contains(states("record", "orientation", "whole life")));
  EXPECT_THAT(figure_named(make_figures(r), "design_life").caption,
              states("orientation", "whole life"));
}

TEST(hazard_report, states_what_the_levels_do_not_show) {
  const Results r = made_up_hazard();  // S_DS up to 2 g: 1/4000 a year
  EXPECT_THAT(answer_sentences(r), Contains(states("1 % in 50 years", "S_DS = 2.23 g")));
  // What is not counted is promised to be said: here alone its words are compared.
  for (const char* what : {"beyond the levels", "any stronger shaking", "slip down the slope",
                           "NOT in the accumulated slip"})
    EXPECT_THAT(answer_sentences(r), Contains(states(what)));
}

TEST(hazard_report, tables_of_the_summary_fit_eighty_columns) {
  std::istringstream summary(summary_text(made_up_hazard()));
  std::size_t rows = 0;
  bool inside = false;
  for (std::string line; std::getline(summary, line);) {
    if (line.starts_with("How often each clearance")) inside = true;
    if (line.empty()) inside = false;
    if (!inside) continue;
    ++rows;
    EXPECT_LE(line.size(), 80u) << line;
  }
  EXPECT_GE(rows, 8u);
}

// The design run has 0.8 of the capacities of the first.
TEST(hazard_report, tells_of_the_least_favourable_combination_and_names_it) {
  Results r = made_up_hazard();
  r.cases.axes = {{"roof.slope_deg", "deg", {1.19349, 2.38594}, {}}};
  for (Case& c : r.cases.cases) c.friction_value = FrictionValue::as_drawn;
  const auto rate = [&](std::size_t run) {
    return format_rate(r.hazard->runs[run].thresholds[0].annual_rate.value);
  };
  ASSERT_NE(rate(0), rate(1));
  const std::string shown = "At slope 2.39 deg: " + format_length(r.thresholds_m[0]);
  EXPECT_THAT(answer_sentences(r), Contains(states(shown, "annual rate " + rate(1))));
  EXPECT_THAT(answer_sentences(r)[0], states("slope 2.39 deg"));
  EXPECT_THAT(summary_text(r), states(rate(1)));
  EXPECT_THAT(html_report(r, {}), testing::Not(states(r.runs[1].label + "</td>")));
}

TEST(hazard_report, names_the_file_of_a_curve_without_the_folder_it_was_read_from) {
  Results r = made_up_hazard();
  r.hazard->source = "../site.csv";
  EXPECT_THAT(figure_named(make_figures(r), "hazard").below, states("site.csv"));
  EXPECT_THAT(summary_text(r), testing::Not(states("../site.csv")));
}

TEST(hazard_report, figure_has_a_line_for_each_run_and_decades_as_ticks) {
  const Results r = made_up_hazard();
  const Figure figure = figure_named(make_figures(r), "hazard");
  ASSERT_EQ(figure.panels.size(), 1u);
  EXPECT_EQ(curves_of(figure).size(), r.runs.size());
  const Panel& panel = figure.panels.front();
  EXPECT_THAT(panel.y.ticks, Contains(testing::Field(&Tick::label, "1e-3")));
  for (const DataSeries& line : curves_of(figure))
    EXPECT_TRUE(std::ranges::is_sorted(line.y, std::greater<>()));
  EXPECT_GE(panel.rules.size(), 1u);
  double last_m = 0.0;
  for (const DataSeries& line : curves_of(figure)) last_m = std::max(last_m, line.x.back());
  EXPECT_THAT(figure.caption, states(format_length(last_m)));
  EXPECT_THAT(figures_of_tables(make_figures(r), csv_tables(r)), Contains("hazard"));
}

}  // namespace
}  // namespace glissade
