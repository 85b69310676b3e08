// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

const std::vector<Distribution> all = {Fixed{0.3},
                                       Normal{0.55, 0.04},
                                       TruncatedNormal{0.55, 0.04, 0.5, infinity},
                                       TruncatedNormal{0.0, 1.0, 8.0, 9.0},
                                       LogNormal{0.5, 0.4},
                                       Uniform{-1.0, 2.0},
                                       Triangular{0.2, 0.5, 2.0},
                                       Triangular{0.2, 0.2, 2.0},
                                       Discrete{{4.76, 1.19, 2.39}, {1.0, 2.0, 1.0}},
                                       Empirical{{3.0, 1.0, 2.0, 7.0}}};

// Phi^-1(0.975) = 1.959963984540054 (published to 16 digits in tables).
TEST(quantile, of_the_normal_family_is_that_of_its_standard_normal) {
  EXPECT_NEAR(quantile(Normal{0.55, 0.04}, 0.975), 0.55 + 0.04 * 1.959963984540054, 1e-15);
  EXPECT_NEAR(quantile(LogNormal{0.5, 0.4}, 0.025), 0.5 * std::exp(-0.4 * 1.959963984540054),
              1e-15);
  EXPECT_DOUBLE_EQ(quantile(TruncatedNormal{0.0, 1.0, -infinity, infinity}, 0.975),
                   1.959963984540054);
}

// Above a = 30 std the parent's survival is that of Mills' ratio R(z) = phi-relative tail, so the
// median z of the tail solves exp(-(z^2 - a^2)/2) R(z)/R(a) = 1/2, here with the asymptotic R(z) =
// 1/z - 1/z^3 + 3/z^5 - 15/z^7 (Abramowitz & Stegun 26.2.12; error below 3e-12 at 30).
TEST(quantile, of_the_truncated_normal_holds_far_in_both_tails) {
  const auto mills = [](double z) {
    return 1 / z - std::pow(z, -3) + 3 * std::pow(z, -5) - 15 * std::pow(z, -7);
  };
  const double z = quantile(TruncatedNormal{0.0, 1.0, 30.0, infinity}, 0.5);
  EXPECT_NEAR(std::exp(-0.5 * (z * z - 900)) * mills(z) / mills(30.0), 0.5, 1e-9);
  EXPECT_DOUBLE_EQ(quantile(TruncatedNormal{0.0, 1.0, -infinity, -30.0}, 0.5), -z);
}

TEST(quantile, of_the_truncated_normal_has_the_share_asked_for_below) {
  const auto phi = [](double z) { return 0.5 * std::erfc(-z / std::sqrt(2.0)); };
  const TruncatedNormal d{0.55, 0.1, 0.4, 0.8};
  for (double u : {1e-9, 0.1, 0.5, 0.9, 1 - 1e-9}) {
    const double z = (quantile(d, u) - 0.55) / 0.1;
    EXPECT_NEAR((phi(z) - phi(-1.5)) / (phi(2.5) - phi(-1.5)), u, 1e-14);
  }
}

TEST(quantile, of_the_triangle_is_the_root_of_its_area) {
  // Closed form: u = (x - min)^2 / ((max - min)(mode - min)) below the mode.
  EXPECT_NEAR(quantile(Triangular{0.0, 1.0, 2.0}, 0.125), 0.5, 1e-15);
  EXPECT_NEAR(quantile(Triangular{0.0, 1.0, 2.0}, 0.875), 1.5, 1e-15);
  EXPECT_NEAR(quantile(Triangular{0.0, 0.0, 1.0}, 0.75), 0.5, 1e-15);
}

TEST(quantile, of_discrete_values_is_by_increasing_value) {
  const Discrete d{{4.76, 1.19, 2.39}, {1.0, 2.0, 1.0}};
  EXPECT_EQ(quantile(d, 0.49), 1.19);
  EXPECT_EQ(quantile(d, 0.51), 2.39);
  EXPECT_EQ(quantile(d, 0.76), 4.76);
  EXPECT_EQ(quantile(d, 1 - 1e-16), 4.76);
}

