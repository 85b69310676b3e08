// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/goodness_of_fit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"
#include "glissade/core/random.hpp"

namespace glissade {
namespace {

constexpr int goodness_samples = 16;

/// ln capacity = a(record) + e(record, sample); above `limit` censored.
struct Spread {
  double between = 0.35, within = 0.20;
  int samples = goodness_samples;
};
std::vector<Bracket> lognormal_records(std::size_t records, std::uint64_t seed,
                                       double limit = infinity, Spread spread = {}) {
  std::vector<Bracket> rows;
  for (std::size_t i = 0; i < records; ++i) {
    const double a = spread.between * keyed_normal(seed, RandomPurpose::test, i, 0);
    for (int s = 1; s <= spread.samples; ++s) {
      const double c = std::exp(a + spread.within * keyed_normal(seed, RandomPurpose::test, i, s));
      rows.push_back({std::min(c, limit), c < limit ? c : infinity, 1.0, i});
    }
  }
  return rows;
}

double rejected_share(std::size_t records, double limit, Spread spread = {}) {
  constexpr int studies = 200;
  int rejected = 0;
  for (int study = 0; study < studies; ++study) {
    const std::uint64_t seed = 1000u + static_cast<std::uint64_t>(study);
    const GoodnessOfFit fit =
        lognormal_goodness_of_fit(lognormal_records(records, seed, limit, spread), {.seed = seed});
    if (fit.p_value < goodness_of_fit_level) ++rejected;
  }
  return rejected / static_cast<double>(studies);
}

// Of 200 studies 5 % are 10, with a standard deviation of 1.5 %: 0.5 to 9.5 % in all but 3 of
// 1,000.
TEST(goodness_of_fit, refuses_a_lognormal_as_often_as_its_level_says) {
  EXPECT_NEAR(rejected_share(7, infinity), 0.05, 0.045);
  EXPECT_NEAR(rejected_share(20, infinity), 0.05, 0.045);
  EXPECT_NEAR(rejected_share(20, 1.0), 0.05, 0.045);
}

// With the 64 of a stratified sample in place of them: 100, 77 and 13 %.
TEST(goodness_of_fit, refuses_as_often_with_100_independent_samples_of_each_record) {
  for (const double correlation : {0.0, 0.2, 0.5}) {
    const Spread spread{0.4 * std::sqrt(correlation), 0.4 * std::sqrt(1 - correlation), 100};
    EXPECT_NEAR(rejected_share(7, infinity, spread), 0.05, 0.045) << correlation;
  }
}

// 14 events, of which 8 have two records, as the far-field set of FEMA P-695: half of the variance
// between records is of the event, or none.
TEST(goodness_of_fit, refuses_as_often_with_records_of_events) {
  constexpr int studies = 200;
  std::vector<std::size_t> unit_of;
  for (std::size_t event = 0; event < 14; ++event)
    unit_of.insert(unit_of.end(), event < 8 ? 2 : 1, event);
  for (const double part : {0.0, 0.5}) {
    int rejected = 0;
    for (std::uint64_t seed = 3000; seed < 3000 + studies; ++seed) {
      const double between = 0.35 * std::sqrt(1 - part);
      std::vector<Bracket> rows =
          lognormal_records(unit_of.size(), seed, infinity, {.between = between});
      for (Bracket& row : rows)
        row.high = row.low *=
            std::exp(0.35 * std::sqrt(part) *
                     keyed_normal(seed, RandomPurpose::test, unit_of[row.record], 100));
      const GoodnessOfFit fit = lognormal_goodness_of_fit(rows, {.seed = seed}, false, unit_of);
      rejected += fit.p_value < goodness_of_fit_level;
    }
    EXPECT_NEAR(rejected / static_cast<double>(studies), 0.05, 0.045) << part;
  }
}

TEST(goodness_of_fit, is_the_distance_of_cramer_and_von_mises) {
  // For a complete sample: 1 / (12 n^2) + mean of (u_i - (2 i - 1) / (2 n))^2.
  std::vector<double> y;
  const std::vector<Bracket> rows = lognormal_records(5, 3);
  for (const Bracket& row : rows) y.push_back(std::log(row.low));
  std::ranges::sort(y);
  const double n = static_cast<double>(y.size());
  double mean = 0, squares = 0, sum = 1 / (12 * n * n);
  for (const double value : y) mean += value / n;
  for (const double value : y) squares += (value - mean) * (value - mean) / (n - 1);
  for (std::size_t i = 0; i < y.size(); ++i) {
    const double u = normal_cdf((y[i] - mean) / std::sqrt(squares));
    sum += std::pow(u - (2.0 * static_cast<double>(i) + 1.0) / (2 * n), 2) / n;
  }
  EXPECT_NEAR(lognormal_goodness_of_fit(rows, {}).distance, sum, 1e-14);
}

TEST(goodness_of_fit, finds_the_correlation_within_records) {
  // 0.35^2 / (0.35^2 + 0.20^2) = 0.754, whose estimate has a deviation of 0.02 with 400 records.
  EXPECT_NEAR(lognormal_goodness_of_fit(lognormal_records(400, 5), {}).correlation, 0.754, 0.06);
  EXPECT_NEAR(lognormal_goodness_of_fit(lognormal_records(400, 5, 1.0), {}).correlation, 0.754,
              0.08);
}

// Half of the samples need little shaking in every record, as where some arrays begin to slide at
// once.
TEST(goodness_of_fit, refuses_two_kinds_of_capacities) {
  std::vector<Bracket> rows = lognormal_records(20, 7);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const double factor = i % goodness_samples < goodness_samples / 2 ? 0.1 : 1.0;
    rows[i].low = rows[i].high = factor * rows[i].low;
  }
  const GoodnessOfFit fit = lognormal_goodness_of_fit(rows, {});
  EXPECT_EQ(fit.p_value, least_p_value);
  // Between the two kinds the share is 0.5, of 0.5 + 0.5 at most.
  EXPECT_GT(std::abs(fit.largest_gap), 0.1);
  EXPECT_LT(std::abs(fit.largest_gap), 0.5);
}

TEST(goodness_of_fit, has_no_test_of_two_records_or_without_a_fit) {
  EXPECT_TRUE(std::isnan(lognormal_goodness_of_fit(lognormal_records(2, 1), {}).p_value));
  std::vector<Bracket> none;
  for (std::size_t i = 0; i < 20; ++i) none.push_back({2.0, infinity, 1.0, i / 4});
  EXPECT_TRUE(std::isnan(lognormal_goodness_of_fit(none, {}).p_value));
  EXPECT_TRUE(std::isnan(lognormal_goodness_of_fit({}, {}).p_value));
}

}  // namespace
}  // namespace glissade
