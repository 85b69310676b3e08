// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/clearance_report.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "analysis/conditions/view.hpp"
#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/report/base_shear_report.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "unit/study/by_rule.hpp"

namespace glissade {
namespace {

using test::fixed;
using test::HistoryPlace;
using test::HistoryRule;
using test::listed;
using test::states;
using testing::ElementsAre;
using testing::Not;

constexpr double inch = 0.0254;

void analyse(Results& r, OrientationRule rule = OrientationRule::median) {
  r.clearance = required_clearance(r, {.orientation = rule});
}

/// One axis, four orientations, two periods; the array isolated.
StudyConfig study_of_periods() {
  StudyConfig study;
  study.name = "made <up>";
  study.source_text = "[clearance]";
  study.model.axes = SlidingAxes::one;
  study.intensity.measure = IntensityMeasure::mce_fraction;
  study.intensity.levels = {2.0 / 3};
  study.quantities.at("roof", "slope_deg") = fixed(1.2);
  study.quantities.at("building", "period_s") = listed({0.2, 1.0});
  study.quantities.at("friction", "mu") = fixed(0.47);
  study.orientation.choice = OrientationChoice::all_permutations;
  return study;
}

/// The same with one axis more.
StudyConfig study_of(const char* table, const char* key, std::vector<double> values) {
  StudyConfig study = study_of_periods();
  study.quantities.at(table, key) = listed(std::move(values));
  return study;
}
template <class T>
StudyConfig study_of(std::vector<T> StudyConfig::*choices, std::vector<T> values) {
  StudyConfig study = study_of_periods();
  study.*choices = std::move(values);
  return study;
}
StudyConfig study_of_levels(std::vector<double> levels) {
  StudyConfig study = study_of_periods();
  study.intensity.levels = std::move(levels);
  return study;
}
StudyConfig study_of_two_frictions(double across) {
  StudyConfig study = study_of("friction", "across_mu", {across});
  study.friction.across_is_given = true;
  study.orientation.slope_axis = {SlopeAxis::e_w, SlopeAxis::n_s};
  return study;
}

/// Two records, of an isolated and an anchored array; all numbers from two rules that can be
/// followed by hand: a displacement of (o + 1)(p + 1) inches for record a and three times that for
/// b, so a mean of 2 (o + 1)(p + 1) inches; times a factor.
Results made_up(
    const StudyConfig& study = study_of(&StudyConfig::support,
                                        {ArraySupport::isolated, ArraySupport::anchored}),
    const std::function<double(const HistoryPlace&)>& factor = [](const auto&) { return 1.0; }) {
  Results r = test::results_by_rule(
      study, {{.id = "a", .has_vertical = true}, {.id = "b"}},
      [&](const HistoryPlace& at) -> test::MadeUpHistory {
        const bool isolated = at.c.support == ArraySupport::isolated;
        const double x = inch * static_cast<double>(at.orientation + 1) *
                         (at.c.period_s == 0.2 ? 1 : 2) * (at.record == 0 ? 1 : 3) * factor(at);
        return {isolated ? x : 0.0, isolated ? x : 0.0, isolated ? 0.9 : 1.0};
      });
  r.suites = {{"suite",
               "two records",
               "ASCE 7-10, S_S 1.5 g, S_1 0.6 g, site class C",
               {{0.0, 1.0, 2.0},
                {{1.0, 2.0, 1.0}, {3.0, 4.0, 1.0}},
                {2.0, 3.0, 1.0},
                {1.0, 2.0, 0.8},
                0.0,
                {{0.99, 0.082}, {2.5, 0.004}}}}};  // between the periods above
  analyse(r);
  return r;
}

/// Of a study of two suites, one record each.
Results two_suites(const char* first, const char* second) {
  Results r = made_up();
  r.suites.push_back(r.suites.front());
  r.suites[0].name = first;
  r.suites[1].name = second;
  r.records[1].suite = 1;
  analyse(r);
  return r;
}

TEST(clearance_report, gives_a_row_for_each_listed_condition_and_the_range_of_all) {
  const Results r = made_up(study_of("building", "damping", {0.02, 0.05}),
                            [](const auto& at) { return at.c.damping == 0.02 ? 1.0 : 0.5; });
  const Table table = clearance_table(r);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(std::get<std::string>(table.rows[1][0]), "building damping 0.05");
  EXPECT_DOUBLE_EQ(std::get<NumberCell>(table.rows[1][3]).value, 5 * inch);
  EXPECT_THAT(clearance_sentences(r).back(),
              states(format_length(5.5 * inch) + " (building damping 0.05)",
                     format_length(11 * inch) + " (building damping 0.02)"));
}

TEST(clearance_report, the_clearance_is_a_factor_times_the_largest_mean_over_the_periods) {
  const Table table = clearance_table(made_up());
  ASSERT_EQ(table.rows.size(), 1u);  // the anchored array has no clearance
  EXPECT_THAT(to_csv(table), states("governing_period_s,lowest_m,median_m,median_low95_m"));
  const auto number = [&](std::size_t i) { return std::get<double>(table.rows[0][i]); };
  EXPECT_EQ(number(0), 1.0);                                                  // T, s
  EXPECT_DOUBLE_EQ(number(1), 4 * inch);                                      // lowest
  EXPECT_DOUBLE_EQ(std::get<NumberCell>(table.rows[0][2]).value, 10 * inch);  // 4, 8, 12, 16
  EXPECT_DOUBLE_EQ(std::get<NumberCell>(table.rows[0][3]).value, 16 * inch);
  EXPECT_DOUBLE_EQ(number(7), 1.1 * 10 * inch);
  EXPECT_DOUBLE_EQ(number(8), 1.1 * 10 * inch);
  EXPECT_DOUBLE_EQ(number(9), 1.1 * 16 * inch);
}

TEST(clearance_report, states_the_rule_of_the_orientations_with_every_clearance) {
  Results r = made_up();
  analyse(r, OrientationRule::largest);
  EXPECT_DOUBLE_EQ(std::get<double>(clearance_table(r).rows[0][7]), 1.1 * 16 * inch);
  const Rule level = clearance_figures(r)[1].panels.at(0).rules.at(0);
  EXPECT_DOUBLE_EQ(level.at, 1.1 * 16 * inch);
  const std::string rule = "largest of the orientations";
  for (const std::string& text :
       {level.label, clearance_table(r).title, clearance_sentences(r).front(),
        clearance_reading(r, ClearanceTopic::period), clearance_summary(r)})
    EXPECT_THAT(text, states(rule));
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::period), states(format_length(17.6 * inch)));
  analyse(r, OrientationRule::median);
  EXPECT_THAT(clearance_summary(r), Not(states(rule)));
}

