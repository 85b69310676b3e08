// SPDX-License-Identifier: GPL-3.0-or-later
// Required clearance, base shear and tipping of histories that can be followed by hand.
#include <gtest/gtest.h>

#include "unit/study/by_rule.hpp"

namespace glissade {
namespace {

/// Two records; two periods, each in two orientations; one level. By (record, period, orientation):
///   displacement   a  1 2  3 4    b  3 4  7 6
///   base shear     a  5 5  10 10  b  15 25  10 20    (by axes of 3 to 4)
///   tips           a  0 1  0 0    b  0 1  1 1
/// @param a_last_m the displacement of a at the second period in the second orientation
Results by_hand(double a_last_m = 4.0) {
  StudyConfig study;
  study.intensity.levels = {0.8};
  study.quantities.at("building", "period_s") = test::listed({0.2, 1.0});
  study.orientation = {OrientationChoice::as_recorded, {SlopeAxis::e_w, SlopeAxis::n_s}};
  const double displacement[2][4] = {{1, 2, 3, a_last_m}, {3, 4, 7, 6}},
               shear[2][4] = {{5, 5, 10, 10}, {15, 25, 10, 20}};
  Results r = test::results_by_rule(
      study, {{.id = "a"}, {.id = "b"}}, [&](const test::HistoryPlace& at) -> test::MadeUpHistory {
        const std::size_t i = (at.c.period_s == 1.0 ? 2 : 0) + at.orientation;
        return {displacement[at.record][i], 0.0, 0.6 * shear[at.record][i],
                0.8 * shear[at.record][i]};
      });
  r.histories.fields.tips = {0, 1, 0, 0, 0, 1, 1, 1};
  return r;
}

TEST(analyses, conditions_are_places_of_the_histories) {
  const Results r = by_hand();
  const ConditionGrid grid(r);
  ASSERT_EQ(grid.count(), 2u);
  EXPECT_EQ(grid.first_case(grid.position(1)), 2u);
  EXPECT_EQ(grid.history(1, 0, grid.position(1)).displacement_m(), 7.0);  // b, first, 1 s
  EXPECT_EQ(grid.history(0, 1, {}).mean(&HistoryFields::shear_along), 3.0);
}

TEST(analyses, a_required_clearance_is_a_factor_on_the_largest_mean_over_the_periods) {
  const ClearanceResults clearance = required_clearance(by_hand(), {.factor = 1.5});
  EXPECT_EQ(clearance.factor, 1.5);
  ASSERT_EQ(clearance.by_period.size(), 2u);
  const SuiteMean& first = clearance.by_period[0];
  EXPECT_EQ(first.by_orientation, (std::vector<double>{2.0, 3.0}));
  EXPECT_EQ(first.range.lowest, 2.0);
  EXPECT_EQ(first.range.median, 2.5);
  EXPECT_EQ(first.range.highest, 3.0);
  EXPECT_EQ(first.bounds.lowest, 2.0);   // a 1, b 3
  EXPECT_EQ(first.bounds.highest, 3.0);  // a 2, b 4
  EXPECT_EQ(first.largest, 4.0);
  EXPECT_EQ(first.at[ConditionAxis::period], 0u);
  ASSERT_EQ(clearance.required.size(), 1u);
  const RequiredClearance& required = clearance.required[0];
  EXPECT_EQ(required.largest.at[ConditionAxis::period], 1u);  // 5 in both orientations
  EXPECT_EQ(required.largest.bounds.lowest, 4.5);             // a 3, b 6
  EXPECT_EQ(required.largest.bounds.highest, 5.5);            // a 4, b 7
  EXPECT_EQ(required.median_m, 7.5);
  EXPECT_EQ(required.highest_m, 7.5);
}

TEST(analyses,
     the_recommended_clearance_is_of_the_largest_orientation_unless_the_median_is_stated) {
  const Results r = by_hand(8.0);  // a mean of 7 in the second orientation at 1 s
  const RequiredClearance usual = required_clearance(r, {.factor = 2.0}).required[0];
  EXPECT_EQ(usual.clearance_m, 14.0);
  EXPECT_EQ(usual.median_m, 12.0);
  const RequiredClearance median =
      required_clearance(r, {.factor = 2.0, .orientation = OrientationRule::median}).required[0];
  EXPECT_EQ(median.clearance_m, 12.0);
  EXPECT_EQ(median.highest_m, 14.0);
}

TEST(analyses, base_shear_is_the_mean_and_the_largest_of_the_records) {
  Results r = by_hand();
  const std::vector<SuiteMean> means = BaseShearAnalysis::find({}, r).means;
  ASSERT_EQ(means.size(), 2u);
  EXPECT_DOUBLE_EQ(means[0].range.lowest, 10.0);   // 5 and 15
  EXPECT_DOUBLE_EQ(means[0].range.highest, 15.0);  // 5 and 25
  EXPECT_DOUBLE_EQ(means[0].largest, 25.0);
  EXPECT_DOUBLE_EQ(means[1].range.median, 12.5);  // 10 and 15
  EXPECT_DOUBLE_EQ(means[1].largest, 20.0);
  EXPECT_EQ(means[1].at[ConditionAxis::period], 1u);
}

TEST(analyses, tipping_is_a_share_of_the_histories_and_of_each_record) {
  StudyConfig study;
  study.tipping = {0.5, 0.25};
  const TippingResults tipping = TippingAnalysis::find(study, by_hand());
  EXPECT_EQ(tipping.body.width_m, 0.25);
  EXPECT_EQ(tipping.least_friction, 0.25);
  ASSERT_EQ(tipping.shares.size(), 2u);
  EXPECT_EQ(tipping.shares[0].share, 0.5);
  EXPECT_EQ(tipping.shares[0].by_record, (std::vector<double>{0.5, 0.5}));
  EXPECT_EQ(tipping.shares[1].share, 0.5);
  EXPECT_EQ(tipping.shares[1].by_record, (std::vector<double>{0.0, 1.0}));
  EXPECT_EQ(tipping.shares[1].first_case, 2u);
  EXPECT_EQ(tipping.shares[1].condition, "building period 1 s");
  EXPECT_EQ(tipping.shares[1].level, 0.8);
}

}  // namespace
}  // namespace glissade
