// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/bootstrap.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "glissade/core/random.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {
namespace {

bool covers(const Interval& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

TEST(bootstrap_interval, draws_as_many_records_as_there_are) {
  bootstrap_interval(9,
                     [](const std::vector<double>& weights) {
                       EXPECT_EQ(weights.size(), 9u);
                       EXPECT_EQ(std::accumulate(weights.begin(), weights.end(), 0.0), 9.0);
                       return 0.0;
                     },
                     {.replicates = 100});
}

// Mean of n = 20 normal numbers: 95 % nominal; 800 studies leave [0.92, 0.98] with probability 1e-4
// were it exact.
TEST(bootstrap_interval, covers_the_mean_of_20_normal_numbers) {
  double share = 0;
  for (int study = 0; study < 800; ++study) {
    std::vector<double> x;
    for (int i = 0; i < 20; ++i) x.push_back(keyed_normal(study, RandomPurpose::test, i, 0));
    const auto mean = [&](const std::vector<double>& w) {
      return std::inner_product(w.begin(), w.end(), x.begin(), 0.0) / 20;
    };
    share +=
        covers(bootstrap_interval(20, mean, {.seed = 3, .replicates = 400}), 0.0) ? 1 / 800.0 : 0;
  }
  EXPECT_GE(share, 0.92);
  EXPECT_LE(share, 0.98);
}

TEST(bootstrap, of_several_statistics_gives_the_intervals_of_each) {
  const auto sum = [](const std::vector<double>& weights) {
    double total = 0.0;
    for (std::size_t i = 0; i < weights.size(); ++i) total += weights[i] * static_cast<double>(i);
    return total;
  };
  const auto of_first = [](const std::vector<double>& weights) { return weights.front(); };
  const BootstrapOptions options{.seed = 7, .replicates = 200};
  const std::vector<Interval> both = bootstrap_intervals(
      8, 2,
      [&](const auto& weights) {
        return std::vector{sum(weights), of_first(weights)};
      },
      options);
  ASSERT_EQ(both.size(), 2u);
  const Interval first = bootstrap_interval(8, sum, options),
                 second = bootstrap_interval(8, of_first, options);
  EXPECT_EQ(both[0].low, first.low);
  EXPECT_EQ(both[0].high, first.high);
  EXPECT_EQ(both[1].low, second.low);
  EXPECT_EQ(both[1].high, second.high);
  for (const Interval& none : bootstrap_intervals(1, 2,
                                                  [](const auto&) {
                                                    return std::vector{1.0, 1.0};
                                                  },
                                                  {}))
    EXPECT_TRUE(std::isnan(none.low));
}

TEST(bootstrap_interval, is_empty_for_one_record) {
  EXPECT_TRUE(std::isnan(bootstrap_interval(1, [](const auto&) { return 1.0; }, {}).low));
}

// 1,000 studies each of lognormal rates: below 0.93 with probability 2e-3 were it 95 %; expanded
// percentiles cover 0.76 to 0.95, and what they miss is above them.
TEST(positive_mean_interval, covers_the_mean_of_lognormal_rates) {
  for (const int records : {7, 22, 44}) {
    for (const double spread : {0.5, 0.77, 1.0, 1.4}) {
      double share = 0;
      for (int study = 0; study < 1000; ++study) {
        std::vector<double> rates;
        for (int i = 0; i < records; ++i)
          rates.push_back(1e-4 *
                          std::exp(spread * keyed_normal(study, RandomPurpose::test, i, 77)));
        share += covers(positive_mean_interval(rates), 1e-4 * std::exp(0.5 * spread * spread))
                     ? 1e-3
                     : 0;
      }
      RecordProperty("coverage_" + std::to_string(records) + "_" + std::to_string(spread),
                     std::to_string(share));
      EXPECT_GE(share, 0.93) << records << " " << spread;
      EXPECT_LE(share, 0.985) << records << " " << spread;
    }
  }
}

// In 11 records some 70 % have the rate of the highest level, which they do not reach: percentiles
// of resamples cover 78 %, Cox's interval with the bootstrap-t 81 %. 600 studies: 3 sigma are 2.6
// %.
TEST(positive_mean_interval, covers_rates_that_few_records_carry) {
  double truth = 0, share = 0;
  for (int i = 0; i < 4000; ++i) {  // by the midpoint rule
    const double z = -8 + 16 * (i + 0.5) / 4000;
    truth +=
        16 / 4000.0 * std::exp(std::max(z, 0.524) - 0.5 * z * z) / std::sqrt(2 * std::acos(-1));
  }
  for (int study = 0; study < 600; ++study) {
    std::vector<double> rates;
    for (int i = 0; i < 11; ++i)
      rates.push_back(std::exp(std::max(0.524, keyed_normal(study, RandomPurpose::test, i, 78))));
    share += covers(positive_mean_interval(rates), truth) ? 1 / 600.0 : 0;
  }
  EXPECT_GE(share, 0.93);
}

TEST(positive_mean_interval, is_finite_with_ties_and_zeros_and_contains_the_mean) {
  for (const std::vector<double>& rates :
       {std::vector{1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-5, 1e-3}, std::vector{0.0, 0.0, 0.0, 2.0},
        std::vector{1e-300, 1e-5, 3e-5}}) {
    const double mean =
        std::accumulate(rates.begin(), rates.end(), 0.0) / static_cast<double>(rates.size());
    const Interval interval = positive_mean_interval(rates);
    EXPECT_LE(interval.low, mean);
    EXPECT_GT(interval.high, mean);
    EXPECT_GE(interval.low, 0.0);
    EXPECT_FALSE(std::isnan(interval.high));
    EXPECT_EQ(positive_mean_interval(rates).high, interval.high);
  }
  const Interval equal = positive_mean_interval({2e-4, 2e-4, 2e-4});
  EXPECT_EQ(equal.low, 2e-4);
  EXPECT_EQ(equal.high, 2e-4);
  EXPECT_EQ(positive_mean_interval({0.0, 0.0}).high, 0.0);
  EXPECT_TRUE(std::isnan(positive_mean_interval({1.0}).low));
}

}  // namespace
}  // namespace glissade
