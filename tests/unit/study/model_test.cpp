// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <set>

#include "glissade/block/coupled.hpp"
#include "glissade/block/on_building.hpp"
#include "glissade/core/error.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/study/run/execute.hpp"
#include "glissade/study/run/reduce.hpp"
#include "glissade/study/run/scene.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::drawn;
using test::fixed;
using test::for_each_history;
using test::ground_of;
using test::small_config;
using test::small_plan;
using test::small_suite;
using testing::HasSubstr;

/// Ten samples, four levels, without standards and design friction.
StudyConfig tiny_config() {
  StudyConfig c = small_config();
  c.intensity.levels = {0.5, 1.0, 2.0, 3.0};
  c.sampling.samples = 10;
  c.standards.compare.clear();
  c.friction.values = {FrictionValue::as_drawn};
  return c;
}

StudyConfig two_axis_config() {
  StudyConfig c = tiny_config();
  c.model.axes = SlidingAxes::two;
  c.quantities.at("building", "mass_ratio") = drawn(Uniform{0.02, 0.2});
  c.quantities.at("building", "period_ratio") = fixed(0.7);
  c.friction.across_is_given = true;
  c.quantities.at("friction", "across_mu") = drawn(TruncatedNormal{0.3, 0.04, 0.0, INFINITY});
  c.quantities.at("roof", "azimuth_deg") = drawn(Uniform{0.0, 90.0});
  return c;
}

Kernel kernel_of(const StudyConfig& config) { return cheapest_exact_kernel(config).kernel; }

TEST(cheapest_exact_kernel, is_the_first_that_has_all_the_study_asks_for) {
  StudyConfig config = tiny_config();
  EXPECT_EQ(kernel_of(config), Kernel::tables);
  config.quantities.at("vertical", "period_s") =
      fixed(0.2);  // tables are exact for any roof motion
  EXPECT_EQ(kernel_of(config), Kernel::tables);
  config.quantities.at("building", "mass_ratio") = fixed(0.05);
  EXPECT_EQ(kernel_of(config), Kernel::full);  // the coupled kernel's vertical is the ground's
  config.quantities.at("vertical", "period_s") = fixed(0.0);
  EXPECT_EQ(kernel_of(config), Kernel::coupled);
  config.quantities.at("building", "yield_coefficient") = fixed(0.3);
  EXPECT_EQ(kernel_of(config), Kernel::coupled);
  config.model.axes = SlidingAxes::two;
  EXPECT_EQ(kernel_of(config), Kernel::full);
}

TEST(cheapest_exact_kernel, needs_no_coupling_with_a_building_that_does_not_move) {
  StudyConfig config = tiny_config();
  config.quantities.at("building", "period_s") = fixed(0.0);
  config.quantities.at("building", "mass_ratio") = fixed(0.3);
  EXPECT_EQ(kernel_of(config), Kernel::tables);
}

TEST(cheapest_exact_kernel, keeps_friction_that_is_stronger_at_rest_exact_on_one_axis) {
  StudyConfig config = tiny_config();
  config.quantities.at("friction", "static_over_sliding") = fixed(1.2);
  EXPECT_EQ(kernel_of(config), Kernel::coupled);
  config.model.axes = SlidingAxes::two;
  EXPECT_EQ(kernel_of(config), Kernel::full);
}

TEST(cheapest_exact_kernel, gives_friction_that_depends_on_speed_to_the_full_model) {
  StudyConfig config = tiny_config();
  config.quantities.at("friction", "fast_over_slow") = fixed(1.3);
  config.quantities.at("friction", "rate_s_per_m") = fixed(10.0);
  EXPECT_EQ(kernel_of(config), Kernel::full);
  config.quantities.at("friction", "fast_over_slow") = fixed(1.0);
  EXPECT_EQ(kernel_of(config), Kernel::tables);
}

