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

namespace glissade {
namespace {

using test::states;
using testing::ElementsAre;
using testing::Not;

constexpr double inch = 0.0254;

/// What is found of the conditions that there are now.
void analyse(Results& r, OrientationRule rule = OrientationRule::median) {
  r.conditions->first_case.assign(r.conditions->grid.count(), 0);
  r.clearance = required_clearance(r, {.orientation = rule});
}

/// Two records in four orientations at two periods, of an isolated and an anchored array; all
/// numbers from two rules that can be followed by hand: a displacement of (o + 1)(p + 1) inches for
/// record a and three times that for b, so a mean of 2 (o + 1)(p + 1) inches.
Results made_up() {
  Results r;
  r.conditions.emplace();
  r.study_name = "made <up>";
  r.study_text = "[clearance]";
  r.conditions->grid.support = {ArraySupport::isolated, ArraySupport::anchored};
  r.conditions->grid.slope_deg = {1.2};
  r.conditions->grid.period_s = {0.2, 1.0};
  for (const double azimuth : {0.0, 180.0, 90.0, 270.0})
    r.conditions->orientations.push_back({SlopeAxis::e_w, azimuth, 1});
  r.conditions->same_as = {0, 1, 2, 3};
  r.suites = {{"suite",
               "two records",
               "ASCE 7-10, S_S 1.5 g, S_1 0.6 g, site class C",
               {{0.0, 1.0, 2.0},
                {{1.0, 2.0, 1.0}, {3.0, 4.0, 1.0}},
                {2.0, 3.0, 1.0},
                {1.0, 2.0, 0.8},
                0.0,
                {{0.99, 0.082}, {2.5, 0.004}}}}};  // between the periods above
  r.records = {{.id = "a", .has_vertical = true}, {.id = "b"}};
  r.conditions->friction = {0.47, 0.47};
  for (int record = 0; record < 2; ++record) {
    for (int o = 0; o < 4; ++o) {
      for (int support = 0; support < 2; ++support) {
        for (int p = 0; p < 2; ++p) {
          const double x = inch * (o + 1) * (p + 1) * (record == 0 ? 1 : 3);
          ConditionHistory h;
          if (support == 0) h = {.displacement_m = x, .peak_m = x, .peak_along_m = x};
          h.shear_along = support == 0 ? 0.9 : 1.0;
          r.conditions->histories.push_back(h);
        }
      }
    }
  }
  analyse(r);
  return r;
}

std::vector<std::string> figure_names(Results r) {
  analyse(r);
  std::vector<std::string> names;
  for (const Figure& figure : clearance_figures(r)) names.push_back(figure.name);
  return names;
}

TEST(clearance_report, gives_a_row_for_each_listed_condition_and_the_range_of_all) {
  Results r = made_up();
  r.conditions->grid.listed = {"building damping 0.02", "building damping 0.05"};
  r.conditions->friction = {0.47, 0.47, 0.47, 0.47};
  // By (record, orientation, listed, support, period): half as much at 5 %.
  std::vector<ConditionHistory> both;
  for (std::size_t at = 0; at < r.conditions->histories.size(); at += 4) {
    for (const double factor : {1.0, 0.5}) {
      for (std::size_t i = at; i < at + 4; ++i) {
        both.push_back(r.conditions->histories[i]);
        both.back().displacement_m *= factor;
      }
    }
  }
  r.conditions->histories = both;
  analyse(r);
  const Table table = clearance_table(r);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(std::get<std::string>(table.rows[1][0]), r.conditions->grid.listed[1]);
  EXPECT_DOUBLE_EQ(std::get<SignedEstimate>(table.rows[1][3]).value, 5 * inch);
  EXPECT_THAT(clearance_sentences(r).back(),
              states(format_length(5.5 * inch) + " (building damping 0.05)",
                     format_length(11 * inch) + " (building damping 0.02)"));
}

TEST(clearance_report, the_clearance_is_a_factor_times_the_largest_mean_over_the_periods) {
  const Table table = clearance_table(made_up());
  ASSERT_EQ(table.rows.size(), 1u);  // the anchored array has no clearance
  EXPECT_THAT(to_csv(table), states("governing_period_s,lowest_m,median_m,median_low95_m"));
  const auto number = [&](std::size_t i) { return std::get<double>(table.rows[0][i]); };
  EXPECT_EQ(number(0), 1.0);                                                      // T, s
  EXPECT_DOUBLE_EQ(number(1), 4 * inch);                                          // lowest
  EXPECT_DOUBLE_EQ(std::get<SignedEstimate>(table.rows[0][2]).value, 10 * inch);  // 4, 8, 12, 16
  EXPECT_DOUBLE_EQ(std::get<SignedEstimate>(table.rows[0][3]).value, 16 * inch);
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
  Results r = made_up();
  ConditionGrid& grid = r.conditions->grid;
  grid.support = {ArraySupport::isolated};
  // In place of the supports: no displacement at the second level.
  struct Shown {
    std::vector<double> levels;
    std::size_t place;
    double clearance_m;
  };
  for (const Shown& shown : {Shown{{2.0 / 3, 1.0}, 0, 11 * inch}, Shown{{0.5, 2.0 / 3}, 1, 0.0},
                             Shown{{0.5, 1.0}, 1, 0.0}}) {
    grid.level = shown.levels;
    analyse(r);
    EXPECT_EQ(shown_condition(grid)[ConditionAxis::level], shown.place);
    EXPECT_DOUBLE_EQ(clearance_figures(r)[1].panels.at(0).rules.at(0).at, shown.clearance_m);
    EXPECT_THAT(clearance_reading(r, ClearanceTopic::period),
                states(label_of(grid, ConditionAxis::level, shown.place)));
  }
  grid.level = {0.5, 2.0 / 3, 1.0};
  grid.level_symbol = "S_DS";  // 2/3 g is no design earthquake
  grid.dbe_level = 0.0;
  EXPECT_EQ(shown_condition(grid)[ConditionAxis::level], 2u);
  grid.dbe_level = 2.0 / 3;  // of a target with this S_DS it is
  EXPECT_EQ(shown_condition(grid)[ConditionAxis::level], 1u);
  EXPECT_EQ(label_of(grid, ConditionAxis::level, 1), "DBE, S_DS = 0.667");
  EXPECT_EQ(label_of(grid, ConditionAxis::level, 2), "MCE, S_DS = 1.00");
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
  Results r = made_up();
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::orientation), Not(states("downhill")));
  r.conditions->friction = {0.47, 0.52};
  r.conditions->orientations[2].slope_axis = r.conditions->orientations[3].slope_axis =
      SlopeAxis::n_s;
  const std::string reading = clearance_reading(r, ClearanceTopic::orientation);
  // Largest over the periods: 4 and 8 inches along E-W, 12 and 16 along N-S.
  EXPECT_THAT(reading, states("0.47", format_length(6 * inch), "0.52", format_length(14 * inch)));
}