TEST(clearance_report, every_orientation_has_its_row) {
  const Table table = clearance_orientations_table(made_up());
  ASSERT_EQ(table.rows.size(), 4u);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[2][2]), 6 * inch);   // third, T 0.2 s
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[2][3]), 12 * inch);  // T 1 s
}

TEST(clearance_report, readings_are_of_what_the_grid_varies) {
  const Results r = made_up();
  // The governing period, median, lowest and highest.
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::period),
              states("T = 1 s", format_length(10 * inch), format_length(4 * inch),
                     format_length(16 * inch)));
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::spectra),
              states("0.990", "0.082 s", "2.50", "0.004 s"));
  for (const ClearanceTopic topic :
       {ClearanceTopic::level, ClearanceTopic::yielding, ClearanceTopic::slope, ClearanceTopic::mce,
        ClearanceTopic::vertical, ClearanceTopic::mass})
    EXPECT_EQ(clearance_reading(r, topic), "");
}

TEST(clearance_report, shows_the_design_earthquake_else_the_highest_level) {
  struct Shown {
    std::vector<double> levels;
    std::size_t place;
    double clearance_m;
  };
  for (const Shown& shown : {Shown{{2.0 / 3, 1.0}, 0, 11 * inch}, Shown{{0.5, 2.0 / 3}, 1, 0.0},
                             Shown{{0.5, 1.0}, 1, 0.0}}) {
    // No displacement at the second level.
    const Results r = made_up(study_of_levels(shown.levels),
                              [](const auto& at) { return at.level == 0 ? 1.0 : 0.0; });
    const ConditionGrid grid(r);
    EXPECT_EQ(shown_condition(grid)[ConditionAxis::level], shown.place);
    EXPECT_DOUBLE_EQ(clearance_figures(r)[1].panels.at(0).rules.at(0).at, shown.clearance_m);
    EXPECT_THAT(clearance_reading(r, ClearanceTopic::period),
                states(label_of(grid, ConditionAxis::level, shown.place)));
  }
  StudyConfig study = study_of_levels({0.5, 2.0 / 3, 1.0});
  study.intensity.measure = IntensityMeasure::sds_g;
  Results r = made_up(study);  // 2/3 g is no design earthquake
  const ConditionGrid grid(r);
  EXPECT_EQ(shown_condition(grid)[ConditionAxis::level], 2u);
  r.model.dbe_level = 2.0 / 3;  // of a target with this S_DS it is
  EXPECT_EQ(shown_condition(grid)[ConditionAxis::level], 1u);
  EXPECT_EQ(label_of(grid, ConditionAxis::level, 1), "DBE, S_DS = 0.667 g");
  EXPECT_EQ(label_of(grid, ConditionAxis::level, 2), "MCE, S_DS = 1.00 g");
}