TEST(kernel_text, names_the_functions_that_compute_the_histories) {
  const auto text = [](const StudyConfig& config) { return describe(kernel_of(config), config); };
  StudyConfig config = two_axis_config();
  EXPECT_THAT(text(config), testing::EndsWith("(peak_slip_two_axes)"));
  config.building.kind = BuildingModel::Kind::cantilever;  // several modes, coupled
  EXPECT_THAT(text(config), testing::EndsWith("(peak_slip_two_axes)"));
  EXPECT_LT(history_us(Kernel::full, config), 500.0);
  config.base_shear = true;
  EXPECT_THAT(text(config), testing::EndsWith("(slide_on_building)"));
  config = two_axis_config();
  config.base_shear = true;
  EXPECT_THAT(text(config), testing::EndsWith("(peak_slip_two_axes)"));
  config = two_axis_config();
  config.quantities.at("friction", "static_over_sliding").values = {1.0, 1.2};
  config.quantities.at("building", "response_modification").values = {0.0, 2.0};
  EXPECT_THAT(text(config), testing::EndsWith("(peak_slip_two_axes)"));
  config.quantities.at("friction", "rate_s_per_m") = fixed(20.0);
  config.quantities.at("friction", "fast_over_slow").values = {1.0, 1.2};
  EXPECT_THAT(text(config), testing::EndsWith("(peak_slip_two_axes)"));
  config = two_axis_config();
  config.quantities.at("friction", "static_over_sliding").values = {1.0, 1.2};
  config.model.axes = SlidingAxes::one;
  config.quantities.at("building", "mass_ratio") = fixed(0.1);
  EXPECT_THAT(text(config), testing::HasSubstr("error-controlled (peak_slip_two_axes)"));
}

TEST(execute_coupled, gives_the_slip_of_the_readable_scheme) {
  StudyConfig config = tiny_config();
  config.quantities.at("building", "mass_ratio") = drawn(Uniform{0.02, 0.3});
  const Plan plan = small_plan(config);
  ASSERT_EQ(plan.kernel.kernel, Kernel::coupled);
  const HistoryTable table = test::run(plan).histories;
  int slid = 0;
  for_each_history(table, [&](std::size_t record, std::size_t i, std::size_t level) {
    const Case c = plan.cases[i];
    const auto ground = ground_of(plan, record, c, config.intensity.levels[level]);
    const CoupledResult expected =
        slide_coupled(ground.motion, ground.factors, {{c.period_s, c.damping}, c.mass_ratio},
                      {.friction = c.friction, .slope_rad = c.slope_deg * rad_per_deg});
    // Where the block lifts off, the steps of the lanes are of lower order.
    EXPECT_NEAR(table.displacement_m(record, i, level), expected.slip.peak_displacement_m,
                (expected.slip.uplift ? 1e-4 : 1e-5) * expected.slip.peak_displacement_m + 1e-9);
    slid += expected.slip.peak_displacement_m > 1e-3 ? 1 : 0;
  });
  EXPECT_GT(slid, 40);
}

TEST(execute_coupled, a_very_light_array_slides_as_one_without_mass) {
  StudyConfig config = tiny_config();
  const HistoryTable a = test::run(small_plan(config)).histories;
  config.quantities.at("building", "mass_ratio") = fixed(1e-12);
  const Plan light = small_plan(config);
  ASSERT_EQ(light.kernel.kernel, Kernel::coupled);
  const HistoryTable b = test::run(light).histories;
  for_each_history(b, [&](std::size_t record, std::size_t i, std::size_t level) {
    if (b.fields.uplift[b.at(record, i, level)] != 0) return;  // tables: linear over 64ths there
    const double slip = b.displacement_m(record, i, level);
    EXPECT_NEAR(a.displacement_m(record, i, level), slip, 1e-6 * slip + 1e-9);
  });
}

// R = 0 is elastic; R = 1 yields at the demand.
TEST(execute_yielding, r_is_the_design_spectrum_s_demand_over_the_strength) {
  for (const double r : {0.0, 1.0, 3.0}) {
    StudyConfig config = tiny_config();
    config.quantities.at("building", "response_modification") = fixed(r);
    config.quantities.at("building", "hardening_ratio") = fixed(0.05);
    config.quantities.at("building", "mass_ratio") = fixed(0.01);
    const Plan plan = small_plan(config);
    ASSERT_EQ(plan.kernel.kernel, Kernel::coupled);
    const HistoryTable table = test::run(plan).histories;
    const TargetSpectrum design(*plan.suites[0].target);
    int differ = 0;
    for_each_history(table, [&](std::size_t record, std::size_t i, std::size_t level) {
      const Case c = plan.cases[i];
      const auto ground = ground_of(plan, record, c, config.intensity.levels[level]);
      CoupledBuilding building{{c.period_s, c.damping}, 0.01};
      const Block block{.friction = c.friction, .slope_rad = c.slope_deg * rad_per_deg};
      const auto slip = [&] {
        return slide_coupled(ground.motion, ground.factors, building, block)
            .slip.peak_displacement_m;
      };
      const double elastic = slip();
      if (r > 0.0)
        building.yielding = {design.design_sa_g(c.period_s) * standard_gravity_mps2 / r, 0.05};
      const double expected = slip();
      EXPECT_NEAR(table.displacement_m(record, i, level), expected, 1e-5 * expected + 1e-9);
      differ += expected != elastic ? 1 : 0;
    });
    if (r == 0.0) {
      EXPECT_EQ(differ, 0);
    } else {
      EXPECT_GT(differ, 20);
    }
  }
}

