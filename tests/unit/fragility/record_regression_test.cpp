// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/fragility/record_regression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "glissade/core/random.hpp"

namespace glissade {
namespace {

RecordRegression normal_values(std::size_t records, std::uint64_t seed, double std) {
  RecordRegression data;
  for (std::size_t i = 0; i < records; ++i)
    data.value.push_back(std * keyed_normal(seed, RandomPurpose::test, i, 0));
  data.censored.assign(records, false);
  return data;
}

// Least squares by hand: y = 0 2 1 3 over x = 0 1 2 3 has slope 0.8, intercept 0.3, squares 1.8.
TEST(fit_records, is_least_squares_without_censored_values) {
  const RecordRegression line{{0, 2, 1, 3}, std::vector(4, false), {{0, 1, 2, 3}}};
  const RecordFit fit = fit_records(line);
  EXPECT_NEAR(fit.coefficients[0], 0.3, 1e-12);
  EXPECT_NEAR(fit.coefficients[1], 0.8, 1e-12);
  EXPECT_NEAR(fit.std, std::sqrt(1.8 / 2.0), 1e-12);
}

// t = 0.8 / sqrt(0.9 / 5) with 2 degrees of freedom, whose p = 1 - t / sqrt(2 + t^2).
TEST(test_slope, has_the_p_value_of_students_t_without_censored_values) {
  const RecordRegression mean{{0, 2, 1, 3}, std::vector(4, false), {}};
  const SlopeTest test = test_slope(mean, {0, 1, 2, 3});
  const double t = 0.8 / std::sqrt(0.9 / 5.0);
  EXPECT_NEAR(test.slope, 0.8, 1e-12);
  EXPECT_NEAR(test.p_value, 1.0 - t / std::sqrt(2.0 + t * t), 1e-10);
  EXPECT_TRUE(std::isnan(test_slope(mean, {1, 1, 1, 1}).p_value));
}

TEST(fit_records, counts_a_record_as_often_as_its_weight) {
  const RecordRegression twice{{0, 2, 2, 5}, std::vector(4, false), {}},
      once{{0, 2, 5}, std::vector(3, false), {}};
  EXPECT_NEAR(fit_records(once, {1, 2, 1}).std, fit_records(twice).std, 1e-12);
}

// 4,000 normal values of which those above 0.5 are known only as such: standard errors near 0.02.
TEST(fit_records, is_not_biased_by_censored_values) {
  RecordRegression data = normal_values(4000, 1, 1.0);
  for (std::size_t i = 0; i < data.records(); ++i) {
    if (data.value[i] < 0.5) continue;
    data.value[i] = 0.5;
    data.censored[i] = true;
  }
  const RecordFit fit = fit_records(data);
  EXPECT_NEAR(fit.coefficients[0], 0.0, 0.08);
  EXPECT_NEAR(fit.std, 1.0, 0.08);
}

// Every value twice: of pairs the error of ln std is that of the values once; taken as independent
// it is smaller by the square root of 2.
TEST(fit_records, has_the_error_of_the_units) {
  const RecordRegression once = normal_values(20, 3, 1.0);
  RecordRegression twice;
  for (std::size_t i = 0; i < 40; ++i) twice.value.push_back(once.value[i / 2]);
  twice.censored.assign(40, false);
  const double apart = fit_records(twice).log_std_error;
  for (std::size_t i = 0; i < 40; ++i) twice.unit_of.push_back(i / 2);
  const double expected = fit_records(once).log_std_error;
  EXPECT_NEAR(fit_records(twice).log_std_error, expected, 1e-12);
  EXPECT_NEAR(apart, expected / std::sqrt(2.0), 1e-12);
}

// 400 studies of 20 normal values: 4.6 sigma of 95 %.
TEST(record_dispersions, cover_the_standard_deviation) {
  double covered = 0.0;
  for (std::uint64_t study = 0; study < 400; ++study) {
    const auto found =
        record_dispersions({normal_values(20, 100 + study, 0.3)}, {.seed = 7, .replicates = 200});
    covered += found[0].interval.low <= 0.3 && 0.3 <= found[0].interval.high ? 1.0 / 400 : 0.0;
  }
  RecordProperty("coverage", std::to_string(covered));
  EXPECT_GE(covered, 0.90);
}

TEST(record_dispersions, rank_the_smaller_first_and_count_two_names_of_one_measure_both) {
  const RecordRegression small = normal_values(20, 1, 0.1), large = normal_values(20, 2, 1.0);
  const auto found = record_dispersions({large, small, small}, {.seed = 7, .replicates = 100});
  EXPECT_NEAR(found[0].smallest_share, 0.0, 1e-12);
  EXPECT_NEAR(found[1].smallest_share, 1.0, 1e-9);
  EXPECT_EQ(found[1].smallest_share, found[2].smallest_share);
}

}  // namespace
}  // namespace glissade
