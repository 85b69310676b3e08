// SPDX-License-Identifier: GPL-3.0-or-later
// Small probabilities, and the error of the samples beside that of the records.
#include "glissade/study/analysis/rare.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/normal.hpp"
#include "glissade/study/cases/sample_points.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::drawn;
using test::fixed;
using test::small_config;
using test::small_plan;

/// Friction alone is drawn, on a rigid flat roof.
StudyConfig friction_config() {
  StudyConfig config = small_config();
  config.quantities.at("building", "period_s") = fixed(0.0);
  config.quantities.at("roof", "slope_deg") = fixed(0.0);
  config.quantities.at("friction", "mu") = drawn(TruncatedNormal{0.4, 0.05, 0.0, INFINITY});
  config.friction.values = {FrictionValue::as_drawn};
  config.orientation.choice = OrientationChoice::as_recorded;
  config.vertical = {VerticalChoice::none};
  config.standards.compare.clear();
  config.fragility.reset();
  config.sampling.method = SamplingMethod::sobol;
  config.sampling.samples = 1024;
  config.sampling.scrambles = 16;
  config.rare = RareConfig{.thresholds_m = {0.02}};
  return config;
}

/// The friction at which each record slips the threshold at each level, from a grid of frictions:
/// slip falls with friction on a flat rigid roof, but for recrossings, which the test excludes.
std::vector<std::vector<double>> critical_frictions(const StudyConfig& rare) {
  constexpr std::size_t grid = 600;
  StudyConfig config = rare;
  config.rare.reset();
  config.sampling.scrambles = 1;
  std::vector<double> frictions;
  for (std::size_t i = 1; i <= grid; ++i) frictions.push_back(0.001 * static_cast<double>(i));
  config.quantities.at("friction", "mu") = test::listed(frictions);
  const Results results = test::run(small_plan(config));
  std::vector<std::vector<double>> critical(3, std::vector<double>(results.levels.size()));
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t level = 0; level < results.levels.size(); ++level) {
      for (std::size_t i = 0; i < grid; ++i) {
        if (results.histories.displacement_m(r, i, level) >= 0.02)
          critical[r][level] = frictions[i] + 0.0005;
      }
    }
  }
  return critical;
}

TEST(rare, probabilities_of_slip_are_those_of_the_friction_at_which_each_record_slips) {
  const StudyConfig config = friction_config();
  const Results results = test::run(small_plan(config));
  const auto critical = critical_frictions(config);
  ASSERT_EQ(results.rare->rows.size(), results.levels.size());
  int small = 0;
  for (std::size_t level = 0; level < results.levels.size(); ++level) {
    double low = 0.0, high = 0.0;
    for (std::size_t r = 0; r < 3; ++r) {  // the grid's step
      low += normal_cdf((critical[r][level] - 0.001 - 0.4) / 0.05) / 3.0;
      high += normal_cdf((critical[r][level] + 0.001 - 0.4) / 0.05) / 3.0;
    }
    const RareRow& row = results.rare->rows[level];
    if (low < 1e-9) continue;
    const double error =
        std::isnan(row.sampling_interval.low) ? 0.0 : row.sampling_interval.high - row.probability;
    EXPECT_GE(row.probability + 2.0 * error, low) << level;
    EXPECT_LE(row.probability - 2.0 * error, high) << level;
    if (high < 1e-2) ++small;
  }
  EXPECT_GE(small, 1);
}

TEST(rare, has_an_interval_of_the_samples_where_enough_of_them_carry_the_probability) {
  StudyConfig config = friction_config();
  config.rare->thresholds_m = {0.02, 100.0};
  const Results results = test::run(small_plan(config));
  int with = 0, without = 0;
  for (const RareRow& row : results.rare->rows) {
    const bool enough = row.effective_samples >= 5.0;
    EXPECT_EQ(std::isnan(row.sampling_interval.low), !enough) << row.level;
    EXPECT_LE(row.effective_samples, 1024.0 * (1.0 + 1e-12));
    (enough ? with : without) += 1;
  }
  EXPECT_GE(with, 1);
  EXPECT_GE(without, 1);
}

TEST(rare, weights_are_by_sample_and_of_mean_one) {
  const StudyConfig config = friction_config();
  const Results results = test::run(small_plan(config));
  double sum = 0.0;
  for (const double w : results.rare->weights) sum += w / 1024.0;
  EXPECT_NEAR(sum, 1.0, 0.02);
  EXPECT_EQ(results.rare->weights[7], SamplePoints(config).weight(7));
  StudyConfig plain = config;
  plain.rare.reset();
  EXPECT_EQ(SamplePoints(plain).weight(7), 1.0);
}

TEST(scrambles, keep_the_samples_of_the_first) {
  StudyConfig config = small_config();
  config.sampling.method = SamplingMethod::sobol;
  config.sampling.samples = 64;
  const SamplePoints whole(config);
  config.sampling.scrambles = 4;
  const SamplePoints parts(config);
  for (std::uint64_t k = 0; k < 16; ++k) EXPECT_EQ(parts.coordinate(k, 0), whole.coordinate(k, 0));
  EXPECT_NE(parts.coordinate(16, 0), whole.coordinate(0, 0));
  EXPECT_NE(parts.coordinate(16, 0), parts.coordinate(0, 0));
}

TEST(scrambles, give_the_error_of_the_samples_beside_that_of_the_records) {
  StudyConfig config = small_config();
  config.sampling.method = SamplingMethod::sobol;
  config.sampling.samples = 64;
  EXPECT_TRUE(test::run(small_plan(config)).sampling_errors.empty());
  config.sampling.scrambles = 8;
  const Results results = test::run(small_plan(config));
  ASSERT_EQ(results.sampling_errors.size(), 6u);  // two frictions, three thresholds
  const SamplingErrorRow& row = results.sampling_errors.front();
  EXPECT_EQ(row.median, results.runs[0].fragilities[0].capacities.curve.median);
  EXPECT_GT(row.sampling_error, 0.0);
  EXPECT_GT(row.record_error, row.sampling_error);
}

TEST(scrambles, give_no_median_where_the_fit_gives_a_bound_of_it) {
  StudyConfig config = small_config();
  config.sampling.method = SamplingMethod::sobol;
  config.sampling.samples = 64;
  config.sampling.scrambles = 8;
  config.fragility->thresholds_m = {1e4};
  const Results results = test::run(small_plan(config));
  ASSERT_EQ(results.runs[0].fragilities[0].capacities.status, FitStatus::lower_bound);
  EXPECT_TRUE(std::isnan(results.sampling_errors.front().median));
}

}  // namespace
}  // namespace glissade