/// A history of a two_axis_config(), by hand.
struct OnTwoAxes {
  BuildingGround ground;
  MotionFactors factors;
  BiaxialBuilding building;
  Block block;

  OnTwoAxes(const Plan& plan, std::size_t record, std::size_t i, std::size_t level) {
    const Case c = plan.cases[i];
    Motion m = plan.motion(record);
    const SignedComponent along = along_axis(c.orientation, 0),
                          across = along_axis(c.orientation, 1);
    EXPECT_NE(along.component, across.component);
    if (along.component == 1) std::swap(m.horizontal_mps2[0], m.horizontal_mps2[1]);
    const double factor = test::factor_of(plan, record, plan.config.intensity.levels[level]);
    ground = building_ground(m, {}, {});
    factors = {{along.sign * factor, across.sign * factor}, factor};
    building = {
        .horizontal = {Oscillator{c.period_s, c.damping}, Oscillator{0.7 * c.period_s, c.damping}},
        .mass_ratio = c.mass_ratio};
    block = {.friction = {c.friction, c.friction_across},
             .slope_rad = c.slope_deg * rad_per_deg,
             .azimuth_rad = c.azimuth_deg * rad_per_deg};
  }
};

TEST(execute_two_axes, gives_the_slip_of_the_full_model_by_the_study_s_measure) {
  StudyConfig config = two_axis_config();
  const Plan plan = small_plan(config);
  ASSERT_EQ(plan.kernel.kernel, Kernel::full);
  const HistoryTable srss = test::run(plan).histories;
  int slid = 0;
  for_each_history(srss, [&](std::size_t record, std::size_t i, std::size_t level) {
    const OnTwoAxes by_hand(plan, record, i, level);
    const SlipResult expected =
        slide_on_building(by_hand.ground, by_hand.factors, by_hand.building, by_hand.block).slip;
    EXPECT_NEAR(srss.displacement_m(record, i, level), srss_of_maxima_m(expected),
                1e-5 * srss_of_maxima_m(expected));
    EXPECT_NEAR(srss.fields.peak_vector_m[srss.at(record, i, level)], expected.peak_displacement_m,
                1e-5 * expected.peak_displacement_m);
    slid += expected.peak_displacement_m > 1e-3 ? 1 : 0;
  });
  EXPECT_GT(slid, 40);
  config.model.displacement = DisplacementMeasure::vector;
  const HistoryFields vector = test::run(small_plan(config)).histories.fields;
  EXPECT_EQ(vector.peak_displacement_m, vector.peak_vector_m);
  EXPECT_EQ(vector.peak_vector_m, srss.fields.peak_vector_m);
}

void expect_closing_by_hand(NeighbourSlope slope) {
  StudyConfig config = two_axis_config();
  const HistoryTable alone = test::run(small_plan(config)).histories;
  EXPECT_TRUE(alone.fields.closing_along_m.empty());
  config.quantities.at("friction", "neighbour_mu") =
      drawn(TruncatedNormal{0.4, 0.05, 0.0, INFINITY});
  config.neighbour_slope = slope;
  const Plan plan = small_plan(config);
  HistoryTable table = test::run(plan).histories;
  int close = 0;
  for_each_history(table, [&](std::size_t record, std::size_t i, std::size_t level) {
    const OnTwoAxes by_hand(plan, record, i, level);
    const Case c = plan.cases[i];
    EXPECT_NE(c.neighbour_friction, c.friction);  // drawn by itself
    Block neighbour = by_hand.block;
    neighbour.friction = {c.neighbour_friction,
                          c.neighbour_friction / c.friction * c.friction_across};
    if (slope == NeighbourSlope::facing) neighbour.azimuth_rad += std::numbers::pi;
    const PlanVector expected = closing_on_building(by_hand.ground, by_hand.factors,
                                                    by_hand.building, by_hand.block, neighbour);
    const std::size_t at = table.at(record, i, level);
    EXPECT_NEAR(table.fields.closing_along_m[at], expected.along_m, 1e-9 * expected.along_m);
    EXPECT_NEAR(table.fields.closing_across_m[at], expected.across_m, 1e-9 * expected.across_m);
    close += expected.along_m > 1e-3 ? 1 : 0;
  });
  EXPECT_GT(close, 20);
  table.fields.closing_along_m.clear();
  table.fields.closing_across_m.clear();
  EXPECT_EQ(test::bits_of(table), test::bits_of(alone));
}

