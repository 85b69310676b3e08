// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/execute.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "glissade/block/slide.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/not_converged.hpp"
#include "run/histories.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::bits_of;
using test::fixed;
using test::small_config;
using test::small_plan;

/// A history by itself: the building, then the block, with the ring-down followed to silence.
SlipResult by_hand(const Plan& plan, std::size_t record, const Case& c, double level) {
  const test::CaseGround ground = test::ground_of(plan, record, c, level);
  const RoofMotion roof =
      roof_motion(ground.motion, {{c.period_s, c.damping}, {}}, {.quiet_horizontal_mps2 = 1e-4});
  return slide({roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2, ground.factors.horizontal,
                ground.factors.vertical},
               {.friction = c.friction, .slope_rad = c.slope_deg * rad_per_deg});
}

TEST(execute, gives_the_slip_that_building_and_block_give) {
  const Plan plan = small_plan(small_config());
  const HistoryTable table = test::run(plan).histories;
  int slid = 0;
  test::for_each_history(table, [&](std::size_t record, std::size_t c, std::size_t level) {
    const SlipResult expected =
        by_hand(plan, record, plan.cases[c], plan.config.intensity.levels[level]);
    // The reference is linear between samples, at least 1,000 a period.
    EXPECT_NEAR(table.displacement_m(record, c, level), expected.peak_displacement_m,
                (expected.uplift ? 1e-3 : 2e-5) * expected.peak_displacement_m + 2e-6);
    EXPECT_EQ(table.fields.uplift[table.at(record, c, level)], expected.uplift ? 1 : 0);
    slid += expected.peak_displacement_m > 0 ? 1 : 0;
  });
  EXPECT_GT(slid, 500);
}

TEST(execute, counts_a_history_that_does_not_converge_and_goes_on) {
  struct DoesNotConverge : Histories {
    bool does_not_slide(double) const override { return false; }
    History at(double level, std::span<Crossing>, WorkCount&) override {
      if (level == 2.0) throw NotConverged("a made-up failure");
      return {.peak_displacement_m = 0.1};
    }
    std::array<double, 2> closing_m(double) const override { return {}; }
    double tipping_level(const RigidBase&) const override { return infinity; }
  } histories;
  WorkCount count;
  for (const double level : {1.0, 2.0, 3.0}) {
    const History history = run_history(histories, level, {}, count);
    EXPECT_EQ(history.failed, level == 2.0);
    EXPECT_EQ(std::isinf(history.peak_displacement_m), level == 2.0);
  }
  EXPECT_EQ(count.failed, 1u);
}

TEST(execute, finds_capacities_at_which_slip_equals_the_clearance) {
  StudyConfig config = small_config();
  config.friction.values = {FrictionValue::as_drawn};
  const Plan plan = small_plan(config);
  const HistoryTable table = test::run(plan).histories;
  const std::vector<double>& thresholds = config.thresholds_m();
  int reached = 0, censored = 0;
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t c = 0; c < table.cases; ++c) {
      for (std::size_t t = 0; t < thresholds.size(); ++t) {
        const double capacity = table.capacity(record, c, t);
        if (std::isinf(capacity)) {
          ++censored;
          EXPECT_LT(table.displacement_m(record, c, table.levels - 1), thresholds[t]);
          continue;
        }
        ++reached;
        // Slip grows about as (x - x_yield)^2: 1e-4 of intensity is well below 1 % of slip here.
        const double slip = by_hand(plan, record, plan.cases[c], capacity).peak_displacement_m;
        EXPECT_NEAR(slip, thresholds[t], 0.01 * thresholds[t]);
        if (t > 0) {
          EXPECT_GE(capacity, table.capacity(record, c, t - 1));
        }
      }
    }
  }
  EXPECT_GT(reached, 100);
  EXPECT_GT(censored, 5);
}

TEST(execute, gives_capacity_zero_to_a_block_that_gets_there_without_shaking) {
  StudyConfig config = small_config();
  config.quantities.at("roof", "slope_deg") = fixed(30.0);
  config.quantities.at("friction", "mu") = fixed(0.5);
  const UnitResult result = execute(small_plan(config), 0);
  ASSERT_FALSE(result.fields.capacity.empty());
  for (const double capacity : result.fields.capacity) EXPECT_EQ(capacity, 0.0);
}

