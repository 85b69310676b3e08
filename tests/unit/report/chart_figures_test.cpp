// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/chart/report.hpp"
#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/figures.hpp"
#include "glissade/report/format.hpp"
#include "glissade/standards/conditions.hpp"
#include "made_up_results.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;
using test::states;
using testing::ElementsAre;
using testing::Not;

Figure figure_named(const Results& results, const std::string& name) {
  return figure_named(make_figures(results), name);
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

TEST(chart_figures, have_the_published_values_of_their_name) {
  Results results = made_up_chart_results();
  const double top = figure_named(results, "chart_intensity").panels[0].y.high;
  results.published = {{"chart_intensity", "A (2019): 0.5 m at 1 g", 1.0, 0.5},
                       {"chart_intensity", "B (2020): beyond the axes", 9.0, 2.0 * top}};
  const Figure figure = figure_named(results, "chart_intensity");
  const DataSeries first = series_named(figure, "A (2019): 0.5 m at 1 g"),
                   second = series_named(figure, "B (2020): beyond the axes");
  EXPECT_EQ(first.x[0], 1.0);
  EXPECT_EQ(first.y[0], 0.5);
  EXPECT_EQ(first.label, first.name);  // in the key
  EXPECT_NE(first.look.symbol, second.look.symbol);
  EXPECT_GE(figure.panels[0].y.high, 2.0 * top);
  EXPECT_EQ(figure.panels[0].x.high, 9.0);
  const Figure other = figure_named(results, "chart_slope");
  for (const DataSeries& series : other.panels[0].series)
    EXPECT_FALSE(series.label.starts_with("A (2019)"));
}

TEST(chart_contours, lie_where_linear_interpolation_puts_them) {
  // From 0.3 m at mu = 0.4 to 0.1 m at 0.8 on both slopes: 0.2 m half way.
  const Figure figure = figure_named(two_by_two({0.3, 0.1, 0.3, 0.1}), "chart_contours");
  const DataSeries line = series_named(figure, "contour 0.2 m");
  ASSERT_GE(numbers_in(line), 2u);
  double least_deg = 9.0, largest_deg = -9.0;
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (!std::isfinite(line.x[i])) continue;
    EXPECT_NEAR(line.x[i], 0.6, 1e-12);
    least_deg = std::min(least_deg, line.y[i]);
    largest_deg = std::max(largest_deg, line.y[i]);
  }
  EXPECT_EQ(least_deg, 0.0);
  EXPECT_EQ(largest_deg, 2.0);
  const std::vector<Note>& notes = figure.panels[0].notes;
  const auto note = std::ranges::find(notes, "0.2 m", &Note::text);
  ASSERT_NE(note, notes.end());
  EXPECT_NEAR(note->x, 0.6, 1e-12);
  EXPECT_EQ(numbers_in(series_named(figure, "contour 0.5 m")), 0u);
}

// From 15 in at mu = 0.4 to 5 in at 0.8 on both slopes: 10 in half way.
TEST(chart_contours, are_round_in_the_unit_that_stands_first) {
  const LengthUnits units(UnitSystem::us_customary);
  const Figure figure = figure_named(
      two_by_two({15.0 * inch_m, 5.0 * inch_m, 15.0 * inch_m, 5.0 * inch_m}), "chart_contours");
  const DataSeries line = series_named(figure, "contour 10 in");
  ASSERT_GE(numbers_in(line), 2u);
  EXPECT_NEAR(line.x[0], 0.6, 1e-12);
  EXPECT_EQ(figure.panels[0].notes[0].text, "10 in");
}

// A manufacturer's chart had three lines in this range.
TEST(chart_contours, cover_the_range_of_the_chart) {
  const LengthUnits units(UnitSystem::us_customary);
  const Figure figure = figure_named(
      two_by_two({57.0 * inch_m, 5.0 * inch_m, 57.0 * inch_m, 5.0 * inch_m}), "chart_contours");
  for (const char* text : {"10", "15", "20", "30", "40", "50"})
    EXPECT_GE(numbers_in(series_named(figure, std::string("contour ") + text + " in")), 2u) << text;
}

TEST(chart_contours, follow_the_surface_of_the_made_up_chart) {
  // On the sides of cells they are exact for the table's numbers; between them the true slip bends
  // below its chords, by less than 8 % at friction 0.05 apart from 0.3 on.
  const Results results = made_up_chart_results();
  const DataSeries line = series_named(figure_named(results, "chart_contours"), "contour 0.2 m");
  ASSERT_GT(numbers_in(line), 14u);
  for (std::size_t i = 0; i < line.x.size(); ++i) {
    if (!std::isfinite(line.x[i])) continue;
    const double yield_g = line.x[i] - std::tan(line.y[i] * rad_per_deg);
    const double clearance_m = 1.1 * 0.25 * (1.0 - yield_g) * (1.0 - yield_g) / yield_g;
    EXPECT_LE(clearance_m, 0.2 + 1e-12);
    EXPECT_GE(clearance_m, 0.92 * 0.2);
  }
}

