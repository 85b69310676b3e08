// SPDX-License-Identifier: GPL-3.0-or-later
// The relative displacement of two arrays under one motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/block/on_building.hpp"
#include "glissade/block/slide.hpp"
#include "unit/block/on_building_scene.hpp"

namespace glissade {
namespace closing_test {

using test::OnBuilding;

Block with_friction(Block block, double factor) {
  block.friction.along *= factor;
  block.friction.across *= factor;
  return block;
}

/// On the slope that falls toward the block's.
Block facing(Block block) {
  block.azimuth_rad += std::numbers::pi;
  return block;
}

PlanVector closing(const OnBuilding& scene, const Block& block, const Block& neighbour) {
  return closing_on_building(scene.ground(), {scene.factor, scene.factor}, scene.building, block,
                             neighbour, scene.tolerance);
}

PlanVector closing(const OnBuilding& scene, double factor, double other_factor) {
  return closing(scene, with_friction(scene.block, factor),
                 with_friction(scene.block, other_factor));
}

PlanVector closing_across_a_valley(const OnBuilding& scene, double factor, double other_factor) {
  return closing(scene, with_friction(scene.block, factor),
                 facing(with_friction(scene.block, other_factor)));
}

/// Displacement of a block of friction mu on a flat roof that is pushed by a toward +x for T
/// seconds, and then less and less over dt: it slides back until friction stops it.
double pushed_m(double mu, double a, double T, double dt) {
  const double g = standard_gravity_mps2, rate = a - mu * g;
  const double v = -rate * T, v_end = v - rate * dt + 0.5 * a * dt;
  EXPECT_LT(v_end, 0.0);  // it stops after the ramp
  return -0.5 * rate * T * T + v * dt - 0.5 * rate * dt * dt + a * dt * dt / 6.0 -
         v_end * v_end / (2.0 * mu * g);
}

TEST(closing_on_building, of_a_constant_push_is_its_closed_form) {
  constexpr double a = 6.0, dt = 0.01;
  const std::vector<double> push(101, a);
  const BuildingGround ground{{std::make_shared<GroundTable>(dt, push), nullptr}, nullptr};
  const Block rough{.friction = 0.4}, smooth{.friction = 0.3};
  const double apart_m = pushed_m(0.4, a, 1.0, dt) - pushed_m(0.3, a, 1.0, dt);
  ASSERT_GT(apart_m, 0.5);
  // The smooth one slides farther back, so it comes closer if it lies ahead of the rough one.
  const PlanVector closes = closing_on_building(ground, {}, {}, rough, smooth);
  EXPECT_NEAR(closes.along_m, apart_m, 1e-9 * apart_m);
  EXPECT_EQ(closes.across_m, 0.0);
  EXPECT_EQ(closing_on_building(ground, {}, {}, smooth, rough).along_m, 0.0);
  const PlanVector reversed = closing_on_building(ground, {{-1.0, 1.0}, 1.0}, {}, smooth, rough);
  EXPECT_EQ(reversed.along_m, closes.along_m);
}

TEST(closing_on_building, of_equal_arrays_is_exactly_zero) {
  OnBuilding scene;
  scene.building.yielding[0] = {4.0, 0.1};
  const PlanVector none = closing(scene, 1.0, 1.0);
  EXPECT_EQ(none.along_m, 0.0);
  EXPECT_EQ(none.across_m, 0.0);
  EXPECT_GT(closing(scene, 1.5, 1.0).along_m, 0.0);
}

/// Displacement at a time, exact on a rigid roof: between the points of its history slip is a
/// cubic.
double displacement_at(const std::vector<SlipPoint>& history, double time_s) {
  const auto after = std::ranges::upper_bound(history, time_s, {}, &SlipPoint::time_s);
  if (after == history.end()) return history.back().displacement_m;
  if (after == history.begin()) return 0.0;
  const SlipPoint &a = *(after - 1), &b = *after;
  const double h = b.time_s - a.time_s, t = (time_s - a.time_s) / h, u = 1.0 - t;
  return u * u * (1.0 + 2.0 * t) * a.displacement_m + t * t * (1.0 + 2.0 * u) * b.displacement_m +
         h * t * u * (u * a.velocity_mps - t * b.velocity_mps);
}

struct TwoOnOneAxis {
  OnBuilding scene;
  std::array<std::vector<SlipPoint>, 2> histories;
  double peak_m = 0.0, end_s = 0.0;
};

/// Two arrays on a rigid roof, the second of 1.2 times the friction, by slide(), which is exact.
/// @param factor of the ground motion of the second
TwoOnOneAxis two_on_one_axis(unsigned seed, double factor) {
  TwoOnOneAxis two{OnBuilding(seed, 600, 12.0), {}};
  OnBuilding& scene = two.scene;
  scene.second.clear();
  scene.building = {};
  scene.block.azimuth_rad = 0.0;
  for (const std::size_t i : {0u, 1u}) {
    const Block block{.friction = (i == 0 ? 1.0 : 1.2) * scene.block.friction.along,
                      .slope_rad = scene.block.slope_rad};
    const RoofAcceleration roof{scene.dt_s, scene.first, scene.up, i == 0 ? 1.0 : factor, 1.0};
    two.peak_m = std::max(two.peak_m, slide(roof, block, two.histories[i]).peak_displacement_m);
    two.end_s = std::max(two.end_s, two.histories[i].back().time_s);
  }
  return two;
}

// slide() is exact on one axis. Its histories are sampled, so their largest difference is a little
// below the true one.
TEST(closing_on_building, is_that_of_two_exact_histories_on_one_axis) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto [scene, histories, peak_m, end_s] = two_on_one_axis(seed, 1.0);
    double ahead_m = 0.0, behind_m = 0.0;
    for (double t = 0.0; t < end_s; t += scene.dt_s / 64.0) {
      const double apart_m = displacement_at(histories[0], t) - displacement_at(histories[1], t);
      ahead_m = std::max(ahead_m, apart_m);
      behind_m = std::max(behind_m, -apart_m);
    }
    ASSERT_GT(ahead_m, 0.01 * peak_m);
    EXPECT_NEAR(closing(scene, 1.0, 1.2).along_m, ahead_m, 1e-5 * peak_m) << seed;
    EXPECT_NEAR(closing(scene, 1.2, 1.0).along_m, behind_m, 1e-5 * peak_m) << seed;
  }
}

