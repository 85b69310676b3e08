// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/standards/code_values.hpp"

#include <gtest/gtest.h>

namespace glissade {
namespace {

// A permit calculation of 2023: C_t 0.02, x 0.75, 35 ft: T_a 0.288 s.
TEST(approximate_period_s, is_that_of_a_published_calculation) {
  EXPECT_NEAR(approximate_period_s(structural_systems.back(), 35 * 0.3048), 0.288, 5e-4);
}

// By hand: 0.028 x 100^0.8 = 1.1147.
TEST(approximate_period_s, of_a_steel_moment_frame_of_100_ft) {
  EXPECT_NEAR(approximate_period_s(structural_systems.front(), 30.48), 1.1147, 1e-4);
}

TEST(seismic_design_category, is_the_more_severe_of_both_accelerations) {
  using enum SeismicDesignCategory;
  const auto of = [](double sds, double sd1, double s1, RiskCategory risk) {
    return seismic_design_category(sds, sd1, s1, risk);
  };
  EXPECT_EQ(of(1.05, 0.574, 0.471, RiskCategory::ii), d);
  EXPECT_EQ(of(0.10, 0.05, 0.03, RiskCategory::ii), a);
  EXPECT_EQ(of(0.10, 0.10, 0.05, RiskCategory::ii), b);
  EXPECT_EQ(of(0.10, 0.10, 0.05, RiskCategory::iv), c);
  EXPECT_EQ(of(0.40, 0.05, 0.05, RiskCategory::ii), c);
  EXPECT_EQ(of(0.33, 0.05, 0.05, RiskCategory::ii), c);  // limits belong to the row above
  EXPECT_EQ(of(1.50, 0.90, 0.75, RiskCategory::iii), e);
  EXPECT_EQ(of(1.50, 0.90, 0.75, RiskCategory::iv), f);
}

TEST(importance_factor, rises_with_the_risk_category) {
  EXPECT_EQ(importance_factor(RiskCategory::i), 1.0);
  EXPECT_EQ(importance_factor(RiskCategory::ii), 1.0);
  EXPECT_EQ(importance_factor(RiskCategory::iii), 1.25);
  EXPECT_EQ(importance_factor(RiskCategory::iv), 1.5);
}

}  // namespace
}  // namespace glissade
