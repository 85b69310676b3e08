// SPDX-License-Identifier: GPL-3.0-or-later
// Where the spread comes from: the design of the samples, and indices beside brute force.
#include "glissade/study/analysis/sensitivity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "glissade/study/run/reduce.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::drawn;
using test::fixed;
using test::small_config;
using test::small_plan;

StudyConfig sensitivity_config() {
  StudyConfig config = small_config();
  config.sensitivity = true;
  config.sampling.method = SamplingMethod::sobol;
  config.sampling.samples = 8;
  return config;
}

TEST(sensitivity, runs_the_samples_of_pick_freeze_matrices) {
  const StudyConfig config = sensitivity_config();
  const std::vector<DrawnFactor> factors = drawn_factors(config);
  ASSERT_EQ(factors.size(), 4u);
  EXPECT_EQ(factors[0].name, "building period");
  EXPECT_EQ(factors[1].name, "slope");
  EXPECT_EQ(factors[2].name, "friction");
  EXPECT_EQ(factors[3].name, "orientation");
  const CaseSet set = PlannedCases(config).stored();
  constexpr std::size_t n = 8;
  ASSERT_EQ(set.samples, n * 6);
  const auto at = [&](std::size_t matrix, std::size_t k) { return set.cases[matrix * n + k]; };
  for (std::size_t k = 0; k < n; ++k) {
    const Case a = at(0, k), b = at(1, k);
    EXPECT_NE(a.friction, b.friction);
    EXPECT_EQ(at(2, k).period_s, b.period_s);
    EXPECT_EQ(at(2, k).friction, a.friction);
    EXPECT_EQ(at(3, k).slope_deg, b.slope_deg);
    EXPECT_EQ(at(3, k).period_s, a.period_s);
    EXPECT_EQ(at(4, k).friction, b.friction);
    EXPECT_EQ(at(4, k).orientation, a.orientation);
    EXPECT_EQ(at(5, k).orientation, b.orientation);
    EXPECT_EQ(at(5, k).slope_deg, a.slope_deg);
  }
}

TEST(sensitivity, leaves_the_samples_of_other_studies_as_they_are) {
  StudyConfig config = sensitivity_config();
  const CaseSet with = PlannedCases(config).stored();
  config.sensitivity = false;
  const CaseSet without = PlannedCases(config).stored();
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(with.cases[k].friction, without.cases[k].friction);
}

/// What a number of a history of a study depends on: its record, friction and slope.
StudyConfig two_factor_config(std::uint64_t samples) {
  StudyConfig config = sensitivity_config();
  config.quantities.at("building", "period_s") = fixed(0.3);
  config.quantities.at("roof", "slope_deg") = drawn(Uniform{0.0, 5.0});
  config.quantities.at("friction", "mu") = drawn(Uniform{0.2, 0.5});
  config.orientation.choice = OrientationChoice::as_recorded;
  config.friction.values = {FrictionValue::as_drawn};
  config.intensity.levels = {0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 4.0, 8.0};
  config.sampling.samples = samples;
  config.sampling.bootstrap_replicates = 100;
  config.fragility = FragilityConfig{.thresholds_m = {0.05}};
  return config;
}

/// First-order and total indices of friction and slope on the study's records, by nested loops over
/// a grid of both: expectations as sums, nothing estimated by pairs.
struct BruteForce {
  double friction_first = 0.0, friction_total = 0.0, slope_first = 0.0, slope_total = 0.0;

