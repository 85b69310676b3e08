// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

#include "analysis/verdict/kinds.hpp"
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
using testing::Not;

/// Two frictions at 0.5, 0.75 and 1 g: the first is exceeded from 0.75 g on, the second slides
/// a tenth of what is prescribed.
Results made_up() {
  Results r = made_up_chart_results();
  VerdictResults& verdict = r.verdict.emplace();
  verdict.exceedance = {0.1, 0.01};
  for (const double mu : {0.3, 0.5}) {
    for (const double sds_g : {0.5, 0.75, 1.0}) {
      VerdictRow row;
      row.standard = Standard::asce7_16;
      row.sds_g = sds_g;
      row.prescribed.value_m = 0.6;
      row.first_case = mu == 0.3 ? 0 : 1;
      row.mu = mu;
      row.slope_deg = 2.0;
      row.within_conditions = mu == 0.5;
      row.dbe.probability = mu == 0.5 ? 0.0 : sds_g - 0.5;
      row.dbe.interval = {row.dbe.probability / 2.0, row.dbe.probability + 0.125};
      row.mce.probability = row.dbe.probability + 0.25;
      row.mce.interval = {0.125, 0.875};
      row.displacement_m = mu == 0.5 ? std::vector{0.03, 0.06} : std::vector{2.0 * sds_g, 3.0};
      row.displacement_interval = {{0.01, 0.1}, {0.02, 0.2}};
      for (const double factor : {0.5, 0.5, 2.0}) {
        VerdictSeparation s{verdict.rows.size(),
                            factor < 1.0 ? "between arrays" : "to an edge",
                            factor,
                            factor * 0.6,
                            {},
                            {}};
        s.dbe.probability = factor * row.dbe.probability;
        s.dbe.interval = {0.0, 0.5};
        verdict.separations.push_back(s);
      }
      verdict.separations.back().dbe.probability = 0.0;
      verdict.separations[verdict.separations.size() - 2].what = "between arrays, across";
      if (sds_g == 1.0) verdict.separations[verdict.separations.size() - 2].dbe.probability = 0.375;
      verdict.rows.push_back(row);
    }
  }
  return r;
}

TEST(verdict_report, has_a_row_for_each_kind_of_array_and_one_for_each_value) {
  const Results r = made_up();
  EXPECT_EQ(table_named(r, "verdict").rows.size(), 6u);
  const auto kinds = table_named(r, "verdict_summary").rows;
  ASSERT_EQ(kinds.size(), 2u);
  EXPECT_EQ(std::get<std::string>(kinds[0][3]), "checked");
  EXPECT_EQ(std::get<std::string>(kinds[0][4]), "outside");
  EXPECT_EQ(std::get<std::string>(kinds[0][5]), "0.75 to 1");
  EXPECT_EQ(std::get<std::string>(kinds[0][6]), "-");
  EXPECT_EQ(std::get<NumberCell>(kinds[0][7]).value, 0.5);
  EXPECT_EQ(std::get<std::string>(kinds[1][5]), "-");
  EXPECT_EQ(std::get<std::string>(kinds[1][6]), "0.5 to 1");
}

TEST(verdict_report, says_which_prescribed_displacements_are_recalled) {
  Results r = made_up();
  const auto provision = [&] {
    return std::get<std::string>(table_named(r, "verdict_summary").rows[0][3]);
  };
  r.verdict->rows[0].prescribed.provenance = Provenance::recalled;
  EXPECT_EQ(provision(), "partly recalled");
  for (VerdictRow& row : r.verdict->rows) row.prescribed.provenance = Provenance::recalled;
  EXPECT_EQ(provision(), "recalled");
}

TEST(verdict_report, says_within_and_outside_the_conditions_apart) {
  const std::vector<std::string> sentences = answer_sentences(made_up());
  EXPECT_THAT(sentences, Contains(states("outside", "3", "2", "S_DS = 1 g", "friction 0.3")));
  EXPECT_THAT(sentences, Contains(states("within", "0", "3")));
  EXPECT_THAT(summary_text(made_up()), states("0.75 to 1"));
}

