// SPDX-License-Identifier: GPL-3.0-or-later
// Multiple stripes: a suite for each level.

#include <gmock/gmock.h>

#include <algorithm>

#include "facts.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::small_suite;

/// Two suites with the records of small_suite(), but for one that is in both.
std::vector<Suite> two_stripes() {
  Suite low = small_suite(), high = small_suite();
  low.name = "low";
  high.name = "high";
  for (Motion& motion : high.motions) {
    motion.id += " of the other";
    if (motion.id.starts_with("motion0")) continue;
    for (Samples& component : motion.horizontal_mps2) {
      std::vector<double> other = component.copy();
      std::ranges::reverse(other);
      component = other;
    }
  }
  return {low, high};
}

StudyConfig stripes_config() {
  StudyConfig config = test::small_config();
  config.suite_files = {"low.toml", "high.toml"};
  config.by_stripes = true;
  config.intensity.measure = IntensityMeasure::pga_g;
  config.intensity.levels = {0.4, 1.5};
  config.standards.compare.clear();
  config.fragility->thresholds_m = {0.02, 0.1};
  return config;
}

TEST(stripes, run_each_record_at_the_level_of_its_suite_alone) {
  const Plan plan = make_plan(stripes_config(), two_stripes());
  EXPECT_EQ(plan.histories(), 6u * plan.order.size());
  const Results results = test::run(plan);
  EXPECT_EQ(results.histories.levels, 1u);
  EXPECT_EQ(results.histories.records_at(0), 3u);
  EXPECT_FALSE(results.histories.has(0, 1));
  EXPECT_TRUE(results.histories.has(3, 1));
  EXPECT_TRUE(results.histories.fields.capacity.empty());
}

// The kernels do not know of stripes: bit by bit what the same suite gives at all levels.
TEST(stripes, give_the_histories_of_the_same_suite_at_all_levels) {
  const Results stripes = test::run(make_plan(stripes_config(), two_stripes()));
  for (std::size_t level = 0; level < 2; ++level) {
    StudyConfig all = stripes_config();
    all.by_stripes = false;
    all.suite_files = {"suite.toml"};
    const Results whole = test::run(make_plan(all, {two_stripes()[level]}));
    for (std::size_t record = 0; record < 3; ++record)
      for (std::size_t c = 0; c < whole.histories.cases; ++c)
        EXPECT_EQ(stripes.histories.displacement_m(3 * level + record, c, level),
                  whole.histories.displacement_m(record, c, level));
  }
}

/// The counts of a run by hand: those of the records of each motion together.
std::vector<Stripe> counted(const Results& results, const RunResults& run, double threshold_m,
                            bool motions_together) {
  std::vector<Stripe> data;
  for (std::size_t record = 0; record < results.records.size(); ++record) {
    const std::size_t level = record / 3, motion = motions_together && record == 3 ? 0 : record;
    Stripe of{results.levels[level], 0.0, 0.0, 1.0, motion}, free{0.0, 0.0, 0.0, 1.0, motion};
    for (std::size_t i = run.first_case; i < run.first_case + run.cases; ++i) {
      if (slides_freely(results.cases.cases[i])) {
        free.trials = ++free.exceedances;
        continue;
      }
      of.trials += 1.0;
      if (results.histories.displacement_m(record, i, level) >= threshold_m) of.exceedances += 1.0;
    }
    data.push_back(of);
    if (motion == record) data.push_back(free);
  }
  return data;
}

TEST(stripes, are_fitted_by_motion_so_that_one_in_two_stripes_is_one_unit) {
  const Results results = test::run(make_plan(stripes_config(), two_stripes()));
  const RunResults& run = results.runs.front();
  const ThresholdFragility& fragility = run.fragilities[0];
  ASSERT_TRUE(fragility.on_stripes);
  const auto fitted = [&](bool motions_together) {
    return fit_stripes(counted(results, run, fragility.threshold_m, motions_together),
                       Independent::records);
  };
  const FitSummary expected = fitted(true);
  EXPECT_EQ(fragility.stripes.status, expected.status);
  EXPECT_EQ(fragility.stripes.curve.median, expected.curve.median);
  EXPECT_EQ(fragility.stripes.curve.log_std, expected.curve.log_std);
  EXPECT_EQ(fragility.stripes.median_interval.low, expected.median_interval.low);
  EXPECT_NE(fitted(false).median_interval.low, expected.median_interval.low);
  EXPECT_EQ(fragility.capacities.status, FitStatus::failed);
  EXPECT_EQ(fragility.stripes.band.size(), run.band_intensities.size());
}

TEST(stripes, have_shares_and_slips_of_the_records_of_their_level) {
  const Results results = test::run(make_plan(stripes_config(), two_stripes()));
  const RunResults& run = results.runs.front();
  for (std::size_t level = 0; level < 2; ++level) {
    double sum = 0.0, exceeding = 0.0;
    for (std::size_t record = 3 * level; record < 3 * level + 3; ++record) {
      for (std::size_t i = run.first_case; i < run.first_case + run.cases; ++i) {
        const double slip_m = results.histories.displacement_m(record, i, level);
        sum += slip_m;
        exceeding += slip_m >= 0.02 ? 1.0 : 0.0;
      }
    }
    const double histories = 3.0 * static_cast<double>(run.cases);
    EXPECT_NEAR(run.slip[level].mean_m, sum / histories, 1e-12 * sum);
    EXPECT_EQ(run.fragilities[0].probability[level], exceeding / histories);
  }
}

TEST(stripes, are_warned_of_where_their_file_scales_them_to_another_level) {
  std::vector<Suite> swapped = two_stripes();
  const Plan plain = make_plan(stripes_config(), swapped);
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t m = 0; m < 3; ++m)
      swapped[s].motions[m].scale =
          plain.factor_at_unit_level[3 * s + m] * stripes_config().intensity.levels[1 - s];
  EXPECT_THAT(make_plan(stripes_config(), swapped).warnings,
              testing::Contains(test::states("low", "selected for another level")));
  for (std::size_t s = 0; s < 2; ++s)
    for (std::size_t m = 0; m < 3; ++m)
      swapped[s].motions[m].scale =
          plain.factor_at_unit_level[3 * s + m] * stripes_config().intensity.levels[s];
  EXPECT_THAT(make_plan(stripes_config(), swapped).warnings,
              testing::Not(testing::Contains(test::states("another level"))));
}

TEST(stripes, of_records_nearest_to_a_target_are_warned_of_with_the_remedy) {
  std::vector<Suite> suites = two_stripes();
  suites[0].nearest_to_target = true;
  EXPECT_THAT(make_plan(stripes_config(), suites).warnings,
              testing::Contains(test::states("low", "scatter less", "suite.stripes")));
}

}  // namespace
}  // namespace glissade