  explicit BruteForce(std::size_t grid) {
    StudyConfig config = two_factor_config(1);
    config.sensitivity = false;
    config.orientation.choice = OrientationChoice::as_recorded;
    std::vector<double> frictions, slopes;
    for (std::size_t i = 0; i < grid; ++i) {
      const double u = (static_cast<double>(i) + 0.5) / static_cast<double>(grid);
      frictions.push_back(0.2 + 0.3 * u);
      slopes.push_back(5.0 * u);
    }
    config.quantities.at("friction", "mu") = test::listed(frictions);
    config.quantities.at("roof", "slope_deg") = test::listed(slopes);
    const Results results = test::run(small_plan(config));
    // Axes: slope, friction (the order of parameters()).
    const auto y = [&](std::size_t record, std::size_t s, std::size_t f) {
      return std::log(std::clamp(results.histories.capacity(record, s * grid + f, 0), 0.05, 8.0));
    };
    const double n = 3.0, g = static_cast<double>(grid);
    // Of pairs of different records: the population's part, as the estimator takes it.
    double mean_product = 0.0, of_records = 0.0, mean = 0.0, squares = 0.0;
    std::vector<std::vector<double>> by_friction(3, std::vector<double>(grid)),
        by_slope = by_friction;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t s = 0; s < grid; ++s) {
        for (std::size_t f = 0; f < grid; ++f) {
          by_friction[r][f] += y(r, s, f) / g;
          by_slope[r][s] += y(r, s, f) / g;
          mean += y(r, s, f) / (n * g * g);
          squares += y(r, s, f) * y(r, s, f) / (n * g * g);
        }
      }
    }
    std::vector<double> means(3);
    for (std::size_t r = 0; r < 3; ++r) {
      for (const double m : by_friction[r]) means[r] += m / g;
      of_records += (means[r] - mean) * (means[r] - mean) / (n - 1.0);
    }
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t q = 0; q < 3; ++q) {
        if (q == r) continue;
        mean_product += means[r] * means[q] / (n * (n - 1.0));
        for (std::size_t i = 0; i < grid; ++i) {
          friction_first += by_friction[r][i] * by_friction[q][i] / (g * n * (n - 1.0));
          slope_first += by_slope[r][i] * by_slope[q][i] / (g * n * (n - 1.0));
        }
      }
    }
    // E[y^2] less the mean product of different records and samples: the population's variance.
    const double variance = squares - mean_product;
    friction_first = (friction_first - mean_product) / variance;
    slope_first = (slope_first - mean_product) / variance;
    double over_friction = 0.0, over_slope = 0.0;
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t i = 0; i < grid; ++i) {
        over_friction += by_slope[r][i] * by_slope[r][i] / (n * g);
        over_slope += by_friction[r][i] * by_friction[r][i] / (n * g);
      }
    }
    friction_total = (squares - over_friction) / variance;
    slope_total = (squares - over_slope) / variance;
    EXPECT_GT(of_records, 0.0);
  }
};

TEST(sensitivity, of_a_slip_study_is_that_of_brute_force) {
  const BruteForce exact(24);
  const Results results = test::run(small_plan(two_factor_config(512)));
  const SensitivityResults& found = *results.sensitivity;
  ASSERT_EQ(found.factors,
            (std::vector<std::string>{"records", "all that is drawn", "slope", "friction"}));
  const SpreadRow& capacity = found.rows.front();
  ASSERT_TRUE(capacity.is_capacity());
  EXPECT_NEAR(capacity.first[2], exact.slope_first, 0.01);
  EXPECT_NEAR(capacity.first[3], exact.friction_first, 0.01);
  EXPECT_NEAR(capacity.total[2], exact.slope_total, 0.01);
  EXPECT_NEAR(capacity.total[3], exact.friction_total, 0.01);
  EXPECT_GT(exact.friction_first, 0.1);  // they are not all small

  // The same of histories that were run without [sensitivity].
  StudyConfig plain = two_factor_config(512);
  plain.sensitivity = false;
  plain.sampling.scrambles = 8;
  Results finished = test::run(small_plan(plain));
  ASSERT_EQ(finished.cases.samples, 512u);
  StudyConfig with = plain;
  with.sensitivity = true;
  analyse_again(with, finished);
  EXPECT_EQ(finished.sensitivity->matrices, 1u);
  const SpreadRow& given = finished.sensitivity->rows.front();
  EXPECT_NEAR(given.first[2], exact.slope_first, 0.01);
  EXPECT_NEAR(given.first[3], exact.friction_first, 0.01);
  EXPECT_LT(given.first_interval[3].low, exact.friction_first);
  EXPECT_GT(given.first_interval[3].high, exact.friction_first);
  EXPECT_TRUE(std::isnan(given.total[3]));
  EXPECT_GE(given.total[0], given.first[0]);  // records
}