// On facing slopes each slides down its own: under the same motion one of them has it reversed.
TEST(closing_on_building, across_a_valley_is_the_sum_of_two_exact_histories_on_one_axis) {
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto [scene, histories, peak_m, end_s] = two_on_one_axis(seed, -1.0);
    double closing_m = 0.0;
    for (double t = 0.0; t < end_s; t += scene.dt_s / 64.0)
      closing_m =
          std::max(closing_m, displacement_at(histories[0], t) + displacement_at(histories[1], t));
    ASSERT_GT(closing_m, 0.01 * peak_m);
    EXPECT_NEAR(closing_across_a_valley(scene, 1.0, 1.2).along_m, closing_m, 1e-5 * peak_m) << seed;
  }
}

// Across a valley equal arrays meet where on one slope they do not; on a flat roof there is no
// valley.
TEST(closing_on_building, across_a_valley_is_that_on_one_slope_where_the_roof_is_flat) {
  for (const double slope_rad : {0.0, 0.05}) {
    OnBuilding scene;
    scene.block.slope_rad = slope_rad;
    const double peak_m = scene.result().slip.peak_displacement_m;
    const PlanVector one = closing(scene, 1.3, 1.0),
                     valley = closing_across_a_valley(scene, 1.3, 1.0),
                     equal = closing_across_a_valley(scene, 1.0, 1.0);
    if (slope_rad == 0.0) {
      EXPECT_NEAR(valley.along_m, one.along_m, 1e-5 * peak_m);
      EXPECT_NEAR(valley.across_m, one.across_m, 1e-5 * peak_m);
      EXPECT_NEAR(equal.along_m, 0.0, 1e-5 * peak_m);
    } else {
      EXPECT_GT(valley.along_m, one.along_m + 0.1 * peak_m);
      EXPECT_GT(equal.along_m, 0.1 * peak_m);
    }
  }
}

// From either array the gap is the same one.
TEST(closing_on_building, across_a_valley_is_that_seen_from_the_other_side) {
  OnBuilding scene;
  const Block other = facing(with_friction(scene.block, 1.3));
  const PlanVector found = closing(scene, scene.block, other),
                   back = closing(scene, other, scene.block);
  ASSERT_GT(found.along_m, 0.0);
  EXPECT_NEAR(back.along_m, found.along_m, 1e-9 * found.along_m);
  EXPECT_NEAR(back.across_m, found.across_m, 1e-9 * found.along_m);
}

// On a roof that does not move horizontally two arrays that friction does not hold slide down by
// the same distance, which each has alone.
TEST(closing_on_building, of_symmetric_arrays_across_a_valley_is_twice_the_slip_of_one) {
  OnBuilding scene(1, 600, 12.0);
  std::ranges::fill(scene.first, 0.0);
  std::ranges::fill(scene.second, 0.0);
  scene.building = {};
  scene.block.friction = 0.09;
  scene.block.slope_rad = 0.1;
  const SlipResult one = scene.result().slip;
  ASSERT_GT(one.peak_by_axis.along_m, 1e-3);
  EXPECT_NEAR(closing_across_a_valley(scene, 1.0, 1.0).along_m, 2.0 * one.peak_by_axis.along_m,
              1e-9 * one.peak_by_axis.along_m);
}