// Hyndman & Fan (1996) type 7: position 1 + (n - 1) u among the order statistics.
TEST(quantile, of_observed_values_is_type_7) {
  const Empirical d{{3.0, 1.0, 2.0, 7.0}};
  EXPECT_DOUBLE_EQ(quantile(d, 0.5), 2.5);
  EXPECT_DOUBLE_EQ(quantile(d, 0.75), 4.0);
  EXPECT_DOUBLE_EQ(quantile(d, 1.0 / 3.0), 2.0);
}

TEST(quantile, never_falls_and_never_leaves_the_support) {
  for (const Distribution& d : all) {
    double last = -infinity;
    for (double u = 0.5 * 0x1p-32; u < 1; u += 1.0 / 1023) {
      const double x = quantile(d, u);
      EXPECT_GE(x, last);
      EXPECT_GE(x, support(d).min);
      EXPECT_LE(x, support(d).max);
      last = x;
    }
  }
}

// Moments against the midpoint rule on the quantile: its error for 2^16 points is below 1e-3 std in
// the long tails.
TEST(moments, are_those_of_the_values_that_quantile_gives) {
  constexpr int n = 65536;
  for (const Distribution& d : all) {
    double sum = 0, squares = 0;
    for (int i = 0; i < n; ++i) sum += quantile(d, (i + 0.5) / n) / n;
    for (int i = 0; i < n; ++i) squares += std::pow(quantile(d, (i + 0.5) / n) - sum, 2) / n;
    EXPECT_NEAR(mean(d), sum, 1e-3 * standard_deviation(d) + 1e-12) << d.index();
    EXPECT_NEAR(standard_deviation(d), std::sqrt(squares), 1e-3 * standard_deviation(d) + 1e-12)
        << d.index();
  }
}

// Closed forms: half normal, sqrt(2/pi) and sqrt(1 - 2/pi); a range too narrow to bend is uniform.
TEST(moments, of_the_truncated_normal_have_their_closed_forms) {
  const double pi = std::acos(-1.0);
  EXPECT_NEAR(mean(TruncatedNormal{0.0, 1.0, 0.0, infinity}), std::sqrt(2 / pi), 1e-12);
  EXPECT_NEAR(standard_deviation(TruncatedNormal{0.0, 1.0, 0.0, infinity}), std::sqrt(1 - 2 / pi),
              1e-12);
  EXPECT_NEAR(
      standard_deviation(TruncatedNormal{0.0, 1.0, 1.0, 1.0 + 1e-6}) / (1e-6 / std::sqrt(12.0)),
      1.0, 1e-6);
}

void expect_refused(const Distribution& distribution, const std::string& parameter,
                    std::size_t problems = 1) {
  try {
    validate(distribution);
    ADD_FAILURE() << "accepted a wrong " << parameter;
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), problems) << error.what();
    EXPECT_EQ(error.problems().front().where, "");
    EXPECT_NE(error.problems().front().what.find(parameter), std::string::npos) << error.what();
  }
}

TEST(validate, accepts_every_distribution_in_its_rules) {
  for (const Distribution& d : all) EXPECT_NO_THROW(validate(d));
}

TEST(validate, names_the_parameter_that_breaks_its_rule) {
  expect_refused(Fixed{std::nan("")}, "value");
  expect_refused(Normal{0.5, 0.0}, "std");
  expect_refused(Normal{infinity, -1.0}, "mean", 2);
  expect_refused(TruncatedNormal{0.0, 1.0, 2.0, 1.0}, "min");
  expect_refused(TruncatedNormal{0.0, 1.0, 50.0, infinity}, "min");
  expect_refused(LogNormal{-0.5, 0.4}, "median");
  expect_refused(LogNormal{0.5, 0.0}, "log_std");
  expect_refused(Uniform{1.0, 1.0}, "min");
  expect_refused(Triangular{0.0, 3.0, 2.0}, "mode");
  expect_refused(Discrete{{1.0, 2.0}, {1.0}}, "weights");
  expect_refused(Discrete{{1.0, 2.0}, {1.0, 0.0}}, "weights");
  expect_refused(Discrete{{}, {}}, "values");
  expect_refused(Empirical{{1.0}}, "values");
}

}  // namespace
}  // namespace glissade