TEST(execute_two_axes, gives_the_closing_of_the_gaps_to_a_neighbour_and_changes_nothing_else) {
  expect_closing_by_hand(NeighbourSlope::same);
}

TEST(execute_two_axes, gives_the_closing_of_the_gaps_across_a_valley_and_changes_nothing_else) {
  expect_closing_by_hand(NeighbourSlope::facing);
}

TEST(execute_two_axes, on_a_flat_roof_a_facing_neighbour_is_one_on_the_same_slope) {
  StudyConfig config = two_axis_config();
  config.quantities.at("roof", "slope_deg") = fixed(0.0);
  config.quantities.at("friction", "neighbour_mu") = fixed(0.2);
  const HistoryTable same = test::run(small_plan(config)).histories;
  config.neighbour_slope = NeighbourSlope::facing;
  EXPECT_EQ(test::bits_of(test::run(small_plan(config)).histories), test::bits_of(same));
}

TEST(execute_two_axes, a_neighbour_of_equal_friction_never_comes_closer) {
  StudyConfig config = two_axis_config();
  config.quantities.at("friction", "mu") = config.quantities.at("friction", "neighbour_mu") =
      fixed(0.35);
  const HistoryFields fields = test::run(small_plan(config)).histories.fields;
  for (const auto* closing : {&fields.closing_along_m, &fields.closing_across_m})
    for (const double closing_m : *closing) EXPECT_EQ(closing_m, 0.0);
}

TEST(execute_two_axes, a_roof_that_falls_the_other_way_is_turned_by_half_a_turn) {
  StudyConfig config = two_axis_config();
  config.quantities.at("roof", "azimuth_deg") = fixed(10.0);
  config.quantities.at("roof", "slope_deg") = fixed(-3.0);
  const Plan back = small_plan(config);
  config.quantities.at("roof", "azimuth_deg") = fixed(190.0);
  config.quantities.at("roof", "slope_deg") = fixed(3.0);
  const Plan turned = small_plan(config);
  const auto a = execute(back, 0).fields.peak_vector_m, b = execute(turned, 0).fields.peak_vector_m;
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) EXPECT_NEAR(a[i], b[i], 1e-9 * b[i]);
}

/// A study of each kernel; the first level is below yield.
std::vector<StudyConfig> study_of_each_kernel() {
  StudyConfig tables = tiny_config(), coupled = tiny_config(), events = tiny_config(),
              full = two_axis_config();
  coupled.quantities.at("building", "mass_ratio") = fixed(0.1);
  full.quantities.at("building", "mass_ratio") = fixed(0.1);
  full.quantities.at("friction", "neighbour_mu") = drawn(Uniform{0.1, 0.4});
  events.quantities.at("friction", "static_over_sliding") = fixed(1.2);
  StudyConfig valley = full;
  valley.neighbour_slope = NeighbourSlope::facing;
  std::vector<StudyConfig> all{tables, coupled, events, full, valley};
  for (StudyConfig& config : all) {
    config.sampling.samples = 6;
    config.intensity.levels = {0.02, 0.2, 1.0};
  }
  return all;
}

TEST(execute_any_model, skipping_what_cannot_slip_changes_no_bit) {
  std::set<Kernel> kernels;
  for (const StudyConfig& config : study_of_each_kernel()) {
    const Plan plan = small_plan(config);
    kernels.insert(plan.kernel.kernel);
    const auto a = test::execute_all(plan), b = test::execute_all(plan, Skipping::none);
    for (std::size_t u = 0; u < a.size(); ++u)
      EXPECT_EQ(test::bits_of({.fields = a[u].fields}), test::bits_of({.fields = b[u].fields}));
    EXPECT_GT(test::total_count(a).below_yield, 10u) << plan.kernel.reason;
    EXPECT_EQ(test::total_count(b).below_yield, 0u);
  }
  EXPECT_EQ(kernels.size(), 3u);
}

