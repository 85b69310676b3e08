// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/friction_statistics.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "facts.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/random.hpp"

namespace glissade {
namespace {

using test::states;
using testing::Contains;

/// Slides at a constant mu over 0.3 m.
PullTest even_pull(const std::string& test, const std::string& direction, double mu) {
  PullTest pull{test, direction, "tests.csv:" + test, {0.0, 0.002}, {0.0, 1100.0 * mu}, {1e3, 1e3}};
  for (int i = 1; i <= 30; ++i) {
    pull.displacement_m.push_back(0.01 * i);
    pull.force_n.push_back(1000.0 * mu);
    pull.normal_n.push_back(1000.0);
  }
  return pull;
}

// 0.5, 0.55, 0.6: mean 0.55, std 0.05 (n - 1).
TEST(friction_over_tests, has_mean_deviation_and_design_value) {
  const MuStatistics s = statistics_of({0.5, 0.55, 0.6});
  EXPECT_EQ(s.tests, 3u);
  EXPECT_NEAR(s.mean, 0.55, 1e-15);
  EXPECT_NEAR(s.std, 0.05, 1e-15);
  EXPECT_NEAR(s.mean_minus_2_std, 0.45, 1e-15);
  EXPECT_LT(s.lower_bound_95, s.mean_minus_2_std);
  ASSERT_TRUE(s.normality);
  EXPECT_NEAR(s.normality->w, 1.0, 1e-12);
}

TEST(friction_over_tests, of_one_test_has_no_deviation) {
  const MuStatistics s = statistics_of({0.5});
  EXPECT_EQ(s.mean, 0.5);
  EXPECT_TRUE(std::isnan(s.std) && std::isnan(s.mean_minus_2_std) && std::isnan(s.lower_bound_95));
  EXPECT_FALSE(s.normality);
}

TEST(friction_over_tests, is_not_judged_for_normality_from_two_or_from_equal_ones) {
  EXPECT_FALSE(statistics_of({0.5, 0.6}).normality);
  const MuStatistics equal = statistics_of({0.1, 0.1, 0.1});
  EXPECT_FALSE(equal.normality);
  EXPECT_EQ(equal.std, 0.0);
  EXPECT_EQ(equal.mean_minus_2_std, 0.1);
}

TEST(friction_over_tests, is_not_below_zero) {
  const MuStatistics s = statistics_of({0.1, 0.9});
  EXPECT_EQ(s.mean_minus_2_std, 0.0);
  EXPECT_EQ(s.lower_bound_95, 0.0);
}

// The bound's promise: in 95 % of test programmes it lies below the friction that 97.7 % of pulls
// have, mean - 2 std of the population, and mean - 2 std of the tests in far fewer. 20,000
// programmes of five: the standard error is 0.15 %, the tolerance 4.5 of them.
TEST(friction_over_tests, has_a_bound_that_holds_in_95_of_100_programmes) {
  constexpr int programmes = 20000;
  const double truth = 0.55 - 2.0 * 0.02;
  int bounds_met = 0, met_by_two_std = 0;
  for (int i = 0; i < programmes; ++i) {
    std::vector<double> mu;
    for (std::uint32_t j = 0; j < 5; ++j)
      mu.push_back(0.55 +
                   0.02 * keyed_normal(1, RandomPurpose::test, static_cast<std::uint64_t>(i), j));
    const MuStatistics s = statistics_of(mu);
    if (s.lower_bound_95 <= truth) ++bounds_met;
    if (s.mean_minus_2_std <= truth) ++met_by_two_std;
  }
  EXPECT_NEAR(bounds_met / static_cast<double>(programmes), 0.95, 0.007);
  EXPECT_LT(met_by_two_std / static_cast<double>(programmes), 0.6);
}

TEST(pull_tests, are_gathered_by_direction_in_order_of_appearance) {
  const PullTestSummary s = summarise(
      {even_pull("1", "north", 0.5), even_pull("2", "east", 0.7), even_pull("3", "north", 0.6)},
      {});
  ASSERT_EQ(s.directions.size(), 2u);
  EXPECT_EQ(s.directions[0].direction, "north");
  EXPECT_EQ(s.directions[0].sliding.tests, 2u);
  EXPECT_NEAR(s.directions[0].sliding.mean, 0.55, 1e-15);
  EXPECT_NEAR(s.directions[0].breakaway.mean, 0.605, 1e-15);
  EXPECT_EQ(s.directions[1].sliding.tests, 1u);
}

TEST(pull_tests, say_how_little_few_of_them_tell) {
  const PullTestSummary s =
      summarise({even_pull("1", "a", 0.5), even_pull("2", "a", 0.52), even_pull("3", "a", 0.55),
                 even_pull("4", "b", 0.5), even_pull("5", "c", 0.5), even_pull("6", "c", 0.6)},
                {});
  EXPECT_THAT(s.notes, Contains(states("a", "3 tests", "95 %")));
  EXPECT_THAT(s.notes, Contains(testing::StartsWith("b: one test")));
  EXPECT_THAT(s.notes, Contains(testing::StartsWith("c: ")));
}

TEST(pull_tests, say_where_friction_is_not_normal) {
  std::vector<PullTest> tests;
  for (const double mu : {0.50, 0.505, 0.51, 0.515, 0.52, 0.525, 0.53, 0.9})
    tests.push_back(even_pull(std::to_string(tests.size()), "a", mu));
  EXPECT_THAT(summarise(tests, {}).notes, Contains(states("does not look normal")));
}

TEST(pull_tests, say_where_a_trace_is_odd) {
  PullTest stretching = even_pull("1", "a", 0.5), uneven = even_pull("2", "a", 0.5);
  stretching.force_n[1] = stretching.force_n[2] = 300.0;  // the true breakaway comes later
  for (std::size_t i = 0; i < 100; ++i) {                 // it halts at 0.15 m and is let go
    const auto at = static_cast<std::ptrdiff_t>(17);
    uneven.displacement_m.insert(uneven.displacement_m.begin() + at, 0.15);
    uneven.force_n.insert(uneven.force_n.begin() + at, 100.0);
    uneven.normal_n.insert(uneven.normal_n.begin() + at, 1000.0);
  }
  const PullTestSummary s = summarise({stretching, uneven}, {});
  EXPECT_THAT(s.notes, Contains(states("test 1 a", "0.300", "slip_m")));
  EXPECT_THAT(s.notes, Contains(states("test 2 a", "uneven")));
}

TEST(pull_tests, tell_the_problems_of_all_together) {
  PullTest first = even_pull("1", "a", 0.5), second = even_pull("2", "a", 0.5);
  for (double& x : first.displacement_m) x *= 0.01;
  for (double& x : second.displacement_m) x *= -1.0;
  try {
    summarise({first, second, even_pull("3", "a", 0.5)}, {});
    FAIL();
  } catch (const InputError& error) {
    ASSERT_EQ(error.problems().size(), 2u);
    EXPECT_EQ(error.problems()[0].where, "tests.csv:1");
    EXPECT_EQ(error.problems()[1].where, "tests.csv:2");
  }
}

}  // namespace
}  // namespace glissade
