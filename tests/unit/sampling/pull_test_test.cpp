// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/pull_test.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "facts.hpp"
#include "glissade/core/error.hpp"

namespace glissade {
namespace {

using test::states;

/// Stretches 2 mm to a breakaway of 0.7, slides at 0.5 and 0.54 in turn by 10 mm a sample to 0.3 m,
/// stops and is let go. Forces of a normal force of 1,000 N.
PullTest made_up_pull() {
  PullTest pull{"1", "along", "tests.csv:2", {}, {}, {}};
  const auto log = [&](double displacement_m, double mu) {
    pull.displacement_m.push_back(displacement_m);
    pull.force_n.push_back(1000.0 * mu);
    pull.normal_n.push_back(1000.0);
  };
  log(0.0, 0.0);
  log(0.001, 0.4);
  log(0.002, 0.7);
  log(0.005, 0.6);
  for (int i = 1; i <= 30; ++i) log(0.01 * i, i % 2 == 0 ? 0.5 : 0.54);
  log(0.3, 0.2);
  log(0.299, 0.0);
  return pull;
}

std::string refusal(const PullTest& pull, const SlidingRule& rule = {}) {
  try {
    friction_of(pull, rule);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(pull_test, breaks_away_at_the_largest_friction_up_to_the_first_slip) {
  EXPECT_DOUBLE_EQ(friction_of(made_up_pull(), {}).breakaway_mu, 0.7);
  PullTest late = made_up_pull();
  late.force_n[3] = 800.0;  // the first sample beyond 3 mm counts too
  EXPECT_DOUBLE_EQ(friction_of(late, {}).breakaway_mu, 0.8);
  late.force_n[4] = 900.0;  // what comes after does not
  EXPECT_DOUBLE_EQ(friction_of(late, {}).breakaway_mu, 0.8);
}

// Beyond 20 mm, so from 30 mm, to 300 mm: 14 samples of 0.54 and 14 of 0.5.
TEST(pull_test, slides_from_the_settling_distance_to_the_end_of_the_pull) {
  const TraceFriction f = friction_of(made_up_pull(), {});
  EXPECT_EQ(f.sliding_begin, 6u);
  EXPECT_EQ(f.sliding_end, 34u);
  EXPECT_NEAR(f.sliding_mu, 0.52, 1e-15);
  EXPECT_NEAR(f.sliding_std, 0.02 * std::sqrt(28.0 / 27.0), 1e-15);
  EXPECT_DOUBLE_EQ(f.min_mu, 0.5);
  EXPECT_DOUBLE_EQ(f.max_mu, 0.54);
  EXPECT_NEAR(f.travel_m, 0.27, 1e-15);
}

TEST(pull_test, is_the_same_from_another_zero_of_displacement_and_at_another_scale_of_force) {
  PullTest other = made_up_pull();
  for (double& x : other.displacement_m) x -= 0.125;
  for (double& x : other.force_n) x *= 4.0;
  for (double& x : other.normal_n) x *= 4.0;
  const SlidingRule rule{0.003, 0.025};  // between samples, so that no rounding moves one across
  const TraceFriction a = friction_of(made_up_pull(), rule), b = friction_of(other, rule);
  EXPECT_EQ(a.breakaway_mu, b.breakaway_mu);
  EXPECT_EQ(a.sliding_mu, b.sliding_mu);
  EXPECT_EQ(a.sliding_end, b.sliding_end);
}

// Logged ten times as densely over the samples of 0.54: the mean over samples leans to them, that
// over displacement does not.
TEST(pull_test, tells_the_mean_over_displacement_beside_that_over_samples) {
  PullTest pull{"1", "along", "", {0.0, 0.002}, {0.0, 600.0}, {1000.0, 1000.0}};
  const auto log = [&](double displacement_m, double force_n) {
    pull.displacement_m.push_back(displacement_m);
    pull.force_n.push_back(force_n);
    pull.normal_n.push_back(1000.0);
  };
  for (int i = 0; i <= 100; ++i) log(0.03 + 0.001 * i, 600.0);
  for (int i = 1; i <= 10; ++i) log(0.13 + 0.01 * i, 400.0);
  const TraceFriction f = friction_of(pull, {});
  EXPECT_NEAR(f.sliding_mu, (101 * 0.6 + 10 * 0.4) / 111, 1e-12);
  EXPECT_NEAR(f.mu_by_displacement, (0.1 * 0.6 + 0.01 * 0.5 + 0.09 * 0.4) / 0.2, 1e-12);
}

TEST(pull_test, uses_the_normal_force_of_each_sample) {
  PullTest pull = made_up_pull();
  for (std::size_t i = 0; i < pull.force_n.size(); ++i) {
    const double factor = 1.0 + 0.1 * static_cast<double>(i % 3);
    pull.force_n[i] *= factor;
    pull.normal_n[i] *= factor;
  }
  EXPECT_NEAR(friction_of(pull, {}).sliding_mu, 0.52, 1e-15);
}

TEST(pull_test, follows_another_rule) {
  const TraceFriction f = friction_of(made_up_pull(), {.slip_m = 0.015, .sliding_from_m = 0.1});
  EXPECT_EQ(f.sliding_begin, 14u);  // 0.11 m
  EXPECT_EQ(f.sliding_end, 33u);    // the first within 15 mm of 0.3 m is 0.29 m
  EXPECT_DOUBLE_EQ(f.breakaway_mu, 0.7);
}

TEST(pull_test, without_sliding_is_refused_at_its_place) {
  PullTest still = made_up_pull();
  for (double& x : still.displacement_m) x *= 0.05;
  EXPECT_THAT(refusal(still), states("tests.csv:2", "test 1 along", "no sliding", "0.015 m"));
  EXPECT_THAT(refusal(made_up_pull(), {0.003, 0.295}), states("no sliding"));
  PullTest one_sample{"1", "along", "tests.csv:2", {0.0}, {1.0}, {1.0}};
  EXPECT_THAT(refusal(one_sample), states("no sliding"));
}

TEST(pull_test, that_goes_backwards_is_refused) {
  PullTest back = made_up_pull();
  for (double& x : back.displacement_m) x = -x;
  EXPECT_THAT(refusal(back), states("0.3 m"));
}

TEST(pull_test, with_a_friction_that_cannot_be_is_refused) {
  PullTest pull = made_up_pull();
  for (double& x : pull.normal_n) x /= 1000.0;  // kN that were said to be N
  EXPECT_THAT(refusal(pull), states("700", "units"));
  PullTest pushed = made_up_pull();
  for (std::size_t i = 4; i < pushed.force_n.size(); ++i) pushed.force_n[i] *= -1.0;
  EXPECT_THAT(refusal(pushed), states("-0.52"));
}

TEST(sliding_rule, has_positive_displacements_in_order) {
  EXPECT_NO_THROW(validate(SlidingRule{}));
  EXPECT_NO_THROW(validate(SlidingRule{0.01, 0.01}));
  EXPECT_THROW(validate(SlidingRule{0.0, 0.01}), InputError);
  EXPECT_THROW(validate(SlidingRule{0.02, 0.01}), InputError);
  EXPECT_THROW(validate(SlidingRule{NAN, 0.01}), InputError);
  EXPECT_THROW(validate(SlidingRule{0.01, INFINITY}), InputError);
}

}  // namespace
}  // namespace glissade
