// SPDX-License-Identifier: GPL-3.0-or-later
// Rules that all models of the block share: critical friction, and which input is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "glissade/block/coupled.hpp"
#include "glissade/block/on_building.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/block/rodriguez_nikl.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/block/two_axis.hpp"
#include "glissade/block/two_axis_lanes.hpp"
#include "glissade/core/not_converged.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace input_rules_test {

using test::made_up_record;

const auto record = made_up_record(400, 3, 6.0);
const double slope_rad = 5 * rad_per_deg;

Block block_with(double friction) { return {.friction = friction, .slope_rad = slope_rad}; }

SlipResult on_two_axes(const Block& block) {
  return slide_two_axis({0.01, {record, {}}, {}}, block);
}

TEST(critical_friction, is_one_rule_for_all_models) {
  const double tan_slope = std::tan(slope_rad);
  for (const double mu : {tan_slope, std::nextafter(tan_slope, 1.0), std::nextafter(tan_slope, 0.0),
                          tan_slope * (1.0 + 1e-13)}) {
    const Block block = block_with(mu);
    const SlipResult exact = slide({0.01, record}, block);
    EXPECT_TRUE(exact.free_sliding) << mu;
    EXPECT_LT(exact.peak_displacement_m, 100.0);
    const SlipPeak table = peak_slip(RoofTable(0.01, record), block);
    EXPECT_TRUE(table.free_sliding);
    EXPECT_NEAR(table.peak_displacement_m, exact.peak_displacement_m, 1e-9);
    const SlipResult two = on_two_axes(block);
    EXPECT_TRUE(two.free_sliding);
    EXPECT_NEAR(two.peak_by_axis.along_m, exact.peak_displacement_m,
                1e-5 * exact.peak_displacement_m);
    EXPECT_TRUE(slide_coupled({0.01, record}, {}, {}, block).slip.free_sliding);
    EXPECT_EQ(yield_acceleration_mps2(block), 0.0);
    EXPECT_EQ(resting_deceleration_mps2(block), 0.0);
  }
  const Block stops = block_with(tan_slope * (1.0 + 1e-9));
  EXPECT_FALSE(slide({0.01, record}, stops).free_sliding);
  EXPECT_FALSE(peak_slip(RoofTable(0.01, record), stops).free_sliding);
  EXPECT_FALSE(on_two_axes(stops).free_sliding);
  EXPECT_GT(yield_acceleration_mps2(stops), 0.0);
}

TEST(critical_friction, yields_where_a_block_at_rest_decelerates) {
  for (double degrees = 0.5; degrees < 60.0; degrees += 0.5) {
    const double slope = degrees * rad_per_deg;
    for (double mu = std::tan(slope), k = 0; k < 6; ++k, mu *= 1.0 + 1e-12) {
      const Block block{.friction = mu, .slope_rad = slope};
      EXPECT_EQ(yield_acceleration_mps2(block) > 0.0, resting_deceleration_mps2(block) > 0.0);
    }
  }
}

// Walked sample by sample, the second would take hours.
TEST(slide_coupled_on_a_rigid_building, takes_the_way_to_rest_in_closed_form) {
  for (const double surplus : {1e-6, 1e-9}) {
    Block block = block_with(std::tan(slope_rad) * (1.0 + surplus));
    const SlipResult exact = slide({0.01, record}, block);
    const SlipResult coupled = slide_coupled({0.01, record}, {}, {{0.0, 0.05}, 0.1}, block).slip;
    EXPECT_FALSE(coupled.free_sliding);
    EXPECT_NEAR(coupled.peak_displacement_m, exact.peak_displacement_m,
                1e-6 * exact.peak_displacement_m);
    EXPECT_NEAR(coupled.slip_duration_s, exact.slip_duration_s, 1e-6 * exact.slip_duration_s);
    block.law.static_over_sliding = 1.2;
    const SlipResult loose = slide_coupled({0.01, record}, {}, {{0.0, 0.05}, 0.1}, block).slip;
    EXPECT_FALSE(loose.free_sliding);
    EXPECT_GT(loose.peak_displacement_m, 1.0);
  }
}

TEST(input_that_is_not_finite, is_refused_by_every_model) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    std::vector<double> broken = record;
    broken[200] = bad;
    const Block block = block_with(0.2);
    const CoupledBuilding building{{0.5, 0.05}, 0.1};
    EXPECT_THROW(slide({0.01, broken}, block), std::invalid_argument);
    EXPECT_THROW(slide({0.01, record, broken}, block), std::invalid_argument);
    EXPECT_THROW(slide({0.01, record}, block_with(bad)), std::invalid_argument);
    EXPECT_THROW(slide({bad, record}, block), std::invalid_argument);
    EXPECT_THROW(RoofTable(0.01, broken), std::invalid_argument);
    EXPECT_THROW(peak_slip(RoofTable(0.01, record), block_with(bad)), std::invalid_argument);
    EXPECT_THROW(peak_slip(RoofTable(0.01, record), block, {bad, 0.0}), std::invalid_argument);
    EXPECT_THROW(roof_motion({0.01, broken}, {}, {}), std::invalid_argument);
    EXPECT_THROW(slide_rodriguez_nikl({0.01, broken}, block, 4), std::invalid_argument);
    EXPECT_THROW(slide_coupled({0.01, broken}, {}, building, block), std::invalid_argument);
    EXPECT_THROW(slide_coupled({0.01, record, broken}, {}, building, block), std::invalid_argument);
    EXPECT_THROW(slide_coupled({0.01, record}, {}, {{bad, 0.05}, 0.1}, block),
                 std::invalid_argument);
    EXPECT_THROW(slide_two_axis({0.01, {broken, {}}, {}}, {.friction = 0.2}),
                 std::invalid_argument);
    EXPECT_THROW(slide_two_axis({0.01, {record, {}}, {}}, {.friction = bad}),
                 std::invalid_argument);
  }
}

