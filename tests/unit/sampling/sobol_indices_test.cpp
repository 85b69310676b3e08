// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/sobol_indices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>

#include "glissade/core/random.hpp"
#include "glissade/sampling/point_set.hpp"

namespace glissade {
namespace {

using Point = std::vector<double>;
/// A response of a record and a point of the unit cube.
using Function = std::function<double(std::size_t record, const Point&)>;

constexpr std::uint32_t half_of_dimensions = 32;

CrossedResponse crossed(const PointSet& points, std::size_t records, std::size_t factors,
                        std::size_t samples, const Function& f) {
  CrossedResponse y(records, factors, samples);
  for (std::size_t k = 0; k < samples; ++k) {
    for (std::size_t matrix = 0; matrix < y.matrices(); ++matrix) {
      Point x(factors);
      for (std::uint32_t i = 0; i < factors; ++i) {
        const bool from_b = matrix == 1 || matrix == 2 + i;
        x[i] = points.coordinate(k, from_b ? i + half_of_dimensions : i);
      }
      for (std::size_t r = 0; r < records; ++r) y(r, matrix, k) = f(r, x);
    }
  }
  return y;
}

/// The points of one matrix, in groups by each coordinate: of one set, or as many of each of
/// several.
CrossedResponse given(const std::vector<PointSet>& sets, std::size_t records, std::size_t factors,
                      std::size_t samples, const Function& f) {
  const std::size_t size = samples / sets.size();
  std::vector<Point> x(samples);
  std::vector<FactorGroups> groups;
  for (std::uint32_t i = 0; i < factors; ++i) {
    std::vector<double> values;
    for (std::size_t k = 0; k < samples; ++k)
      values.push_back(x[k].emplace_back(sets[k / size].coordinate(k % size, i)));
    groups.push_back(groups_of(values));
  }
  CrossedResponse y(records, groups, sets.size());
  for (std::size_t k = 0; k < samples; ++k) {
    for (std::size_t r = 0; r < records; ++r) y(r, 0, k) = f(r, x[k]);
  }
  return y;
}

std::vector<PointSet> scrambles(std::uint64_t seed, std::size_t count) {
  std::vector<PointSet> sets;
  for (std::size_t b = 0; b < count; ++b) sets.emplace_back(SamplingMethod::sobol, 1000 * seed + b);
  return sets;
}

double ishigami(const Point& x) {
  const auto angle = [&](std::size_t i) { return (2 * x[i] - 1) * std::numbers::pi; };
  const double s = std::sin(angle(1));
  return std::sin(angle(0)) * (1 + 0.1 * std::pow(angle(2), 4)) + 7.0 * s * s;
}

// Ishigami & Homma (1990) with a = 7, b = 0.1 on (-pi, pi): closed forms in Saltelli et al. (2008),
// Global Sensitivity Analysis, 4.2: V = a^2/8 + b pi^4/5 + b^2 pi^8/18 + 1/2,
// V_1 = (1 + b pi^4/5)^2/2, V_2 = a^2/8, V_13 = 8 b^2 pi^8/225.
TEST(sobol_indices, are_those_of_Ishigami_in_closed_form) {
  constexpr double a = 7.0, b = 0.1, pi4 = 97.40909103400243723644, pi8 = pi4 * pi4;
  constexpr double v1 = 0.5 * (1 + b * pi4 / 5) * (1 + b * pi4 / 5), v2 = a * a / 8,
                   v13 = 8 * b * b * pi8 / 225,
                   v = a * a / 8 + b * pi4 / 5 + b * b * pi8 / 18 + 0.5;
  const SobolIndices found =
      sobol_indices(crossed(PointSet(SamplingMethod::sobol, 4), 3, 3, 8192,
                            [](auto, const Point& x) { return ishigami(x); }));
  EXPECT_NEAR(found.mean, a / 2, 0.01);
  EXPECT_NEAR(found.variance / v, 1.0, 0.01);
  const std::array first{v1 / v, v2 / v, 0.0}, total{(v1 + v13) / v, v2 / v, v13 / v};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.factors[i].first.value, first[i], 0.01) << i;
    EXPECT_NEAR(found.factors[i].total.value, total[i], 0.01) << i;
  }
  EXPECT_NEAR(found.records.first.value, 0.0, 1e-3);  // they are equal
  EXPECT_NEAR(found.records.total.value, 0.0, 1e-12);
  EXPECT_NEAR(found.drawn.first.value, 1.0, 1e-3);
}

