// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "made_up_results.hpp"
#include "plot/labels.hpp"
#include "plot/script.hpp"

namespace glissade {
namespace {

using test::states;

namespace fs = std::filesystem;

fs::path fresh_folder(const std::string& name) {
  const fs::path folder = fs::path(testing::TempDir()) / ("glissade_report_" + name);
  fs::remove_all(folder);
  return folder;
}

TEST(figures, are_those_the_results_can_fill) {
  Results results = made_up_results();
  EXPECT_THAT(names(make_figures(results)), testing::ElementsAre("fragility", "fragility_design",
                                                                 "slip_vs_sds", "ida", "spectra"));
  results.measure = *IntensityMeasure::named("pga_g");
  results.suites[0].spectra = {};
  EXPECT_THAT(names(make_figures(results)),
              testing::ElementsAre("fragility", "fragility_design", "ida"));
  EXPECT_TRUE(make_figures(Results{}).empty());
}

TEST(figures, are_the_same_bytes_each_time) {
  const Figure figure = make_figures(made_up_results()).front();
  const fs::path first = fresh_folder("first"), second = fresh_folder("second");
  render_figure(figure, first);
  render_figure(figure, second);
  for (const char* file : {"fragility.svg", "fragility.pdf", "fragility.gp", "fragility.dat"}) {
    EXPECT_EQ(read_text_file(first / file), read_text_file(second / file)) << file;
  }
  EXPECT_THAT(read_text_file(first / "fragility.pdf"),
              testing::HasSubstr("/CreationDate (D:19700101000000"));
}

TEST(figures, draw_without_the_fits_that_failed) {
  Results results = made_up_results();
  results.runs[0].fragilities[0].capacities = FitSummary{};
  const Figure figure = fragility_figure(results, results.runs[0]);
  const auto of_clearance = [&](std::size_t t, const char* part) {
    return "slip above " + format_length(results.thresholds_m[t]) + part;
  };
  EXPECT_EQ(numbers_in(series_named(figure, of_clearance(0, ", lognormal"))), 0u);
  EXPECT_EQ(numbers_in(series_named(figure, of_clearance(0, ", lognormal: 95 % interval"))), 0u);
  EXPECT_GT(numbers_in(series_named(figure, of_clearance(0, ", observed"))), 0u);
  EXPECT_GT(numbers_in(series_named(figure, of_clearance(1, ", lognormal"))), 0u);
  EXPECT_NO_THROW(render_figure(figure, fresh_folder("failed_fit")));
}

TEST(figures, say_what_each_point_is) {
  DataSeries means{DataSeries::Kind::points, look(Role::median), "means", "mean"};
  means.x = {0.5, 1.0, 9.0};  // the last is outside of the plot
  means.y = {0.0254, 0.0508, 0.0254};
  Panel panel{"", {"Building period (s)", 0.0, 2.0}, length_axis("Displacement", 0.1), {means}};
  const fs::path folder = fresh_folder("points");
  render_figure({"points", "", "", "", {panel}}, folder);
  const std::string svg = read_text_file(folder / "points.svg");
  const std::string begin = "<title>means: Building period (s) ";
  EXPECT_THAT(svg, states(begin + "0.500, Displacement 0.0254 m (1.00 in)",
                          begin + "1.00, Displacement 0.0508 m (2.00 in)"));
  EXPECT_THAT(svg, testing::Not(states(begin + "9.00")));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("points_plot_1</title>")));
}

TEST(figures, are_described_for_who_does_not_see_them_and_break_no_name_of_a_standard) {
  DataSeries line{DataSeries::Kind::line, look(Role::median), "mean"};
  line.x = {0.5, 1.0, 2.0};
  line.y = {0.0254, 0.0508, 0.0127};
  const Panel panel{"", {"Period (s)", 0.0, 2.0}, length_axis("Displacement", 0.1), {line}};
  const fs::path folder = fresh_folder("described");
  const std::string below = std::string(78, 'a') + "; target ASCE 7-10, S_S 1.95 g, class D";
  render_figure({"described", "Title <1>", below, "", {panel}}, folder);
  EXPECT_THAT(read_text_file(folder / "described.svg"),
              states("<title>Title &lt;1&gt;</title>", "<desc id=\"described_desc\">",
                     "Across: Period (s), 0 to 2.00",
                     "mean: 0.0254 m (1.00 in) at 0.500, 0.0127 m (0.500 in) at 2.00, largest "
                     "0.0508 m (2.00 in) at 1.00."));
  EXPECT_THAT(read_text_file(folder / "described.gp"), testing::HasSubstr("ASCE\u00a07-10"));
}