TEST(clearance_report, figures_are_of_the_axes_with_several_values) {
  EXPECT_EQ(figure_names(made_up()),
            (std::vector<std::string>{"spectra", "period", "orientations"}));
  Results r = made_up();
  r.conditions->grid.support = {ArraySupport::isolated};
  r.conditions->grid.slope_deg = {1.2, 2.4};  // in place of the supports: as many conditions
  for (ConditionHistory& h : r.conditions->histories) h.displacement_m += inch;
  EXPECT_EQ(figure_names(r),
            (std::vector<std::string>{"spectra", "period", "orientations", "slope"}));
  r.conditions->friction[1] = 0.5;
  EXPECT_EQ(figure_names(r),
            (std::vector<std::string>{"spectra", "period", "permutations", "slope"}));
  r.conditions->friction[1] = r.conditions->friction[0];
  r.conditions->grid.slope_deg = {1.2};
  r.conditions->grid.level = {2.0 / 3, 1.0};
  EXPECT_EQ(figure_names(r),
            (std::vector<std::string>{"spectra", "period", "orientations", "mce"}));
  r.conditions->grid.level = {1.0};
  r.conditions->grid.response_modification = {0.0, 2.0};
  EXPECT_EQ(figure_names(r),
            (std::vector<std::string>{"spectra", "period", "orientations", "yielding"}));
  r.conditions->grid.response_modification = {0.0};
  r.conditions->grid.vertical = {{VerticalChoice::none, 0.0}, {VerticalChoice::if_available, 0.0}};
  EXPECT_EQ(figure_names(r),
            (std::vector<std::string>{"spectra", "period", "orientations", "vertical"}));
}

TEST(clearance_report, of_several_suites_only_how_they_compare_is_reported) {
  Results r = made_up();
  r.suites.push_back(r.suites.front());
  r.suites.back().name = "other";
  r.records[1].suite = 1;
  EXPECT_EQ(figure_names(r), std::vector<std::string>{"level"});
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
  Results r = made_up();
  r.conditions->grid.support = {ArraySupport::isolated};
  r.conditions->grid.mass_ratio = {0.05, 0.1};  // in place of the supports: as many conditions
  std::vector<ConditionHistory>& histories = r.conditions->histories;
  for (std::size_t i = 0; i < histories.size(); ++i) {
    if (i % 4 >= 2) histories[i].displacement_m = 2.0 * histories[i - 2].displacement_m;
  }
  analyse(r);
  EXPECT_DOUBLE_EQ(clearance_figures(r)[1].panels.at(0).rules.at(0).at, 22 * inch);
}

