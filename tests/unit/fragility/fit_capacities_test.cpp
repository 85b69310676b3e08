// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "glissade/core/error.hpp"
#include "glissade/core/random.hpp"
#include "glissade/fragility/bootstrap.hpp"
#include "glissade/fragility/fit.hpp"

namespace glissade {
namespace {

CapacitySample lognormal_sample(int n, double log_std, double censored_at, std::uint64_t seed) {
  CapacitySample sample{{}, 0.0, censored_at};
  for (int i = 0; i < n; ++i) {
    const double x = std::exp(log_std * keyed_normal(seed, RandomPurpose::test, i, 0));
    if (x <= censored_at)
      sample.capacities.push_back(x);
    else
      sample.censored += 1;
  }
  return sample;
}

// By hand: ln x = -1, 0, 1 has mean 0 and standard deviation 1 with n - 1; t(2; 0.975)
// = 4.302652730 and chi-square(2; p) = -2 ln(1 - p) in closed form.
TEST(fit_capacities, is_the_mean_and_deviation_of_logarithms) {
  const FitSummary fit = fit_capacities({{std::exp(-1.0), 1.0, std::exp(1.0)}, 0.0});
  EXPECT_EQ(fit.status, FitStatus::maximum_likelihood);
  EXPECT_NEAR(fit.curve.median, 1.0, 1e-15);
  EXPECT_NEAR(fit.curve.log_std, 1.0, 1e-15);
  EXPECT_NEAR(std::log(fit.median_interval.high), 4.302652730 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(std::log(fit.median_interval.low), -4.302652730 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(fit.log_std_interval.low, 1 / std::sqrt(-std::log(0.025)), 1e-12);
  EXPECT_NEAR(fit.log_std_interval.high, 1 / std::sqrt(-std::log(0.975)), 1e-12);
}

// By hand: ln density of a lognormal at its median, x = 2, log_std 0.5: -ln(2) - ln(0.5) - ln(2
// pi)/2; a history censored at the median adds ln(1/2).
TEST(capacity_log_likelihood, is_that_of_the_lognormal_density_and_tail) {
  const double density = -0.5 * std::log(2 * std::acos(-1.0));
  EXPECT_NEAR(capacity_log_likelihood({{2.0}, 0.0}, {2.0, 0.5}), density, 1e-15);
  EXPECT_NEAR(capacity_log_likelihood({{2.0}, 3.0, 2.0}, {2.0, 0.5}), density - 3 * std::log(2.0),
              1e-14);
}

TEST(fit_capacities, finds_the_greatest_censored_likelihood_of_its_neighbourhood) {
  const CapacitySample sample = lognormal_sample(40, 0.4, 1.1, 3);
  ASSERT_GT(sample.censored, 5);
  const FitSummary fit = fit_capacities(sample);
  EXPECT_EQ(fit.interval_method, "profile likelihood");
  for (double dm : {-1e-3, 0.0, 1e-3}) {
    for (double ds : {-1e-3, 0.0, 1e-3}) {
      EXPECT_LE(capacity_log_likelihood(sample, {fit.curve.median + dm, fit.curve.log_std + ds}),
                fit.log_likelihood + 1e-12);
    }
  }
  // Profile interval: at its ends the likelihood, greatest over log_std on a grid, is lower by half
  // of n ln(1 + t^2 / (n - 1)), t = 2.022690912 with 39 degrees of freedom.
  const double allowed = 40 * std::log1p(std::pow(2.022690912, 2) / 39);
  for (double median : {fit.median_interval.low, fit.median_interval.high}) {
    double greatest = -1e300;
    for (double s = 0.1; s < 1.5; s += 1e-4)
      greatest = std::max(greatest, capacity_log_likelihood(sample, {median, s}));
    EXPECT_NEAR(fit.log_likelihood - greatest, allowed / 2, 1e-5);
  }
}

// 4,000 capacities of median 1 and log_std 0.4, a third of them censored: standard error of ln
// median below 0.4 / sqrt(2600), limits at 4 of these. Filling censored histories in with the last
// intensity would put the median at exp(-0.06).
TEST(fit_capacities, is_not_biased_by_censoring) {
  const CapacitySample sample = lognormal_sample(4000, 0.4, std::exp(0.4 * 0.43), 5);
  EXPECT_NEAR(sample.censored / 4000, 1 - 0.6664, 0.03);
  const FitSummary fit = fit_capacities(sample);
  EXPECT_NEAR(std::log(fit.curve.median), 0.0, 4 * 0.4 / std::sqrt(2600.0));
  EXPECT_NEAR(std::log(fit.curve.log_std / 0.4), 0.0, 4 / std::sqrt(2600.0));
}

TEST(fit_capacities, comes_to_the_complete_sample_as_censoring_vanishes) {
  CapacitySample sample = lognormal_sample(30, 0.4, 1e3, 7);
  const double complete =
      fit_capacities(sample).curve.log_std * std::sqrt(29.0 / 30.0);  // n, not n - 1
  sample.censored = 1e-12;
  EXPECT_NEAR(fit_capacities(sample).curve.log_std, complete, 1e-9);
}

TEST(fit_capacities, bounds_the_median_where_no_history_reached_the_threshold) {
  const FitSummary fit = fit_capacities({{}, 40, 0.5});
  const FitSummary stripes = fit_stripes({{0.5, 40, 0}});
  EXPECT_EQ(fit.status, FitStatus::lower_bound);
  EXPECT_EQ(fit.curve.median, stripes.curve.median);
}

TEST(fit_capacities, fails_with_a_reason_where_no_curve_can_be_fitted) {
  const FitSummary none = fit_capacities({}), one = fit_capacities({{0.7, 0.7}, 2.0, 0.7});
  EXPECT_EQ(none.status, FitStatus::failed);
  EXPECT_EQ(one.status, FitStatus::one_level);
  for (const FitSummary& fit : {none, one}) EXPECT_NE(fit.note, "");
}

// Two of five have capacity 0. Clopper-Pearson of 2 in 5 at 95 %: 0.05274495 to 0.85336720 (closed
// form: beta quantiles (2, 4) and (3, 3), here from the binomial sums that define them).
// No spread is known, but the median is: all that there is to fit.
TEST(fit_capacities, of_one_capacity_have_it_as_their_median_and_no_log_std) {
  for (const FitSummary& fit : {fit_capacities({{0.7}}), fit_capacities({{0.7, 0.7}}),
                                fit_capacities_by_record({{{0.7}}}, 2.0)}) {
    EXPECT_EQ(fit.status, FitStatus::one_capacity);
    EXPECT_FALSE(fit.converged());
    EXPECT_NEAR(fit.curve.median, 0.7, 1e-15);
    EXPECT_EQ(fit.curve.intensity_at(0.5), fit.curve.median);
    EXPECT_TRUE(std::isnan(fit.curve.log_std));
    EXPECT_FALSE(fit.note.empty());
  }
}

TEST(fit_capacities, has_the_share_that_slides_freely_as_its_floor) {
  const FitSummary fit =
      fit_capacities({{0.5, 1.0, 2.0}, 0.0, std::numeric_limits<double>::infinity(), 2.0});
  const FitSummary rest = fit_capacities({{0.5, 1.0, 2.0}});
  EXPECT_EQ(fit.status, FitStatus::maximum_likelihood);
  EXPECT_DOUBLE_EQ(fit.curve.floor, 0.4);
  EXPECT_EQ(fit.curve.median, rest.curve.median);
  EXPECT_EQ(fit.curve.log_std, rest.curve.log_std);
  const auto at_least_two = [](double p) {
    return 1 - std::pow(1 - p, 5) - 5 * p * std::pow(1 - p, 4);
  };
  const auto at_most_two = [](double p) {
    const double q = 1 - p;
    return std::pow(q, 5) + 5 * p * std::pow(q, 4) + 10 * p * p * std::pow(q, 3);
  };
  EXPECT_NEAR(at_least_two(fit.floor_interval.low), 0.025, 1e-12);
  EXPECT_NEAR(at_most_two(fit.floor_interval.high), 0.025, 1e-12);
  EXPECT_GT(fit.curve.probability(0.1), 0.4);
}

TEST(fit_capacities, always_exceeds_where_every_history_slides_freely) {
  const FitSummary fit = fit_capacities({{}, 0.0, std::numeric_limits<double>::infinity(), 7.0});
  EXPECT_EQ(fit.status, FitStatus::always_exceeds);
  EXPECT_FALSE(fit.converged());
  EXPECT_EQ(fit.curve.floor, 1.0);
  EXPECT_EQ(fit.curve.probability(0.01), 1.0);
}

TEST(fit_capacities, keeps_the_floor_where_the_others_never_reach_it) {
  const FitSummary fit = fit_capacities({{}, 30.0, 0.5, 10.0});
  EXPECT_EQ(fit.status, FitStatus::lower_bound);
  EXPECT_DOUBLE_EQ(fit.curve.floor, 0.25);
  EXPECT_EQ(fit.curve.median, fit_capacities({{}, 30.0, 0.5}).curve.median);
}

TEST(fit_capacities, refuses_capacities_that_contradict_the_censoring) {
  EXPECT_THROW(fit_capacities({{0.5, 1.2}, 1.0, 1.0}), InputError);
  EXPECT_THROW(fit_capacities({{0.5, -1.2}, 0.0}), InputError);
  EXPECT_THROW(fit_capacities({{0.5, 0.6}, 1.0}), InputError);  // censored, but where?
  EXPECT_THROW(fit_capacities({{0.5}, 0.0, 1.0, -1.0}), InputError);
}

}  // namespace
}  // namespace glissade
