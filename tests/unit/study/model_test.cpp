// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "glissade/block/coupled.hpp"
#include "glissade/block/on_building.hpp"
#include "glissade/core/error.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/study/execute.hpp"
#include "glissade/study/reduce.hpp"
#include "glissade/study/scene.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::small_config;
using test::small_suite;
using testing::HasSubstr;

/// Ten samples, four levels, without standards.
StudyConfig tiny_config() {
  StudyConfig c = small_config();
  c.intensity.levels = {0.5, 1.0, 2.0, 3.0};
  c.sampling.samples = 10;
  c.standards.compare.clear();
  return c;
}

StudyConfig two_axis_config() {
  StudyConfig c = tiny_config();
  c.model.axes = SlidingAxes::two;
  c.building.mass_ratio = Uniform{0.02, 0.2};
  c.building.period_ratio = 0.7;
  c.friction.across = TruncatedNormal{0.3, 0.04, 0.0, INFINITY};
  c.roof.azimuth_deg = Uniform{0.0, 90.0};
  return c;
}

Kernel kernel_of(const StudyConfig& config) { return cheapest_exact_kernel(config).kernel; }

TEST(cheapest_exact_kernel, is_the_first_that_has_all_the_study_asks_for) {
  StudyConfig config = tiny_config();
  EXPECT_EQ(kernel_of(config), Kernel::tables);
  config.vertical.period_s = 0.2;  // tables hold any roof motion
  EXPECT_EQ(kernel_of(config), Kernel::tables);
  config.building.mass_ratio = Fixed{0.05};
  EXPECT_EQ(kernel_of(config), Kernel::full);  // the coupled kernel's vertical is the ground's
  config.vertical.period_s = 0.0;
  EXPECT_EQ(kernel_of(config), Kernel::coupled);
  config.building.strength = StrengthConfig{.yield_coefficient = 0.3};
  EXPECT_EQ(kernel_of(config), Kernel::events);
  config.model.axes = SlidingAxes::two;
  EXPECT_EQ(kernel_of(config), Kernel::full);
}

TEST(cheapest_exact_kernel, needs_no_coupling_with_a_building_that_does_not_move) {
  StudyConfig config = tiny_config();
  config.building.period_s = Fixed{0.0};
  config.building.mass_ratio = Fixed{0.3};
  EXPECT_EQ(kernel_of(config), Kernel::tables);
}

TEST(cheapest_exact_kernel, keeps_friction_that_is_stronger_at_rest_exact_on_one_axis) {
  StudyConfig config = tiny_config();
  config.friction.law.static_ratio = 1.2;
  EXPECT_EQ(kernel_of(config), Kernel::events);
  config.model.axes = SlidingAxes::two;
  EXPECT_EQ(kernel_of(config), Kernel::full);
}

TEST(cheapest_exact_kernel, gives_friction_that_depends_on_speed_to_the_full_model) {
  StudyConfig config = tiny_config();
  config.friction.law = {.fast_ratio = 1.3, .rate_spm = 10.0};
  EXPECT_EQ(kernel_of(config), Kernel::full);
  config.friction.law = {.fast_ratio = 1.0, .rate_spm = 10.0};
  EXPECT_EQ(kernel_of(config), Kernel::tables);
}

/// Calls check(sample, level index, history's place, unit result) for every history of a plan.
template <class Check>
void for_each_history(const Plan& plan, Check check) {
  const std::size_t levels = plan.config.intensity.levels.size();
  for (std::size_t u = 0; u < plan.units.size(); ++u) {
    const UnitResult result = execute(plan, u);
    const WorkUnit& unit = plan.units[u];
    for (std::size_t i = 0; i < unit.sample_count; ++i) {
      for (std::size_t j = 0; j < levels; ++j)
        check(unit.record, unit.first_sample + i, j, i * levels + j, result.runs[0]);
    }
  }
}

