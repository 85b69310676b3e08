// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/conditions/suite_mean.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glissade/fragility/share.hpp"
#include "unit/study/by_rule.hpp"

namespace glissade {
namespace {

using test::fixed;
using test::listed;

/// Two records of one suite and one of another, four orientations (slope along E-W), two periods.
/// Displacements of the first suite, by (record, orientation, period):
///   a  1 2   3 4   5 6   7 0
///   b  1 0   1 0   1 0   1 8
/// @param a_last_m a in the last orientation at 1 s
/// @param more_m at 1 s, of all
Results by_hand(double a_last_m = 0.0, double more_m = 0.0) {
  StudyConfig study;
  study.model.axes = SlidingAxes::one;
  study.intensity.levels = {1.0};
  study.quantities.at("roof", "slope_deg") = fixed(1.0);
  study.quantities.at("building", "period_s") = listed({0.2, 1.0});
  study.orientation.choice = OrientationChoice::all_permutations;
  const double by_record[3][8] = {{1., 2., 3., 4., 5., 6., 7., a_last_m},
                                  {1., 0., 1., 0., 1., 0., 1., 8.},
                                  {9., 9., 9., 9., 9., 9., 9., 9.}};
  Results r = test::results_by_rule(study,
                                    {{.suite = 0, .id = "a", .stronger = 0},
                                     {.suite = 0, .id = "b", .stronger = 1},
                                     {.suite = 1, .id = "c"}},
                                    [&](const test::HistoryPlace& at) -> test::MadeUpHistory {
                                      const bool last = at.c.period_s == 1.0;
                                      const double x =
                                          by_record[at.record][2 * at.orientation + last];
                                      return {x + (last ? more_m : 0.0), 0.9 * x, 0.3 * x, 0.4 * x};
                                    });
  return r;
}

Condition at_period(std::size_t period) {
  Condition at;
  at[ConditionAxis::period] = period;
  return at;
}

TEST(suite_mean, means_are_of_the_suites_records_in_one_orientation) {
  const Results r = by_hand();
  EXPECT_DOUBLE_EQ(suite_mean(r, {}, 0, at_period(0)), 1.0);
  EXPECT_DOUBLE_EQ(suite_mean(r, {}, 3, at_period(1)), 4.0);
  EXPECT_DOUBLE_EQ(suite_mean(r, {.suite = 1}, 0, at_period(0)), 9.0);
  EXPECT_DOUBLE_EQ(suite_mean(r, {.number = HistoryNumber::base_shear}, 2, at_period(0)), 1.5);
  EXPECT_DOUBLE_EQ(suite_mean(r, {.number = HistoryNumber::vector_peak}, 2, at_period(0)), 2.7);
}

TEST(suite_mean, the_range_is_over_orientations_with_the_median_between_the_middle_two) {
  const OrientationRange one = over_orientations(by_hand(), {}, at_period(0), Periods::one);
  EXPECT_DOUBLE_EQ(one.lowest, 1.0);  // means 1, 2, 3, 4
  EXPECT_DOUBLE_EQ(one.median, 2.5);
  EXPECT_DOUBLE_EQ(one.highest, 4.0);
  const OrientationRange largest = over_orientations(by_hand(), {}, {}, Periods::largest);
  EXPECT_DOUBLE_EQ(largest.lowest, 1.0);  // the larger of the two periods: 1, 2, 3, 4
  EXPECT_DOUBLE_EQ(largest.highest, 4.0);
}

// Record a has 1, 3, 5, 7 in the orientations, b has 1: the rule takes of the ends of the means'
// intervals what it takes of the means.
TEST(suite_mean, the_interval_is_over_records) {
  const OrientationRange range = over_orientations(by_hand(), {}, at_period(0), Periods::one);
  const Interval of_3 = positive_mean_interval({3, 1}), of_5 = positive_mean_interval({5, 1}),
                 of_7 = positive_mean_interval({7, 1});
  EXPECT_DOUBLE_EQ(range.interval.low, 0.5 * (of_3.low + of_5.low));
  EXPECT_DOUBLE_EQ(range.interval.high, 0.5 * (of_3.high + of_5.high));
  EXPECT_DOUBLE_EQ(range.highest_interval.low, of_7.low);
  EXPECT_DOUBLE_EQ(range.highest_interval.high, of_7.high);
  const OrientationRange alone = over_orientations(by_hand(), {.suite = 1}, {}, Periods::one);
  EXPECT_TRUE(std::isnan(alone.interval.low));
}

TEST(suite_mean, the_governing_period_is_of_the_rule) {
  using enum OrientationRule;
  // 2.5 against (1 + 2)/2 + ...: 1, 2, 3, 4
  EXPECT_EQ(governing_period(by_hand(), {}, {}, median), 0u);
  const Results r = by_hand(1.0);  // in the last orientation at 1 s: 4.5
  EXPECT_EQ(governing_period(r, {}, {}, median), 0u);
  EXPECT_EQ(governing_period(r, {}, {}, largest), 1u);
  EXPECT_EQ(governing_period(by_hand(1.0, 100.0), {}, {}, median), 1u);
}

TEST(suite_mean, no_orientation_by_record_leaves_the_bounds) {
  const Results r = by_hand();
  const PerRecordBounds bounds = per_record_bounds(r, {}, at_period(1), Periods::one);
  EXPECT_DOUBLE_EQ(bounds.lowest, 0.0);
  EXPECT_DOUBLE_EQ(bounds.highest, 7.0);  // a 6, b 8
  const PerRecordBounds largest = per_record_bounds(r, {}, {}, Periods::largest);
  EXPECT_DOUBLE_EQ(largest.lowest, 1.0);
  EXPECT_DOUBLE_EQ(largest.highest, 7.0);
  const std::vector<double> means = per_record_means(r, {}, at_period(1), Periods::one);
  ASSERT_EQ(means.size(), 10000u);
  EXPECT_DOUBLE_EQ(means.front(), 0.0);
  EXPECT_DOUBLE_EQ(means.back(), 7.0);
  // Of the sixteen pairs, equally likely, one gives 7: 625 +- 24 (binomial), here within four.
  const double share = 1.0 - share_below(means, 6.9);
  EXPECT_NEAR(share, 1.0 / 16, 4 * 0.0024);
}

TEST(suite_mean, ties_count_half_below) {
  EXPECT_DOUBLE_EQ(share_below({1.0, 2.0, 2.0, 3.0}, 2.0), 0.5);
  EXPECT_DOUBLE_EQ(share_below({1.0, 2.0}, 5.0), 1.0);
  EXPECT_TRUE(std::isnan(share_below({}, 5.0)));
}

TEST(suite_mean, each_records_stronger_component_falls_with_the_roof) {
  // a by its first (azimuth 0, 180), b by its second (90, 270).
  const StrongerAlong strong = stronger_along(by_hand(), {}, at_period(1), Periods::one);
  EXPECT_DOUBLE_EQ(strong.as_recorded, 1.0);  // a 2, b 0
  EXPECT_DOUBLE_EQ(strong.reversed, 6.0);     // a 4, b 8
  Results r = by_hand();
  r.cases.cases[3].orientation.ground_azimuth_deg = 22.5;
  EXPECT_TRUE(std::isnan(stronger_along(r, {}, {}, Periods::one).reversed));
}

TEST(suite_mean, a_slope_axis_that_was_not_run_has_no_orientations) {
  EXPECT_TRUE(orientations_of(by_hand(), {.slope_axis = SlopeAxis::n_s}).empty());
}

}  // namespace
}  // namespace glissade