TEST(clearance_report, of_one_axis_does_not_mention_two) {
  Results r = made_up();
  ASSERT_FALSE(slides_on_two_axes(r));
  const auto text = [&] {
    std::string all;
    for (const Figure& figure : clearance_figures(r)) {
      if (figure.name.text() == "spectra") continue;
      all += figure.caption;
      for (const std::string& entry : key_of(figure)) all += entry;
    }
    for (const std::string& sentence : clearance_sentences(r))
      if (sentence.find("spectrum") == std::string::npos) all += sentence;
    for (const Table& table : {clearance_table(r), clearance_orientations_table(r)})
      all += to_csv(table);
    return all;
  };
  EXPECT_THAT(text(), Not(testing::ContainsRegex("SRSS|across")));
  r.axes = SlidingAxes::two;
  EXPECT_THAT(text(), states("SRSS", "across"));
}

TEST(clearance_report, of_two_frictions_each_is_reported_where_it_acts_downhill) {
  const Results r = made_up();
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::orientation), Not(states("downhill")));
  const std::string reading =
      clearance_reading(made_up(study_of_two_frictions(0.52)), ClearanceTopic::orientation);
  // Largest over the periods: 4 to 16 inches along E-W, 20 to 32 along N-S.
  EXPECT_THAT(reading, states("0.47", format_length(10 * inch), "0.52", format_length(26 * inch)));
}

TEST(clearance_report, figures_are_of_the_axes_with_several_values) {
  const auto names_of = [](const StudyConfig& study) {
    return names(clearance_figures(made_up(study)));
  };
  EXPECT_THAT(names(clearance_figures(made_up())),
              ElementsAre("spectra", "period", "orientations"));
  EXPECT_THAT(names_of(study_of("roof", "slope_deg", {1.2, 2.4})),
              ElementsAre("spectra", "period", "orientations", "slope"));
  StudyConfig both = study_of_two_frictions(0.5);
  both.quantities.at("roof", "slope_deg") = listed({1.2, 2.4});
  EXPECT_THAT(names_of(both), ElementsAre("spectra", "period", "permutations", "slope"));
  EXPECT_THAT(names_of(study_of_levels({2.0 / 3, 1.0})),
              ElementsAre("spectra", "period", "orientations", "mce"));
  EXPECT_THAT(names_of(study_of("building", "response_modification", {0.0, 2.0})),
              ElementsAre("spectra", "period", "orientations", "yielding"));
  EXPECT_THAT(names_of(study_of(&StudyConfig::vertical,
                                {VerticalChoice::none, VerticalChoice::if_available})),
              ElementsAre("spectra", "period", "orientations", "vertical"));
}

