// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/friction_report.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "facts.hpp"
#include "figure_facts.hpp"
#include "glissade/core/file.hpp"

namespace glissade {
namespace {

using test::states;

/// Slides at a constant mu over 0.1 m.
PullTest even_pull(const std::string& test, const std::string& direction, double mu) {
  PullTest pull{test, direction, "", {5.0, 5.002}, {0.0, 1200.0 * mu}, {1000.0, 1000.0}};
  for (int i = 1; i <= 10; ++i) {
    pull.displacement_m.push_back(5.0 + 0.01 * i);
    pull.force_n.push_back(1000.0 * mu);
    pull.normal_n.push_back(1000.0);
  }
  return pull;
}

const std::vector<PullTest> tests = {even_pull("1", "along", 0.50), even_pull("2", "along", 0.60),
                                     even_pull("1", "E_W's {&} @ #1, \"x\"", 0.70)};

TEST(friction_tables, have_a_row_for_each_test_and_two_for_each_direction) {
  const PullTestSummary summary = summarise(tests, {});
  const Table each = pull_tests_table(summary), over = friction_table(summary);
  ASSERT_EQ(each.rows.size(), 3u);
  EXPECT_EQ(std::get<std::string>(each.rows[1][0]), "2");
  EXPECT_NEAR(std::get<double>(each.rows[1][3]), 0.6, 1e-12);
  ASSERT_EQ(over.rows.size(), 4u);
  EXPECT_NEAR(std::get<double>(over.rows[0][3]), 0.55, 1e-12);
  EXPECT_NEAR(std::get<double>(over.rows[1][3]), 0.66, 1e-12);
  // One test: empty fields where nothing can be computed.
  EXPECT_THAT(to_csv(over), testing::ContainsRegex(",sliding,1,0.7[0-9]*,,,,,\n"));
}

double largest_of(const std::vector<double>& values) {
  double largest = 0.0;
  for (const double value : values) largest = std::fmax(largest, value);
  return largest;
}

TEST(friction_figure, draws_every_trace_from_its_own_zero_and_the_levels_of_each_direction) {
  const PullTestSummary summary = summarise(tests, {});
  const Figure figure = friction_figure(tests, summary);
  ASSERT_EQ(figure.panels.size(), 2u);
  EXPECT_EQ(figure.panels[0].title, "along");
  ASSERT_EQ(figure.panels[0].rules.size(), 2u);  // mean and mean - 2 std of two tests
  ASSERT_EQ(figure.panels[1].rules.size(), 1u);  // the mean of one
  EXPECT_NEAR(figure.panels[0].rules[0].at, 0.55, 1e-12);
  EXPECT_NEAR(figure.panels[1].rules[0].at, 0.70, 1e-12);
  for (const Panel& panel : figure.panels) {
    ASSERT_EQ(panel.series.size(), 2u);  // traces and their sliding parts
    EXPECT_EQ(panel.series[0].x.front(), 0.0);
    EXPECT_EQ(panel.series[0].y.front(), 0.0);
    EXPECT_LE(largest_of(panel.series[0].x), 0.1 + 1e-12);
    EXPECT_GT(numbers_in(panel.series[1]), 0u);
    EXPECT_LT(numbers_in(panel.series[1]), numbers_in(panel.series[0]));
  }
}

TEST(friction_figure, keeps_the_peaks_of_a_long_trace_and_little_else) {
  PullTest pull{"1", "along", "", {}, {}, {}};
  for (int i = 0; i < 100000; ++i) {
    pull.displacement_m.push_back(1e-5 * i);
    pull.force_n.push_back(i == 54321 ? 900.0 : i == 65432 ? 100.0 : 500.0 + i % 7);
    pull.normal_n.push_back(1000.0);
  }
  const Figure figure = friction_figure({pull}, summarise({pull}, {}));
  const DataSeries& trace = figure.panels.at(0).series.at(0);
  EXPECT_EQ(std::ranges::count(trace.y, 0.9), 1);
  EXPECT_EQ(std::ranges::count(trace.y, 0.1), 1);
  EXPECT_LE(trace.x.size(), 1001u);
}

TEST(friction_figure, is_drawn_whatever_directions_are_called) {
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / "glissade_report_friction";
  std::filesystem::remove_all(folder);
  write_friction_report(tests, summarise(tests, {}), folder);
  const std::string svg = read_text_file(folder / "figures" / "friction.svg");
  EXPECT_THAT(svg, states("E_W\u2019s {", "@ #1, \"x\""));
  for (const char* file : {"figures/friction.pdf", "tables/friction.csv", "tables/pull_tests.csv"})
    EXPECT_TRUE(std::filesystem::exists(folder / file)) << file;
}

}  // namespace
}  // namespace glissade
