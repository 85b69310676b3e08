// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/scaling_rule.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/response_spectrum.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Made-up motions, each another sweep of frequencies along each axis.
Suite sweeps(int count) {
  Suite suite;
  suite.name = "sweeps";
  for (int m = 0; m < count; ++m) {
    Motion motion;
    motion.id = "m" + std::to_string(m);
    motion.dt_s = 0.01;
    std::vector<double> axes[2];
    for (int axis = 0; axis < 2; ++axis)
      for (int i = 0; i < 1200; ++i) {
        const double t = 0.01 * i;
        axes[axis].push_back((1.0 + 0.2 * m) * std::sin(std::numbers::pi * t / 12.0) *
                             std::sin((2.0 + 0.3 * m) * t + (0.8 + 0.1 * axis) * t * t + m));
      }
    motion.horizontal_mps2 = {axes[0], axes[1]};
    suite.motions.push_back(std::move(motion));
  }
  return suite;
}

double target_g(double period_s) { return 0.4 / (0.5 + period_s); }

/// The average spectrum over the target at a period, in the plainest way: SRSS of two spectra, or
/// the largest of 720 directions.
double plain_ratio(const Suite& suite, const std::vector<double>& factors, double period_s,
                   bool is_srss) {
  double sum = 0.0;
  for (std::size_t m = 0; m < suite.motions.size(); ++m) {
    const auto& [a, b] = suite.motions[m].horizontal_mps2;
    const std::vector<double> period{period_s};
    const auto sa = [&](double c, double s) {
      std::vector<double> turned;
      for (std::size_t i = 0; i < a.size(); ++i) turned.push_back(c * a[i] + s * b[i]);
      return pseudo_acceleration_spectrum(0.01, turned, period)[0];
    };
    double largest = is_srss ? std::hypot(sa(1, 0), sa(0, 1)) : 0.0;
    for (int k = 0; k < 720 && !is_srss; ++k) {
      const double angle = std::numbers::pi * k / 720.0;
      largest = std::max(largest, sa(std::cos(angle), std::sin(angle)));
    }
    sum += factors[m] * largest;
  }
  return sum / static_cast<double>(suite.motions.size()) / standard_gravity_mps2 /
         target_g(period_s);
}

TEST(scaling_rule, of_asce_7_10_brings_the_average_srss_to_the_target_from_02_to_15_periods) {
  const Suite suite = sweeps(7);
  const RuleScaling s = scale_by_rule(suite, ScalingRule::asce7_10, {0.5, 0.8}, target_g, 1000.0);
  EXPECT_DOUBLE_EQ(s.range.from_s, 0.1);
  EXPECT_DOUBLE_EQ(s.range.to_s, 1.2);
  EXPECT_NEAR(s.lowest.ratio, 1.0, 1e-12);
  EXPECT_NEAR(plain_ratio(suite, s.factors, s.lowest.period_s, true), 1.0, 1e-9);
  for (const double period_s : {0.1, 0.17, 0.4, 0.9, 1.2})
    EXPECT_GE(plain_ratio(suite, s.factors, period_s, true), 1.0 - 1e-3) << period_s;
  EXPECT_THAT(s.warnings, IsEmpty());
}

TEST(scaling_rule, of_asce_7_16_averages_the_largest_direction_over_02_to_2_periods) {
  const Suite suite = sweeps(11);
  const RuleScaling s = scale_by_rule(suite, ScalingRule::asce7_16, {0.5, 0.6}, target_g, 1000.0);
  EXPECT_DOUBLE_EQ(s.range.from_s, 0.1);
  EXPECT_DOUBLE_EQ(s.range.to_s, 1.2);
  EXPECT_GE(s.lowest.ratio, 0.9 - 1e-12);
  EXPECT_GE(s.mean_ratio, 1.0 - 1e-9);
  EXPECT_TRUE(s.lowest.ratio < 0.9 + 1e-9 || s.mean_ratio < 1.0 + 1e-9);  // the least factor
  EXPECT_NEAR(plain_ratio(suite, s.factors, s.lowest.period_s, false) / s.lowest.ratio, 1.0, 1e-4);
  EXPECT_THAT(s.warnings, IsEmpty());
  const RuleScaling justified =
      scale_by_rule(suite, ScalingRule::asce7_22, {0.5, 0.6, true}, target_g, 1000.0);
  EXPECT_DOUBLE_EQ(justified.range.to_s, 0.9);
}

TEST(scaling_rule, of_one_period_gives_every_motion_the_target) {
  const Suite suite = sweeps(3);
  const RuleScaling s =
      scale_by_rule(suite, ScalingRule::single_period, {0.7, 0.7}, target_g, 1000.0);
  for (std::size_t m = 0; m < 3; ++m)
    EXPECT_NEAR(
        s.factors[m] * spectrum_by_rule_g(suite.motions[m], ScalingRule::single_period, {0.7})[0],
        target_g(0.7), 1e-12);
}

TEST(scaling_rule, of_walters_is_that_of_scale_suite_to_target) {
  const Suite suite = sweeps(4);
  const RuleScaling s = scale_by_rule(suite, ScalingRule::walters_2012, {}, target_g, 1000.0);
  EXPECT_EQ(s.factors, scale_suite_to_target(suite, target_g, walters_periods_s(), 1000.0).factors);
  EXPECT_NEAR(s.lowest.ratio, 1.0, 1e-12);
}

TEST(scaling_rule, too_few_motions_are_warned_of_with_the_clause) {
  const auto warnings = [](ScalingRule rule, int motions) {
    return scale_by_rule(sweeps(motions), rule, {0.5, 0.5}, target_g, 1e4).warnings;
  };
  EXPECT_THAT(warnings(ScalingRule::asce7_16, 2), ElementsAre(HasSubstr("16.2.2")));
  EXPECT_THAT(warnings(ScalingRule::asce7_22, 2), ElementsAre(HasSubstr("ASCE 7-22")));
  EXPECT_THAT(warnings(ScalingRule::asce7_10, 2), ElementsAre(HasSubstr("3 at least")));
  EXPECT_THAT(warnings(ScalingRule::asce7_10, 6), ElementsAre(HasSubstr("largest response")));
}

TEST(scaling_rule, what_cannot_be_is_refused) {
  const auto refused = [](ScalingRule rule, FirstPeriods building, double most) {
    try {
      scale_by_rule(sweeps(2), rule, building, target_g, most);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refused(ScalingRule::asce7_10, {}, 4.0), HasSubstr("first periods"));
  EXPECT_THAT(refused(ScalingRule::asce7_16, {0.8, 0.5}, 4.0), HasSubstr("shorter first"));
  EXPECT_THAT(refused(ScalingRule::asce7_16, {0.5, 0.5}, 1e-3), HasSubstr("of the target"));
  EXPECT_THAT(refused(ScalingRule::single_period, {0.5, 0.5}, 1e-3), HasSubstr("m0"));
  EXPECT_THROW(parse_scaling_rule("asce7_05"), InputError);
  EXPECT_EQ(parse_scaling_rule("asce7_22"), ScalingRule::asce7_22);
}

}  // namespace
}  // namespace glissade
