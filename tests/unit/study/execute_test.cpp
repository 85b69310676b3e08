// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/execute.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glissade/block/slide.hpp"
#include "glissade/building/roof_motion.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::small_config;
using test::small_suite;

/// A unit's sample computed by hand: the building, then the block, with the ring-down followed to
/// silence.
SlipResult by_hand(const Plan& plan, std::size_t record, std::size_t sample, std::size_t run,
                   double level) {
  const SamplePoint& p = plan.samples[sample];
  const Motion& m = plan.suite.motions[record];
  const RoofMotion roof = roof_motion(
      {m.dt_s, m.horizontal_mps2[static_cast<std::size_t>(p.component)], m.vertical_mps2},
      {{p.period_s, p.damping}, {}}, {.quiet_horizontal_mps2 = 1e-4});
  const double factor = level * plan.factor_at_unit_level[record];
  return slide(
      {roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2, p.sign * factor, factor},
      {.friction = plan.runs[run].friction[sample], .slope_rad = p.slope_deg * rad_per_deg});
}

TEST(execute, gives_the_slip_that_building_and_block_give) {
  const Plan plan = make_plan(small_config(), small_suite());
  int slid = 0;
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const WorkUnit& unit = plan.units[u];
    const UnitResult result = execute(plan, u);
    const std::size_t levels = plan.config.intensity.levels.size();
    for (std::size_t run = 0; run < 2; ++run) {
      for (std::size_t i = 0; i < unit.sample_count; ++i) {
        for (std::size_t j = 0; j < levels; ++j) {
          const SlipResult expected = by_hand(plan, unit.record, unit.first_sample + i, run,
                                              plan.config.intensity.levels[j]);
          // The reference is linear between samples, at least 1,000 a period.
          EXPECT_NEAR(result.runs[run].peak_displacement_m[i * levels + j],
                      expected.peak_displacement_m,
                      (expected.uplift ? 1e-3 : 2e-5) * expected.peak_displacement_m + 2e-6);
          EXPECT_EQ(result.runs[run].uplift[i * levels + j], expected.uplift ? 1 : 0);
          slid += expected.peak_displacement_m > 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(slid, 500);
}

TEST(execute, finds_capacities_at_which_slip_equals_the_clearance) {
  const Plan plan = make_plan(small_config(), small_suite());
  int reached = 0, censored = 0;
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const WorkUnit& unit = plan.units[u];
    const UnitResult result = execute(plan, u);
    const auto& thresholds = plan.config.thresholds_m;
    for (std::size_t i = 0; i < unit.sample_count; ++i) {
      for (std::size_t t = 0; t < thresholds.size(); ++t) {
        const double capacity = result.runs[0].capacity[i * thresholds.size() + t];
        if (std::isinf(capacity)) {
          ++censored;
          EXPECT_LT(
              result.runs[0].peak_displacement_m[(i + 1) * plan.config.intensity.levels.size() - 1],
              thresholds[t]);
          continue;
        }
        ++reached;
        // Slip grows about as (x - x_yield)^2: 1e-4 of intensity is well below 1 % of slip here.
        const double slip =
            by_hand(plan, unit.record, unit.first_sample + i, 0, capacity).peak_displacement_m;
        EXPECT_NEAR(slip, thresholds[t], 0.01 * thresholds[t]);
        if (t > 0) {
          EXPECT_GE(capacity, result.runs[0].capacity[i * thresholds.size() + t - 1]);
        }
      }
    }
  }
  EXPECT_GT(reached, 100);
  EXPECT_GT(censored, 5);
}

TEST(execute, gives_capacity_zero_to_a_block_that_gets_there_without_shaking) {
  StudyConfig config = small_config();
  config.roof.slope_deg = Fixed{30.0};
  config.friction.mu = Fixed{0.5};
  const Plan plan = make_plan(config, small_suite());
  const UnitResult result = execute(plan, 0);
  for (const double capacity : result.runs[0].capacity) EXPECT_EQ(capacity, 0.0);
}

TEST(execute, scales_the_roof_to_the_peak_roof_acceleration) {
  StudyConfig config = small_config();
  config.intensity.measure = IntensityMeasure::ppa_g;
  config.intensity.levels = {0.29, 0.31};
  config.standards.compare.clear();
  config.roof.slope_deg = Fixed{0.0};
  config.friction.mu = Fixed{0.3};
  config.vertical.use = VerticalChoice::none;
  const Plan plan = make_plan(config, small_suite());
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const UnitResult result = execute(plan, u);
    for (std::size_t i = 0; i < result.runs[0].peak_displacement_m.size(); i += 2) {
      EXPECT_EQ(result.runs[0].peak_displacement_m[i], 0.0);  // peak roof acceleration below mu g
      EXPECT_GT(result.runs[0].peak_displacement_m[i + 1], 0.0);  // above
    }
  }
}

TEST(execute, does_not_integrate_histories_that_cannot_slip) {
  const Plan plan = make_plan(small_config(), small_suite());
  std::uint64_t held = 0, integrated = 0;
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const UnitResult result = execute(plan, u);
    held += result.count.held;
    integrated += result.count.integrated;
  }
  EXPECT_GT(held, 10u);
  EXPECT_EQ(held + integrated, plan.histories());
}

