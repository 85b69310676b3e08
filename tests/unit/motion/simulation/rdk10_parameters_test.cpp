// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/rdk10_parameters.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glissade/motion/simulation/rdk10_process.hpp"

namespace glissade {
namespace {

TEST(rdk10_parameters, stay_within_their_published_bounds) {
  for (const double score : {-6.0, -3.0, 0.0, 3.0, 6.0}) {
    const Rdk10Parameters p = rdk10_parameters({score, score, score, score, score, score});
    EXPECT_GE(p.significant_duration_s, 5.0);
    EXPECT_LE(p.significant_duration_s, 45.0);
    EXPECT_GE(p.middle_time_s, 0.5);
    EXPECT_LE(p.middle_time_s, 40.0);
    EXPECT_GE(p.frequency_slope_hzps, -2.0 - 1e-9);
    EXPECT_LE(p.frequency_slope_hzps, 0.5 + 1e-9);
    EXPECT_GE(p.damping_ratio, 0.02);
    EXPECT_LT(p.damping_ratio, 1.0);
  }
}

// P(f' < 0) = (c/b)(1 - exp(-2b)) = 0.71627 with b and c of Rezaeian & Der Kiureghian (2010): the
// score of zero slope is 0.5718.
TEST(rdk10_parameters, give_zero_slope_at_the_probability_of_negative_slopes) {
  EXPECT_NEAR(rdk10_parameters({0, 0, 0, 0, 0.5718, 0}).frequency_slope_hzps, 0.0, 1e-4);
}

// tau and sigma of the Arias score: .2738, .5937.
TEST(rdk10_parameters, have_the_total_deviation_of_both_residuals) {
  EXPECT_NEAR(rdk10_score_deviations()[0], std::sqrt(.2738 * .2738 + .5937 * .5937), 1e-12);
}

TEST(rdk10_parameters, correlate_symmetrically) {
  const auto c = rdk10_score_correlation();
  for (std::size_t i = 0; i < 6; ++i) {
    EXPECT_EQ(c[i][i], 1.0);
    for (std::size_t j = 0; j < 6; ++j) EXPECT_EQ(c[i][j], c[j][i]);
  }
}

}  // namespace
}  // namespace glissade
