// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/point_set.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace glissade {
namespace {

/// Number of points in each of 2^bits equal cells of [0, 1).
std::vector<int> counts(const std::vector<double>& values, int bits) {
  std::vector<int> result(std::size_t{1} << bits);
  for (double v : values) ++result[static_cast<std::size_t>(std::ldexp(v, bits))];
  return result;
}

std::vector<double> column(const PointSet& points, int samples, std::uint32_t dimension) {
  std::vector<double> values;
  for (int i = 0; i < samples; ++i)
    values.push_back(points.coordinate(static_cast<std::uint64_t>(i), dimension));
  return values;
}

// A (0, 1)-sequence in base 2 has one of 2^m points in each interval of 2^-m; nested scrambling
// keeps it (Owen 1995).
TEST(point_set, has_one_scrambled_point_in_each_interval_in_every_dimension) {
  for (std::uint64_t seed : {1u, 2u}) {
    const PointSet points(SamplingMethod::sobol, seed);
    for (std::uint32_t d = 0; d < 64; ++d)
      EXPECT_THAT(counts(column(points, 256, d), 8), ::testing::Each(1)) << d;
  }
}

TEST(point_set, stays_inside_the_open_unit_interval_at_the_ends_of_its_range) {
  for (SamplingMethod method : {SamplingMethod::sobol, SamplingMethod::monte_carlo}) {
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
      for (std::uint64_t sample : {std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{0xffffffff}}) {
        const double u = PointSet(method, seed).coordinate(sample, 63);
        EXPECT_GT(u, 0.0);
        EXPECT_LT(u, 1.0);
      }
    }
  }
}

// Over seeds point 0, which unscrambled is the origin in every dimension, is uniform and its
// coordinates are independent: chi-square of 16 x 16 cells, 16,384 pairs; 330.5 is the 99.9 % point
// of 255 degrees of freedom (Boost.Math).
TEST(point_set, makes_point_0_uniform_and_independent_between_dimensions_over_seeds) {
  constexpr int n = 16384;
  std::vector<double> cells(256);
  for (std::uint64_t seed = 0; seed < n; ++seed) {
    const PointSet points(SamplingMethod::sobol, seed);
    ++cells[static_cast<std::size_t>(points.coordinate(0, 0) * 16) * 16 +
            static_cast<std::size_t>(points.coordinate(0, 1) * 16)];
  }
  double chi_squared = 0;
  for (double count : cells) chi_squared += (count - n / 256.0) * (count - n / 256.0) / (n / 256.0);
  EXPECT_LT(chi_squared, 330.5);
}

// Marginals of both methods: Kolmogorov's statistic of n numbers, sqrt(n) D < 1.949 with
// probability 99.9 %.
TEST(point_set, is_uniform_in_every_dimension) {
  for (SamplingMethod method : {SamplingMethod::sobol, SamplingMethod::monte_carlo}) {
    for (std::uint32_t d : {0u, 1u, 2u, 31u, 63u}) {
      std::vector<double> u = column(PointSet(method, 5), 1000, d);
      std::sort(u.begin(), u.end());
      double distance = 0;
      for (int i = 0; i < 1000; ++i)
        distance = std::max({distance, u[i] - i / 1000.0, (i + 1) / 1000.0 - u[i]});
      EXPECT_LT(std::sqrt(1000.0) * distance, 1.949) << d;
    }
  }
}

/// Sum of products of pairs of uniform numbers, scaled to a correlation.
class Correlation {
 public:
  void add(double u, double v) {
    sum_ += 12 * (u - 0.5) * (v - 0.5);
    ++count_;
  }
  double value() const { return sum_ / count_; }

 private:
  double sum_ = 0;
  int count_ = 0;
};

// Correlation of n = 4096 pairs of independent uniforms: below 4 / sqrt(n) with probability 99.99
// %. Between seeds it is that of one point over pairs of seeds: over the points of one pair of
// scrambles it is not small, as all of them share the first coin.
TEST(point_set, has_uncorrelated_dimensions_and_seeds) {
  for (SamplingMethod method : {SamplingMethod::sobol, SamplingMethod::monte_carlo}) {
    for (std::uint32_t d = 0; d < 12; ++d) {
      Correlation between_dimensions, between_seeds;
      for (std::uint64_t i = 0; i < 4096; ++i) {
        const PointSet points(method, 1), one(method, 2 * i), other(method, 2 * i + 1);
        between_dimensions.add(points.coordinate(i, d), points.coordinate(i, d + 1));
        between_seeds.add(one.coordinate(77, d), other.coordinate(77, d));
      }
      EXPECT_LT(std::abs(between_dimensions.value()), 4 / 64.0) << d;
      EXPECT_LT(std::abs(between_seeds.value()), 4 / 64.0) << d;
    }
  }
}

// The scrambles of deep bits differ between cells: the second half of a scrambled sequence is not
// the first half with one digit flipped, as it would be if each digit had a single coin (a random
// digital shift).
TEST(point_set, scrambles_each_cell_on_its_own) {
  const PointSet points(SamplingMethod::sobol, 9);
  std::set<double> shifts;
  for (std::uint32_t i = 0; i < 64; ++i) {
    const auto plain = static_cast<std::uint64_t>(std::ldexp(sobol_coordinate(i, 0), 32));
    shifts.insert(static_cast<double>(
        plain ^ static_cast<std::uint64_t>(std::ldexp(points.coordinate(i, 0), 32))));
  }
  EXPECT_EQ(shifts.size(), 64u);
}

// Mean of a smooth function of four coordinates, exp(sum u) with mean (e - 1)^4, over 32 seeds of
// 512 points. The ratio of mean squared errors has an F distribution with (32, 32) degrees of
// freedom if the methods were alike: above 3.1 with probability 0.1 %. Scrambled nets gain orders
// more for smooth functions (Owen 1997).
TEST(point_set, reduces_the_variance_of_a_smooth_function_against_monte_carlo) {
  const auto mean_squared_error = [](SamplingMethod method) {
    double sum = 0;
    for (std::uint64_t seed = 0; seed < 32; ++seed) {
      const PointSet points(method, seed);
      double mean = 0;
      for (std::uint64_t i = 0; i < 512; ++i) {
        double exponent = 0;
        for (std::uint32_t d = 0; d < 4; ++d) exponent += points.coordinate(i, d);
        mean += std::exp(exponent) / 512;
      }
      sum += std::pow(mean - std::pow(std::exp(1.0) - 1, 4), 2) / 32;
    }
    return sum;
  };
  EXPECT_GT(
      mean_squared_error(SamplingMethod::monte_carlo) / mean_squared_error(SamplingMethod::sobol),
      100.0);
}

}  // namespace
}  // namespace glissade