TEST(figures, of_the_fragility_name_suite_roof_and_building) {
  const Results results = made_up_results();
  EXPECT_THAT(fragility_figure(results, results.runs.front()).below,
              states(results.suites.front().name, "slope", "buildings of T", "friction"));
}

TEST(figures, name_what_the_study_lists_once) {
  Results results = made_up_results();
  results.cases.axes.push_back({"roof.slope_deg", "deg", {2.39}, {}});
  results.cases.axes.push_back({"building.damping", "-", {0.05}, {}});
  RunResults& run = results.runs.front();
  run.friction = "mu 0.5";
  const std::string below = fragility_figure(results, run).below;
  EXPECT_THAT(below, states("slope", "friction mu 0.5", "damping"));
  EXPECT_THAT(below, testing::Not(testing::HasSubstr("slope 2.39 deg")));
}

TEST(figures, have_names_beside_a_single_panel_in_one_line) {
  Panel panel{"", {"Dispersion", 0.0, 1.0}, {"", -1.0, 1.0, {{0.0, "roof velocity and D5-95"}}}};
  const fs::path folder = fresh_folder("names");
  render_figure({"names", "", "", "", {panel}}, folder);
  EXPECT_THAT(read_text_file(folder / "names.gp"), states("'roof velocity and D5-95' 0"));
}

// Of the panel and the series that a point is in, by the values of a logarithmic axis and by the
// name of the nearest tick; a line says its name.
TEST(figures, say_what_each_point_of_several_panels_is) {
  const auto with_points = DataSeries::Kind::line_and_points;
  Panel rates{"first", {"S_DS (g)", 0.0, 2.0}, {"Rate", 1e-4, 1.0, {{1e-3, "1e-3"}}}};
  rates.y.values = Axis::Values::logarithms;
  rates.series = {{with_points, look(Role::median), "roof 1", "", {1.0}, {0.00105}},
                  {with_points, look(Role::mean), "roof 2", "", {1.0}, {1e-6}}};
  Panel kinds{"second", {"Vertical", -0.5, 1.5, {{0.0, "none"}, {1.0, "0.1 s"}}}, {"", -0.5, 0.5}};
  kinds.x.values = kinds.y.values = Axis::Values::names;
  kinds.y.ticks = {{0.0, "PGA"}};
  kinds.series = {{with_points, look(Role::median), "roof 3", "", {0.1, 0.9}, {0.0, 0.0}}};
  const fs::path folder = fresh_folder("two_panels");
  render_figure({"two-panels", "", "", "", {rates, kinds}}, folder);
  const std::string svg = read_text_file(folder / "two-panels.svg");
  for (const char* title :
       {"roof 1: S_DS (g) 1.00, Rate 0.00105", "roof 2: S_DS (g) 1.00, Rate at most 0.000100",
        "roof 3: Vertical: none, PGA", "roof 3: Vertical: 0.1 s, PGA", "roof 1", "roof 3"})
    EXPECT_THAT(svg, states(std::string("<title>") + title + "</title>"));
  EXPECT_THAT(svg, testing::Not(testing::HasSubstr("_plot_1a</title>")));
}

TEST(figures, draw_rules_of_one_colour_each_with_its_dashes) {
  Panel panel{"", {"x", 0.0, 1.0}, {"y", 0.0, 1.0}};
  panel.rules = {{Rule::Kind::horizontal, 0.4, {{0x123456}, 3.0, 1}},
                 {Rule::Kind::horizontal, 0.6, {{0x123456}, 3.0, 2}}};
  const fs::path folder = fresh_folder("dashes");
  render_figure({"dashes", "", "", "", {panel}}, folder);
  const std::string svg = read_text_file(folder / "dashes.svg"), colour = "rgb( 18,  52,  86)'";
  const std::size_t solid = svg.find(colour), dashed = svg.find(colour, solid + 1);
  ASSERT_NE(dashed, std::string::npos);
  EXPECT_FALSE(svg.substr(solid + colour.size()).starts_with(" stroke-dasharray"));
  EXPECT_TRUE(svg.substr(dashed + colour.size()).starts_with(" stroke-dasharray"))
      << svg.substr(dashed, 80);
}

