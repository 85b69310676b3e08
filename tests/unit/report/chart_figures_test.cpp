// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/figures.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> names(const std::vector<Figure>& figures) {
  std::vector<std::string> list;
  for (const Figure& figure : figures) list.push_back(figure.name);
  return list;
}

Figure figure_named(const Results& results, const std::string& name) {
  for (const Figure& figure : make_figures(results)) {
    if (figure.name == name) return figure;
  }
  ADD_FAILURE() << "no figure " << name;
  return {};
}

/// The rows of a data block; "nan" is read as NaN.
std::vector<std::vector<double>> block(const Figure& figure, const std::string& name) {
  std::istringstream lines(figure.data);
  std::vector<std::vector<double>> rows;
  bool inside = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("# columns")) continue;
    if (line.starts_with("#")) inside = line == "# " + name;
    if (!inside || line.empty() || line[0] == '#') continue;
    std::istringstream words(line);
    std::vector<double>& row = rows.emplace_back();
    for (std::string word; words >> word;) row.push_back(std::stod(word));
  }
  return rows;
}

/// A chart of one record with two slopes and two frictions.
Results two_by_two(const std::vector<double>& slip_m) {
  Results results = made_up_one_record_chart();
  Chart& chart = *results.chart;
  results.levels = {1.0};
  chart.shown_level = 1.0;
  chart.slope_deg = {0.0, 2.0};
  chart.mu = {0.4, 0.8};
  chart.points.clear();
  for (std::size_t i = 0; i < 4; ++i) {
    ChartPoint point;
    point.level = 1.0;
    point.slope_deg = chart.slope_deg[i / 2];
    point.mu = chart.mu[i % 2];
    point.largest.envelope_m = slip_m[i];
    point.by_period = {point.largest};
    chart.points.push_back(point);
  }
  return results;
}

TEST(chart_figures, are_those_the_chart_can_fill) {
  Results results = made_up_chart_results();
  EXPECT_THAT(names(make_figures(results)),
              ElementsAre("chart_contours", "chart_friction", "chart_slope", "chart_intensity",
                          "chart_slope_levels", "chart_period", "spectra"));
  EXPECT_THAT(names(make_figures(two_by_two({1, 1, 1, 1}))),
              ElementsAre("chart_contours", "chart_friction", "chart_slope"));
}

TEST(chart_contours, lie_where_linear_interpolation_puts_them) {
  // From 0.3 m at mu = 0.4 to 0.1 m at 0.8 on both slopes: 0.2 m half way.
  const Figure figure = figure_named(two_by_two({0.3, 0.1, 0.3, 0.1}), "chart_contours");
  const auto line = block(figure, "contour 0.2 m");
  ASSERT_GE(line.size(), 2u);
  double least_deg = 9.0, largest_deg = -9.0;
  for (const std::vector<double>& point : line) {
    EXPECT_NEAR(point[0], 0.6, 1e-12);
    least_deg = std::min(least_deg, point[1]);
    largest_deg = std::max(largest_deg, point[1]);
  }
  EXPECT_EQ(least_deg, 0.0);
  EXPECT_EQ(largest_deg, 2.0);
  EXPECT_THAT(figure.body, HasSubstr("set label '0.2 m'"));
  EXPECT_TRUE(block(figure, "contour 0.5 m").empty());
}

TEST(chart_contours, follow_the_surface_of_the_made_up_chart) {
  // On the sides of cells they are exact for the table's numbers; between them the true slip bends
  // below its chords, by less than 8 % at friction 0.05 apart from 0.3 on.
  const Results results = made_up_chart_results();
  const auto line = block(figure_named(results, "chart_contours"), "contour 0.2 m");
  ASSERT_GT(line.size(), 14u);
  for (const std::vector<double>& point : line) {
    const double yield_g = point[0] - std::tan(point[1] * rad_per_deg);
    const double clearance_m = 1.1 * 0.25 * (1.0 - yield_g) * (1.0 - yield_g) / yield_g;
    EXPECT_LE(clearance_m, 0.2 + 1e-12);
    EXPECT_GE(clearance_m, 0.92 * 0.2);
  }
}

TEST(chart_contours, stay_out_of_cells_that_slide_freely) {
  const double infinity = std::numeric_limits<double>::infinity();
  Results results = two_by_two({0.3, 0.1, infinity, 0.1});
  EXPECT_TRUE(block(figure_named(results, "chart_contours"), "contour 0.2 m").empty());
  EXPECT_THAT(figure_named(results, "chart_contours").caption, HasSubstr("No line from 0.01"));
}

TEST(chart_contours, shade_where_gravity_alone_moves_the_array) {
  const auto edge = block(figure_named(made_up_chart_results(), "chart_contours"), "slides freely");
  ASSERT_GT(edge.size(), 2u);
  for (const std::vector<double>& point : edge)
    EXPECT_LE(point[0], std::max(0.1, std::tan(point[1] * rad_per_deg)) + 1e-12);
}

TEST(chart_contours, tell_where_the_prescribed_line_is_or_why_there_is_none) {
  Results results = made_up_chart_results();
  const Figure at_1g = figure_named(results, "chart_contours");
  EXPECT_FALSE(block(at_1g, "prescribed SEAOC PV1-2012").empty());
  EXPECT_THAT(at_1g.body, HasSubstr("'SEAOC PV1-2012: 0.549 m'"));
  EXPECT_THAT(at_1g.body, HasSubstr("SEAOC PV1-2012 is for slopes and friction in here"));
  for (ChartPrescription& p : results.chart->standards) p.prescribed.value_m = 100.0;
  const Figure nowhere = figure_named(results, "chart_contours");
  EXPECT_THAT(nowhere.caption, HasSubstr("more than the chart asks for"));
  EXPECT_TRUE(block(nowhere, "prescribed SEAOC PV1-2012 and ASCE 7-16").empty());
  for (ChartPrescription& p : results.chart->standards) p.prescribed.value_m = 0.001;
  EXPECT_THAT(figure_named(results, "chart_contours").caption,
              HasSubstr("less than the chart asks for"));
}

