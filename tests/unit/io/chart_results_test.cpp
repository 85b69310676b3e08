// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::HasSubstr;

constexpr double infinity = std::numeric_limits<double>::infinity();

Results make_chart_results() {
  Results r;
  r.levels = {0.0, 1.3};
  r.samples = {{0.3, 0.0, 0.2, 0.05, 0, 1}};
  r.records = {{"a"}};
  r.spectra.srss_g = {{}};
  r.runs.resize(1);
  r.runs[0].label = "chart";
  r.runs[0].peak_displacement_m = Array3<double>(1, 1, 2, 0.25);
  r.runs[0].uplift = r.runs[0].tips = Array3<std::uint8_t>(1, 1, 2);
  r.runs[0].tips(0, 0, 1) = 1;
  r.runs[0].capacity = Array3<double>(1, 1, 0);
  Chart& chart = r.chart.emplace();
  chart.slope_deg = {0.0, 2.0};
  chart.mu = {0.3, 0.5};
  chart.period_s = {0.2, 1.0};
  chart.shown_slope_deg = 2.0;
  chart.shown_mu = 0.5;
  chart.shown_level = 1.3;
  for (int i = 0; i < 8; ++i) {
    const double x = std::sqrt(1.0 + i);
    chart.points.push_back({.level = r.levels[i / 4],
                            .slope_deg = chart.slope_deg[i / 2 % 2],
                            .mu = chart.mu[i % 2],
                            .free_sliding = i == 3,
                            .largest = {x, 2 * x, 3 * x, i == 3 ? infinity : 4 * x},
                            .mean_interval = {x / 2, i == 3 ? std::nan("") : x * 2},
                            .governing_period_s = chart.period_s[i % 2],
                            .clearance_m = 1.1 * x,
                            .uplift_share = x / 10,
                            .tip_share = i == 5 ? std::nan("") : x / 20,
                            .by_period = {{x, x, x, x}, {0.1, 0.2, 0.3, infinity}}});
  }
  chart.readings = {{{1.3, 1.19, 0.47, std::nullopt}, 1.0, 1.1, 2.0, 3.0, 4.0},
                    {{1.3, 1.19, std::nullopt, 0.6}, 0.4, 0.5, 0.6, 0.7, infinity}};
  chart.standards = {{Standard::seaoc_pv1_2012, 1.3, {1.23, Provenance::checked, "60 (...)"}}};
  return r;
}

TEST(chart_results, come_back_to_the_last_bit) {
  const TemporaryFolder folder;
  const Results written = make_chart_results();
  write_results(folder.path() / "a.h5", written);
  const Results read = read_results(folder.path() / "a.h5");
  write_results(folder.path() / "b.h5", read);
  EXPECT_EQ(read_text_file(folder.path() / "a.h5"), read_text_file(folder.path() / "b.h5"));

  ASSERT_TRUE(read.chart);
  const Chart& chart = *read.chart;
  EXPECT_EQ(chart.slope_deg, written.chart->slope_deg);
  EXPECT_EQ(chart.mu, written.chart->mu);
  EXPECT_EQ(chart.period_s, written.chart->period_s);
  EXPECT_EQ(chart.shown_slope_deg, 2.0);
  EXPECT_EQ(chart.shown_mu, 0.5);
  EXPECT_EQ(chart.shown_level, 1.3);
  ASSERT_EQ(chart.points.size(), 8u);
  const ChartPoint &point = chart.points[3], &expected = written.chart->points[3];
  EXPECT_EQ(point.level, expected.level);
  EXPECT_EQ(point.slope_deg, 2.0);
  EXPECT_EQ(point.mu, 0.5);
  EXPECT_TRUE(point.free_sliding);
  EXPECT_FALSE(chart.points[2].free_sliding);
  EXPECT_EQ(point.largest.p84_m, expected.largest.p84_m);
  EXPECT_EQ(point.largest.envelope_m, infinity);
  EXPECT_EQ(point.mean_interval.low, expected.mean_interval.low);
  EXPECT_EQ(point.governing_period_s, 1.0);
  EXPECT_EQ(point.clearance_m, expected.clearance_m);
  EXPECT_EQ(point.uplift_share, expected.uplift_share);
  EXPECT_EQ(point.tip_share, expected.tip_share);
  EXPECT_TRUE(std::isnan(chart.points[5].tip_share));
  ASSERT_EQ(point.by_period.size(), 2u);
  EXPECT_EQ(point.by_period[1].p95_m, 0.3);
  EXPECT_EQ(point.by_period[1].envelope_m, infinity);
  ASSERT_EQ(chart.readings.size(), 2u);
  EXPECT_EQ(chart.readings[0].question.mu, 0.47);
  EXPECT_FALSE(chart.readings[0].question.displacement_m);
  EXPECT_EQ(chart.readings[1].question.displacement_m, 0.6);
  EXPECT_FALSE(chart.readings[1].question.mu);
  EXPECT_EQ(chart.readings[1].envelope, infinity);
  ASSERT_EQ(chart.standards.size(), 1u);
  EXPECT_EQ(chart.standards[0].prescribed.value_m, 1.23);
  EXPECT_EQ(read.runs[0].tips.data, written.runs[0].tips.data);
}

TEST(chart_results, that_do_not_fit_their_axes_are_refused) {
  const TemporaryFolder folder;
  Results results = make_chart_results();
  results.chart->points.pop_back();
  write_results(folder.path() / "a.h5", results);
  EXPECT_THAT(message_of([&] { read_results(folder.path() / "a.h5"); }),
              HasSubstr("fit points to the chart's axes"));
  results = make_chart_results();
  results.chart->points[2].by_period.pop_back();
  write_results(folder.path() / "b.h5", results);
  EXPECT_THAT(message_of([&] { read_results(folder.path() / "b.h5"); }),
              HasSubstr("fit by_period to the chart's periods"));
}

}  // namespace
}  // namespace glissade
