// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/normality.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glissade/core/random.hpp"

namespace glissade {
namespace {

// Royston (1995), the example of AS R94: W = 0.83467, p = 0.000914 (in single precision; in double
// it is 0.0009135).
TEST(shapiro_wilk, gives_the_published_example) {
  const ShapiroWilk s = shapiro_wilk({0.139, 0.157, 0.175, 0.256, 0.344, 0.413, 0.503, 0.577, 0.614,
                                      0.655, 0.954, 1.392, 1.557, 1.648, 1.690, 1.994, 2.174, 2.206,
                                      3.245, 3.510, 3.571, 4.354, 4.980, 6.084, 8.351});
  EXPECT_NEAR(s.w, 0.83467, 5e-6);
  EXPECT_NEAR(s.p_value, 0.000914, 1e-6);
}

// Shapiro & Wilk (1965), section 4, example 1: W = 0.79; digits as SciPy's documentation has them.
TEST(shapiro_wilk, refuses_the_weights_of_eleven_men) {
  const ShapiroWilk s = shapiro_wilk({148, 154, 158, 160, 161, 162, 166, 170, 182, 195, 236});
  EXPECT_NEAR(s.w, 0.7888146948, 1e-9);
  EXPECT_NEAR(s.p_value, 0.0067038141, 1e-9);
}

// SciPy's own tests of scipy.stats.shapiro.
TEST(shapiro_wilk, agrees_with_scipy_on_twenty_values) {
  const ShapiroWilk s = shapiro_wilk({0.11, 7.87, 4.61, 10.14, 7.95, 3.14, 0.46, 4.43, 0.21, 4.75,
                                      0.71, 1.52, 3.24, 0.93,  0.42, 4.97, 9.53, 4.55, 0.47, 6.66});
  EXPECT_NEAR(s.w, 0.900473, 1e-6);
  EXPECT_NEAR(s.p_value, 0.0420897, 1e-6);
}

// Reference values from SciPy, kept in a public test suite.
TEST(shapiro_wilk, agrees_with_scipy_on_five_values) {
  const ShapiroWilk s = shapiro_wilk({1.0, 1.5, 2.0, 2.5, 9.0});
  EXPECT_NEAR(s.w, 0.7135481348, 1e-9);
  EXPECT_NEAR(s.p_value, 0.0132012609, 1e-9);
}

// Three values: W = (x3 - x1)^2 / 2 over the sum of squares, p = 6/pi asin(sqrt W) - 2.
TEST(shapiro_wilk, of_three_values_is_the_closed_form) {
  const double w = 81.0 / 2.0 / (438.0 / 9.0);  // of 1, 2, 10
  const ShapiroWilk s = shapiro_wilk({10.0, 1.0, 2.0});
  EXPECT_NEAR(s.w, w, 1e-15);
  EXPECT_NEAR(s.p_value, 6.0 / std::numbers::pi * std::asin(std::sqrt(w)) - 2.0, 1e-14);
  EXPECT_NEAR(shapiro_wilk({1.0, 2.0, 3.0}).p_value, 1.0, 1e-7);  // asin is steep at W = 1
  EXPECT_NEAR(shapiro_wilk({1.0, 1.0, 3.0}).p_value, 0.0, 1e-14);
}

TEST(shapiro_wilk, does_not_depend_on_origin_scale_sign_or_order) {
  const std::vector<double> values{0.51, 0.47, 0.60, 0.55, 0.49, 0.53, 0.58};
  const ShapiroWilk s = shapiro_wilk(values);
  std::vector<double> moved;
  for (const double x : values) moved.insert(moved.begin(), 1e3 - 1e2 * x);
  EXPECT_NEAR(shapiro_wilk(moved).w, s.w, 1e-12);
  EXPECT_NEAR(shapiro_wilk(moved).p_value, s.p_value, 1e-10);
}

// What a p-value is: normal samples fall below 0.05 in 5 % of cases. 20,000 samples: the standard
// error is 0.15 %; 0.7 % is 4.5 of them, so a correct p-value passes with more than 99.999 %.
TEST(shapiro_wilk, refuses_one_normal_sample_in_twenty) {
  constexpr int samples = 20000;
  for (const std::size_t n : {3u, 4u, 5u, 6u, 8u, 11u, 12u, 20u, 50u}) {
    int refused = 0;
    for (int i = 0; i < samples; ++i) {
      std::vector<double> values;
      for (std::uint32_t j = 0; j < n; ++j)
        values.push_back(keyed_normal(n, RandomPurpose::test, static_cast<std::uint64_t>(i), j));
      if (shapiro_wilk(values).p_value < 0.05) ++refused;
    }
    EXPECT_NEAR(refused / static_cast<double>(samples), 0.05, 0.007) << n;
  }
}

}  // namespace
}  // namespace glissade