PlanVector displacement_at(const std::vector<TwoAxisPoint>& history, double time_s) {
  const auto after = std::ranges::upper_bound(history, time_s, {}, &TwoAxisPoint::time_s);
  if (after == history.end()) return history.back().displacement;
  if (after == history.begin()) return {};
  const TwoAxisPoint &a = *(after - 1), &b = *after;
  const double share = (time_s - a.time_s) / (b.time_s - a.time_s);
  return {std::lerp(a.displacement.along_m, b.displacement.along_m, share),
          std::lerp(a.displacement.across_m, b.displacement.across_m, share)};
}

// Between the points of a fine history on two axes the displacement is close to linear.
void expect_that_of_two_fine_histories(bool across_a_valley) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    OnBuilding scene(seed, 400, 12.0);
    scene.building = {};
    std::array<std::vector<TwoAxisPoint>, 2> fine;
    double peak_m = 0.0;
    for (const std::size_t i : {0u, 1u}) {
      Block block = with_friction(scene.block, i == 0 ? 1.3 : 1.0);
      if (i == 1 && across_a_valley) block = facing(block);
      const SlipResult alone = slide_two_axis({scene.dt_s, {scene.first, scene.second}, scene.up},
                                              block, fine[i], 1e-11);
      peak_m = std::max(peak_m, alone.peak_displacement_m);
    }
    // The axes of a facing slope are those of this one, turned by half a turn.
    const double sign = across_a_valley ? -1.0 : 1.0;
    PlanVector ahead;
    const double end_s = std::max(fine[0].back().time_s, fine[1].back().time_s);
    for (double t = 0.0; t < end_s + scene.dt_s; t += scene.dt_s / 16.0) {
      const PlanVector one = displacement_at(fine[0], t), other = displacement_at(fine[1], t);
      ahead.along_m = std::max(ahead.along_m, one.along_m - sign * other.along_m);
      ahead.across_m = std::max(ahead.across_m, one.across_m - sign * other.across_m);
    }
    const PlanVector found =
        across_a_valley ? closing_across_a_valley(scene, 1.3, 1.0) : closing(scene, 1.3, 1.0);
    ASSERT_GT(found.along_m, 0.0);
    EXPECT_NEAR(found.along_m, ahead.along_m, 1e-3 * peak_m) << seed;
    EXPECT_NEAR(found.across_m, ahead.across_m, 1e-3 * peak_m) << seed;
  }
}

TEST(closing_on_building, is_that_of_two_fine_histories_on_two_axes) {
  expect_that_of_two_fine_histories(false);
}

TEST(closing_on_building, across_a_valley_is_that_of_two_fine_histories_on_two_axes) {
  expect_that_of_two_fine_histories(true);
}

TEST(closing_on_building, is_within_its_tolerance_on_any_building) {
  std::mt19937 random(5);
  double largest = 0.0;
  std::size_t compared = 0;
  for (unsigned k = 0; k < 60; ++k) {
    OnBuilding scene(random, k, 400);
    const double peak_m = scene.result().slip.peak_displacement_m;
    if (peak_m < 1e-5) continue;
    const PlanVector usual = closing(scene, 1.2, 1.0);
    scene.tolerance = 1e-10;
    const PlanVector fine = closing(scene, 1.2, 1.0);
    largest = std::max({largest, std::abs(usual.along_m - fine.along_m) / peak_m,
                        std::abs(usual.across_m - fine.across_m) / peak_m});
    ++compared;
  }
  EXPECT_GT(compared, 40u);
  EXPECT_LT(largest, 1e-5);
  RecordProperty("largest_e9", std::to_string(1e9 * largest));
}

TEST(closing_on_building, changes_sides_with_the_mirrored_ground) {
  OnBuilding scene;
  scene.block.azimuth_rad = 0.0;
  const BuildingGround ground = scene.ground();
  const Block other = with_friction(scene.block, 1.3);
  const PlanVector found = closing_on_building(ground, {}, scene.building, other, scene.block);
  const PlanVector mirrored =
      closing_on_building(ground, {{1.0, -1.0}, 1.0}, scene.building, scene.block, other);
  EXPECT_GT(found.across_m, 0.0);
  EXPECT_NEAR(mirrored.across_m, found.across_m, 1e-9 * found.across_m);
}

}  // namespace closing_test
}  // namespace glissade