// Twice the displacement without vertical motion, which is not at the first place.
TEST(clearance_report, the_clearance_of_the_figure_over_periods_is_of_the_lines_that_it_has) {
  Results r = made_up();
  r.conditions->grid.support = {ArraySupport::isolated};
  r.conditions->grid.mass_ratio = {0.05, 0.1};
  r.conditions->grid.vertical = {{VerticalChoice::if_available, 0.0}, {VerticalChoice::none, 0.0}};
  r.conditions->histories.clear();
  for (const int record : {1, 3})
    for (int o = 0; o < 4; ++o)
      for (const int vertical : {1, 2})
        for (int mass = 0; mass < 2; ++mass)
          for (int p = 0; p < 2; ++p)
            r.conditions->histories.push_back(
                {.displacement_m = inch * (o + 1) * (p + 1) * record * vertical});
  analyse(r);
  const Figure figure = clearance_figures(r)[1];
  double largest_m = 0.0;
  for (const DataSeries& line : curves_of(figure))
    largest_m = std::max(largest_m, *std::ranges::max_element(line.y));
  EXPECT_DOUBLE_EQ(largest_m, 20 * inch);
  EXPECT_DOUBLE_EQ(figure.panels.at(0).rules.at(0).at, 1.1 * largest_m);
  EXPECT_THAT(figure.below, states("no vertical motion"));
}

Figure figure_of(Results r, const std::string& name) {
  analyse(r);
  return figure_named(clearance_figures(r), name);
}

TEST(clearance_report, the_line_at_the_design_earthquake_is_what_the_text_says) {
  Results r = made_up();
  r.conditions->grid.support = {ArraySupport::isolated};
  r.conditions->grid.level = {2.0 / 3, 1.0};
  const Rule line = figure_of(r, "mce").panels.at(0).rules.at(0);
  EXPECT_DOUBLE_EQ(line.at, 10 * inch);  // median of the orientations, at 1 s
  analyse(r);
  EXPECT_THAT(clearance_reading(r, ClearanceTopic::mce),
              states(format_length(line.at) + " at DBE"));
}

TEST(clearance_report, a_yielding_building_is_drawn_from_r_above_0) {
  Results r = made_up();
  r.conditions->grid.support = {ArraySupport::isolated};
  r.conditions->grid.response_modification = {0.0, 2.0};
  for (ConditionHistory& h : r.conditions->histories) h.displacement_m += inch;
  for (const DataSeries& line : curves_of(figure_of(r, "yielding")))
    EXPECT_EQ(line.x, std::vector{2.0});
}

TEST(clearance_report, intensity_levels_are_named_on_their_axis) {
  Results r = made_up();
  r.suites.push_back(r.suites.front());
  r.suites[0].name = "my_level1";
  r.suites[1].name = "my_level3";
  r.records[1].suite = 1;
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
  EXPECT_DOUBLE_EQ(std::get<SignedEstimate>(table.rows[0][3]).value, 0.9);
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
  Results r = made_up();
  r.conditions->grid.support = {ArraySupport::isolated};
  r.conditions->grid.level = {1.0, 2.0};  // in place of the supports: as many conditions
  analyse(r);
  r.base_shear = BaseShearAnalysis::find({}, r);
  EXPECT_EQ(base_shear_sentences(r).size(), 1u);
  EXPECT_EQ(base_shear_figures(r).size(), 1u);
}

// The numbers of the figures, whatever the axes, are those of the tables.
TEST(clearance_report, figures_have_the_numbers_of_the_tables) {
  const auto of_tables = [](Results r) {
    analyse(r);
    r.base_shear = BaseShearAnalysis::find({}, r);
    std::vector<Figure> figures = clearance_figures(r);
    for (Figure& figure : base_shear_figures(r)) figures.push_back(std::move(figure));
    return figures_of_tables(figures, csv_tables(r));
  };
  Results r = made_up();
  EXPECT_THAT(of_tables(r), ElementsAre("period", "orientations", "base_shear"));
  r.conditions->grid.support[1] = ArraySupport::no_array;
  EXPECT_THAT(of_tables(r),
              ElementsAre("period", "orientations", "base_shear", "base_shear_ratio"));
  r.conditions->grid.support = {ArraySupport::isolated};
  const ConditionGrid one = r.conditions->grid;
  std::vector<ConditionGrid> several(4, one);
  several[0].slope_deg = {1.2, 2.4};
  several[1].level = {2.0 / 3, 1.0};
  several[2].response_modification = {0.0, 2.0};
  several[3].vertical = {{VerticalChoice::none, 0.0}, {VerticalChoice::if_available, 0.0}};
  for (const ConditionGrid& grid : several) {
    r.conditions->grid = grid;
    EXPECT_EQ(of_tables(r).size(), 4u);  // slope, mce, yielding, vertical
  }
  r = made_up();
  r.suites.push_back(r.suites.front());
  r.suites.back().name = "other";
  r.records[1].suite = 1;
  EXPECT_THAT(of_tables(r), ElementsAre("level", "base_shear"));
}

TEST(clearance_report, histories_have_base_shears_only_beside_that_analysis) {
  Results r = made_up();
  const std::size_t columns = clearance_histories_table(r).columns.size();
  EXPECT_THAT(to_csv(clearance_histories_table(r)), Not(testing::HasSubstr("shear")));
  r.base_shear = BaseShearAnalysis::find({}, r);
  EXPECT_EQ(clearance_histories_table(r).columns.size(), columns + 2);
}

TEST(clearance_report, histories_are_reported_once_each) {
  Results r = made_up();
  r.conditions->same_as = {0, 1, 0, 1};
  EXPECT_EQ(clearance_histories_table(r).rows.size(), 2u * 2u * 4u);
}

}  // namespace
}  // namespace glissade