TEST(clearance_report, of_several_suites_only_how_they_compare_is_reported) {
  const Results r = two_suites("suite", "other");
  EXPECT_THAT(names(clearance_figures(r)), ElementsAre("level"));
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::level),
              states(format_length(2.5 * inch), "0.190 m (7.50 in)"));  // a: 1, 2, 3, 4 inches
}

TEST(clearance_report, the_figure_over_periods_has_median_range_bounds_and_clearance) {
  const Figure figure = clearance_figures(made_up())[1];
  const Panel& panel = figure.panels.at(0);
  // Means of 2, 4, 6, 8 inches at 0.2 s and twice that at 1 s.
  const DataSeries median = curves_of(figure).at(0);
  EXPECT_DOUBLE_EQ(median.y[0], 5 * inch);
  EXPECT_DOUBLE_EQ(median.y[1], 10 * inch);
  EXPECT_DOUBLE_EQ(panel.series[0].low[0], 2 * inch);
  EXPECT_DOUBLE_EQ(panel.series[0].high[1], 16 * inch);
  ASSERT_EQ(panel.rules.size(), 1u);
  EXPECT_DOUBLE_EQ(panel.rules[0].at, 11 * inch);
  EXPECT_GE(panel.y.high, 16 * inch);
  for (const Figure& drawn : clearance_figures(made_up())) {
    for (const std::string& entry : key_of(drawn))
      EXPECT_LE(entry.size(), 86u) << drawn.name.text() << ": " << entry;
  }
}

TEST(clearance_report, the_figure_over_periods_hides_no_larger_clearance_than_it_states) {
  const Results r = made_up(study_of("building", "mass_ratio", {0.05, 0.1}),
                            [](const auto& at) { return at.c.mass_ratio == 0.05 ? 1.0 : 2.0; });
  EXPECT_DOUBLE_EQ(clearance_figures(r)[1].panels.at(0).rules.at(0).at, 22 * inch);
}

// Twice the displacement without vertical motion, which is not at the first place.
TEST(clearance_report, the_clearance_of_the_figure_over_periods_is_of_the_lines_that_it_has) {
  StudyConfig study =
      study_of(&StudyConfig::vertical, {VerticalChoice::if_available, VerticalChoice::none});
  study.quantities.at("building", "mass_ratio") = listed({0.05, 0.1});
  const Results r = made_up(
      study, [](const auto& at) { return at.c.vertical == VerticalChoice::none ? 2.0 : 1.0; });
  const Figure figure = clearance_figures(r)[1];
  double largest_m = 0.0;
  for (const DataSeries& line : curves_of(figure))
    largest_m = std::max(largest_m, *std::ranges::max_element(line.y));
  EXPECT_DOUBLE_EQ(largest_m, 20 * inch);
  EXPECT_DOUBLE_EQ(figure.panels.at(0).rules.at(0).at, 1.1 * largest_m);
  EXPECT_THAT(figure.below, states("no vertical motion"));
}

Figure figure_of(const Results& r, const std::string& name) {
  return figure_named(clearance_figures(r), name);
}

TEST(clearance_report, the_line_at_the_design_earthquake_is_what_the_text_says) {
  const Results r = made_up(study_of_levels({2.0 / 3, 1.0}));
  const Rule line = figure_of(r, "mce").panels.at(0).rules.at(0);
  EXPECT_DOUBLE_EQ(line.at, 10 * inch);  // median of the orientations, at 1 s
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::mce),
              states(format_length(line.at) + " at DBE"));
}

TEST(clearance_report, a_yielding_building_is_drawn_from_r_above_0) {
  const Results r = made_up(study_of("building", "response_modification", {0.0, 2.0}));
  for (const DataSeries& line : curves_of(figure_of(r, "yielding")))
    EXPECT_EQ(line.x, std::vector{2.0});
}