/// The g function of Sobol' (1993): a product of (|4 x - 2| + a_i)/(1 + a_i), each of mean 1 and
/// variance 1/(3 (1 + a_i)^2). The first factor is the record's.
struct GFunction {
  static constexpr std::array a{0.5, 1.0, 2.0, 9.0};
  static constexpr std::size_t factors = a.size() - 1;

  static double part(std::size_t i, double x) { return (std::abs(4 * x - 2) + a[i]) / (1 + a[i]); }
  static double variance_of(std::size_t i) { return 1 / (3 * (1 + a[i]) * (1 + a[i])); }
  static double product_of(const std::vector<std::size_t>& some) {
    double product = 1.0;
    for (const std::size_t i : some) product *= 1 + variance_of(i);
    return product;
  }
  static double variance() { return product_of({0, 1, 2, 3}) - 1; }
  static double first(std::size_t i) { return variance_of(i) / variance(); }
  static double total(std::size_t i) {
    return variance_of(i) * (variance() + 1) / (1 + variance_of(i)) / variance();
  }

  /// Of records drawn by `seed`, crossed or given.
  template <class Design, class Points>
  static SobolIndices indices(Design design, const Points& points, std::uint64_t seed,
                              std::size_t records, std::size_t samples) {
    return sobol_indices(
        design(points, records, factors, samples, [&](std::size_t record, const Point& x) {
          double y = part(0, keyed_uniform(seed, RandomPurpose::test, record, 0));
          for (std::size_t i = 0; i < factors; ++i) y *= part(i + 1, x[i]);
          return y;
        }));
  }
};

TEST(sobol_indices, of_many_records_and_samples_are_those_of_the_g_function_in_closed_form) {
  const SobolIndices found =
      GFunction::indices(crossed, PointSet(SamplingMethod::sobol, 1), 1, 1024, 256);
  EXPECT_NEAR(found.variance / GFunction::variance(), 1.0, 0.05);
  EXPECT_NEAR(found.records.first.value, GFunction::first(0), 0.02);
  EXPECT_NEAR(found.records.total.value, GFunction::total(0), 0.02);
  EXPECT_NEAR(found.drawn.total.value, 1.0 - GFunction::first(0), 0.02);
  for (std::size_t i = 0; i < GFunction::factors; ++i) {
    EXPECT_NEAR(found.factors[i].first.value, GFunction::first(i + 1), 0.02) << i;
    EXPECT_NEAR(found.factors[i].total.value, GFunction::total(i + 1), 0.02) << i;
  }
}

// 400 studies of 20 records and 32 independent samples. A share of 95 % has a standard error of
// 1.1 %.
TEST(sobol_indices, have_intervals_that_cover) {
  constexpr int studies = 400;
  std::array<int, 4> first{}, total{};
  std::array<double, 4> mean_total{};
  for (int s = 0; s < studies; ++s) {
    const auto seed = static_cast<std::uint64_t>(s);
    const SobolIndices found =
        GFunction::indices(crossed, PointSet(SamplingMethod::monte_carlo, seed), seed, 20, 32);
    for (std::size_t i = 0; i < 4; ++i) {
      const SobolIndex& index = i == 0 ? found.records : found.factors[i - 1];
      const auto covers = [](const VarianceShare& share, double value) {
        return share.low <= value && value <= share.high ? 1 : 0;
      };
      first[i] += covers(index.first, GFunction::first(i));
      total[i] += covers(index.total, GFunction::total(i));
      mean_total[i] += index.total.value / studies;
    }
  }
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(mean_total[i], GFunction::total(i), 0.03) << i;
    EXPECT_GE(first[i], 0.90 * studies) << i;
    EXPECT_GE(total[i], 0.90 * studies) << i;
  }
}