// Crossings are there where the vector gets that far, and nowhere else.
TEST(execute_any_model, a_threshold_is_crossed_where_the_peak_is_beyond_it) {
  for (StudyConfig config : study_of_each_kernel()) {
    config.impact = true;
    config.intensity.levels = {0.5, 1.0, 2.0, 3.0};
    const Plan plan = small_plan(config);
    const HistoryTable table = test::run(plan).histories;
    const HistoryFields& fields = table.fields;
    const auto& peaks = config.two_axes() ? fields.peak_vector_m : fields.peak_displacement_m;
    int crossed = 0;
    for_each_history(table, [&](std::size_t record, std::size_t i, std::size_t level) {
      const std::size_t place = table.at(record, i, level);
      const Motion& motion = plan.motion(record);
      const double length_s = motion.dt_s * static_cast<double>(motion.horizontal_mps2[0].size());
      for (std::size_t t = 0; t < table.thresholds; ++t) {
        const double time_s = fields.crossing_time_s[place * table.thresholds + t];
        EXPECT_EQ(!std::isnan(time_s), peaks[place] >= config.thresholds_m()[t]);
        if (std::isnan(time_s)) continue;
        ++crossed;
        EXPECT_GT(time_s, 0.0);
        EXPECT_LT(time_s, length_s + 20.0);
        EXPECT_GE(fields.crossing_speed_mps[place * table.thresholds + t], 0.0);
      }
    });
    EXPECT_GT(crossed, 20);
  }
}

TEST(reduce_two_axes, has_the_mean_of_the_vectors_below_that_of_the_srss) {
  const Results results = test::run(small_plan(two_axis_config()));
  EXPECT_TRUE(slides_on_two_axes(results));
  const SlipStatistics& top = results.runs[0].slip.back();
  EXPECT_GT(top.mean_vector_m, 0.0);
  EXPECT_LT(top.mean_vector_m, top.mean_m);
  EXPECT_GT(std::numbers::sqrt2 * top.mean_vector_m, top.mean_m);
}

void expect_refused(const StudyConfig& config, Suite suite, const char* message) {
  try {
    make_plan(config, {std::move(suite)});
    ADD_FAILURE() << "accepted: " << message;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(message));
    EXPECT_EQ(error.problems().size(), 1u) << error.what();
  }
}

TEST(plan_of_a_model, refuses_what_does_not_go_together_with_one_message) {
  StudyConfig config = two_axis_config();
  Suite single = small_suite();
  single.motions[1].horizontal_mps2[1] = {};
  expect_refused(config, single, "record motion1 has no second horizontal component");

  config = two_axis_config();
  config.quantities.at("friction", "across_mu") = fixed(0.0);
  expect_refused(config, small_suite(), "friction.mu is");

  config = tiny_config();
  config.quantities.at("building", "mass_ratio") = fixed(1.0);
  config.quantities.at("friction", "mu") = fixed(5.0);
  config.quantities.at("roof", "slope_deg") = fixed(45.0);
  expect_refused(config, small_suite(), "friction locks the array against the roof");

  // One mass of this m/M is far from it; three modes of walls are 12 times as light at the roof.
  config = tiny_config();
  config.quantities.at("building", "period_s") = fixed(1.5);
  config.quantities.at("building", "mass_ratio") = fixed(0.3);
  config.quantities.at("friction", "mu") = fixed(1.4);
  config.quantities.at("roof", "slope_deg") = fixed(15.0);
  EXPECT_NO_THROW(make_plan(config, {small_suite()}));
  config.building.kind = BuildingModel::Kind::cantilever;
  config.quantities.at("building", "alpha") = fixed(0.0);
  expect_refused(config, small_suite(), "a mass ratio of 0.3 (3.6 at the array, by the modes)");

  config = tiny_config();
  config.quantities.at("building", "mass_ratio") = fixed(0.1);
  config.tipping = RigidBase{1.0, 2.0};
  expect_refused(config, small_suite(), "the tipping check of [tipping]");
  config.tipping.reset();
  config.intensity.measure = IntensityMeasure::ppa_g;
  expect_refused(config, small_suite(), "measure = \"ppa_g\"");

  config = tiny_config();
  config.quantities.at("building", "response_modification") = fixed(2.0);
  config.intensity.measure = *IntensityMeasure::named("pga_g");
  Suite without_target = small_suite();
  without_target.target.reset();
  expect_refused(config, without_target, "building.response_modification divides");
  config.quantities.at("building", "response_modification") = fixed(0.0);
  config.quantities.at("building", "yield_coefficient") = fixed(0.2);
  config.quantities.at("building", "period_s") = drawn(Uniform{0.0, 1e-3});
  expect_refused(config, without_target, "a rigid building does not yield");
}

}  // namespace
}  // namespace glissade