/// Every number of every unit, and what was counted.
struct Outcome {
  std::vector<double> numbers;
  WorkCount count;
};
Outcome all_units(const Plan& plan, Skipping skipping) {
  Outcome all;
  RoofStore roofs(plan, skipping);
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const UnitResult result = execute(plan, u, roofs);
    for (const UnitResult::Run& run : result.runs) {
      all.numbers.insert(all.numbers.end(), run.peak_displacement_m.begin(),
                         run.peak_displacement_m.end());
      all.numbers.insert(all.numbers.end(), run.uplift.begin(), run.uplift.end());
      all.numbers.insert(all.numbers.end(), run.capacity.begin(), run.capacity.end());
    }
    all.count += result.count;
  }
  return all;
}

/// Skipping changes no bit; returns what it counted.
WorkCount expect_skips_change_nothing(const Plan& plan) {
  const Outcome skipped = all_units(plan, Skipping::all), done = all_units(plan, Skipping::none);
  EXPECT_EQ(skipped.numbers, done.numbers);
  EXPECT_EQ(done.count.held, 0u);
  EXPECT_EQ(done.count.from_curve, 0u);
  EXPECT_GE(done.count.integrated, skipped.count.integrated);
  // A roof for every history, and one to begin a sample with.
  EXPECT_GE(done.count.roofs, done.count.integrated + done.count.searched);
  EXPECT_EQ(done.count.beyond, 0u);
  return skipped.count;
}

TEST(execute, gives_the_same_bits_when_histories_that_cannot_slip_are_integrated) {
  EXPECT_GT(expect_skips_change_nothing(make_plan(small_config(), small_suite())).held, 10u);
}

TEST(execute, gives_the_same_bits_when_a_vertical_that_is_not_there_is_run) {
  StudyConfig config = small_config();
  config.vertical.use = VerticalChoice::none;
  expect_skips_change_nothing(make_plan(config, small_suite()));
}

TEST(execute, makes_one_roof_motion_for_all_samples_of_one_building) {
  for (const double period : {0.0, 0.4}) {
    StudyConfig config = small_config();
    config.building.period_s = Fixed{period};
    const WorkCount count = expect_skips_change_nothing(make_plan(config, small_suite()));
    EXPECT_EQ(count.roofs, 6u);  // three records, two components
  }
}

TEST(execute, computes_a_point_of_a_flat_roof_s_curve_once) {
  StudyConfig config = small_config();
  config.vertical.use = VerticalChoice::none;
  config.roof.slope_deg = Fixed{0.0};
  for (const double period : {0.0, 0.4}) {
    config.building.period_s = Fixed{period};
    config.friction.mu = Fixed{0.2};
    const WorkCount count = expect_skips_change_nothing(make_plan(config, small_suite()));
    EXPECT_LE(count.integrated, 6 * config.intensity.levels.size());
    EXPECT_GT(count.from_curve, 10 * count.integrated);
  }
}

TEST(execute, runs_no_level_above_the_largest_threshold_where_none_is_asked) {
  StudyConfig config = small_config();
  config.stop_at_largest_threshold = true;
  config.thresholds_m = {0.02, 0.1};
  const Plan plan = make_plan(config, small_suite());
  const WorkCount stopped = expect_skips_change_nothing(plan);
  EXPECT_GT(stopped.beyond, 100u);
  EXPECT_EQ(stopped.beyond + stopped.integrated + stopped.held, plan.histories());
  config.stop_at_largest_threshold = false;
  const Plan all = make_plan(config, small_suite());
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const UnitResult with = execute(plan, u), without = execute(all, u);
    for (std::size_t r = 0; r < with.runs.size(); ++r) {
      EXPECT_EQ(with.runs[r].capacity, without.runs[r].capacity);
      for (std::size_t i = 0; i < with.runs[r].peak_displacement_m.size(); ++i) {
        const double slip = with.runs[r].peak_displacement_m[i];
        if (std::isfinite(slip)) {
          EXPECT_EQ(slip, without.runs[r].peak_displacement_m[i]);
        }
      }
    }
  }
}

}  // namespace
}  // namespace glissade