// From 0.3 to 0.1 m at the middle; from infinity to 0.1 m where its inverse is 5: at half, too.
TEST(chart_contours, go_on_beside_a_corner_that_slides_freely) {
  const double infinity = std::numeric_limits<double>::infinity();
  const Figure figure = figure_named(two_by_two({0.3, 0.1, infinity, 0.1}), "chart_contours");
  const DataSeries line = series_named(figure, "contour 0.2 m");
  ASSERT_GT(numbers_in(line), 2u);
  const Axis &x = figure.panels[0].x, &y = figure.panels[0].y;
  std::vector<double> ends;
  for (std::size_t i = 0; i < line.x.size(); ++i)
    if (line.y[i] == y.low || line.y[i] == y.high) ends.push_back(line.x[i]);
  ASSERT_GE(ends.size(), 2u);
  EXPECT_EQ(*std::ranges::min_element(line.y), y.low);
  EXPECT_EQ(*std::ranges::max_element(line.y), y.high);
  for (const double end : ends) EXPECT_NEAR(end, 0.5 * (x.low + x.high), 1e-9);
}

TEST(chart_contours, shade_where_gravity_alone_moves_the_array) {
  const DataSeries edge =
      series_named(figure_named(made_up_chart_results(), "chart_contours"), "slides freely");
  ASSERT_GT(edge.x.size(), 2u);
  for (std::size_t i = 0; i < edge.x.size(); ++i)
    EXPECT_LE(edge.x[i], std::max(0.1, std::tan(edge.y[i] * rad_per_deg)) + 1e-12);
}

TEST(chart_contours, show_the_prescribed_line_or_say_why_there_is_none) {
  Results results = made_up_chart_results();
  const std::string seaoc = "prescribed SEAOC PV1-2012";
  const Figure at_1g = figure_named(results, "chart_contours");
  EXPECT_GT(numbers_in(series_named(at_1g, seaoc)), 0u);
  EXPECT_EQ(series_named(at_1g, "SEAOC PV1-2012 limits").x.size(), 3u);
  EXPECT_EQ(series_named(at_1g, "ASCE 7-16 limits").x.at(0), 0.4);  // friction of 0.4 or more
  EXPECT_NEAR(series_named(at_1g, "ASCE 7-16 limits").y.at(1), slope_limit_deg(Standard::asce7_16),
              1e-12);
  for (const double value_m : {100.0, 0.001}) {
    for (ChartPrescription& p : results.chart->standards) p.prescribed.value_m = value_m;
    const Figure nowhere = figure_named(results, "chart_contours");
    EXPECT_EQ(numbers_in(series_named(nowhere, seaoc + " and ASCE 7-16")), 0u);
    EXPECT_THAT(nowhere.caption, states(value_m > 1.0 ? "more" : "less"));
  }
}

/// The prescribed value drawn as a line, by the beginning of its label.
Rule rule_of(const Figure& figure, const std::string& standard) {
  for (const Rule& rule : figure.panels.at(0).rules)
    if (rule.label.starts_with(standard)) return rule;
  return {};
}

TEST(chart_friction, has_the_clearance_of_the_table_and_a_gap_where_the_array_slides_freely) {
  const Figure figure = figure_named(made_up_chart_results(), "chart_friction");
  const std::vector<DataSeries> curves = curves_of(figure);
  ASSERT_EQ(curves.at(0).x.size(), 15u);
  EXPECT_DOUBLE_EQ(curves[0].x[8], 0.5);
  EXPECT_NEAR(curves[0].y[8], 0.1375, 1e-12);       // 1.1 x 0.125 m on a flat roof
  EXPECT_FALSE(std::isfinite(curves.back().y[0]));  // 7 degrees with mu = 0.1
  EXPECT_NEAR(rule_of(figure, "SEAOC PV1-2012").at, 0.549, 5e-4);
  EXPECT_EQ(rule_of(figure, "SEAOC PV1-2012").from, 0.4);
  EXPECT_THAT(figure.below, states("SEAOC PV1-2012", "3"));
  EXPECT_THAT(figure.caption, states("ASCE 7-16", "2.86 degrees"));
  EXPECT_NE(rule_of(figure, "SEAOC PV1-2012").look.dash, rule_of(figure, "ASCE 7-16").look.dash);
}