TEST(execute_coupled, gives_the_slip_of_the_readable_scheme) {
  StudyConfig config = tiny_config();
  config.building.mass_ratio = Uniform{0.02, 0.3};
  const Plan plan = make_plan(config, small_suite());
  ASSERT_EQ(plan.kernel.kernel, Kernel::coupled);
  int slid = 0;
  for_each_history(plan, [&](std::size_t record, std::size_t i, std::size_t level,
                             std::size_t place, const UnitResult::Run& run) {
    const SamplePoint& s = plan.samples[i];
    const Motion& m = plan.suite.motions[record];
    const double factor = config.intensity.levels[level] * plan.factor_at_unit_level[record];
    const CoupledResult expected = slide_coupled(
        {m.dt_s, m.horizontal_mps2[static_cast<std::size_t>(s.component)], m.vertical_mps2},
        {s.sign * factor, factor}, {{s.period_s, s.damping}, s.mass_ratio},
        {.friction = s.friction, .slope_rad = s.slope_deg * rad_per_deg});
    EXPECT_NEAR(run.peak_displacement_m[place], expected.slip.peak_displacement_m,
                1e-10 * expected.slip.peak_displacement_m + 1e-13);
    slid += expected.slip.peak_displacement_m > 1e-3 ? 1 : 0;
  });
  EXPECT_GT(slid, 40);
}

TEST(execute_coupled, a_very_light_array_slides_as_one_without_mass) {
  StudyConfig config = tiny_config();
  const Plan uncoupled = make_plan(config, small_suite());
  config.building.mass_ratio = Fixed{1e-12};
  const Plan light = make_plan(config, small_suite());
  ASSERT_EQ(light.kernel.kernel, Kernel::coupled);
  for (std::size_t u = 0; u < light.units.size(); ++u) {
    const UnitResult a = execute(uncoupled, u), b = execute(light, u);
    for (std::size_t i = 0; i < a.runs[0].peak_displacement_m.size(); ++i) {
      const double slip = b.runs[0].peak_displacement_m[i];
      if (b.runs[0].uplift[i] != 0) continue;  // tables take a lifting roof linear over 64ths
      EXPECT_NEAR(a.runs[0].peak_displacement_m[i], slip, 1e-6 * slip + 1e-9);
    }
  }
}

TEST(execute_yielding, r_is_the_design_spectrum_s_demand_over_the_strength) {
  StudyConfig config = tiny_config();
  config.building.strength = StrengthConfig{.response_modification = 3.0, .hardening_ratio = 0.05};
  const Plan plan = make_plan(config, small_suite());
  ASSERT_EQ(plan.kernel.kernel, Kernel::events);
  const TargetSpectrum design(*plan.suite.target);
  int differ = 0;
  for_each_history(plan, [&](std::size_t record, std::size_t i, std::size_t level,
                             std::size_t place, const UnitResult::Run& run) {
    const SamplePoint& s = plan.samples[i];
    const Motion& m = plan.suite.motions[record];
    const double factor = config.intensity.levels[level] * plan.factor_at_unit_level[record];
    CoupledBuilding building{{s.period_s, s.damping}, 0.0};
    const GroundMotion ground{m.dt_s, m.horizontal_mps2[static_cast<std::size_t>(s.component)],
                              m.vertical_mps2};
    const Block block{.friction = s.friction, .slope_rad = s.slope_deg * rad_per_deg};
    const double elastic =
        slide_coupled(ground, {s.sign * factor, factor}, building, block).slip.peak_displacement_m;
    building.yielding = {design.design_sa_g(s.period_s) * standard_gravity_mps2 / 3.0, 0.05};
    const double expected =
        slide_coupled(ground, {s.sign * factor, factor}, building, block).slip.peak_displacement_m;
    EXPECT_EQ(run.peak_displacement_m[place], expected);
    differ += expected != elastic ? 1 : 0;
  });
  EXPECT_GT(differ, 20);
}