TEST(figures, of_several_panels_have_one_key_with_each_entry_once) {
  Panel panel{"", {"x", 0.0, 1.0}, {"y", 0.0, 1.0}};
  panel.series = {{DataSeries::Kind::line, {}, "a", "shared", {0.0, 1.0}, {0.0, 1.0}}};
  Panel other = panel;
  other.rules = {{Rule::Kind::horizontal, 0.5, {}, "in one alone"}};
  const std::string script = gnuplot::script_of({"shared", "", "", "", {panel, other}});
  const std::string of_svg = script.substr(0, script.find("set terminal pdfcairo"));
  const auto count = [&](const std::string& text) {
    int found = 0;
    for (std::size_t at = 0; (at = of_svg.find(text, at)) != std::string::npos; ++at) ++found;
    return found;
  };
  EXPECT_EQ(count("title 'shared'"), 1);
  EXPECT_EQ(count("title 'in one alone'"), 1);
  EXPECT_EQ(count("plot \\\n"), 3);
}

TEST(figures, may_have_a_minus_in_their_name) {  // gnuplot allows none in a terminal's
  Figure figure = make_figures(made_up_results()).front();
  figure.name = "fragility_slope_deg_-4";
  EXPECT_NO_THROW(render_figure(figure, fresh_folder("minus")));
}

TEST(figures, an_axis_of_no_length_has_no_steps_and_ends) {
  for (const double high_m : {0.0, std::numeric_limits<double>::infinity()})
    EXPECT_LT(length_axis("Slip", high_m).ticks.size(), 1000u);
}

/// At the key's font a figure of 900 px has room for some 86 characters in a row.
TEST(figures, have_keys_that_end_within_the_figure) {
  for (const Results& results :
       {made_up_results(), made_up_impact_results(), made_up_chart_results()}) {
    for (const Figure& figure : make_figures(results)) {
      for (const std::string& entry : key_of(figure))
        EXPECT_LE(entry.size(), 86u) << figure.name.text() << ": " << entry;
    }
  }
}

// Beside the ends of the curves, in their order and none over another.
TEST(figures, of_the_fragility_name_the_clearance_beside_each_curve) {
  const Results results = made_up_results();
  const Panel panel = fragility_figure(results, results.runs[0]).panels.at(0);
  ASSERT_EQ(panel.notes.size(), results.runs[0].fragilities.size());
  for (std::size_t t = 0; t < panel.notes.size(); ++t) {
    EXPECT_GT(panel.notes[t].x, results.levels.back());
    EXPECT_LT(panel.notes[t].x, panel.x.high);
    EXPECT_GE(panel.notes[t].y, 0.0);
    if (t == 0) continue;
    EXPECT_GE(panel.notes[t - 1].y - panel.notes[t].y, 0.069);
  }
}

// Else the axis strikes through the lowest.
TEST(figures, names_of_lines_stand_above_the_axis_in_the_order_of_the_lines) {
  Panel panel{"", {"x", 0.0, 1.0}, {"y", 0.0, 1.0}};
  add_side_labels(panel, {{0.0, 0.0, "low"}, {0.0, 0.02, "high"}}, {Side::right, 0.2, 0.1});
  ASSERT_EQ(panel.notes.size(), 2u);
  EXPECT_EQ(panel.notes[0].text, "high");
  EXPECT_GE(panel.notes[1].y, 0.05);
  EXPECT_GE(panel.notes[0].y - panel.notes[1].y, 0.099);
}

