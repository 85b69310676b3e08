// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>

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

/// 2e-5 at 0.5 g, 0.02 at 1 g.
Results made_up() {
  Results r = made_up_results();
  r.rare = RareResults{.widening = 3.0,
                       .friction = "mu normal, mean 0.5, std 0.06",
                       .weights = {2.0, 1.0},
                       .rows = {}};
  r.rare->rows = {{0, "", 0.3, 0.5, 2e-5, {1e-5, 4e-5}, {1e-6, 9e-5}, 2.5, 3e6, 40.0},
                  {0, "", 0.3, 1.0, 0.02, {0.015, 0.03}, {0.01, 0.04}, 7.5, 4e4, 900.0}};
  r.sampling_errors = {{"sampled", 0.3, 1.25, 0.125, 0.03125}};
  return r;
}

TEST(rare_report, states_the_probability_near_1e_minus_5_with_both_intervals) {
  const std::string text = summary_text(made_up());
  EXPECT_THAT(text, states("2e-05", "1e-05 to 4e-05", "1e-06 to 9e-05", "2.5", "3e+06"));
  EXPECT_THAT(summary_text(made_up_results()), Not(testing::HasSubstr("Effective number")));
}

TEST(rare_report, draws_a_line_for_each_threshold) {
  const std::vector<Figure> figures = make_figures(made_up());
  const auto figure = std::ranges::find(figures, FileName("rare"), &Figure::name);
  ASSERT_NE(figure, figures.end());
  EXPECT_THAT(figure->below, states("friction mu normal, mean 0.5, std 0.06"));
  const Panel& panel = figure->panels.front();
  ASSERT_EQ(panel.series.size(), 3u);  // band, bars, line
  EXPECT_EQ(panel.series[2].x.size(), 2u);
  EXPECT_NEAR(panel.series[2].y[0], 2e-5, 1e-8);
  EXPECT_THAT(figures_of_tables(figures, csv_tables(made_up())), testing::Contains("rare"));
  EXPECT_EQ(panel.y.values, Axis::Values::logarithms);  // the titles of the points are of 2e-5
}

TEST(sampling_error_report, says_whether_records_or_samples_are_what_is_missing) {
  Results r = made_up();
  const auto wanted = [](const char* text) { return Contains(states(text)); };
  EXPECT_THAT(answer_sentences(r), Contains(states("12.5 %", "3.12 %")));
  EXPECT_THAT(answer_sentences(r), wanted("more samples would not"));
  r.sampling_errors[0].sampling_error = 0.25;
  EXPECT_THAT(answer_sentences(r), Not(wanted("more samples would not")));
}

}  // namespace
}  // namespace glissade