TEST(verdict_report, says_how_probably_two_arrays_close_their_gap_beside_the_figures_of_one) {
  const Results r = made_up();
  EXPECT_EQ(table_named(r, "verdict_separations").rows.size(), 18u);
  const auto kinds = table_named(r, "verdict_separations_summary").rows;
  ASSERT_EQ(kinds.size(), 2u);
  EXPECT_EQ(std::get<NumberCell>(kinds[0][4]).value, 0.375);  // the worse of both gaps
  EXPECT_EQ(std::get<NumberCell>(kinds[0][5]).value, 0.0);
  EXPECT_THAT(answer_sentences(r),
              Contains(states("outside", "close a gap", "2 of 3", "38 % [0 % to 50 %]",
                              "between arrays, across", "0 of 3")));
}

TEST(verdict_report, says_on_which_slopes_two_arrays_stand) {
  Results r = made_up();
  EXPECT_THAT(answer_sentences(r), Contains(states("close a gap", "on one slope")));
  for (Case& c : r.cases.cases) c.neighbour_slope = NeighbourSlope::facing;
  EXPECT_THAT(answer_sentences(r),
              Contains(states("close a gap", "on two slopes that fall towards each other")));
  EXPECT_THAT(answer_sentences(r), Not(Contains(states("on one slope"))));
}

TEST(verdict_report, of_arrays_that_differ_in_more_names_them_and_draws_the_largest) {
  Results r = made_up();
  r.cases.axes = {{"building.mass_ratio", "-", {0.01, 0.1}, {}}};
  VerdictRow heavier = r.verdict->rows.back();
  heavier.first_case = 2;
  heavier.condition = "mass ratio 0.1";
  heavier.displacement_m.front() = 6.0;  // ten times what is prescribed
  r.verdict->rows.push_back(heavier);
  EXPECT_EQ(std::get<std::string>(table_named(r, "verdict_summary").rows.back().back()),
            "mass ratio 0.1");
  const Figure figure = verdict_figure(r);
  const DataSeries& line = figure.panels.at(0).series.at(3);  // friction 0.5, behind the bars
  ASSERT_EQ(line.x.size(), 3u);
  EXPECT_NEAR(line.y.back(), 10.0, 1e-12);
  EXPECT_EQ(figure.panels[0].y.values, Axis::Values::logarithms);
}

TEST(verdict_report, says_on_which_buildings_and_counts_those_that_yield_apart) {
  Results r = made_up();
  EXPECT_THAT(answer_sentences(r), Contains(states("elastic")));
  EXPECT_THAT(answer_sentences(r), Not(Contains(states("yield"))));
  for (VerdictRow& row : r.verdict->rows) row.first_case = row.mu == 0.3 ? 0 : 1;
  r.cases.cases.at(1).response_modification = 4.0;  // friction 0.5: within the conditions
  const std::vector<std::string> sentences = answer_sentences(r);
  EXPECT_THAT(sentences, Contains(states("R = 4", "within", "0 of 3", "3 by estimate")));
  EXPECT_THAT(sentences, Contains(states("elastic buildings", "outside", "2")));
}

TEST(verdict_report, draws_intervals_and_what_the_other_standard_prescribes) {
  Results r = made_up();
  r.verdict->rows[0].displacement_interval.front() = {0.6, 6.0};
  std::vector<VerdictRow> others(r.verdict->rows.begin(), r.verdict->rows.begin() + 2);
  for (VerdictRow& other : others) {
    other.standard = Standard::seaoc_pv1_2012;
    other.prescribed.value_m = 0.06;  // a tenth of the other standard's
  }
  r.verdict->rows.insert(r.verdict->rows.begin(), others.begin(), others.end());
  const Panel panel = verdict_figure(r).panels.at(0);
  EXPECT_NEAR(panel.series.at(0).y.at(0), 0.1, 1e-12);
  const DataSeries& bars = panel.series.at(1);
  EXPECT_EQ(bars.kind, DataSeries::Kind::bars);
  EXPECT_NEAR(bars.low.at(0), 1.0, 1e-12);
  EXPECT_NEAR(bars.high.at(0), 10.0, 1e-12);
}