TEST(execute_two_axes, gives_the_slip_of_the_full_model_by_the_measure_asked_for) {
  StudyConfig config = two_axis_config();
  const Plan srss = make_plan(config, small_suite());
  config.model.displacement = DisplacementMeasure::vector;
  const Plan vector = make_plan(config, small_suite());
  ASSERT_EQ(srss.kernel.kernel, Kernel::full);
  int slid = 0;
  for_each_history(srss, [&](std::size_t record, std::size_t i, std::size_t level,
                             std::size_t place, const UnitResult::Run& run) {
    const SamplePoint& s = srss.samples[i];
    Motion m = srss.suite.motions[record];
    if (s.component == 1) std::swap(m.horizontal_mps2[0], m.horizontal_mps2[1]);
    const double factor = config.intensity.levels[level] * srss.factor_at_unit_level[record];
    const TwoAxisResult expected =
        slide_on_building(building_ground(m, {}, {}),
                          {{s.sign * factor, s.second_sign * factor}, factor},
                          {.horizontal = {Oscillator{s.period_s, s.damping},
                                          Oscillator{0.7 * s.period_s, s.damping}},
                           .mass_ratio = s.mass_ratio},
                          {.friction = {s.friction, s.friction_across},
                           .slope_rad = s.slope_deg * rad_per_deg,
                           .azimuth_rad = s.azimuth_deg * rad_per_deg})
            .slip;
    EXPECT_EQ(run.peak_displacement_m[place], srss_of_maxima_m(expected));
    EXPECT_EQ(run.peak_vector_m[place], expected.peak_displacement_m);
    slid += expected.peak_displacement_m > 1e-3 ? 1 : 0;
  });
  EXPECT_GT(slid, 40);
  for_each_history(vector, [](std::size_t, std::size_t, std::size_t, std::size_t place,
                              const UnitResult::Run& run) {
    EXPECT_EQ(run.peak_displacement_m[place], run.peak_vector_m[place]);
  });
}

TEST(execute_two_axes, a_roof_that_falls_the_other_way_is_turned_by_half_a_turn) {
  StudyConfig config = two_axis_config();
  config.roof.azimuth_deg = Fixed{10.0};
  config.roof.slope_deg = Fixed{-3.0};
  const Plan back = make_plan(config, small_suite());
  config.roof.azimuth_deg = Fixed{190.0};
  config.roof.slope_deg = Fixed{3.0};
  const Plan turned = make_plan(config, small_suite());
  const UnitResult a = execute(back, 0), b = execute(turned, 0);
  for (std::size_t i = 0; i < a.runs[0].peak_vector_m.size(); ++i)
    EXPECT_NEAR(a.runs[0].peak_vector_m[i], b.runs[0].peak_vector_m[i],
                1e-9 * b.runs[0].peak_vector_m[i]);
}

TEST(execute_any_model, skipping_what_cannot_slip_changes_no_bit) {
  StudyConfig coupled = tiny_config(), full = two_axis_config();
  coupled.building.mass_ratio = full.building.mass_ratio = Fixed{0.1};
  coupled.intensity.levels = full.intensity.levels = {0.02, 0.2, 1.0};
  for (const StudyConfig& config : {coupled, full}) {
    const Plan plan = make_plan(config, small_suite());
    std::uint64_t held = 0;
    for (std::size_t u = 0; u < plan.units.size(); ++u) {
      const UnitResult a = execute(plan, u), b = execute(plan, u, Skipping::none);
      for (std::size_t run = 0; run < a.runs.size(); ++run) {
        EXPECT_EQ(a.runs[run].peak_displacement_m, b.runs[run].peak_displacement_m);
        EXPECT_EQ(a.runs[run].capacity, b.runs[run].capacity);
      }
      held += a.count.held;
      EXPECT_EQ(b.count.held, 0u);
    }
    EXPECT_GT(held, 20u);
  }
}