// A group of 1/16 of a coordinate hides little of the three waves of Ishigami's second factor.
TEST(sobol_indices, of_given_data_are_those_of_Ishigami_in_closed_form) {
  const SobolIndices found = sobol_indices(
      given(scrambles(4, 8), 3, 3, 8192, [](auto, const Point& x) { return ishigami(x); }));
  const std::array first{0.313905, 0.442411, 0.0};  // as above
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(found.factors[i].first.value, first[i], 0.025) << i;
    EXPECT_TRUE(std::isnan(found.factors[i].total.value));
  }
  EXPECT_NEAR(found.drawn.first.value, 1.0, 1e-3);
}

// 400 studies of 20 records and 128 samples: independent, and in eight scrambles. A share of 95 %
// has a standard error of 1.1 %.
TEST(sobol_indices, of_given_data_have_intervals_that_cover) {
  constexpr int studies = 400;
  for (const bool sobol : {false, true}) {
    std::array<int, 4> covered{};
    std::array<double, 4> mean{};
    for (int s = 0; s < studies; ++s) {
      const auto seed = static_cast<std::uint64_t>(s);
      const SobolIndices found = GFunction::indices(
          given,
          sobol ? scrambles(seed, 8) : std::vector{PointSet(SamplingMethod::monte_carlo, seed)},
          seed, 20, 128);
      for (std::size_t i = 0; i < 4; ++i) {
        const VarianceShare& share = i == 0 ? found.records.first : found.factors[i - 1].first;
        covered[i] += share.low <= GFunction::first(i) && GFunction::first(i) <= share.high ? 1 : 0;
        mean[i] += share.value / studies;
      }
    }
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_NEAR(mean[i], GFunction::first(i), i == 0 ? 0.03 : 0.01) << sobol << i;
      EXPECT_GE(covered[i], 0.90 * studies) << sobol << i;
    }
  }
}

TEST(groups_of, keep_equal_values_together_and_have_equal_size) {
  EXPECT_EQ(groups_of({3.0, 1.0, 3.0, 2.0, 1.0, 2.0, 1.0, 1.0, 3.0, 3.0, 1.0, 1.0,
                       1.0, 1.0, 2.0, 2.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0, 3.0}),
            (FactorGroups{2, 0, 2, 1, 0, 1, 0, 0, 2, 2, 0, 0, 0, 0, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2}));
  std::vector<double> falling;
  for (int k = 0; k < 32; ++k) falling.push_back(-k);
  const FactorGroups groups = groups_of(falling);
  for (std::size_t k = 0; k < 32; ++k) EXPECT_EQ(groups[k], 3 - k / 8);
}

TEST(sobol_indices, of_a_sum_have_no_interaction_and_the_errors_of_its_mean) {
  // Records of 1, 2 ... 5, variance 2.5; a factor that is uniform in (0, 1), variance 1/12.
  const SobolIndices found = sobol_indices(
      crossed(PointSet(SamplingMethod::sobol, 7), 5, 1, 1024,
              [](std::size_t r, const Point& x) { return 1.0 + static_cast<double>(r) + x[0]; }));
  EXPECT_NEAR(found.variance, 2.5 + 1.0 / 12, 1e-3);
  EXPECT_NEAR(found.records.first.value, 2.5 / found.variance, 1e-3);
  EXPECT_NEAR(found.records.total.value, found.records.first.value, 1e-12);
  EXPECT_NEAR(found.factors[0].first.value, found.factors[0].total.value, 2e-3);
  EXPECT_NEAR(found.record_error, std::sqrt(2.5 / 5), 1e-6);
  EXPECT_NEAR(found.sample_error, std::sqrt(1.0 / 12 / 2048), 1e-5);
}

TEST(sobol_indices, are_nan_where_nothing_varies) {
  const SobolIndices found = sobol_indices(
      crossed(PointSet(SamplingMethod::sobol, 7), 3, 2, 4, [](auto, auto) { return 0.1; }));
  EXPECT_EQ(found.variance, 0.0);
  EXPECT_TRUE(std::isnan(found.records.first.value));
  EXPECT_TRUE(std::isnan(found.factors[1].total.low));
}

}  // namespace
}  // namespace glissade
