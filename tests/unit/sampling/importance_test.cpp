// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/importance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glissade/core/normal.hpp"
#include "glissade/sampling/point_set.hpp"

namespace glissade {
namespace {

TEST(importance, leaves_a_coordinate_as_it_is_where_nothing_is_widened) {
  const WidenedCoordinate same = widened_coordinate(0.3, 1.0);
  EXPECT_NEAR(same.u, 0.3, 1e-15);
  EXPECT_NEAR(same.weight, 1.0, 1e-15);
}

TEST(importance, has_weights_of_mean_one_and_no_more_than_the_widening) {
  const PointSet points(SamplingMethod::sobol, 3);
  double sum = 0.0;
  for (std::uint64_t k = 0; k < 4096; ++k) {
    const WidenedCoordinate c = widened_coordinate(points.coordinate(k, 0), 3.0);
    EXPECT_GT(c.u, 0.0);
    EXPECT_LT(c.u, 1.0);
    EXPECT_LE(c.weight, 3.0);
    sum += c.weight / 4096.0;
  }
  EXPECT_NEAR(sum, 1.0, 2e-3);
}

TEST(importance, keeps_far_tails_inside_the_open_interval) {
  EXPECT_GT(widened_coordinate(1e-12, 10.0).u, 0.0);
  EXPECT_LT(widened_coordinate(1.0 - 1e-12, 10.0).u, 1.0);
}

/// A sum of a normal number and 1/2 of another is below a value with this probability.
WeightedProbability of_a_sum(std::uint64_t seed, double probability) {
  constexpr std::size_t samples = 1024, blocks = 16;
  double z = -8.0, high = 0.0;  // where Phi is `probability`
  for (int i = 0; i < 80; ++i) {
    const double middle = 0.5 * (z + high);
    (normal_cdf(middle) < probability ? z : high) = middle;
  }
  std::vector<double> event, weight;
  for (std::size_t block = 0; block < blocks; ++block) {
    const PointSet points(SamplingMethod::sobol, 1000 * seed + block);
    for (std::size_t k = 0; k < samples / blocks; ++k) {
      const WidenedCoordinate first = widened_coordinate(points.coordinate(k, 0), 3.0),
                              second = widened_coordinate(points.coordinate(k, 1), 3.0);
      const double sum = normal_quantile(first.u) + 0.5 * normal_quantile(second.u);
      event.push_back(sum < z * std::sqrt(1.25) ? 1.0 : 0.0);
      weight.push_back(first.weight * second.weight);
    }
  }
  return weighted_probability(event, weight, blocks);
}

// 400 studies of 1,024 samples; a share of 95 % has a standard error of 1.1 %.
TEST(importance, reaches_1e_minus_5_with_an_interval_that_covers) {
  constexpr double probability = 1e-5;
  int covered = 0;
  double mean = 0.0, error = 0.0, plain = 0.0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    const WeightedProbability found = of_a_sum(seed, probability);
    covered += found.low <= probability && probability <= found.high ? 1 : 0;
    mean += found.probability / 400.0;
    error += found.standard_error / 400.0;
    plain += found.plain_samples / 400.0;
  }
  RecordProperty("covered_of_400", covered);
  EXPECT_GE(covered, 364);  // 91 %
  EXPECT_LE(covered, 396);
  EXPECT_NEAR(mean / probability, 1.0, 0.05);
  EXPECT_LT(error / probability, 0.5);
  EXPECT_GT(plain, 100.0 * 1024.0);
}

// Two of 64 samples, in two of four blocks: the blocks do not show the error.
TEST(importance, has_no_interval_where_few_samples_carry_it) {
  std::vector<double> event(64, 0.0), weight(64, 1.0);
  event[3] = event[20] = 1.0;
  weight[20] = 0.5;
  const WeightedProbability found = weighted_probability(event, weight, 4);
  EXPECT_DOUBLE_EQ(found.probability, 1.5 / 64.0);
  EXPECT_DOUBLE_EQ(found.effective_samples, 1.5 * 1.5 / 1.25);
  EXPECT_TRUE(std::isnan(found.low) && std::isnan(found.high));
  EXPECT_EQ(weighted_probability(std::vector(64, 0.0), weight, 4).effective_samples, 0.0);
}

TEST(importance, has_no_error_where_all_blocks_agree) {
  const WeightedProbability found =
      weighted_probability(std::vector(8, 1.0), std::vector(8, 1.0), 2);
  EXPECT_EQ(found.probability, 1.0);
  EXPECT_EQ(found.low, 1.0);
  EXPECT_EQ(found.high, 1.0);
}

}  // namespace
}  // namespace glissade