TEST(sensitivity, of_finished_results_needs_32_samples_and_eight_scrambles_of_Sobol_points) {
  const auto added = [](std::uint64_t samples, std::uint64_t scrambles, SamplingMethod method) {
    StudyConfig config = two_factor_config(samples);
    config.sensitivity = false;
    config.sampling.scrambles = scrambles;
    config.sampling.method = method;
    Results results = test::run(small_plan(config));
    config.sensitivity = true;
    analyse_again(config, results);
  };
  EXPECT_THROW(added(16, 8, SamplingMethod::sobol), InputError);
  EXPECT_THROW(added(32, 4, SamplingMethod::sobol), InputError);
  EXPECT_NO_THROW(added(32, 8, SamplingMethod::sobol));
  EXPECT_NO_THROW(added(32, 1, SamplingMethod::monte_carlo));
}

TEST(sensitivity, has_a_row_for_each_threshold_and_level) {
  const Results results = test::run(small_plan(sensitivity_config()));
  const SensitivityResults& found = *results.sensitivity;
  EXPECT_EQ(found.samples, 8u);
  ASSERT_EQ(found.rows.size(), 3u * 9u);  // sampled friction alone
  EXPECT_TRUE(found.rows[9].is_capacity());
  EXPECT_EQ(found.rows[9].threshold_m, 0.1);
  EXPECT_EQ(found.rows[12].level, 0.75);
  double exceeding = 0.0;
  for (std::size_t record = 0; record < 3; ++record) {
    for (std::size_t c = 0; c < 16; ++c)  // A and B
      exceeding += results.histories.displacement_m(record, c, 2) >= 0.1 ? 1.0 : 0.0;
  }
  EXPECT_DOUBLE_EQ(found.rows[12].mean, exceeding / 48.0);
}

TEST(sensitivity, compares_drawn_friction_with_its_design_value) {
  const Results results = test::run(small_plan(sensitivity_config()));
  const auto& rows = results.sensitivity->design_friction;
  ASSERT_EQ(rows.size(), results.levels.size());
  const std::size_t level = 5, samples = 48;
  double above = 0.0, mean_m = 0.0, above_mean = 0.0;
  for (std::size_t record = 0; record < 3; ++record) {
    for (std::size_t c = 0; c < samples; ++c) {
      const double design_m = results.histories.displacement_m(record, samples + c, level);
      above += results.histories.displacement_m(record, c, level) > design_m ? 1.0 : 0.0;
      mean_m += design_m / (3.0 * samples);
    }
  }
  for (std::size_t record = 0; record < 3; ++record) {
    for (std::size_t c = 0; c < samples; ++c)
      above_mean += results.histories.displacement_m(record, c, level) > mean_m ? 1.0 : 0.0;
  }
  EXPECT_DOUBLE_EQ(rows[level].same_motion.value, above / (3.0 * samples));
  EXPECT_NEAR(rows[level].design_mean_m, mean_m, 1e-12);
  EXPECT_DOUBLE_EQ(rows[level].above_mean.value, above_mean / (3.0 * samples));
  // Leaving out one of the 8 samples of every matrix.
  std::vector<double> without(8);
  for (std::size_t g = 0; g < 8; ++g) {
    for (std::size_t record = 0; record < 3; ++record) {
      for (std::size_t c = 0; c < samples; ++c) {
        if (c % 8 == g) continue;
        without[g] += results.histories.displacement_m(record, c, level) >
                              results.histories.displacement_m(record, samples + c, level)
                          ? 1.0 / (3.0 * (samples - 6.0))
                          : 0.0;
      }
    }
  }
  double mean = 0.0, squares = 0.0;
  for (const double w : without) mean += w / 8.0;
  for (const double w : without) squares += (w - mean) * (w - mean);
  EXPECT_NEAR(rows[level].same_motion_error, std::sqrt(squares * 7.0 / 8.0), 1e-12);
  EXPECT_GT(rows[level].same_motion_error, 0.0);
  EXPECT_LE(rows[level].same_motion.interval.low,
            std::max(0.0, rows[level].same_motion.value - 2.3 * rows[level].same_motion_error));
  EXPECT_LE(rows[level].same_motion.interval.low, rows[level].same_motion.value);
  EXPECT_GE(rows[level].above_mean.interval.high, rows[level].above_mean.value);
}

TEST(sensitivity, needs_three_records) {
  Suite two = test::small_suite();
  two.motions.pop_back();
  EXPECT_THROW(make_plan(sensitivity_config(), {two}), InputError);
}

}  // namespace
}  // namespace glissade