TEST(figures, spectra_hold_every_record_and_number_a_few_on_their_own_lines) {
  Results results = made_up_results();  // 12 records
  Figure figure = spectra_figure(results);
  for (const std::vector<double>& record : results.suites[0].spectra.records_g)
    EXPECT_GT(figure.panels[0].y.high, *std::ranges::max_element(record));
  EXPECT_TRUE(figure.panels[0].notes.empty());
  EXPECT_THAT(figure.caption, testing::Not(testing::HasSubstr("number")));
  SuiteSpectra& spectra = results.suites[0].spectra;
  spectra.records_g.resize(7);
  figure = spectra_figure(results);
  ASSERT_EQ(figure.panels[0].notes.size(), 7u);
  for (std::size_t r = 0; r < 7; ++r) {
    const Note& number = figure.panels[0].notes[r];
    EXPECT_EQ(number.text, std::to_string(r + 1));
    const auto at = std::ranges::find(spectra.periods_s, number.x) - spectra.periods_s.begin();
    EXPECT_EQ(number.y, spectra.records_g[r].at(static_cast<std::size_t>(at)));
    EXPECT_NE(number.y, spectra.average_g.at(static_cast<std::size_t>(at)));
  }
}

TEST(figures, lines_are_named_beside_their_last_points_and_rules_where_they_hide_least) {
  Panel panel{"", {"x", 0.0, 10.0}, {"y", 0.0, 100.0}};
  const auto line = DataSeries::Kind::line;
  panel.series = {{line, {}, "a", "whole", {0.0, 10.0}, {30.0, 80.0}},
                  {line, {}, "b", "near it", {0.0, 10.0}, {30.0, 79.0}},
                  {line, {}, "c", "short", {0.0, 4.0, 10.0}, {10.0, 20.0, std::nan("")}},
                  {DataSeries::Kind::band, {}, "", "shaded: interval"}};
  panel.rules = {{Rule::Kind::horizontal, 50.0, {}, "prescribed"}};
  label_lines(panel, {700.0, 400.0});
  ASSERT_EQ(panel.notes.size(), 4u);
  const auto note = [&](const std::string& text) {
    return *std::ranges::find(panel.notes, text, &Note::text);
  };
  EXPECT_GT(note("whole").x, 10.0);
  EXPECT_LT(note("whole").x, panel.x.high);
  EXPECT_GE(note("whole").y - note("near it").y, 5.0);
  EXPECT_NEAR(note("short").x, 4.2, 0.1);
  EXPECT_EQ(note("short").y, 20.0);
  EXPECT_NEAR(note("prescribed").y, 54.0, 2.0);  // above its left end the lines are below
  EXPECT_EQ(note("prescribed").align, Note::Align::left);
  EXPECT_EQ(panel.rules[0].to, 10.0);  // not into the margin
  EXPECT_EQ(panel.x.ticks.back().at, 10.0);
  for (const DataSeries& series : panel.series)
    EXPECT_EQ(series.label, series.name.empty() ? "shaded: interval" : "");
}

// Where a rule has no free place its label stands in the margin, joined to it; a label that is too
// long for the margin stays in the key. A band counts as a line does.
TEST(figures, rules_are_labelled_on_no_curve_and_not_across_another_rule) {
  Panel panel{"", {"x", 0.0, 10.0}, {"y", 0.0, 100.0}};
  panel.series = {
      {DataSeries::Kind::band, {}, "range", "", {0.0, 10.0}, {}, {35.0, 35.0}, {90.0, 90.0}}};
  panel.rules = {{Rule::Kind::horizontal, 24.0, {}, "higher", 0.0, 3.0},
                 {Rule::Kind::horizontal, 22.0, {}, "lower", 0.0, 3.0},
                 {Rule::Kind::horizontal, 60.0, {}, "in the band"},
                 {Rule::Kind::horizontal, 70.0, {}, std::string(60, 'x')}};
  label_lines(panel, {700.0, 400.0});
  const auto note = [&](const std::string& text) {
    return *std::ranges::find(panel.notes, text, &Note::text);
  };
  ASSERT_EQ(panel.notes.size(), 3u);
  EXPECT_NEAR(note("higher").y, 28.4, 0.5);
  EXPECT_NEAR(note("lower").y, 17.6, 0.5);
  EXPECT_GT(note("in the band").x, 10.0);
  EXPECT_EQ(note("in the band").y, 60.0);
  EXPECT_EQ(panel.rules[3].label.size(), 60u);
  panel.rules[0].label = "higher";
  panel.notes.clear();
  panel.x.high = 10.0;
  panel.series[0].low = {20.0, 20.0};
  label_lines(panel, {700.0, 400.0});
  EXPECT_GT(note("higher").x, 10.0);
  EXPECT_EQ(panel.rules.back().at, 24.0);  // from the end of the rule to the margin
  EXPECT_EQ(panel.rules.back().from, 3.0);
  EXPECT_EQ(panel.rules.back().to, 10.0);
}