TEST(clearance_report, intensity_levels_are_named_on_their_axis) {
  Results r = two_suites("site_a", "site_b");
  EXPECT_THAT(figure_of(r, "level").panels.at(0).x.label, states("Suite site_..."));
  r.suites[0].intensity_level = 1;
  r.suites[1].intensity_level = 3;
  const Axis x = figure_of(r, "level").panels.at(0).x;
  EXPECT_THAT(x.label, states("Intensity Level"));
  ASSERT_EQ(x.ticks.size(), 2u);
  EXPECT_THAT(x.ticks[1].label, states("3 (S_DS 1.33 g)"));  // 2 g over 1.5
}

TEST(base_shear_report, is_by_condition_and_beside_the_other_supports) {
  Results r = made_up();
  r.base_shear = BaseShearAnalysis::find({}, r);
  const Table table = base_shear_table(r);
  ASSERT_EQ(table.rows.size(), 4u);  // support, period
  EXPECT_EQ(std::get<std::string>(table.rows[3][0]), "anchored array");
  EXPECT_EQ(std::get<double>(table.rows[3][1]), 1.0);  // T, s
  EXPECT_DOUBLE_EQ(std::get<NumberCell>(table.rows[0][3]).value, 0.9);
  EXPECT_DOUBLE_EQ(std::get<double>(table.rows[3][7]), 1.0);  // largest
  const std::vector<std::string> sentences = base_shear_sentences(r);
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_THAT(sentences[0], states("0.900"));  // of that of the anchored array
  const std::vector<Figure> figures = base_shear_figures(r);
  ASSERT_EQ(figures.size(), 1u);  // without an array: not run
  EXPECT_EQ(figures[0].name, FileName("base_shear"));
  EXPECT_DOUBLE_EQ(curves_of(figures[0]).at(1).y.at(0), 1.0);
}

TEST(base_shear_report, of_one_support_has_no_comparison) {
  Results r = made_up(study_of_levels({1.0, 2.0}));
  r.base_shear = BaseShearAnalysis::find({}, r);
  EXPECT_EQ(base_shear_sentences(r).size(), 1u);
  EXPECT_EQ(base_shear_figures(r).size(), 1u);
}

// The numbers of the figures, whatever the axes, are those of the tables.
TEST(clearance_report, figures_have_the_numbers_of_the_tables) {
  const auto of_tables = [](Results r) {
    r.base_shear = BaseShearAnalysis::find({}, r);
    std::vector<Figure> figures = clearance_figures(r);
    for (Figure& figure : base_shear_figures(r)) figures.push_back(std::move(figure));
    return figures_of_tables(figures, csv_tables(r));
  };
  EXPECT_THAT(of_tables(made_up()), ElementsAre("period", "orientations", "base_shear"));
  EXPECT_THAT(of_tables(made_up(study_of(&StudyConfig::support,
                                         {ArraySupport::isolated, ArraySupport::no_array}))),
              ElementsAre("period", "orientations", "base_shear", "base_shear_ratio"));
  for (const StudyConfig& study :
       {study_of("roof", "slope_deg", {1.2, 2.4}), study_of_levels({2.0 / 3, 1.0}),
        study_of("building", "response_modification", {0.0, 2.0}),
        study_of(&StudyConfig::vertical, {VerticalChoice::none, VerticalChoice::if_available})})
    EXPECT_EQ(of_tables(made_up(study)).size(), 4u);  // slope, mce, yielding, vertical
  EXPECT_THAT(of_tables(two_suites("suite", "other")), ElementsAre("level", "base_shear"));
}

TEST(clearance_report, histories_have_base_shears_only_beside_that_analysis) {
  Results r = made_up();
  const std::size_t columns = clearance_histories_table(r).columns.size();
  EXPECT_THAT(to_csv(clearance_histories_table(r)), Not(testing::HasSubstr("shear")));
  r.base_shear = BaseShearAnalysis::find({}, r);
  EXPECT_EQ(clearance_histories_table(r).columns.size(), columns + 2);
}

TEST(clearance_report, histories_are_reported_once_each) {
  // On a flat roof a history and its mirror image are one: two of the four orientations.
  const Results r = made_up(study_of("roof", "slope_deg", {0.0}));
  EXPECT_EQ(clearance_histories_table(r).rows.size(), 2u * 2u * 2u);
}

}  // namespace
}  // namespace glissade