TEST(chart_figures, hold_at_most_four_curves_none_of_which_leaves_and_name_suite_and_subject) {
  for (const Results& results : {made_up_chart_results(), made_up_one_record_chart()}) {
    std::vector<std::string> titles;
    for (const Figure& figure : chart_figures(results)) {
      titles.push_back(figure.title);
      EXPECT_THAT(figure.below, states(results.suites.front().name));
      EXPECT_THAT(figure.title,
                  results.records.size() == 1
                      ? states(results.records.front().id)
                      : states(figure.name.text() == "chart_period" ? "Mean, 95th"
                                                                    : "1.1 x the largest mean"));
      if (figure.name.text() == "chart_contours") continue;
      EXPECT_LE(curves_of(figure).size(), 4u) << figure.name.text();
      EXPECT_TRUE(figure.labels_at_lines);
      for (const DataSeries& curve : curves_of(figure))
        for (const double slip_m : curve.y)
          EXPECT_FALSE(std::isfinite(slip_m) && slip_m > figure.panels[0].y.high);
    }
    std::ranges::sort(titles);
    EXPECT_EQ(std::ranges::adjacent_find(titles), titles.end());
  }
}

TEST(chart_slope, draws_seaoc_to_3_degrees_and_only_from_a_friction_of_0_4_on) {
  Results results = made_up_chart_results();
  const Figure figure = figure_named(results, "chart_slope");
  const Rule seaoc = rule_of(figure, "SEAOC PV1-2012");
  EXPECT_NEAR(seaoc.at, 0.548639, 1e-6);
  EXPECT_EQ(seaoc.from, 0.0);
  EXPECT_EQ(seaoc.to, 3.0);
  EXPECT_EQ(curves_of(figure).size(), 4u);  // clearance, 84th, 95th, largest
  results.chart->shown_mu = 0.35;
  const Figure low_friction = figure_named(results, "chart_slope");
  EXPECT_EQ(rule_of(low_friction, "SEAOC").label, "");
  EXPECT_THAT(low_friction.caption, states("0.4"));
}

TEST(chart_slope, says_which_prescribed_value_lies_above_the_figure) {
  Results results = made_up_chart_results();
  for (ChartPrescription& p : results.chart->standards) {
    if (p.standard == Standard::asce7_16) p.prescribed.value_m = 50.0;  // slips reach 0.37 m
  }
  const Figure figure = figure_named(results, "chart_slope");
  EXPECT_LT(figure.panels[0].y.high, 50.0);
  EXPECT_THAT(rule_of(figure, "ASCE 7-16").label, states("above"));
  EXPECT_THAT(rule_of(figure, "SEAOC PV1-2012").label, Not(states("above")));
}

TEST(chart_slope, has_one_line_for_one_record) {
  const auto curves = curves_of(figure_named(made_up_one_record_chart(), "chart_slope"));
  ASSERT_EQ(curves.size(), 1u);
  EXPECT_NEAR(curves[0].y[0], 0.5, 1e-12);  // 0.25 m (1.5 - 0.5)^2 / 0.5
}

TEST(chart_intensity, has_a_curve_for_four_frictions_from_no_shaking_on) {
  const auto curves = curves_of(figure_named(made_up_one_record_chart(), "chart_intensity"));
  ASSERT_EQ(curves.size(), 4u);  // mu = 0.1, 0.35, 0.6, 0.8
  for (const DataSeries& curve : curves) {
    ASSERT_EQ(curve.x.size(), 16u);
    EXPECT_EQ(curve.x[0], 0.0);
    EXPECT_EQ(curve.y[0], 0.0);
  }
  // mu = 0.6, slope 1 degree.
  const double yield_g = 0.6 - std::tan(1.0 * rad_per_deg);
  EXPECT_NEAR(curves[2].y[15], 0.25 * (1.5 - yield_g) * (1.5 - yield_g) / yield_g, 1e-12);
}

TEST(chart_slope_levels, ends_with_the_highest_level) {
  const auto curves = curves_of(figure_named(made_up_one_record_chart(), "chart_slope_levels"));
  EXPECT_NEAR(curves.back().y[0], 0.5, 1e-12);
  EXPECT_EQ(curves.back().label, "1.5 g");
}

TEST(chart_period, shows_each_period_and_the_clearance_across) {
  Results results = made_up_chart_results();
  results.chart->shown_slope_deg = 0.0;
  const auto curves = curves_of(figure_named(results, "chart_period"));
  ASSERT_EQ(curves.front().y.size(), 3u);
  EXPECT_NEAR(curves.front().y[0], 0.0875, 1e-12);  // 0.7 x 0.125 m
  EXPECT_NEAR(curves.front().y[2], 0.05, 1e-12);    // 0.4 x 0.125 m
  for (const double clearance_m : curves.back().y) EXPECT_NEAR(clearance_m, 0.1375, 1e-12);
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
      EXPECT_GT(fs::file_size(folder / (figure.name + ".svg")), 1000u) << figure.name.text();
    }
  }
}

}  // namespace
}  // namespace glissade
