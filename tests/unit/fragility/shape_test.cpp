// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/shape.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "glissade/core/finite.hpp"
#include "glissade/core/normal.hpp"
#include "glissade/core/random.hpp"
#include "worked_examples.hpp"

namespace glissade {
namespace {

using testing::DoubleNear;
using testing::Each;
using testing::Pointwise;

const ModelScore& of(const ShapeComparison& comparison, ShapeModel model) {
  return comparison.models.at(static_cast<std::size_t>(model));
}

/// Counts shared equally by three records.
ShapeData three_records(const std::vector<Stripe>& stripes) {
  ShapeData data{.thresholds_m = {0.1}, .stripes = {{}}};
  for (const Stripe& s : stripes) {
    data.intensities.push_back(s.intensity);
    for (std::size_t record = 0; record < 3; ++record)
      data.stripes[0].push_back({s.intensity, s.trials / 3, s.exceedances / 3, 1.0, record});
  }
  return data;
}

// Dobson, An Introduction to Generalized Linear Models, the beetles of Bliss (1935): numbers dead
// by three models, to the digits that are printed.
TEST(compare_shapes, gives_the_published_fits_of_bliss_beetles) {
  const std::vector<Stripe> beetles = worked_examples::bliss_beetles();
  const ShapeComparison comparison = compare_shapes(three_records(beetles)).at(0);
  ASSERT_EQ(comparison.status, ComparisonStatus::compared);
  const auto dead = [&](ShapeModel model) {
    std::vector<double> numbers;
    for (std::size_t j = 0; j < beetles.size(); ++j)
      numbers.push_back(beetles[j].trials * of(comparison, model).probability[j]);
    return numbers;
  };
  EXPECT_THAT(
      dead(ShapeModel::lognormal),
      Pointwise(DoubleNear(0.0051), {3.36, 10.72, 23.48, 33.82, 49.62, 53.32, 59.66, 59.23}));
  EXPECT_THAT(dead(ShapeModel::logit), Pointwise(DoubleNear(0.0051), {3.46, 9.84, 22.45, 33.90,
                                                                      50.10, 53.29, 59.22, 58.74}));
  EXPECT_THAT(
      dead(ShapeModel::complementary_log_log),
      Pointwise(DoubleNear(0.0051), {5.59, 11.28, 20.95, 30.37, 47.78, 54.14, 61.11, 59.95}));
  EXPECT_THAT(dead(ShapeModel::monotone),
              Pointwise(DoubleNear(1e-9), {6, 13, 18, 28, 52, 53, 61, 60}));
  // Records that are alike do not differ in what predicts them.
  EXPECT_NEAR(of(comparison, ShapeModel::complementary_log_log).standard_error, 0.0, 1e-12);
}

TEST(compare_shapes, pools_adjacent_violators) {
  // Shares 0.5, 0.25, 0.75, 0.5, 1 of 12 each: the first four pool in pairs.
  const ShapeData data =
      three_records({{1, 12, 6}, {2, 12, 3}, {3, 12, 9}, {4, 12, 6}, {5, 12, 12}});
  EXPECT_THAT(of(compare_shapes(data).at(0), ShapeModel::monotone).probability,
              Pointwise(DoubleNear(1e-12), {0.375, 0.375, 0.625, 0.625, 1.0}));
}

/// Records whose displacements are ln D = 2 ln x + a(record) + 0.4 e where the shaking is above a
/// capacity of sliding of median 1 and log_std 0.1, else 0.
ShapeData slides_above(std::size_t records, double capacity_median) {
  constexpr std::uint32_t samples = 40;
  ShapeData data{.thresholds_m = {0.02, 1.2}};
  for (int j = 0; j < 10; ++j) data.intensities.push_back(0.4 * std::pow(1.25, j));
  const double highest = data.intensities.back();
  data.stripes.resize(2);
  data.capacities.resize(2);
  data.slips.resize(records);
  for (std::size_t i = 0; i < records; ++i) {
    const auto normal = [&](std::uint32_t k) { return keyed_normal(9, RandomPurpose::test, i, k); };
    for (const double x : data.intensities) {
      data.slips[i].push_back({.intensity = x});
      for (auto& stripes : data.stripes) stripes.push_back({x, samples, 0.0, 1.0, i});
    }
    for (std::uint32_t s = 0; s < samples; ++s) {
      const double begins = capacity_median * std::exp(0.1 * normal(1 + 2 * s));
      const double size = std::exp(0.2 * normal(0) + 0.4 * normal(2 + 2 * s));
      for (std::size_t j = 0; j < 10; ++j) {
        const double x = data.intensities[j], d = x > begins ? size * x * x : 0.0;
        data.slips[i][j].add(d);
        for (std::size_t t = 0; t < 2; ++t)
          data.stripes[t][10 * i + j].exceedances += d > data.thresholds_m[t] ? 1 : 0;
      }
      for (std::size_t t = 0; t < 2; ++t) {
        const double c =
            std::min(highest, std::max(begins, std::sqrt(data.thresholds_m[t] / size)));
        data.capacities[t].push_back({c, c, 1.0, i});
      }
    }
  }
  return data;
}

// The larger threshold is reached where the shaking suffices to slide and the size does: a step
// that no lognormal has.
TEST(compare_shapes, prefers_two_parts_where_sliding_begins_at_once) {
  const std::vector<ShapeComparison> comparisons = compare_shapes(slides_above(30, 1.0));
  ASSERT_EQ(comparisons.at(1).status, ComparisonStatus::compared);
  const ModelScore& two_part = of(comparisons.at(1), ShapeModel::two_part);
  EXPECT_GT(two_part.difference, 2.0 * two_part.standard_error);
  EXPECT_EQ(of(comparisons.at(1), ShapeModel::lognormal).difference, 0.0);
  // With the truth itself: P(x > begins) P(size x^2 > 1.2).
  const std::vector<double> x = slides_above(1, 1.0).intensities;
  for (std::size_t j = 0; j < x.size(); ++j) {
    const double truth = normal_cdf(std::log(x[j]) / 0.1) *
                         normal_cdf((2 * std::log(x[j]) - std::log(1.2)) / std::hypot(0.2, 0.4));
    EXPECT_NEAR(two_part.probability[j], truth, 0.06) << x[j];
  }
}

TEST(compare_shapes, names_what_it_cannot_compare) {
  EXPECT_EQ(compare_shapes(three_records(worked_examples::separated())).at(0).status,
            ComparisonStatus::no_overlap);
  EXPECT_EQ(compare_shapes(three_records({{1, 9, 3}, {2, 9, 3}, {3, 9, 3}})).at(0).status,
            ComparisonStatus::no_rise);
  EXPECT_EQ(compare_shapes(three_records({{1, 0, 0}, {2, 0, 0}})).at(0).status,
            ComparisonStatus::always_exceeds);
  ShapeData two = three_records(worked_examples::bliss_beetles());
  std::erase_if(two.stripes[0], [](const Stripe& row) { return row.record == 2; });
  EXPECT_EQ(compare_shapes(two).at(0).status, ComparisonStatus::few_records);
  EXPECT_TRUE(compare_shapes(two).at(0).models.empty());
}

/// Capacities of three thresholds, of medians 0.5, 1 and 1.4 and log_std 0.4, half of it by record.
ShapeData capacities_of(std::size_t records) {
  ShapeData data{.intensities = {1.0}, .thresholds_m = {0.1, 0.2, 0.4}};
  const std::vector<double> medians = {0.5, 1.0, 1.4};
  data.capacities.resize(3);
  for (std::size_t i = 0; i < records; ++i) {
    for (std::uint32_t s = 1; s <= 20; ++s) {
      const double e = std::sqrt(0.5) * (keyed_normal(4, RandomPurpose::test, i, 0) +
                                         keyed_normal(4, RandomPurpose::test, i, s));
      for (std::size_t t = 0; t < 3; ++t) {
        const double c = medians[t] * std::exp(0.4 * e);
        data.capacities[t].push_back({std::min(c, 1.5), c < 1.5 ? c : infinity, 1.0, i});
      }
    }
  }
  return data;
}

TEST(fit_surface, recovers_medians_and_one_log_std_from_censored_capacities) {
  const auto surface = fit_surface(capacities_of(400));
  ASSERT_TRUE(surface);
  // ln median has a standard error of 0.4 sqrt(0.5 / 400) = 0.014, ln log_std of about 0.03.
  const std::vector<double> truth = {0.5, 1.0, 1.4};
  for (std::size_t t = 0; t < 3; ++t) {
    EXPECT_NEAR(std::log(surface->medians[t] / truth[t]), 0.0, 0.05);
    EXPECT_NEAR(std::log(surface->median_intervals[t].high / surface->median_intervals[t].low),
                2 * 1.966 * 0.4 * std::sqrt(0.525 / 400), 0.02);
  }
  EXPECT_NEAR(surface->log_std, 0.4, 0.03);
  EXPECT_LT(surface->log_std_interval.low, 0.4);
  EXPECT_GT(surface->log_std_interval.high, 0.4);
}

TEST(fit_surface, never_crosses) {
  const auto surface = fit_surface(capacities_of(8));
  ASSERT_TRUE(surface);
  for (double x = 0.01; x < 100; x *= 1.5) {
    for (double d = 0.1; d < 0.39; d += 0.01)
      EXPECT_GE(surface->probability(x, d), surface->probability(x, d + 0.01));
  }
  EXPECT_DOUBLE_EQ(surface->probability(surface->medians[1], 0.2), 0.5);
}

TEST(fit_surface, leaves_out_a_threshold_that_was_not_reached) {
  ShapeData data = capacities_of(8);
  for (Bracket& row : data.capacities[2]) row = {1.5, infinity, 1.0, row.record};
  EXPECT_EQ(fit_surface(data)->thresholds_m.size(), 2u);
  for (Bracket& row : data.capacities[1]) row = {1.5, infinity, 1.0, row.record};
  EXPECT_FALSE(fit_surface(data));
}

TEST(crossing_of, is_where_both_have_one_probability) {
  const FragilityCurve a{1.0, 0.3, 0.1}, b{1.2, 0.6, 0.1};
  const auto crossing = crossing_of(a, b);
  ASSERT_TRUE(crossing);
  EXPECT_NEAR(crossing->intensity, 1 / 1.2, 1e-12);
  EXPECT_NEAR(a.probability(crossing->intensity), crossing->probability, 1e-12);
  EXPECT_NEAR(b.probability(crossing->intensity), crossing->probability, 1e-12);
  EXPECT_FALSE(crossing_of(a, {1.5, 0.3}));
}

// ln D = 1 + 2 ln x with residuals 0.3 and -0.3 at each of two intensities: sum of squares 0.36
// over n - 2 = 2.
TEST(fit_two_part, is_the_regression_and_the_share_that_slips) {
  std::vector<SlipSums> rows = {{.intensity = 1.0}, {.intensity = std::exp(1.0)}};
  for (const double e : {-0.3, 0.3}) {
    rows[0].add(std::exp(1 + e));
    rows[1].add(std::exp(3 + e));
  }
  const TwoPartFit all = fit_two_part(rows);
  EXPECT_EQ(all.any_status, FitStatus::upper_bound);
  EXPECT_EQ(all.size_status, FitStatus::maximum_likelihood);
  EXPECT_NEAR(all.intercept, 1.0, 1e-14);
  EXPECT_NEAR(all.slope, 2.0, 1e-14);
  EXPECT_NEAR(all.log_std, std::sqrt(0.18), 1e-14);
  EXPECT_NEAR(all.probability(1.0, std::exp(1.0)), 0.5, 1e-12);
  EXPECT_EQ(all.probability(0.0, 1.0), 0.0);
  for (int i = 0; i < 2; ++i) rows[0].add(0.0);
  rows[1].add(0.0);
  const TwoPartFit some = fit_two_part(rows);  // 2 of 4 and 2 of 3 slip
  EXPECT_EQ(some.any_status, FitStatus::maximum_likelihood);
  EXPECT_NEAR(some.slope, 2.0, 1e-14);
  EXPECT_NEAR(some.probability(1.0, std::exp(1.0)), 0.25, 1e-9);
  EXPECT_NEAR(some.probability(std::exp(1.0), std::exp(3.0)), 1.0 / 3, 1e-9);
}

TEST(fit_two_part, names_what_it_cannot_fit) {
  SlipSums level{.intensity = 1.0}, rest{.intensity = 2.0};
  for (const double d : {0.1, 0.2, 0.4}) level.add(d);
  rest.add(0.0);
  EXPECT_EQ(fit_two_part({level, rest}).size_status, FitStatus::one_level);
  EXPECT_EQ(fit_two_part({rest}).size_status, FitStatus::failed);
  EXPECT_EQ(fit_two_part({rest}).any_status, FitStatus::lower_bound);
  EXPECT_FALSE(fit_two_part({level, rest}).has_curve());
}

}  // namespace
}  // namespace glissade
