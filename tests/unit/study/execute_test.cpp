// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/execute.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "glissade/block/slide.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/not_converged.hpp"
#include "run/capacities.hpp"
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
  return slide({roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2, ground.factors.horizontal[0],
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

/// Histories, some of which do not converge.
struct Failing : Histories {
  using Fails = std::function<bool(double)>;
  std::unique_ptr<Histories> of;
  Fails fails;
  std::vector<double> run_at, failed_at;  ///< levels, in order

  Failing(std::unique_ptr<Histories> others, Fails predicate)
      : of(std::move(others)), fails(std::move(predicate)) {}
  bool does_not_slide(double level) const override { return of->does_not_slide(level); }
  void prepare(double level) override { of->prepare(level); }
  bool is_ready(double level) const override { return fails(level) || of->is_ready(level); }
  History at(double level, std::span<Crossing> crossings, WorkCount& count) override {
    (fails(level) ? failed_at : run_at).push_back(level);
    if (fails(level)) throw NotConverged("a made-up failure");
    return of->at(level, crossings, count);
  }
  std::array<double, 2> closing_m(double) const override { return {}; }
  double tipping_level(const RigidBase&) const override { return infinity; }
};

/// Slip c (level - 0.2)^2.
struct Parabola : Histories {
  double c;
  explicit Parabola(double slip_m) : c(slip_m) {}
  bool does_not_slide(double level) const override { return level <= 0.2; }
  History at(double level, std::span<Crossing>, WorkCount& count) override {
    ++count.integrated;
    return {.peak_displacement_m = c * (level - 0.2) * (level - 0.2)};
  }
  std::array<double, 2> closing_m(double) const override { return {}; }
  double tipping_level(const RigidBase&) const override { return infinity; }
};

/// Levels and capacities as `execute` finds them.
struct Found {
  HistoryFields fields;
  WorkCount count;
  std::vector<double> run_at, failed_at;  ///< in search of the capacities
};
Found find(const StudyConfig& config, std::unique_ptr<Histories> histories, Failing::Fails fails,
           TwoAxisBatch& batch) {
  Found found;
  std::vector<std::unique_ptr<Histories>> cases;
  cases.push_back(std::make_unique<Failing>(std::move(histories), std::move(fails)));
  auto& failing = static_cast<Failing&>(*cases.front());
  for (const double level : config.intensity.levels)
    found.fields.peak_displacement_m.push_back(
        failing.does_not_slide(level)
            ? 0.0
            : run_history(failing, level, {}, found.count).peak_displacement_m);
  failing.run_at.clear();
  failing.failed_at.clear();
  find_capacities(config, cases, batch, found.fields, found.count);
  found.run_at = failing.run_at;
  found.failed_at = failing.failed_at;
  return found;
}

TEST(execute, counts_a_history_that_does_not_converge_and_goes_on) {
  Failing histories(std::make_unique<Parabola>(0.1), [](double level) { return level == 2.0; });
  Failing no_number(std::make_unique<Parabola>(std::nan("")), [](double) { return false; });
  WorkCount count;
  for (const double level : {1.0, 2.0, 3.0}) {
    const History history = run_history(histories, level, {}, count);
    EXPECT_EQ(history.failed, level == 2.0);
    EXPECT_EQ(std::isinf(history.peak_displacement_m), level == 2.0);
  }
  EXPECT_EQ(count.failed, 1u);
  EXPECT_TRUE(run_history(no_number, 1.0, {}, count).failed);
}

/// What is expected of a search over failing histories, beside the capacity without failures.
void expect_on_the_unsafe_side(const Found& found, const StudyConfig& config, double sound) {
  ASSERT_EQ(found.fields.capacity.size(), 1u);
  const double capacity = found.fields.capacity[0], highest = config.intensity.levels.back();
  const double tolerance = 1.0001 * 1e-4 * highest;
  EXPECT_GT(capacity, 0.0);
  EXPECT_LE(capacity, sound + tolerance);
  for (const double level : found.run_at) EXPECT_TRUE(0.0 <= level && level < highest) << level;
  for (const double level : found.failed_at) EXPECT_LE(capacity, level);
  EXPECT_EQ(found.fields.search_failed[0], found.failed_at.empty() ? 0 : 1);
}

// Two levels between which the threshold is reached, near them and far apart.
TEST(execute, ends_every_search_in_which_histories_do_not_converge_on_the_unsafe_side) {
  StudyConfig config = small_config();
  TwoAxisBatch none;
  int inside = 0;
  for (const double low : {0.1, 0.25, 0.5, 0.9, 0.99})
    for (const double high : {1.0, 1.1, 2.0, 10.0})
      for (const double share : {0.001, 0.1, 0.5, 0.9, 0.999})
        for (const double c : {1e-6, 1.0, 1e6}) {
          config.intensity.levels = {low, high};
          const double exact = low + share * (high - low);
          if (exact <= 0.2) continue;
          config.fragility->thresholds_m = {c * (exact - 0.2) * (exact - 0.2)};
          const auto with = [&](const Failing::Fails& fails) {
            return find(config, std::make_unique<Parabola>(c), fails, none);
          };
          const Found sound = with([](double) { return false; });
          const double capacity = sound.fields.capacity[0];
          EXPECT_NEAR(capacity, exact, 1e-4 * exact);
          EXPECT_EQ(sound.count.failed, 0u);
          const Found upper = with([&](double level) { return level == high; });
          EXPECT_NEAR(upper.fields.capacity[0], exact, 1e-4 * exact);
          EXPECT_EQ(upper.count.failed, 1u);
          expect_on_the_unsafe_side(upper, config, capacity);
          for (const double from : {low + 0.3 * (high - low), exact, std::max(low, 0.2)})
            expect_on_the_unsafe_side(with([&](double level) { return level > from; }), config,
                                      std::min(capacity, from));
          for (const double level : sound.run_at) {
            const Found one = with([&](double at) { return at == level; });
            expect_on_the_unsafe_side(one, config, capacity);
            EXPECT_EQ(one.count.failed, one.failed_at.size());
            EXPECT_LE(one.failed_at.size(), 1u) << "run again";
            inside += one.failed_at.empty() ? 0 : 1;
          }
        }
  EXPECT_GT(inside, 400);
}

TEST(execute, ends_a_search_in_which_histories_of_any_kernel_do_not_converge) {
  const auto with = [](auto change) {
    StudyConfig config = small_config();
    config.sampling.samples = 2;
    config.fragility->thresholds_m = {0.05};
    change(config);
    return config;
  };
  for (StudyConfig config :
       {with([](StudyConfig&) {}),
        with([](StudyConfig& c) { c.quantities.at("building", "mass_ratio") = fixed(0.1); }),
        with([](StudyConfig& c) { c.model.axes = SlidingAxes::two; }), with([](StudyConfig& c) {
          c.model.axes = SlidingAxes::two;
          c.base_shear = true;
        })}) {
    const Plan plan = small_plan(config);
    RoofStore roofs(plan, Skipping::all);
    for (std::size_t record = 0; record < plan.records.size(); ++record) {
      const std::vector<std::size_t> building{plan.building[0]};
      const CaseRoof roof = roofs.under(record, building)[0];
      const auto find_with = [&](const Failing::Fails& fails) {
        TwoAxisBatch batch;
        return find(plan.config, histories_of(plan, roofs, record, 0, roof, batch, {}), fails,
                    batch);
      };
      const Found sound = find_with([](double) { return false; });
      const double capacity = sound.fields.capacity[0];
      ASSERT_TRUE(std::isfinite(capacity)) << "reached at no level";
      ASSERT_FALSE(sound.run_at.empty());
      const auto& levels = config.intensity.levels;
      const double high = *std::ranges::lower_bound(levels, capacity);
      const Found upper = find_with([&](double level) { return level == high; });
      EXPECT_NEAR(upper.fields.capacity[0], capacity, 2e-4 * capacity);
      expect_on_the_unsafe_side(upper, config, capacity);
      for (const double from : {0.3, 0.9 * capacity})
        expect_on_the_unsafe_side(find_with([&](double level) { return level > from; }), config,
                                  from);
      const double third = sound.run_at[std::min<std::size_t>(2, sound.run_at.size() - 1)];
      const Found one = find_with([&](double level) { return level == third; });
      expect_on_the_unsafe_side(one, config, capacity);
      EXPECT_EQ(one.count.failed, 1u);
    }
  }
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
  EXPECT_EQ(done.decided, less.decided);  // a point of a curve is a step of a search
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