TEST(execute, scales_the_roof_to_the_peak_roof_acceleration) {
  StudyConfig config = small_config();
  config.intensity.measure = IntensityMeasure::ppa_g;
  config.intensity.levels = {0.29, 0.31};
  config.standards.compare.clear();
  config.quantities.at("roof", "slope_deg") = fixed(0.0);
  config.quantities.at("friction", "mu") = fixed(0.3);
  config.vertical = {VerticalChoice::none};
  const HistoryTable table = test::run(small_plan(config)).histories;
  for (std::size_t record = 0; record < table.records; ++record) {
    for (std::size_t c = 0; c < table.cases; ++c) {
      EXPECT_EQ(table.displacement_m(record, c, 0), 0.0);  // peak roof acceleration below mu g
      EXPECT_GT(table.displacement_m(record, c, 1), 0.0);  // above
    }
  }
}

TEST(execute, does_not_integrate_histories_that_cannot_slip) {
  const Plan plan = small_plan(small_config());
  const WorkCount count = test::total_count(test::execute_all(plan));
  EXPECT_GT(count.below_yield, 10u);
  EXPECT_EQ(count.below_yield + count.integrated, plan.histories());
}

/// Skipping changes no bit; returns what it counted.
WorkCount expect_skips_change_nothing(const Plan& plan) {
  const std::vector<UnitResult> skipped = test::execute_all(plan);
  const std::vector<UnitResult> all = test::execute_all(plan, Skipping::none);
  for (std::size_t u = 0; u < all.size(); ++u)
    EXPECT_EQ(bits_of({.fields = skipped[u].fields}), bits_of({.fields = all[u].fields}));
  const WorkCount less = test::total_count(skipped), done = test::total_count(all);
  EXPECT_EQ(done.below_yield, 0u);
  EXPECT_EQ(done.from_curve, 0u);
  EXPECT_EQ(done.beyond, 0u);
  EXPECT_GE(done.integrated, less.integrated);
  // A roof for every history, and one to begin a case with.
  EXPECT_GE(done.roofs, done.integrated + done.searched);
  return less;
}

TEST(execute, gives_the_same_bits_when_histories_that_cannot_slip_are_integrated) {
  EXPECT_GT(expect_skips_change_nothing(small_plan(small_config())).below_yield, 10u);
}

TEST(execute, gives_the_same_bits_when_a_vertical_that_is_not_there_is_run) {
  StudyConfig config = small_config();
  config.vertical = {VerticalChoice::none};
  expect_skips_change_nothing(small_plan(config));
}

TEST(execute, makes_one_roof_motion_for_all_samples_of_one_building) {
  for (const double period : {0.0, 0.4}) {
    StudyConfig config = small_config();
    config.quantities.at("building", "period_s") = fixed(period);
    const WorkCount count = expect_skips_change_nothing(small_plan(config));
    EXPECT_EQ(count.roofs, 6u);  // three records, two components
  }
}

TEST(execute, computes_a_point_of_a_flat_roof_s_curve_once) {
  StudyConfig config = small_config();
  config.vertical = {VerticalChoice::none};
  config.quantities.at("roof", "slope_deg") = fixed(0.0);
  config.quantities.at("friction", "mu") = test::listed({0.2, 0.4});
  config.intensity.levels = {0.5, 1.0, 2.0, 4.0};
  for (const double period : {0.0, 0.4}) {
    config.quantities.at("building", "period_s") = fixed(period);
    const Plan plan = small_plan(config);
    EXPECT_EQ(plan.order.size(), 4u);  // frictions x components: nothing else counts on a flat roof
    const WorkCount count = expect_skips_change_nothing(plan);
    EXPECT_LE(count.integrated, 6 * 5u);  // mu / lambda: 0.2 and 0.4 over four levels, five values
    EXPECT_GE(count.from_curve, 6u);
  }
}

TEST(execute, runs_no_level_above_the_largest_threshold_where_the_study_stops_there) {
  StudyConfig config = small_config();
  config.fragility = FragilityConfig{.thresholds_m = {0.02, 0.1}, .stop_at_largest = true};
  const Plan plan = small_plan(config);
  const WorkCount stopped = expect_skips_change_nothing(plan);
  EXPECT_GT(stopped.beyond, 100u);
  EXPECT_EQ(stopped.beyond + stopped.integrated + stopped.below_yield, plan.histories());
  const HistoryTable with = test::run(plan).histories;
  config.fragility->stop_at_largest = false;
  const HistoryTable without = test::run(small_plan(config)).histories;
  EXPECT_EQ(with.fields.capacity, without.fields.capacity);
  for (std::size_t i = 0; i < with.fields.peak_displacement_m.size(); ++i) {
    const double slip = with.fields.peak_displacement_m[i];
    if (std::isfinite(slip)) {
      EXPECT_EQ(slip, without.fields.peak_displacement_m[i]);
    }
  }
}

}  // namespace
}  // namespace glissade
