// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "glissade/core/finite.hpp"
#include "glissade/core/random.hpp"
#include "glissade/fragility/fit.hpp"

namespace glissade {
namespace {

/// Exact capacities, and histories that are not reached by the last of them.
std::vector<Bracket> sample(const std::vector<double>& capacities, int not_reached = 0,
                            double limit = 0.0) {
  std::vector<Bracket> rows;
  for (const double c : capacities) rows.push_back({c, c});
  rows.insert(rows.end(), static_cast<std::size_t>(not_reached), {limit, infinity});
  return rows;
}

FitSummary fit(const std::vector<Bracket>& rows) { return fit_brackets(rows, Independent::rows); }

std::vector<Bracket> lognormal_sample(int n, double log_std, double censored_at,
                                      std::uint64_t seed) {
  std::vector<Bracket> rows;
  for (int i = 0; i < n; ++i) {
    const double x = std::exp(log_std * keyed_normal(seed, RandomPurpose::test, i, 0));
    rows.push_back({std::min(x, censored_at), x <= censored_at ? x : infinity});
  }
  return rows;
}

// By hand: ln x = -1, 0, 1 has mean 0 and standard deviation 1 with n - 1; t(2; 0.975)
// = 4.302652730 and chi-square(2; p) = -2 ln(1 - p) in closed form.
TEST(fit_capacities, is_the_mean_and_deviation_of_logarithms) {
  const FitSummary of = fit(sample({std::exp(-1.0), 1.0, std::exp(1.0)}));
  EXPECT_EQ(of.status, FitStatus::maximum_likelihood);
  EXPECT_NEAR(of.curve.median, 1.0, 1e-15);
  EXPECT_NEAR(of.curve.log_std, 1.0, 1e-15);
  EXPECT_NEAR(std::log(of.median_interval.high), 4.302652730 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(std::log(of.median_interval.low), -4.302652730 / std::sqrt(3.0), 1e-9);
  EXPECT_NEAR(of.log_std_interval.low, 1 / std::sqrt(-std::log(0.025)), 1e-12);
  EXPECT_NEAR(of.log_std_interval.high, 1 / std::sqrt(-std::log(0.975)), 1e-12);
}

// By hand: ln density of a lognormal at its median, x = 2, log_std 0.5: -ln(2) - ln(0.5) - ln(2
// pi)/2; a history censored at the median adds ln(1/2).
TEST(log_likelihood, is_that_of_the_lognormal_density_and_tail) {
  const double density = -0.5 * std::log(2 * std::acos(-1.0));
  EXPECT_NEAR(log_likelihood(sample({2.0}), {2.0, 0.5}), density, 1e-15);
  EXPECT_NEAR(log_likelihood(sample({2.0}, 3, 2.0), {2.0, 0.5}), density - 3 * std::log(2.0),
              1e-14);
}

TEST(fit_capacities, finds_the_greatest_censored_likelihood_of_its_neighbourhood) {
  const std::vector<Bracket> rows = lognormal_sample(40, 0.4, 1.1, 3);
  ASSERT_GT(std::ranges::count(rows, infinity, &Bracket::high), 5);
  const FitSummary of = fit(rows);
  EXPECT_EQ(of.interval_method, "profile likelihood");
  for (double dm : {-1e-3, 0.0, 1e-3}) {
    for (double ds : {-1e-3, 0.0, 1e-3}) {
      EXPECT_LE(log_likelihood(rows, {of.curve.median + dm, of.curve.log_std + ds}),
                of.log_likelihood + 1e-12);
    }
  }
  // Profile interval: at its ends the likelihood, greatest over log_std on a grid, is lower by half
  // of n ln(1 + t^2 / (n - 1)), t = 2.022690912 with 39 degrees of freedom.
  const double allowed = 40 * std::log1p(std::pow(2.022690912, 2) / 39);
  for (double median : {of.median_interval.low, of.median_interval.high}) {
    double greatest = -1e300;
    for (double s = 0.1; s < 1.5; s += 1e-4)
      greatest = std::max(greatest, log_likelihood(rows, {median, s}));
    EXPECT_NEAR(of.log_likelihood - greatest, allowed / 2, 1e-5);
  }
}

// 4,000 capacities of median 1 and log_std 0.4, a third of them censored: standard error of ln
// median below 0.4 / sqrt(2600), limits at 4 of these. Filling censored histories in with the last
// intensity would put the median at exp(-0.06).
TEST(fit_capacities, is_not_biased_by_censoring) {
  const std::vector<Bracket> rows = lognormal_sample(4000, 0.4, std::exp(0.4 * 0.43), 5);
  EXPECT_NEAR(static_cast<double>(std::ranges::count(rows, infinity, &Bracket::high)) / 4000,
              1 - 0.6664, 0.03);
  const FitSummary of = fit(rows);
  EXPECT_NEAR(std::log(of.curve.median), 0.0, 4 * 0.4 / std::sqrt(2600.0));
  EXPECT_NEAR(std::log(of.curve.log_std / 0.4), 0.0, 4 / std::sqrt(2600.0));
}

TEST(fit_capacities, comes_to_the_complete_sample_as_censoring_vanishes) {
  std::vector<Bracket> rows = lognormal_sample(30, 0.4, infinity, 7);
  const double complete = fit(rows).curve.log_std * std::sqrt(29.0 / 30.0);  // n, not n - 1
  rows.push_back({1e3, infinity, 1e-12});
  EXPECT_NEAR(fit(rows).curve.log_std, complete, 1e-9);
}

TEST(fit_capacities, bounds_the_median_where_no_history_reached_the_threshold) {
  const FitSummary of = fit(sample({}, 40, 0.5));
  const FitSummary stripes = fit_stripes({{0.5, 40, 0}}, Independent::rows);
  EXPECT_EQ(of.status, FitStatus::lower_bound);
  EXPECT_EQ(of.curve.median, stripes.curve.median);
}

TEST(fit_capacities, fails_with_a_reason_where_no_curve_can_be_fitted) {
  const FitSummary none = fit({}), one = fit(sample({0.7, 0.7}, 2, 0.7));
  EXPECT_EQ(none.status, FitStatus::failed);
  EXPECT_EQ(one.status, FitStatus::one_level);
  for (const FitSummary& of : {none, one}) EXPECT_NE(of.note, "");
}

// No spread is known, but the median is: all that there is to fit.
TEST(fit_capacities, of_one_capacity_have_it_as_their_median_and_no_log_std) {
  for (const FitSummary& of : {fit(sample({0.7})), fit(sample({0.7, 0.7})),
                               fit_brackets(sample({0.7}), Independent::records)}) {
    EXPECT_EQ(of.status, FitStatus::one_capacity);
    EXPECT_FALSE(of.converged());
    EXPECT_NEAR(of.curve.median, 0.7, 1e-15);
    EXPECT_EQ(of.curve.intensity_at(0.5), of.curve.median);
    EXPECT_TRUE(std::isnan(of.curve.log_std));
    EXPECT_FALSE(of.note.empty());
  }
}

// Two of five have capacity 0. Clopper-Pearson of 2 in 5 at 95 %: 0.05274495 to 0.85336720 (closed
// form: beta quantiles (2, 4) and (3, 3), here from the binomial sums that define them).
TEST(fit_capacities, has_the_share_that_slides_freely_as_its_floor) {
  const FitSummary of = fit(sample({0.5, 1.0, 2.0, 0.0, 0.0}));
  const FitSummary rest = fit(sample({0.5, 1.0, 2.0}));
  EXPECT_EQ(of.status, FitStatus::maximum_likelihood);
  EXPECT_DOUBLE_EQ(of.curve.floor, 0.4);
  EXPECT_EQ(of.curve.median, rest.curve.median);
  EXPECT_EQ(of.curve.log_std, rest.curve.log_std);
  const auto at_least_two = [](double p) {
    return 1 - std::pow(1 - p, 5) - 5 * p * std::pow(1 - p, 4);
  };
  const auto at_most_two = [](double p) {
    const double q = 1 - p;
    return std::pow(q, 5) + 5 * p * std::pow(q, 4) + 10 * p * p * std::pow(q, 3);
  };
  EXPECT_NEAR(at_least_two(of.floor_interval.low), 0.025, 1e-12);
  EXPECT_NEAR(at_most_two(of.floor_interval.high), 0.025, 1e-12);
  EXPECT_GT(of.curve.probability(0.1), 0.4);
}

}  // namespace
}  // namespace glissade