TEST(verdict_report, draws_how_probably_two_arrays_meet_where_they_have_neighbours) {
  Results r = made_up();
  const auto figures = [&] {
    std::vector<std::string> names;
    for (const Figure& figure : make_figures(r)) names.push_back(figure.name.text());
    return names;
  };
  EXPECT_THAT(figures(), Contains("verdict_separations"));
  const Figure figure = verdict_separations_figure(r);
  EXPECT_EQ(series_named(figure, "friction 0.3").y, (std::vector{0.0, 0.125, 0.375}));
  EXPECT_EQ(figure.panels[0].series[0].high.at(2), 0.5);
  EXPECT_EQ(figure.panels[0].rules.at(0).at, 0.1);
  EXPECT_THAT(figures_of_tables(make_figures(r), csv_tables(r)),
              testing::IsSupersetOf({"verdict", "verdict_separations"}));
  std::erase_if(r.verdict->separations, [](const auto& s) { return s.factor < 1.0; });
  EXPECT_THAT(figures(), Not(Contains("verdict_separations")));
}

TEST(verdict_report, over_R_where_there_is_one_S_DS_elastic_at_1_and_all_points_inside) {
  Results r = made_up();
  std::erase_if(r.verdict->rows, [](const VerdictRow& row) { return row.sds_g != 1.0; });
  for (VerdictRow& row : r.verdict->rows) row.mu = 0.5;
  r.cases.cases.at(1).response_modification = 4.0;
  const Panel panel = verdict_figure(r).panels.at(0);
  EXPECT_EQ(panel.series.at(1).x, (std::vector{1.0, 4.0}));
  EXPECT_THAT(panel.x.label, states("1: elastic"));
  EXPECT_EQ(panel.y.ticks.front().label, "\u2264 0.1");
  for (const DataSeries& series : panel.series) {
    EXPECT_GT(series.x.front() + series.aside, panel.x.low);
    EXPECT_LT(series.x.back() + series.aside, panel.x.high);
  }
}

TEST(verdict_report, is_absent_without_the_analysis) {
  const Results r = made_up_chart_results();
  for (const Table& table : csv_tables(r))
    EXPECT_FALSE(table.name.text().starts_with("verdict")) << table.name.text();
}

// An empty plot shows nothing; what is in it is said instead.
TEST(verdict_report, leaves_out_slopes_on_which_no_line_leaves_the_lower_edge) {
  Results r = made_up();
  for (std::size_t i = 0; i < 6; ++i) {
    VerdictRow flat = r.verdict->rows[i];
    flat.slope_deg = 0.0;
    flat.displacement_m.front() = 0.03;  // a twentieth
    flat.displacement_interval.front() = {0.01, 0.09};
    r.verdict->rows.push_back(flat);
  }
  Figure figure = verdict_figure(r);
  ASSERT_EQ(figure.panels.size(), 1u);
  EXPECT_EQ(figure.panels[0].title, "slope 2 degrees");
  EXPECT_THAT(figure.below,
              states("not drawn: slope 0 degrees, at most 0.0500 (intervals to 0.150)"));
  r.verdict->rows.erase(r.verdict->rows.begin(), r.verdict->rows.begin() + 6);
  figure = verdict_figure(r);  // there is no other
  ASSERT_EQ(figure.panels.size(), 1u);
  EXPECT_THAT(figure.below, Not(states("not drawn")));
}

}  // namespace
}  // namespace glissade
