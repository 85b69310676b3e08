// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/fragility/fit.hpp"
#include "worked_examples.hpp"

// Where not said otherwise the expected numbers are those of the project's worked examples:
// published inputs, results computed with two independent programs.

namespace glissade {
namespace {

using namespace worked_examples;

FitSummary independent(const std::vector<Stripe>& stripes) {
  return fit_stripes(stripes, Independent::rows);
}

TEST(fit_stripes, reproduces_baker_2015) {
  const FitSummary fit = independent(baker_2015());
  EXPECT_EQ(fit.status, FitStatus::extrapolated);  // 18 of 40 at the highest level
  EXPECT_NEAR(fit.curve.median, 1.076115794, 5e-10);
  EXPECT_NEAR(fit.curve.log_std, 0.4292372038, 5e-11);
  EXPECT_NEAR(fit.median_interval.low, 0.964246, 5e-7);
  EXPECT_NEAR(fit.median_interval.high, 1.306991, 5e-7);
  EXPECT_NEAR(fit.log_std_interval.low, 0.301758, 5e-7);
  EXPECT_NEAR(fit.log_std_interval.high, 0.650025, 5e-7);
}

TEST(log_likelihood, reproduces_baker_2015) {
  EXPECT_NEAR(log_likelihood(baker_2015(), {0.8, 0.5}), -39.433505974789, 5e-13);
}

TEST(fit_stripes, reproduces_mastodon) {
  const FitSummary fit = independent(mastodon());
  EXPECT_NEAR(fit.curve.median, 0.40021328, 5e-9);
  EXPECT_NEAR(fit.curve.log_std, 0.23842755, 5e-9);
  EXPECT_NEAR(log_likelihood(mastodon(), {0.4, 0.1}) / std::log(10), -502.18887815, 5e-9);
}

// The published fit is a probit in log10 dose: b0 + b1 log10 x = ln(x / median) / log_std.
TEST(fit_stripes, is_the_probit_of_bliss_beetles) {
  const FitSummary fit = independent(bliss_beetles());
  EXPECT_NEAR(-std::log(fit.curve.median) / fit.curve.log_std, -34.93525892, 5e-8);
  EXPECT_NEAR(std::log(10) / fit.curve.log_std, 19.72793422, 5e-8);
  double saturated = 0;  // log likelihood with each stripe's own share
  for (const Stripe& s : bliss_beetles()) {
    const double k = s.exceedances, n = s.trials;
    saturated += std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) +
                 k * std::log(k / n) + (k < n ? (n - k) * std::log1p(-k / n) : 0.0);
  }
  EXPECT_NEAR(2 * (saturated - fit.log_likelihood), 10.11975811, 5e-8);
}

TEST(fit_stripes_jeffreys, reproduces_baker_2015) {
  const FitSummary fit = fit_stripes_jeffreys(baker_2015(), Independent::rows);
  EXPECT_EQ(fit.status, FitStatus::jeffreys_penalised);
  EXPECT_NEAR(fit.curve.median, 1.086048945, 5e-10);
  EXPECT_NEAR(fit.curve.log_std, 0.4478973625, 5e-11);
}

TEST(fit_stripes, penalises_separated_stripes_and_says_so) {
  const FitSummary fit = independent(separated());
  EXPECT_EQ(fit.status, FitStatus::jeffreys_penalised);
  EXPECT_NE(fit.note, "");
  EXPECT_NEAR(fit.curve.median, 0.6928211161, 5e-11);
  EXPECT_NEAR(fit.curve.log_std, 0.06843924275, 5e-12);
  EXPECT_GT(fit.median_interval.low, 0.6);  // no trial lies between 0.6 and 0.8
  EXPECT_LT(fit.median_interval.high, 0.8);
  EXPECT_LT(fit.log_std_interval.low, fit.curve.log_std);
  EXPECT_GT(fit.log_std_interval.high, fit.curve.log_std);
}

TEST(fit_stripes, calls_one_mixed_stripe_between_sure_ones_separated) {
  EXPECT_EQ(independent({{0.5, 20, 0}, {1.0, 20, 7}, {2.0, 20, 20}}).status,
            FitStatus::jeffreys_penalised);
}

// With b1 = 1 / log_std and b0 = -ln(median) / log_std the likelihood equations are linear in the
// counts.
TEST(fit_stripes, does_not_change_when_all_counts_are_scaled_to_fractions) {
  std::vector<Stripe> tenths = baker_2015();
  for (Stripe& s : tenths) {
    s.trials /= 10;
    s.exceedances /= 10;
  }
  const FitSummary fit = independent(tenths), whole = independent(baker_2015());
  EXPECT_NEAR(fit.curve.median, whole.curve.median, 1e-11);
  EXPECT_NEAR(fit.curve.log_std, whole.curve.log_std, 1e-11);
  EXPECT_LT(fit.median_interval.low, whole.median_interval.low);
}

TEST(fit_stripes, follows_a_change_of_unit_of_the_intensity) {
  std::vector<Stripe> scaled = baker_2015();
  for (Stripe& s : scaled) s.intensity *= 9.80665;
  const FitSummary fit = independent(scaled), original = independent(baker_2015());
  EXPECT_NEAR(fit.curve.median / original.curve.median, 9.80665, 1e-10);
  EXPECT_NEAR(fit.curve.log_std, original.curve.log_std, 1e-11);
  EXPECT_NEAR(fit.log_likelihood, original.log_likelihood, 1e-10);
}

TEST(fit_stripes, finds_the_greatest_likelihood_of_its_neighbourhood) {
  const FitSummary fit = independent(baker_2015());
  for (double dm : {-0.01, 0.0, 0.01}) {
    for (double ds : {-0.01, 0.0, 0.01}) {
      EXPECT_LE(log_likelihood(baker_2015(), {fit.curve.median + dm, fit.curve.log_std + ds}),
                fit.log_likelihood + 1e-12);
    }
  }
}

// Closed form at one level x: Phi(-ln(x/theta)/0.4)^n = 0.05 gives theta = x exp(0.4
// Phi^-1(0.05^(1/n))).
TEST(fit_stripes, bounds_the_median_from_below_without_exceedance) {
  const FitSummary fit = independent({{0.5, 40, 0}});
  EXPECT_EQ(fit.status, FitStatus::lower_bound);
  EXPECT_FALSE(fit.converged());
  EXPECT_EQ(fit.curve.log_std, 0.4);
  const FragilityCurve unit{1.0, 1.0};
  EXPECT_NEAR(fit.curve.median, 0.5 * std::pow(unit.intensity_at(std::pow(0.05, 1 / 40.0)), 0.4),
              1e-12);
  EXPECT_EQ(fit.median_interval.low, fit.curve.median);
  EXPECT_TRUE(std::isinf(fit.median_interval.high));
  EXPECT_NEAR(fit.log_likelihood, std::log(0.05), 1e-12);
  EXPECT_NE(fit.note.find("0.4"), std::string::npos);
}

TEST(fit_stripes, gives_a_lower_bound_below_the_level_for_one_trial) {
  EXPECT_LT(independent({{0.5, 1, 0}}).curve.median, 0.5);
}

// By symmetry of the normal distribution, x -> 1/x turns "none exceeded" into "all exceeded".
TEST(fit_stripes, bounds_the_median_from_above_when_all_exceeded) {
  const FitSummary lower = independent({{0.5, 20, 0}, {0.8, 10, 0}});
  const FitSummary upper = independent({{1 / 0.8, 10, 10}, {1 / 0.5, 20, 20}});
  EXPECT_EQ(upper.status, FitStatus::upper_bound);
  EXPECT_NEAR(upper.curve.median, 1 / lower.curve.median, 1e-12);
  EXPECT_EQ(upper.median_interval.low, 0.0);
  EXPECT_EQ(upper.median_interval.high, upper.curve.median);
}

TEST(fit_stripes, has_no_curve_of_one_level) {
  const FitSummary fit = independent({{0.5, 10, 4}});
  EXPECT_EQ(fit.status, FitStatus::one_level);
  EXPECT_FALSE(fit.converged());
}

TEST(fit_stripes, fails_with_a_reason_where_no_curve_can_be_fitted) {
  const std::vector<std::vector<Stripe>> hopeless = {
      {},                          // nothing
      {{0.5, 0, 0}, {1.0, 0, 0}},  // no trials
  };
  for (const auto& stripes : hopeless) {
    const FitSummary fit = independent(stripes);
    EXPECT_EQ(fit.status, FitStatus::failed);
    EXPECT_NE(fit.note, "");
    EXPECT_TRUE(std::isnan(fit.median_interval.low));
  }
}

TEST(fit_stripes, has_no_curve_where_the_share_does_not_rise) {
  const std::vector<std::vector<Stripe>> without_trend = {
      {{0.5, 20, 10}, {1.0, 20, 10}, {2.0, 20, 10}},  // flat at one half
      {{0.2, 20, 7}, {0.4, 20, 7}, {0.8, 20, 7}},     // flat
      {{0.3, 10, 3}, {0.7, 30, 9}, {1.1, 20, 6}},     // flat, other numbers of trials
      {{0.5, 20, 10}, {1.0, 20, 3}, {2.0, 20, 10}},   // as much down as up
      {{0.5, 10, 10}, {1.0, 10, 5}, {2.0, 10, 0}},    // decreasing, separated
      {{0.5, 10, 6}, {1.0, 10, 5}, {2.0, 10, 4}},     // decreasing
      {{0.5, 1e6, 300000.0}, {1.0, 1e6, 300100.0}},   // median at 1e1000
  };
  for (const auto& stripes : without_trend) {
    for (const FitSummary& fit :
         {independent(stripes), fit_stripes_jeffreys(stripes, Independent::rows)}) {
      EXPECT_EQ(fit.status, FitStatus::no_trend);
      EXPECT_FALSE(fit.converged());
      EXPECT_TRUE(std::isnan(fit.curve.median));
      EXPECT_TRUE(std::isnan(fit.median_interval.low));
    }
  }
}

// One trial more at the highest level: the maximum exists, and is the curve through the shares.
TEST(fit_stripes, has_a_curve_where_the_share_rises_by_one_trial) {
  const FitSummary fit = independent({{0.5, 20, 10}, {2.0, 20, 11}});
  EXPECT_EQ(fit.status, FitStatus::maximum_likelihood);
  EXPECT_NEAR(fit.curve.probability(0.5), 10 / 20.0, 1e-9);
  EXPECT_NEAR(fit.curve.probability(2.0), 11 / 20.0, 1e-9);
}

// So little of a trend that a constant probability is not rejected: log_std has no upper limit.
TEST(fit_stripes, leaves_an_interval_open_that_the_data_do_not_close) {
  const FitSummary fit = independent({{0.5, 10, 4}, {1.0, 10, 5}, {2.0, 10, 6}});
  EXPECT_EQ(fit.status, FitStatus::maximum_likelihood);
  EXPECT_TRUE(std::isinf(fit.log_std_interval.high));
}

TEST(fit_stripes, names_every_count_out_of_range) {
  try {
    independent({{0.5, 10, 11}, {-1.0, 10, 1}, {1.0, 10, 5}});
    FAIL() << "no InputError";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u);
  }
}

}  // namespace
}  // namespace glissade
