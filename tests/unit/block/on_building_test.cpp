// SPDX-License-Identifier: GPL-3.0-or-later
// The full model where it must come back to the simpler ones, and what must not change it.
#include "glissade/block/on_building.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "glissade/block/coupled.hpp"
#include "unit/block/on_building_scene.hpp"

namespace glissade {
namespace on_building_test {

using test::made_up_record;
using test::OnBuilding;

/// |found - expected| relative to `scale`.
double off(double found, double expected, double scale) {
  return std::abs(found - expected) / (scale > 0.0 ? scale : 1.0);
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

double largest(const std::vector<double>& values) {
  return *std::max_element(values.begin(), values.end());
}

/// Largest difference in any displacement, relative to the peak.
double difference(const SlipResult& a, const SlipResult& b) {
  return std::max({off(a.peak_displacement_m, b.peak_displacement_m, b.peak_displacement_m),
                   off(a.peak_by_axis.along_m, b.peak_by_axis.along_m, b.peak_displacement_m),
                   off(a.peak_by_axis.across_m, b.peak_by_axis.across_m, b.peak_displacement_m),
                   off(a.residual.along_m, b.residual.along_m, b.peak_displacement_m),
                   off(a.residual.across_m, b.residual.across_m, b.peak_displacement_m)});
}

/// The same against slide_coupled(), and in the building's peaks relative to themselves.
double difference(const BuildingSlip& two, const CoupledResult& one) {
  const double slip = one.slip.peak_displacement_m;
  return std::max({off(two.slip.peak_displacement_m, one.slip.peak_displacement_m, slip),
                   off(two.slip.residual.along_m, one.slip.residual.along_m, slip),
                   off(two.slip.residual.across_m, 0.0, slip),
                   off(two.peak_base_shear[0], one.peak_base_shear, one.peak_base_shear),
                   off(two.peak_roof_displacement_m[0], one.peak_roof_displacement_m,
                       one.peak_roof_displacement_m)});
}

// slide_coupled() is exact. Every third roof falls the other way, every fifth is not coupled with
// the block, every seventh lets go of it.
TEST(slide_on_building, is_slide_coupled_where_the_ground_moves_along_the_slope) {
  for (const double tolerance : {1e-5, 1e-6, 1e-7}) {
    std::mt19937 random(3);
    std::vector<double> errors;
    int lifted = 0;
    for (unsigned k = 0; k < 100; ++k) {
      OnBuilding scene(random, k, 400);
      scene.second.clear();
      const double toward = k % 3 == 0 ? -1.0 : 1.0;
      scene.block.azimuth_rad = toward < 0.0 ? std::numbers::pi : 0.0;
      scene.building.horizontal[1][0].period_s = k % 2 == 0 ? 0.0 : 0.7;
      scene.tolerance = tolerance;
      if (k % 5 == 0) scene.building.mass_ratio = 0.0;
      if (k % 7 == 0)
        for (double& w : scene.up) w *= 4.0;
      const BuildingSlip two = scene.result();
      const CoupledResult one = slide_coupled(
          {scene.dt_s, scene.first, scene.up}, {scene.factor, scene.factor},
          {scene.building.horizontal[0][0].oscillator(), scene.building.mass_ratio},
          {.friction = scene.block.friction.along, .slope_rad = toward * scene.block.slope_rad});
      EXPECT_EQ(two.slip.free_sliding, one.slip.free_sliding);
      EXPECT_EQ(two.slip.uplift, one.slip.uplift) << k;
      errors.push_back(difference(two, one));
      lifted += one.slip.uplift ? 1 : 0;
    }
    EXPECT_GT(lifted, 8);
    EXPECT_LT(median(errors), tolerance);
    EXPECT_LT(largest(errors), 20.0 * tolerance);
  }
}

TEST(slide_on_building, is_slide_two_axis_on_a_rigid_building) {
  std::mt19937 random(5);
  int slid = 0, lifted = 0;
  for (unsigned k = 0; k < 60; ++k) {
    OnBuilding scene(random, k, 400);
    scene.building = {};  // with a mass ratio the same to rounding
    if (k % 2 == 0) scene.block.friction.across *= 0.8;
    if (k % 5 == 0)
      for (double& w : scene.up) w *= 5.0;
    const BuildingSlip full = scene.result();
    const SlipResult plain = slide_two_axis(
        {scene.dt_s, {scene.first, scene.second}, scene.up, scene.factor, scene.factor},
        scene.block, scene.tolerance);
    EXPECT_EQ(full.slip.peak_displacement_m, plain.peak_displacement_m);
    EXPECT_EQ(full.slip.residual.along_m, plain.residual.along_m);
    EXPECT_EQ(full.slip.residual.across_m, plain.residual.across_m);
    EXPECT_EQ(full.slip.path_length_m, plain.path_length_m);
    EXPECT_EQ(full.slip.slip_phases, plain.slip_phases);
    EXPECT_EQ(full.slip.uplift, plain.uplift);
    EXPECT_EQ(full.slip.free_sliding, plain.free_sliding);
    EXPECT_EQ(full.peak_roof_displacement_m[0], 0.0);
    slid += plain.slip_phases > 0 ? 1 : 0;
    lifted += plain.uplift ? 1 : 0;
  }
  EXPECT_GT(slid, 30);
  EXPECT_GT(lifted, 3);
}

// The roof motion is sampled 16,000 times a period and linear between: off by 2e-8 of itself. A
// building's vertical is exact at the table's nodes and a quartic between.
TEST(slide_on_building, is_slide_two_axis_over_the_roof_motion_where_the_block_weighs_nothing) {
  std::mt19937 random(6);
  for (unsigned k = 0; k < 6; ++k) {
    OnBuilding scene(random, k, 300);
    scene.dt_s = 0.01;
    const Oscillator oscillator{0.4 + 0.1 * k, 0.05};
    scene.building = {{oscillator, oscillator}, {}, 0.0};
    if (k % 2 == 0) scene.vertical = {0.3, 0.05};
    const RoofMotionOptions ring{
        .quiet_horizontal_mps2 = 1e-4, .quiet_vertical_mps2 = 1e-6, .steps_per_period = 16000};
    const RoofMotion one = roof_motion({scene.dt_s, scene.first, scene.up},
                                       {oscillator, scene.vertical}, ring),
                     other = roof_motion({scene.dt_s, scene.second, scene.up},
                                         {oscillator, scene.vertical}, ring);
    std::vector<double> a = one.horizontal_mps2, b = other.horizontal_mps2, w = one.vertical_mps2;
    const std::size_t n = std::max({a.size(), b.size(), w.size()});
    for (auto* x : {&a, &b, &w}) x->resize(n, 0.0);
    const SlipResult plain =
        slide_two_axis({one.dt_s, {a, b}, w, scene.factor, scene.factor}, scene.block);
    EXPECT_GT(plain.peak_displacement_m, 1e-4);
    EXPECT_LT(difference(scene.result().slip, plain), 2e-5) << k;
  }
}

TEST(slide_on_building, mirrors_exactly) {
  const BuildingSlip one = OnBuilding().result();
  OnBuilding mirrored;
  mirrored.block.azimuth_rad *= -1.0;
  for (double& x : mirrored.second) x = -x;
  const BuildingSlip other = mirrored.result();
  EXPECT_GT(one.slip.peak_displacement_m, 0.0);
  EXPECT_EQ(other.slip.residual.along_m, one.slip.residual.along_m);
  EXPECT_EQ(other.slip.residual.across_m, -one.slip.residual.across_m);
  EXPECT_EQ(other.slip.peak_displacement_m, one.slip.peak_displacement_m);
  EXPECT_EQ(other.peak_base_shear, one.peak_base_shear);
}

// theory.md, 1.7: the whole acceleration field, and the clock with the building's periods.
TEST(slide_on_building, scales_exactly_with_all_accelerations_and_with_the_clock) {
  for (const double yield_mps2 : {std::numeric_limits<double>::infinity(), 3.0}) {
    for (const double across : {0.3, 0.2}) {
      OnBuilding scene;
      scene.block.friction.across = across;
      scene.building.yielding = {Yielding{yield_mps2, 0.05}, Yielding{yield_mps2, 0.0}};
      const BuildingSlip one = scene.result();
      OnBuilding doubled = scene;
      doubled.factor = 2.0;
      doubled.block.gravity_mps2 *= 2.0;
      for (Yielding& y : doubled.building.yielding) y.yield_acceleration_mps2 *= 2.0;
      const BuildingSlip two = doubled.result();
      EXPECT_EQ(two.slip.peak_displacement_m, 2.0 * one.slip.peak_displacement_m);
      EXPECT_EQ(two.slip.residual.across_m, 2.0 * one.slip.residual.across_m);
      EXPECT_EQ(two.peak_base_shear, one.peak_base_shear);
      OnBuilding slower = scene;
      slower.dt_s *= 2.0;
      for (Modes& o : slower.building.horizontal) o[0].period_s *= 2.0;
      const BuildingSlip four = slower.result();
      EXPECT_EQ(four.slip.path_length_m, 4.0 * one.slip.path_length_m);
      EXPECT_EQ(four.slip.slip_duration_s, 2.0 * one.slip.slip_duration_s);
      EXPECT_EQ(four.peak_roof_displacement_m[0], 4.0 * one.peak_roof_displacement_m[0]);
    }
  }
}

TEST(slide_on_building, zeros_after_the_record_change_not_a_bit) {
  const BuildingSlip one = OnBuilding().result();
  OnBuilding padded;
  for (auto* x : {&padded.first, &padded.second, &padded.up}) x->resize(1500, 0.0);
  const BuildingSlip other = padded.result();
  EXPECT_EQ(other.slip.peak_displacement_m, one.slip.peak_displacement_m);
  EXPECT_EQ(other.slip.residual.across_m, one.slip.residual.across_m);
  EXPECT_EQ(other.slip.path_length_m, one.slip.path_length_m);
  EXPECT_EQ(other.slip.slip_duration_s, one.slip.slip_duration_s);
}

// Of a building alike on both axes, which way they lie does not matter.
TEST(slide_on_building, turning_building_motion_and_slope_together_turns_nothing) {
  OnBuilding scene;
  scene.building.horizontal[1] = scene.building.horizontal[0];
  scene.tolerance = 1e-9;
  const SlipResult one = scene.result().slip;
  for (const double angle : {0.7, 2.0}) {
    OnBuilding turned = scene;
    turned.block.azimuth_rad += angle;
    for (std::size_t i = 0; i < scene.first.size(); ++i) {
      turned.first[i] = std::cos(angle) * scene.first[i] - std::sin(angle) * scene.second[i];
      turned.second[i] = std::sin(angle) * scene.first[i] + std::cos(angle) * scene.second[i];
    }
    EXPECT_LT(difference(turned.result().slip, one), 1e-7);
  }
}

TEST(slide_on_building, exchanging_the_building_axes_exchanges_their_results) {
  OnBuilding scene;
  scene.tolerance = 1e-9;
  scene.block.friction.across = 0.2;
  const BuildingSlip one = scene.result();
  OnBuilding exchanged = scene;
  std::swap(exchanged.first, exchanged.second);
  std::swap(exchanged.building.horizontal[0], exchanged.building.horizontal[1]);
  exchanged.block.azimuth_rad = 0.5 * std::numbers::pi - scene.block.azimuth_rad;
  const BuildingSlip other = exchanged.result();
  EXPECT_NEAR(other.slip.residual.along_m, one.slip.residual.along_m,
              1e-7 * one.slip.peak_displacement_m);
  EXPECT_NEAR(other.slip.residual.across_m, -one.slip.residual.across_m,
              1e-7 * one.slip.peak_displacement_m);
  EXPECT_NEAR(other.peak_base_shear[1], one.peak_base_shear[0], 1e-8 * one.peak_base_shear[0]);
  EXPECT_NEAR(other.peak_roof_displacement_m[0], one.peak_roof_displacement_m[1],
              1e-8 * one.peak_roof_displacement_m[1]);
}

TEST(slide_on_building, rests_at_critical_friction_and_slides_freely_beyond) {
  for (const double slope_deg : {1.0, 4.0, 20.0}) {
    OnBuilding scene;
    for (auto* x : {&scene.first, &scene.second, &scene.up}) x->assign(50, 0.0);
    scene.building = {{Oscillator{0.5, 0.0}, Oscillator{0.0}}, {}, 0.3};
    const double slope = slope_deg * rad_per_deg, mu = std::tan(slope);
    scene.block = {{mu, mu}, slope, 0.0};
    EXPECT_EQ(scene.result().slip.slip_phases, 0u);
    scene.block.friction = {0.9 * mu, mu};
    const SlipResult r = scene.result().slip;
    EXPECT_TRUE(r.free_sliding);
    const CoupledResult one = slide_coupled({scene.dt_s, scene.first}, {},
                                            {scene.building.horizontal[0][0].oscillator(), 0.3},
                                            {.friction = 0.9 * mu, .slope_rad = slope});
    EXPECT_NEAR(r.residual.along_m, one.slip.residual.along_m, 1e-7 * one.slip.residual.along_m);
  }
}

TEST(slide_on_building, without_friction_the_building_is_not_affected_by_a_block_on_a_flat_roof) {
  OnBuilding scene;
  scene.second.clear();
  scene.block = {};
  const BuildingSlip two = scene.result();
  const CoupledResult one =
      slide_coupled({scene.dt_s, scene.first, scene.up}, {},
                    {scene.building.horizontal[0][0].oscillator(), 0.0}, {.friction = 0.0});
  EXPECT_TRUE(two.slip.free_sliding);
  EXPECT_NEAR(two.slip.residual.along_m, one.slip.residual.along_m,
              1e-6 * one.slip.peak_displacement_m);
  EXPECT_NEAR(two.peak_base_shear[0], one.peak_base_shear, 1e-12);
}

TEST(coupling_is_regular, is_that_of_one_axis_where_both_axes_move) {
  for (const double mu : {0.5, 2.7, 2.9, 4.0}) {
    for (const double slope : {0.1, 0.6, 0.62, 1.2}) {
      for (const double ratio : {0.1, 0.5, 1.0}) {
        const BiaxialBuilding building{{Oscillator{0.5}, Oscillator{0.8}}, {}, ratio};
        EXPECT_EQ(coupling_is_regular({{mu, mu}, slope, 0.3}, building),
                  coupling_is_regular({.friction = mu, .slope_rad = slope}, ratio));
      }
    }
  }
  // A rigid axis gives way to nothing.
  EXPECT_FALSE(
      coupling_is_regular({{9.0, 9.0}, 0.7}, {{Oscillator{0.5}, Oscillator{0.5}}, {}, 1.0}));
  EXPECT_TRUE(
      coupling_is_regular({{9.0, 9.0}, 0.7}, {{Oscillator{0.0}, Oscillator{0.0}}, {}, 1.0}));
}

}  // namespace on_building_test
}  // namespace glissade
