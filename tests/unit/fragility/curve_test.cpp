// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/curve.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace glissade {
namespace {

// Closed form: half of the trials exceed at the median; Phi(1) = 0.8413447460685429 (Abramowitz &
// Stegun table 26.1).
TEST(fragility_curve, is_a_half_at_the_median_and_phi_of_one_a_log_std_above) {
  const FragilityCurve curve{0.5, 0.4};
  EXPECT_DOUBLE_EQ(curve.probability(0.5), 0.5);
  EXPECT_NEAR(curve.probability(0.5 * std::exp(0.4)), 0.8413447460685429, 1e-15);
}

TEST(fragility_curve, is_zero_without_shaking) {
  EXPECT_EQ((FragilityCurve{0.5, 0.4}.probability(0.0)), 0.0);
  EXPECT_EQ((FragilityCurve{0.5, 0.4}.probability(-1.0)), 0.0);
}

TEST(fragility_curve, inverse_undoes_the_probability) {
  const FragilityCurve curve{0.7, 0.3};
  for (double p : {1e-12, 1e-3, 0.2, 0.5, 0.9, 0.999}) {
    EXPECT_NEAR(curve.probability(curve.intensity_at(p)) / p, 1.0, 1e-12) << p;
  }
}

TEST(fragility_curve, contains_its_floor_at_every_intensity) {
  const FragilityCurve curve{0.5, 0.4, 0.125}, rest{0.5, 0.4};
  EXPECT_EQ(curve.probability(0.0), 0.125);
  EXPECT_NEAR(curve.probability(0.5), 0.125 + 0.875 * 0.5, 1e-15);
  for (double x : {1e-3, 0.1, 0.4, 2.0, 1e3})
    EXPECT_NEAR(curve.probability(x), 0.125 + 0.875 * rest.probability(x), 1e-15) << x;
}

TEST(fragility_curve, inverse_undoes_the_probability_above_the_floor_and_is_zero_up_to_it) {
  const FragilityCurve curve{0.7, 0.3, 0.2};
  for (double p : {0.2 + 1e-9, 0.25, 0.5, 0.9, 0.999})
    EXPECT_NEAR(curve.probability(curve.intensity_at(p)), p, 1e-15) << p;
  EXPECT_EQ(curve.intensity_at(0.2), 0.0);
  EXPECT_EQ(curve.intensity_at(0.1), 0.0);
}

TEST(fragility_curve, is_one_everywhere_where_all_slide_freely) {
  FragilityCurve curve;
  curve.floor = 1.0;
  EXPECT_EQ(curve.probability(0.0), 1.0);
  EXPECT_EQ(curve.probability(3.0), 1.0);
  EXPECT_EQ(curve.intensity_at(0.99), 0.0);
}

// Mills' ratio expansion, Phi(-x) = phi(x)/x (1 - 1/x^2 + 3/x^4 - 15/x^6 + ...) (Abramowitz &
// Stegun 26.2.12): at x = 40 the first neglected term is below 3e-11, at 1e4 the first term alone
// is good to 1e-8 of 5e7.
TEST(log_normal_cdf, follows_the_asymptotic_expansion_in_the_lower_tail) {
  const auto expansion = [](double x) {
    return -0.5 * x * x - std::log(x * std::sqrt(2 * std::acos(-1.0))) +
           std::log1p(-1 / (x * x) + 3 / std::pow(x, 4) - 15 / std::pow(x, 6));
  };
  for (double x : {40.0, 100.0, 1e4})
    EXPECT_NEAR(log_normal_cdf(-x) / expansion(x), 1.0, 1e-13) << x;
}

// In the upper tail ln Phi(z) = -Phi(-z) to first order.
TEST(log_normal_cdf, keeps_relative_accuracy_in_the_upper_tail) {
  for (double z : {6.0, 10.0, 30.0}) {
    EXPECT_NEAR(log_normal_cdf(z) / -std::exp(log_normal_cdf(-z)), 1.0, 2e-9) << z;
  }
}

TEST(log_normal_cdf, agrees_with_the_error_function_between) {
  for (double z = -8; z <= 5; z += 0.37) {
    EXPECT_NEAR(log_normal_cdf(z) / std::log(0.5 * std::erfc(-z / std::sqrt(2.0))), 1.0, 1e-9) << z;
  }
}

}  // namespace
}  // namespace glissade