/// For each kernel: crossings are there where the vector gets that far, and nowhere else.
TEST(execute_any_model, a_threshold_is_crossed_where_the_peak_is_beyond_it) {
  StudyConfig tables = tiny_config(), coupled = tiny_config(), full = two_axis_config();
  coupled.building.mass_ratio = Fixed{0.1};
  for (StudyConfig config : {tables, coupled, full}) {
    config.impact = true;
    const Plan plan = make_plan(config, small_suite());
    const bool two = config.model.axes == SlidingAxes::two;
    const std::size_t thresholds = config.thresholds_m.size();
    int crossed = 0;
    for_each_history(plan, [&](std::size_t record, std::size_t, std::size_t, std::size_t place,
                               const UnitResult::Run& run) {
      const double peak = two ? run.peak_vector_m[place] : run.peak_displacement_m[place];
      const double length_s =
          plan.suite.motions[record].dt_s *
          static_cast<double>(plan.suite.motions[record].horizontal_mps2[0].size());
      for (std::size_t t = 0; t < thresholds; ++t) {
        const double time_s = run.crossing_time_s[place * thresholds + t];
        const double speed = run.crossing_speed_mps[place * thresholds + t];
        EXPECT_EQ(!std::isnan(time_s), peak >= config.thresholds_m[t]);
        if (std::isnan(time_s)) continue;
        ++crossed;
        EXPECT_GT(time_s, 0.0);
        EXPECT_LT(time_s, length_s + 20.0);
        EXPECT_GE(speed, 0.0);
      }
    });
    EXPECT_GT(crossed, 40);
  }
}

TEST(reduce_two_axes, tells_the_mean_of_the_vectors_below_that_of_the_srss) {
  const Plan plan = make_plan(two_axis_config(), small_suite());
  std::vector<UnitResult> units;
  for (std::size_t u = 0; u < plan.units.size(); ++u) units.push_back(execute(plan, u));
  const Results results = reduce(plan, units);
  EXPECT_TRUE(slides_on_two_axes(results));
  const SlipStatistics& top = results.runs[0].slip.back();
  EXPECT_GT(top.mean_vector_m, 0.0);
  EXPECT_LT(top.mean_vector_m, top.mean_m);
  EXPECT_GT(std::numbers::sqrt2 * top.mean_vector_m, top.mean_m);
  EXPECT_THAT(results.model.kernel, HasSubstr("full model"));
}

void expect_refused(const StudyConfig& config, Suite suite, const char* message) {
  try {
    make_plan(config, std::move(suite));
    ADD_FAILURE() << "accepted: " << message;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr(message));
    EXPECT_EQ(error.problems().size(), 1u) << error.what();
  }
}

TEST(plan_of_a_model, refuses_what_does_not_go_together_with_one_message) {
  StudyConfig config = two_axis_config();
  Suite single = small_suite();
  single.motions[1].horizontal_mps2[1].clear();
  expect_refused(config, single, "record motion1 has no second horizontal component");

  config = two_axis_config();
  config.friction.across = Fixed{0.0};
  expect_refused(config, small_suite(), "an axis of the friction ellipse is zero");

  config = tiny_config();
  config.building.mass_ratio = Fixed{1.0};
  config.friction.mu = Fixed{5.0};
  config.roof.slope_deg = Fixed{45.0};
  expect_refused(config, small_suite(), "friction locks the array against the roof");

  config = tiny_config();
  config.building.mass_ratio = Fixed{0.1};
  config.base = RigidBase{1.0, 2.0};
  expect_refused(config, small_suite(), "the tipping check of [array]");
  config.base.reset();
  config.intensity.measure = IntensityMeasure::ppa_g;
  expect_refused(config, small_suite(), "measure = \"ppa_g\"");

  config = tiny_config();
  config.building.strength = StrengthConfig{.response_modification = 2.0};
  config.intensity.measure = IntensityMeasure::pga_g;
  Suite without_target = small_suite();
  without_target.target.reset();
  expect_refused(config, without_target, "building.response_modification divides");
  config.building.strength = StrengthConfig{.yield_coefficient = 0.2};
  config.building.period_s = Uniform{0.0, 1e-3};
  expect_refused(config, without_target, "a rigid building does not yield");
}

}  // namespace
}  // namespace glissade
