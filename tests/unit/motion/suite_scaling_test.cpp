// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/suite_scaling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/error.hpp"
#include "glissade/core/random.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"

namespace glissade {
namespace {

/// Noise under an envelope, of a strength and a random character of its own.
Motion made_up_motion(std::uint64_t number, double strength_mps2) {
  Motion motion;
  motion.id = "made-up " + std::to_string(number);
  motion.dt_s = 0.01;
  for (std::uint32_t axis = 0; axis < 2; ++axis) {
    std::vector<double> samples;
    for (std::size_t n = 0; n < 400; ++n) {
      const double envelope =
          strength_mps2 * std::sin(std::numbers::pi * static_cast<double>(n) / 400.0);
      samples.push_back(envelope * keyed_normal(number, RandomPurpose::test, n, axis));
    }
    motion.horizontal_mps2[axis] = samples;
  }
  return motion;
}

Suite made_up_suite() {
  Suite suite;
  suite.name = "made-up";
  suite.motions = {made_up_motion(1, 1.0), made_up_motion(2, 0.5), made_up_motion(3, 2.0)};
  return suite;
}

double target_sa_g(double period_s) {
  return DesignSpectrum{.sds_g = 1.0, .sd1_g = 0.6, .tl_s = 8.0}.sa_g(period_s);
}

/// Average over the suite of factor x SRSS spectrum, over the target, at each period.
std::vector<double> average_over_target(const Suite& suite, const std::vector<double>& factors,
                                        const std::vector<double>& periods_s) {
  std::vector<double> ratios(periods_s.size(), 0.0);
  for (std::size_t j = 0; j < suite.motions.size(); ++j) {
    const std::vector<double> spectrum =
        horizontal_spectrum_mps2(suite.motions[j], periods_s, HorizontalCombination::srss);
    for (std::size_t i = 0; i < periods_s.size(); ++i) {
      ratios[i] += factors[j] * spectrum[i] / standard_gravity_mps2 / target_sa_g(periods_s[i]) /
                   static_cast<double>(suite.motions.size());
    }
  }
  return ratios;
}

// The least of a fine grid round the period found is no lower, and the grid of the rule is above
// it.
TEST(ratios_to_target, are_extremes_between_the_periods_of_the_rule_too) {
  const Suite suite = made_up_suite();
  const std::vector<double> factors{1.0, 2.0, 0.5};
  const SpectralRatios found = ratios_to_target(suite, factors, target_sa_g);
  const std::vector<double> rule = average_over_target(suite, factors, walters_periods_s());
  EXPECT_LT(found.lowest.ratio, std::ranges::min(rule));
  EXPECT_GE(found.highest.ratio, std::ranges::max(rule));
  const auto around = [&](double period_s) {
    std::vector<double> periods_s;
    for (int i = -200; i <= 200; ++i) periods_s.push_back(std::max(period_s + 5e-6 * i, 0.0));
    return average_over_target(suite, factors, periods_s);
  };
  EXPECT_GE(std::ranges::min(around(found.lowest.period_s)), found.lowest.ratio * (1 - 1e-6));
  EXPECT_LE(std::ranges::max(around(found.highest.period_s)), found.highest.ratio * (1 + 1e-6));
  EXPECT_DOUBLE_EQ(average_over_target(suite, factors, {found.lowest.period_s})[0],
                   found.lowest.ratio);
}

TEST(walters_periods, run_from_zero_to_two_seconds_and_rise) {
  const std::vector<double> periods_s = walters_periods_s();
  EXPECT_EQ(periods_s.front(), 0.0);
  EXPECT_EQ(periods_s.back(), 2.0);
  EXPECT_TRUE(std::ranges::is_sorted(periods_s, std::ranges::less_equal{}));
  for (int i = 1; i <= 40; ++i)
    EXPECT_THAT(periods_s, testing::Contains(testing::DoubleEq(i / 20.0)));
}

TEST(suite_average_factor, lifts_the_average_to_the_target_and_no_further) {
  Suite suite = made_up_suite();
  suite.motions[1].scale = 2.5;
  const double factor = suite_average_factor(suite, target_sa_g, walters_periods_s());
  const std::vector<double> ratios =
      average_over_target(suite, {factor, 2.5 * factor, factor}, walters_periods_s());
  EXPECT_NEAR(std::ranges::min(ratios), 1.0, 1e-13);
}

// Amplitude goes, shape stays: FEMA P-695's factors are the median PGV over each record's own.
TEST(normalise_by_pgv, gives_every_motion_the_median_velocity_of_the_suite) {
  Suite suite = made_up_suite();
  suite.motions[1].scale = 2.5;
  const auto pgv_mps = [](const Motion& motion) {
    return motion.scale * horizontal_pgv_mps(motion, HorizontalCombination::geometric_mean);
  };
  std::vector<double> before_mps;
  for (const Motion& motion : suite.motions) before_mps.push_back(pgv_mps(motion));
  ASSERT_GT(std::ranges::max(before_mps), 1.01 * std::ranges::min(before_mps));
  std::ranges::sort(before_mps);
  ASSERT_EQ(before_mps.size(), 3u);
  normalise_by_pgv(suite);
  for (const Motion& motion : suite.motions)
    EXPECT_NEAR(pgv_mps(motion) / before_mps[1], 1.0, 1e-14);
  const double scale = suite.motions[0].scale;
  normalise_by_pgv(suite);
  EXPECT_NEAR(suite.motions[0].scale / scale, 1.0, 1e-14);
  suite.motions[2].horizontal_mps2 = {std::vector<double>(10), std::vector<double>(10)};
  EXPECT_THROW(normalise_by_pgv(suite), InputError);
}

TEST(suite_average_factor, at_period_zero_compares_the_srss_of_the_peaks) {
  Suite suite;
  suite.motions.resize(1);
  suite.motions[0].dt_s = 0.01;
  suite.motions[0].horizontal_mps2 = {{{0.0, 3.0}, {0.0, -4.0}}};
  const double factor = suite_average_factor(
      suite, [](double) { return 1.0; }, std::vector<double>{0.0});
  EXPECT_NEAR(factor, standard_gravity_mps2 / 5.0, 1e-15);
}

TEST(scale_suite_to_target, brings_the_average_to_touch_the_target_and_nowhere_below) {
  const Suite suite = made_up_suite();
  const std::vector<double> periods_s = walters_periods_s();
  const SuiteScaling scaling = scale_suite_to_target(suite, target_sa_g, periods_s, 1e3);
  const std::vector<double> ratios = average_over_target(suite, scaling.factors, periods_s);
  const auto lowest = std::ranges::min_element(ratios);
  EXPECT_NEAR(*lowest, 1.0, 1e-13);
  EXPECT_EQ(periods_s[lowest - ratios.begin()], scaling.controlling_period_s);
  EXPECT_EQ(scaling.largest_factor, std::ranges::max(scaling.factors));
}

TEST(scale_suite_to_target, brings_each_motion_equally_close_to_the_target) {
  // Least squares in ln Sa: without a binding limit the mean of ln(factor x Sa / target) is one
  // number for all.
  const Suite suite = made_up_suite();
  const std::vector<double> periods_s = walters_periods_s();
  const SuiteScaling scaling = scale_suite_to_target(suite, target_sa_g, periods_s, 1e3);
  std::vector<double> mean_logs;
  for (std::size_t j = 0; j < suite.motions.size(); ++j) {
    const std::vector<double> ratios = average_over_target(
        {"", "", {suite.motions[j]}, std::nullopt}, {scaling.factors[j]}, periods_s);
    double sum = 0.0;
    for (const double ratio : ratios) sum += std::log(ratio);
    mean_logs.push_back(sum / static_cast<double>(ratios.size()));
  }
  EXPECT_NEAR(mean_logs[0], mean_logs[1], 1e-13);
  EXPECT_NEAR(mean_logs[0], mean_logs[2], 1e-13);
}

TEST(scale_suite_to_target, does_not_look_at_the_scale_a_motion_has) {
  Suite suite = made_up_suite();
  const SuiteScaling before = scale_suite_to_target(suite, target_sa_g, walters_periods_s(), 1e3);
  suite.motions[0].scale = 7.0;
  EXPECT_EQ(scale_suite_to_target(suite, target_sa_g, walters_periods_s(), 1e3).factors,
            before.factors);
}

TEST(scale_suite_to_target, holds_motions_at_the_limit_and_lets_the_others_make_up_for_it) {
  const Suite suite = made_up_suite();
  const std::vector<double> periods_s = walters_periods_s();
  const SuiteScaling free = scale_suite_to_target(suite, target_sa_g, periods_s, 1e3);
  const double limit = 0.8 * free.largest_factor;  // that of the weak second motion
  const SuiteScaling limited = scale_suite_to_target(suite, target_sa_g, periods_s, limit);
  EXPECT_EQ(limited.factors[1], limit);
  EXPECT_EQ(limited.largest_factor, limit);
  EXPECT_GT(limited.factors[0], free.factors[0]);
  EXPECT_GT(limited.factors[2], free.factors[2]);
  EXPECT_NEAR(limited.factors[0] / limited.factors[2], free.factors[0] / free.factors[2], 1e-13);
  EXPECT_NEAR(std::ranges::min(average_over_target(suite, limited.factors, periods_s)), 1.0, 1e-13);
}

TEST(scale_suite_to_target, reaches_the_target_with_all_motions_but_one_at_the_limit) {
  // All three at the limit just suffice where the limit is suite_average_factor's: a hair more
  // leaves the strongest free.
  const Suite suite = made_up_suite();
  const std::vector<double> periods_s = walters_periods_s();
  const double limit = 1.001 * suite_average_factor(suite, target_sa_g, periods_s);
  const SuiteScaling scaling = scale_suite_to_target(suite, target_sa_g, periods_s, limit);
  EXPECT_EQ(scaling.factors[0], limit);
  EXPECT_EQ(scaling.factors[1], limit);
  EXPECT_LT(scaling.factors[2], limit);
  EXPECT_NEAR(std::ranges::min(average_over_target(suite, scaling.factors, periods_s)), 1.0, 1e-13);
}

TEST(scale_suite_to_target,
     beyond_what_the_limit_allows_is_an_input_error_that_names_the_least_limit) {
  const Suite suite = made_up_suite();
  const double least = suite_average_factor(suite, target_sa_g, walters_periods_s());
  EXPECT_NO_THROW(
      scale_suite_to_target(suite, target_sa_g, walters_periods_s(), (1.0 + 1e-9) * least));
  try {
    scale_suite_to_target(suite, target_sa_g, walters_periods_s(), 0.8 * least);
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    const std::string text = error.problems().front().suggestion;
    EXPECT_NEAR(std::stod(text.substr(text.find_first_of("0123456789"))) / least, 1.0, 1e-3)
        << text;
  }
}

TEST(suite_scaling, refuses_empty_suites_silent_motions_and_limits_that_are_not_positive) {
  EXPECT_THROW(suite_average_factor({}, target_sa_g, walters_periods_s()), InputError);
  Suite suite = made_up_suite();
  EXPECT_THROW(scale_suite_to_target(suite, target_sa_g, walters_periods_s(), 0.0), InputError);
  for (Samples& component : suite.motions[2].horizontal_mps2)
    component = std::vector<double>(component.size(), 0.0);
  EXPECT_THROW(suite_average_factor(suite, target_sa_g, walters_periods_s()), InputError);
}

}  // namespace
}  // namespace glissade
