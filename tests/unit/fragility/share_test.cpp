// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/share.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glissade/core/normal.hpp"
#include "glissade/core/random.hpp"

namespace glissade {
namespace {

// With none of n trials the upper end p is where (1 - p)^n = 0.025.
TEST(share_interval, counts_each_record_as_one_trial_where_none_exceeds) {
  const Interval none = share_interval(std::vector(7, 0.0)),
                 all = share_interval(std::vector(7, 1.0));
  EXPECT_EQ(none.low, 0.0);
  EXPECT_NEAR(none.high, 1.0 - std::pow(0.025, 1.0 / 7.0), 1e-12);
  EXPECT_NEAR(all.low, std::pow(0.025, 1.0 / 7.0), 1e-12);
  EXPECT_EQ(all.high, 1.0);
}

TEST(share_interval, is_the_share_where_all_records_have_the_same) {
  const Interval interval = share_interval(std::vector(7, 0.125));
  EXPECT_EQ(interval.low, 0.125);
  EXPECT_EQ(interval.high, 0.125);
}

// Equal numbers of histories, whatever they are, are those of one each.
TEST(share_interval, counts_records_by_their_histories) {
  const std::vector<double> shares{0.1, 0.5, 0.2, 0.9, 0.4, 0.3};
  const auto with = [&](const std::vector<double>& histories) {
    UnitValues of(shares);
    of.records = histories;
    return share_interval(of);
  };
  const Interval each = share_interval(shares), of_50 = with(std::vector(6, 50.0)),
                 of_more = with({1, 1, 1, 4, 1, 1});
  EXPECT_NEAR(of_50.low, each.low, 1e-12);
  EXPECT_NEAR(of_50.high, each.high, 1e-12);
  EXPECT_LT(of_more.low, each.low);  // less than six records are effective
  EXPECT_GT(of_more.high, each.high);
}

// By hand: 1, 2 and 3 of three units, of which the second has two records, 1.5 and 2.5.
TEST(unit_values, are_means_of_the_records_of_a_unit) {
  const UnitValues values({1.5, 1.0, 2.5, 3.0}, {4, 0, 4, 7});
  EXPECT_EQ(values.means, (std::vector{2.0, 1.0, 3.0}));
  EXPECT_EQ(values.records, (std::vector{2.0, 1.0, 1.0}));
  EXPECT_NEAR(effective_number(values), 64.0 / 26.0, 1e-12);  // of the sums 4, 1 and 3
}

// By hand, of sums 4, 1 and 3 of 2, 1 and 1 records: mean 2, departures of the units (2 - 2)
// 2/(4/3), (1 - 2) 3/4 and (3 - 2) 3/4 of the mean 2: error sqrt(2 (3/8)^2 / 2 / 3).
TEST(positive_mean_interval, of_units_is_from_the_departures_of_their_sums) {
  const Interval interval = positive_mean_interval(UnitValues({1.5, 1.0, 2.5, 3.0}, {4, 0, 4, 7}));
  constexpr double t = 4.30265272974946;  // of 2 degrees of freedom at 0.975
  EXPECT_NEAR(interval.low, 2.0 * std::exp(-t * std::sqrt(2.0 * 0.375 * 0.375 / 2.0 / 3.0)), 1e-9);
}

// (1 - p)^n = 0.025: ln 0.025 / ln 0.84 = 21.2, / ln 0.5 = 5.3.
TEST(records_that_bound, are_as_many_as_the_interval_of_none_takes) {
  EXPECT_EQ(records_that_bound(0.16), 22u);
  EXPECT_EQ(records_that_bound(0.5), 6u);
  EXPECT_EQ(records_that_bound(0.05), 72u);
  for (const double p : {0.16, 0.5, 0.05}) {
    const std::size_t n = records_that_bound(p);
    EXPECT_LE(share_interval(std::vector(n, 0.0)).high, p);
    EXPECT_GT(share_interval(std::vector(n - 1, 0.0)).high, p);
  }
}

TEST(share_interval, of_the_histories_that_do_not_exceed_is_its_mirror_image) {
  const Interval some = share_interval({0.0, 0.02, 0.3, 0.0, 0.1, 0.0, 0.8}),
                 others = share_interval({1.0, 0.98, 0.7, 1.0, 0.9, 1.0, 0.2});
  EXPECT_NEAR(some.low, 1.0 - others.high, 1e-12);
  EXPECT_NEAR(some.high, 1.0 - others.low, 1e-12);
}

TEST(share_interval, is_that_of_the_binomial_for_the_trials_that_the_variance_is_worth) {
  // 10 of 20 records, all or nothing: p (1 - p) / v = 19 trials; the interval is symmetric here.
  std::vector<double> shares(20, 0.0);
  std::fill(shares.begin(), shares.begin() + 10, 1.0);
  const Interval interval = share_interval(shares);
  EXPECT_NEAR(interval.low + interval.high, 1.0, 1e-12);
  // qbeta(0.025, x, x + 1) by quadrature of the density
  const double x = 0.5 * 19.0;
  double below = 0.0, total = 0.0;
  constexpr int steps = 200000;
  for (int i = 0; i < steps; ++i) {
    const double p = (i + 0.5) / steps;
    const double density = std::pow(p, x - 1.0) * std::pow(1.0 - p, x);
    total += density;
    if (p < interval.low) below += density;
  }
  EXPECT_NEAR(below / total, 0.025, 1e-4);
}

// 2 of 448 histories, both of one of seven records: it is not known that more than none exceed.
TEST(share_interval, begins_at_0_where_less_than_one_trial_exceeds) {
  const Interval interval = share_interval({2.0 / 64.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0});
  EXPECT_EQ(interval.low, 0.0);
  EXPECT_GT(interval.high, 0.4);
  EXPECT_LT(interval.high, 0.5);
}

TEST(order_intervals, lets_no_larger_share_end_lower) {
  std::vector<Interval> intervals = {{0.0, 0.42}, {0.3, 0.9}, {0.1, 0.3}, {0.2, 0.8}};
  order_intervals({0.0, 0.6, 0.2, 0.7}, intervals);
  const std::vector<Interval> expected = {{0.0, 0.42}, {0.2, 0.9}, {0.1, 0.42}, {0.2, 0.9}};
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(intervals[i].low, expected[i].low) << i;
    EXPECT_EQ(intervals[i].high, expected[i].high) << i;
  }
}

// One record: no intervals. They became [1, 0].
TEST(order_intervals, leaves_a_share_without_an_interval_without_one) {
  std::vector<Interval> intervals = {{}, {0.2, 0.8}, {}};
  order_intervals({0.0, 0.5, 1.0}, intervals);
  for (const std::size_t i : {0u, 2u}) {
    EXPECT_TRUE(std::isnan(intervals[i].low)) << i;
    EXPECT_TRUE(std::isnan(intervals[i].high)) << i;
  }
  EXPECT_EQ(intervals[1].low, 0.2);
  EXPECT_EQ(intervals[1].high, 0.8);
}

TEST(share_interval, needs_two_records) { EXPECT_TRUE(std::isnan(share_interval({0.3}).low)); }

// Records with dispersion 0.35, 50 samples each with 0.20 more: of expanded percentiles only 78 %
// of 7 records and 88 % of 20 covered. 600 studies; the lower bound is 3 sigma below the 96 % of
// the manual.
TEST(share_interval, covers_a_share_of_one_tenth) {
  const double level = std::hypot(0.35, 0.20) * normal_quantile(0.1);
  for (const int records : {7, 20}) {
    double covered = 0.0;
    for (std::uint64_t study = 0; study < 600; ++study) {
      std::vector<double> shares(records);
      for (int i = 0; i < records; ++i) {
        const double a = 0.35 * keyed_normal(study, RandomPurpose::test, i, 0);
        for (std::uint32_t s = 1; s <= 50; ++s)
          shares[i] +=
              a + 0.20 * keyed_normal(study, RandomPurpose::test, i, s) < level ? 1.0 / 50.0 : 0.0;
      }
      const Interval interval = share_interval(shares);
      covered += interval.low <= 0.1 && 0.1 <= interval.high ? 1.0 / 600.0 : 0.0;
    }
    RecordProperty("coverage_of_" + std::to_string(records), std::to_string(covered));
    EXPECT_GE(covered, 0.935) << records;
  }
}

}  // namespace
}  // namespace glissade
