// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <limits>

#include "misfits.hpp"
#include "whole_results.hpp"

namespace glissade {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(chart_results, come_back) {
  const TemporaryFolder folder;
  const Results written = with_all();
  write_results(folder.path() / "a.h5", written);
  const Results read = read_results(folder.path() / "a.h5");

  ASSERT_TRUE(read.chart);
  const Chart& chart = *read.chart;
  EXPECT_EQ(chart.slope_deg, written.chart->slope_deg);
  EXPECT_EQ(chart.mu, written.chart->mu);
  EXPECT_EQ(chart.period_s, written.chart->period_s);
  EXPECT_EQ(chart.shown_slope_deg, 2.0);
  EXPECT_EQ(chart.shown_mu, 0.5);
  EXPECT_EQ(chart.shown_level, 1.5);
  ASSERT_EQ(chart.points.size(), 12u);
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
}

TEST(chart_results, that_do_not_fit_their_axes_are_refused) {
  const auto refusal = [](void (*spoil)(Chart&)) {
    Results results = with_all();
    spoil(*results.chart);
    return misfit_in(results);
  };
  EXPECT_EQ(refusal([](Chart& c) { c.points.pop_back(); }), "points");
  EXPECT_EQ(refusal([](Chart& c) { c.points[2].by_period.pop_back(); }), "by_period");
  EXPECT_EQ(refusal([](Chart& c) { c.slope_deg.pop_back(); }), "axes");
  EXPECT_EQ(refusal([](Chart& c) { c.mu.clear(); }), "axes");
  EXPECT_EQ(refusal([](Chart& c) { c.period_s.clear(); }), "axes");
  // One of both is given, and the other is read.
  EXPECT_EQ(refusal([](Chart& c) { c.readings[0].question.mu.reset(); }), "friction");
  EXPECT_EQ(refusal([](Chart& c) { c.readings[0].question.displacement_m = 0.6; }), "friction");
}

}  // namespace
}  // namespace glissade