TEST(figures, take_any_text_of_the_user_as_text) {
  Results results = made_up_results();
  results.suites[0].name = "it's {a} \"_suite^\" `date` \\n $x";
  const fs::path folder = fresh_folder("text");
  render_figure(spectra_figure(results), folder);
  const std::string svg = read_text_file(folder / "spectra.svg");
  EXPECT_THAT(svg, states("`date`", "{a}"));
}

TEST(figures, say_what_to_do_when_gnuplot_is_missing) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nonexistent", 1);
  try {
    render_figure(make_figures(made_up_results()).front(), fresh_folder("no_gnuplot"));
    ADD_FAILURE() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), states("gnuplot", "install"));
  }
  ::setenv("PATH", path.c_str(), 1);
}

TEST(figures, pass_on_what_gnuplot_complains_about) {
  const fs::path folder = fresh_folder("complaint");
  const Figure figure = make_figures(made_up_results()).front();
  fs::create_directories(folder / "fragility.svg");  // in the drawing's place
  try {
    render_figure(figure, folder);
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), states("fragility.svg"));
  }
}

TEST(figures, of_the_fragility_hold_the_shares_and_the_fitted_curve) {
  const Results results = made_up_results();
  const RunResults& run = results.runs[0];
  const Figure figure = fragility_figure(results, run);
  const std::string name = "slip above " + format_length(run.fragilities[1].threshold_m);
  const DataSeries observed = series_named(figure, name + ", observed"),
                   curve = series_named(figure, name + ", lognormal");
  EXPECT_EQ(observed.x, results.levels);
  EXPECT_EQ(observed.y, run.fragilities[1].probability);
  ASSERT_EQ(curve.x, run.band_intensities);
  EXPECT_EQ(curve.y[20], run.fragilities[1].capacities.curve.probability(curve.x[20]));
  EXPECT_EQ(key_of(figure).size(), 1u);  // clearances are named at their curves
  for (const ThresholdFragility& fragility : run.fragilities)
    EXPECT_THAT(figure.caption, states(format_length(fragility.threshold_m)));
}

TEST(figures, of_a_table_have_the_numbers_of_its_file) {
  const auto of_tables = [](const Results& results) {
    return figures_of_tables(make_figures(results), csv_tables(results));
  };
  EXPECT_THAT(of_tables(made_up_chart_results()),
              testing::ElementsAre("chart_friction", "chart_slope", "chart_intensity",
                                   "chart_slope_levels", "chart_period"));
  EXPECT_EQ(of_tables(made_up_one_record_chart()).size(), 4u);
  EXPECT_THAT(of_tables(made_up_impact_results()),
              testing::ElementsAre("fragility", "fragility_design", "slip_vs_sds", "impact"));
}

TEST(figures, are_drawn_whatever_their_numbers_are) {
  const double infinity = std::numeric_limits<double>::infinity();
  Figure figure{"odd", "Odd numbers", "", ""};
  figure.panels.resize(3);
  figure.panels[0].series = {{DataSeries::Kind::line, look(Role::mean), "none", "no numbers"},
                             {DataSeries::Kind::line,
                              look(Role::mean),
                              "nan",
                              "gap",
                              {infinity, 1.0},
                              {1.0, std::nan("")}}};
  figure.panels[1].x = {"no extent", 1.0, 1.0};
  figure.panels[1].y = {"none", 0.0, std::nan("")};
  figure.panels[1].rules = {{Rule::Kind::vertical, infinity, look(Role::bound), "far"}};
  figure.panels[2].notes = {{std::nan(""), 0.0, "nowhere", {}}};
  EXPECT_NO_THROW(render_figure(figure, fresh_folder("odd")));
}

}  // namespace
}  // namespace glissade