// Each number of a scene of two axes in turn: the scalar scheme did not return for some, the lanes
// gave zero.
TEST(a_scene_that_is_not_finite, is_refused_by_every_model_of_two_axes) {
  const BuildingGround ground{{std::make_shared<GroundTable>(0.01, record), nullptr}, nullptr};
  const TwoAxisScene good{{{{{0.5, 0.05}, {0.4, 0.05}}}, {}, 0.05}, {.friction = 0.2}, {}};
  const auto numbers = [](TwoAxisScene& s) {
    return std::vector<double*>{&s.factors.horizontal[0],
                                &s.factors.horizontal[1],
                                &s.factors.vertical,
                                &s.building.mass_ratio,
                                &s.building.horizontal[0][0].period_s,
                                &s.building.horizontal[1][0].damping_ratio,
                                &s.building.yielding[0].hardening_ratio,
                                &s.building.yielding[1].yield_acceleration_mps2,
                                &s.block.friction.along,
                                &s.block.friction.across,
                                &s.block.slope_rad,
                                &s.block.azimuth_rad,
                                &s.block.gravity_mps2,
                                &s.block.law.static_over_sliding,
                                &s.block.law.fast_over_slow,
                                &s.block.law.rate_s_per_m};
  };
  TwoAxisScene scene = good;
  const std::size_t count = numbers(scene).size();
  for (std::size_t i = 0; i < count; ++i) {
    scene = good;
    *numbers(scene)[i] = std::nan("");
    BuildingPeak peak;
    EXPECT_THROW(peak_slip_two_axes(ground, {&scene, 1}, {&peak, 1}), std::invalid_argument) << i;
    EXPECT_THROW(slide_on_building(ground, scene.factors, scene.building, scene.block),
                 std::invalid_argument)
        << i;
    EXPECT_THROW(
        closing_on_building(ground, scene.factors, scene.building, scene.block, scene.block),
        std::invalid_argument)
        << i;
  }
}

TwoAxisScene scene_on_a_building(double factor, const FrictionLaw& law = {}) {
  return {{{{{0.5, 0.05}, {0.4, 0.05}}}, {}, 0.05},
          {.friction = 0.2, .law = law},
          {{factor, 0.0}, 0.0}};
}

// With 1e80 the scheme of two axes read beyond its thresholds, with 1e160 it did not return.
TEST(a_factor_beyond_any_motion, is_refused_by_every_model) {
  const Block block = block_with(0.2);
  const CoupledBuilding building{{0.5, 0.05}, 0.05, {}};
  const BuildingGround ground{{std::make_shared<GroundTable>(0.01, record), nullptr}, nullptr};
  const auto slips = [&](double factor) {
    const MotionFactors factors{factor, factor};
    const TwoAxisScene scene = scene_on_a_building(factor);
    BuildingPeak peak;
    return std::vector<std::function<double()>>{
        [=] {
          return slide({0.01, record, {}, factor}, block).peak_displacement_m;
        },
        [=] { return peak_slip(RoofTable(0.01, record), block, factors).peak_displacement_m; },
        [=] {
          return slide_coupled({0.01, record}, factors, building, block).slip.peak_displacement_m;
        },
        [=] {
          return slide_on_building(ground, scene.factors, scene.building, scene.block)
              .slip.peak_displacement_m;
        },
        [=]() mutable {
          peak_slip_two_axes(ground, {&scene, 1}, {&peak, 1});
          return peak.peak_displacement_m;
        }};
  };
  for (const double factor : {1e13, 1e80, 1e160, 1e300})
    for (const auto& slip : slips(factor)) EXPECT_THROW(slip(), std::invalid_argument) << factor;
  for (const auto& slip : slips(1e9)) EXPECT_TRUE(std::isfinite(slip()));
}

TEST(a_tolerance, that_no_step_can_meet_is_refused_in_every_build) {
  const BuildingGround ground{{std::make_shared<GroundTable>(0.01, record), nullptr}, nullptr};
  const TwoAxisScene scene = scene_on_a_building(1.0);
  BuildingPeak peak;
  for (const double bad : {0.0, -1.0, 0.1, std::nan("")}) {
    EXPECT_THROW(peak_slip_two_axes(ground, {&scene, 1}, {&peak, 1}, bad), std::invalid_argument);
    EXPECT_THROW(slide_on_building(ground, scene.factors, scene.building, scene.block, bad),
                 std::invalid_argument);
  }
}

// Such a history took minutes in each of its sample intervals.
TEST(friction_that_is_nearly_a_jump_in_speed, ends_a_history_soon) {
  const BuildingGround ground{{std::make_shared<GroundTable>(0.01, record), nullptr}, nullptr};
  const TwoAxisScene scene = scene_on_a_building(1.0, {.fast_over_slow = 1.5, .rate_s_per_m = 1e9});
  EXPECT_THROW(slide_on_building(ground, scene.factors, scene.building, scene.block), NotConverged);
}

}  // namespace input_rules_test
}  // namespace glissade
