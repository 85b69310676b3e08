// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/normal.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "glissade/core/distributions.hpp"

namespace glissade {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// From mpmath (ncdf, 40 digits).
TEST(normal_cdf, keeps_its_digits_in_both_tails) {
  EXPECT_NEAR(normal_cdf(1.0), 0.8413447460685429, 2e-16);
  EXPECT_NEAR(normal_cdf(-1.96) / 0.02499789514822043, 1.0, 1e-15);
  EXPECT_NEAR(normal_cdf(-10.0) / 7.61985302416052607e-24, 1.0, 1e-14);
  EXPECT_NEAR(normal_cdf(-37.0) / 5.72557122252457682e-300, 1.0, 1e-13);
  for (double z = -37.0; z <= 8.0; z += 0.5)
    EXPECT_NEAR(normal_cdf(z) / (0.5 * std::erfc(-z / std::sqrt(2.0))), 1.0, 1e-13) << z;
}

TEST(normal_quantile, undoes_the_distribution_far_into_the_lower_tail) {
  EXPECT_EQ(normal_quantile(0.5), 0.0);
  EXPECT_NEAR(normal_quantile(0.975), 1.959963984540054, 1e-15);
  for (double z = -37.0; z <= 5.0; z += 0.5)
    EXPECT_NEAR(normal_quantile(normal_cdf(z)), z, 1e-13 * (1 + std::abs(z)) + 1e-9 * (z > 4)) << z;
}

TEST(normal, takes_what_is_infinite_and_hands_nan_on) {
  EXPECT_EQ(normal_cdf(-infinity), 0.0);
  EXPECT_EQ(normal_cdf(infinity), 1.0);
  EXPECT_EQ(normal_quantile(0.0), -infinity);
  EXPECT_EQ(normal_quantile(1.0), infinity);
  EXPECT_TRUE(std::isnan(normal_cdf(std::nan(""))));
  EXPECT_TRUE(std::isnan(normal_quantile(std::nan(""))));
}

// 10 degrees of freedom (t: its closed form); 3 successes of 20 (sums of binomial terms).
TEST(distributions, agree_with_closed_forms) {
  EXPECT_NEAR(student_quantile(10, 0.975), 2.2281388519862744, 1e-13);
  EXPECT_NEAR(student_upper_tail(10, 2.2281388519862744), 0.025, 1e-14);
  EXPECT_NEAR(chi_squared_quantile(10, 0.95), 18.307038053275146, 1e-12);
  EXPECT_NEAR(binomial_lower_end(20, 3, 0.025), 0.0320709, 1e-6);
  EXPECT_NEAR(binomial_upper_end(20, 3, 0.025), 0.3789268, 1e-6);
}

}  // namespace
}  // namespace glissade
