// SPDX-License-Identifier: GPL-3.0-or-later
// sampling.target_error: after which scramble a run ends, and what it then gives.
#include <gmock/gmock.h>

#include <random>

#include "glissade/study/run/sampling_progress.hpp"
#include "small_study.hpp"

namespace glissade {
namespace {

using test::bits_of;
using test::small_config;
using test::small_plan;

StudyConfig config_with(double target_error) {
  StudyConfig config = small_config();
  config.sampling.method = SamplingMethod::sobol;
  config.sampling.samples = 256;
  config.sampling.scrambles = 32;
  config.sampling.target = {target_error, 32};
  config.fragility->thresholds_m = {0.02, 0.1};
  return config;
}

/// The units of the blocks that a run needs.
std::vector<UnitResult> run_to_target(const Plan& plan) {
  SamplingProgress progress(plan);
  RoofStore roofs(plan, Skipping::all);
  std::vector<UnitResult> units;
  for (const std::size_t end : plan.unit_ends) {
    while (units.size() < end) {
      units.push_back(execute(plan, units.size(), roofs));
      progress.add(units.back());
    }
    progress.end_block();
    if (progress.is_enough()) break;
  }
  return units;
}

TEST(sampling_target, no_unit_is_of_two_blocks_and_each_block_is_whole) {
  const Plan plan = small_plan(config_with(0.1));
  ASSERT_EQ(plan.unit_ends.size(), 32u);
  const SampleBlocks blocks = plan.config.sampling.blocks();
  std::size_t unit = 0;
  for (std::size_t block = 0; block < blocks.count; ++block) {
    for (; unit < plan.unit_ends[block]; ++unit) {
      const WorkUnit& work = plan.units[unit];
      for (std::size_t i = work.first; i < work.first + work.count; ++i)
        EXPECT_EQ(plan.cases.block(plan.order[i], blocks), block);
    }
  }
  EXPECT_EQ(unit, plan.units.size());
  for (std::size_t i = 0; i < plan.cases.size(); ++i)
    EXPECT_EQ(plan.cases.block(plan.same_as[i], blocks), plan.cases.block(i, blocks));
}

TEST(sampling_target, a_run_that_ends_early_is_that_of_a_study_with_fewer_scrambles) {
  const Plan plan = small_plan(config_with(0.05));
  const std::vector<UnitResult> units = run_to_target(plan);
  const Results ended = reduce(first_blocks(plan, units.size()), units);
  ASSERT_TRUE(ended.reached_target);
  const std::uint64_t scrambles = ended.reached_target->scrambles;
  ASSERT_GT(scrambles, least_scrambles);
  ASSERT_LT(scrambles, 32u);
  EXPECT_TRUE(ended.reached_target->is_reached());
  EXPECT_EQ(ended.reached_target->most_scrambles, 32u);
  EXPECT_EQ(ended.plan_hash, plan.hash);

  StudyConfig fewer = config_with(0.05);
  fewer.sampling.samples = 8 * scrambles;
  fewer.sampling.scrambles = scrambles;
  fewer.sampling.target.reset();
  const Results whole = test::run(small_plan(fewer));
  EXPECT_EQ(bits_of(ended.histories), bits_of(whole.histories));
  ASSERT_EQ(ended.sampling_errors.size(), whole.sampling_errors.size());
  for (std::size_t i = 0; i < whole.sampling_errors.size(); ++i)
    EXPECT_EQ(ended.sampling_errors[i].sampling_error, whole.sampling_errors[i].sampling_error);
  // With a scramble fewer it was not reached.
  fewer.sampling.samples -= 8;
  --fewer.sampling.scrambles;
  double before = 0.0;
  for (const SamplingErrorRow& row : test::run(small_plan(fewer)).sampling_errors)
    before = std::max(before, half_width(row.sampling_error, scrambles - 1));
  EXPECT_GT(before, 0.05);
}

TEST(sampling_target, is_decided_by_the_blocks_alone) {
  const Plan plan = small_plan(config_with(0.05));
  std::vector<UnitResult> units = run_to_target(plan);
  const std::size_t enough = units.size();
  // What another session ran beyond it changes nothing, nor does the order.
  RoofStore roofs(plan, Skipping::all);
  while (units.size() < plan.unit_ends.back()) units.push_back(execute(plan, units.size(), roofs));
  std::ranges::reverse(units);
  SamplingProgress progress(plan);
  for (const UnitResult& unit : units) progress.add(unit);
  std::size_t block = 0;
  do progress.end_block();
  while (!progress.is_enough() && ++block < plan.unit_ends.size());
  EXPECT_EQ(plan.unit_ends[block], enough);
}

TEST(sampling_target, is_not_looked_at_before_the_scrambles_that_are_run_in_any_case) {
  StudyConfig config = config_with(0.5);
  const Plan plan = small_plan(config);
  EXPECT_EQ(run_to_target(plan).size(), plan.unit_ends[least_scrambles - 1]);
  config.sampling.scrambles_to_target = 20;
  const Plan later = small_plan(config);
  EXPECT_EQ(run_to_target(later).size(), later.unit_ends[19]);
}

TEST(sampling_target, that_is_not_reached_is_a_warning_beside_all_samples) {
  StudyConfig config = config_with(1e-4);
  config.sampling = config.sampling.first_blocks(8);
  config.sampling.target->most_scrambles = 8;
  const Plan plan = small_plan(config);
  const std::vector<UnitResult> units = run_to_target(plan);
  ASSERT_EQ(units.size(), plan.units.size());
  const Results results = reduce(first_blocks(plan, units.size()), units);
  EXPECT_FALSE(results.reached_target->is_reached());
  EXPECT_THAT(texts_of(results.warnings),
              testing::Contains(testing::HasSubstr("target_error = 0.0001")));

  config.sampling.target->error = 0.5;
  EXPECT_THAT(texts_of(test::run(small_plan(config)).warnings),
              testing::Not(testing::Contains(testing::HasSubstr("target_error"))));
}

TEST(sampling_target, without_a_fit_is_not_reached) {
  StudyConfig config = config_with(0.5);
  config.sampling = config.sampling.first_blocks(8);
  config.fragility->thresholds_m = {50.0};  // nothing slides so far
  const Results results = test::run(small_plan(config));
  EXPECT_TRUE(std::isinf(results.reached_target->error));
}

// The rule by which a run ends, on normal medians of known mean: half of the interval is then
// reached in 94 % of runs or more. 1.5 % is four standard errors of the count.
TEST(sampling_target, covers_the_median) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  constexpr int runs = 4000;
  for (const double target : {1.0, 0.5}) {
    int covered = 0;
    for (int run = 0; run < runs; ++run) {
      double sum = 0.0, squares = 0.0, mean = 0.0;
      for (std::uint64_t k = 1;; ++k) {
        const double median = normal(random);
        sum += median, squares += median * median;
        const double n = static_cast<double>(k);
        mean = sum / n;
        if (k < least_scrambles) continue;
        const double error = std::sqrt((squares / n - mean * mean) / (n - 1.0));
        if (half_width(error, k) <= target) break;
      }
      covered += std::abs(mean) <= target;
    }
    EXPECT_GT(covered, (0.94 - 0.015) * runs) << target;
  }
}

}  // namespace
}  // namespace glissade
