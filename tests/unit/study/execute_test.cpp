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
          // A longer ring-down that moves nothing changes nothing but the last interval's ramp to
          // zero.
          EXPECT_NEAR(result.runs[run].peak_displacement_m[i * levels + j],
                      expected.peak_displacement_m, 1e-12 * expected.peak_displacement_m);
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
    held += result.held;
    integrated += result.integrated;
  }
  EXPECT_GT(held, 10u);
  EXPECT_EQ(held + integrated, plan.histories());
}

}  // namespace
}  // namespace glissade