TEST(chart_friction, has_the_clearance_of_the_table_and_a_gap_where_the_array_slides_freely) {
  const Figure figure = figure_named(made_up_chart_results(), "chart_friction");
  const auto rows = block(figure, "curves");
  ASSERT_EQ(rows.size(), 15u);
  EXPECT_DOUBLE_EQ(rows[8][0], 0.5);
  EXPECT_NEAR(rows[8][1], 0.1375, 1e-12);   // 1.1 x 0.125 m on a flat roof
  EXPECT_TRUE(std::isnan(rows[0].back()));  // 7 degrees with mu = 0.1
  EXPECT_THAT(figure.body, HasSubstr("SEAOC PV1-2012: 0.549 m (21.6 in)"));
  // From mu = 0.4 on.
  EXPECT_THAT(figure.body, HasSubstr("set arrow from 0.4,"));
}

TEST(chart_slope, draws_seaoc_under_3_degrees_and_only_above_a_friction_of_0_4) {
  Results results = made_up_chart_results();
  const Figure figure = figure_named(results, "chart_slope");
  EXPECT_THAT(figure.body, HasSubstr("set arrow from 0,0.548639"));
  EXPECT_THAT(figure.body, HasSubstr(" to 3,0.548639"));
  EXPECT_EQ(block(figure, "curves")[0].size(), 6u);  // slope, clearance, mean, 84th, 95th, largest
  results.chart->shown_mu = 0.4;
  const Figure low_friction = figure_named(results, "chart_slope");
  EXPECT_THAT(low_friction.body, Not(HasSubstr("SEAOC")));
  EXPECT_THAT(low_friction.caption, HasSubstr("is not drawn: it is for friction above 0.4"));
}

TEST(chart_slope, says_which_prescribed_value_lies_above_the_figure) {
  Results results = made_up_chart_results();
  for (ChartPrescription& p : results.chart->standards) {
    if (p.standard == Standard::asce7_16) p.prescribed.value_m = 50.0;  // slips reach 0.37 m
  }
  const std::string body = figure_named(results, "chart_slope").body;
  EXPECT_THAT(body, HasSubstr("ASCE 7-16: 50.0 m (1969 in) (recalled: verify): above the figure"));
  EXPECT_THAT(body, Not(HasSubstr("SEAOC PV1-2012: 0.549 m (21.6 in): above")));
}

TEST(chart_slope, has_one_line_for_one_record) {
  const Figure figure = figure_named(made_up_one_record_chart(), "chart_slope");
  const auto rows = block(figure, "curves");
  ASSERT_EQ(rows.at(0).size(), 2u);
  EXPECT_NEAR(rows[0][1], 0.5, 1e-12);  // 0.25 m (1.5 - 0.5)^2 / 0.5
}

TEST(chart_intensity, has_a_curve_for_eight_frictions_from_no_shaking_on) {
  const Figure figure = figure_named(made_up_one_record_chart(), "chart_intensity");
  const auto rows = block(figure, "curves");
  ASSERT_EQ(rows.size(), 16u);
  ASSERT_EQ(rows[0].size(), 9u);  // level, then mu = 0.1, 0.2 ... 0.8
  for (std::size_t c = 0; c < rows[0].size(); ++c) EXPECT_EQ(rows[0][c], 0.0);
  // mu = 0.5, slope 1 degree.
  const double yield_g = 0.5 - std::tan(1.0 * rad_per_deg);
  EXPECT_NEAR(rows[15][5], 0.25 * (1.5 - yield_g) * (1.5 - yield_g) / yield_g, 1e-12);
}

TEST(chart_slope_levels, ends_with_the_highest_level) {
  const Figure figure = figure_named(made_up_one_record_chart(), "chart_slope_levels");
  EXPECT_NEAR(block(figure, "curves")[0].back(), 0.5, 1e-12);
  EXPECT_THAT(figure.body, HasSubstr("title '1.5 g'"));
}

TEST(chart_period, shows_each_period_and_the_clearance_across) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 0.0;
  const auto rows = block(figure_named(results, "chart_period"), "curves");
  ASSERT_EQ(rows.size(), 3u);
  EXPECT_NEAR(rows[0][1], 0.0875, 1e-12);  // 0.7 x 0.125 m
  EXPECT_NEAR(rows[2][1], 0.05, 1e-12);    // 0.4 x 0.125 m
  for (const std::vector<double>& row : rows) EXPECT_NEAR(row.back(), 0.1375, 1e-12);
}

TEST(chart_figures, are_drawn_by_gnuplot_even_where_everything_slides_freely) {
  Results freely = two_by_two(std::vector<double>(4, std::numeric_limits<double>::infinity()));
  int chart = 0;
  for (const Results& results : {made_up_chart_results(), made_up_one_record_chart(), freely}) {
    const fs::path folder =
        fs::path(testing::TempDir()) / ("glissade_chart_" + std::to_string(chart++));
    fs::remove_all(folder);
    for (const Figure& figure : make_figures(results)) {
      ASSERT_NO_THROW(render_figure(figure, folder)) << figure.name.text();
      EXPECT_THAT(read_text_file(folder / (figure.name + ".svg")),
                  HasSubstr(figure.title.substr(0, 12)))
          << figure.name.text();
    }
  }
}

}  // namespace
}  // namespace glissade
