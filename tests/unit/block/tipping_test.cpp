// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/tipping.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "unit/block/reference.hpp"

namespace glissade {
namespace tipping_test {

using test::made_up_record;

constexpr double g = standard_gravity_mps2;
constexpr double never = std::numeric_limits<double>::infinity();
constexpr double dt_s = 0.01;
constexpr RigidBase slender{.centre_of_mass_height_m = 1.0, .width_m = 0.5};  // b / (2 h) = 0.25

Block rough(double slope_rad) { return {.friction = 0.9, .slope_rad = slope_rad}; }

/// Up to `peak_mps2` and back, between samples linear.
std::vector<double> triangle(double peak_mps2) {
  return {0.0, 0.5 * peak_mps2, peak_mps2, 0.5 * peak_mps2, 0.0};
}

/// Made-up motions on a rigid roof and on oscillators, with and without vertical.
struct Scene {
  GroundMotion ground;
  Building building;
  Block block;
};

/// Runs `check` on made-up motions, buildings, slopes both ways and frictions; returns how many.
int for_each_scene(const std::function<void(const Scene&)>& check) {
  int scenes = 0;
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    const auto a = made_up_record(700, seed, 5.0), w = made_up_record(700, seed + 10, 4.0);
    for (const bool vertical : {false, true}) {
      for (const Building& building :
           {Building{}, Building{.horizontal = {0.13, 0.02}}, Building{.horizontal = {0.7, 0.05}},
            Building{.horizontal = {0.35, 0.05}, .vertical = {0.11, 0.03}}}) {
        for (const double slope_deg : {-6.0, 0.0, 3.0}) {
          for (const double mu : {0.15, 0.4}) {
            SCOPED_TRACE(testing::Message()
                         << "seed " << seed << " vertical " << vertical << " T "
                         << building.horizontal.period_s << " slope " << slope_deg << " mu " << mu);
            check({{dt_s, a, vertical ? std::span<const double>(w) : std::span<const double>()},
                   building,
                   {.friction = mu, .slope_rad = slope_deg * rad_per_deg}});
            ++scenes;
          }
        }
      }
    }
  }
  return scenes;
}

/// Followed until no block of for_each_scene can move at a factor up to 20.
RoofTable tabulated(const Scene& scene) {
  return tabulate_roof(scene.ground, scene.building,
                       {.quiet_horizontal_mps2 = 0.01, .quiet_vertical_mps2 = 0.01});
}

// -- closed forms

TEST(slip_onset, on_a_flat_roof_is_friction_times_gravity_over_the_peak) {
  const auto a = triangle(3.0);
  const Block block{.friction = 0.4};
  EXPECT_DOUBLE_EQ(slip_onset_factor(RoofTable(dt_s, a), block), 0.4 * g / 3.0);
  EXPECT_DOUBLE_EQ(slip_onset_factor({.dt_s = dt_s, .horizontal_mps2 = a}, block), 0.4 * g / 3.0);
}

TEST(slip_onset, downslope_only_waits_for_a_push_downslope) {
  auto a = triangle(8.0);  // upslope on a roof that falls toward +x
  a[3] = -1.0;
  const double slope = 0.05, phi = std::atan(0.4);
  Block block{.friction = 0.4, .slope_rad = slope};
  EXPECT_NEAR(slip_onset_factor(RoofTable(dt_s, a), block), g * std::tan(phi + slope) / 8.0, 1e-14);
  block.directions = SlipDirections::downslope_only;
  EXPECT_NEAR(slip_onset_factor(RoofTable(dt_s, a), block), g * std::tan(phi - slope) / 1.0, 1e-13);
}

TEST(slip_onset, without_horizontal_motion_comes_when_the_block_lifts) {
  const std::vector<double> still(5, 0.0);
  EXPECT_DOUBLE_EQ(slip_onset_factor(RoofTable(dt_s, still, triangle(-6.0)), {.friction = 0.4}),
                   g / 6.0);
  EXPECT_EQ(slip_onset_factor(RoofTable(dt_s, still, triangle(6.0)), {.friction = 0.4}), never);
}

TEST(slip_onset, is_zero_where_gravity_moves_the_block_and_never_where_nothing_does) {
  const Block sticking{.friction = 0.4, .slope_rad = 0.1},
      sliding{.friction = 0.4, .slope_rad = 0.5},
      critical{.friction = std::tan(0.1), .slope_rad = 0.1};
  const RoofTable still(dt_s, std::vector<double>(5, 0.0)), pushed(dt_s, triangle(-1.0));
  EXPECT_EQ(slip_onset_factor(still, sticking), never);
  EXPECT_EQ(slip_onset_factor(still, sliding), 0.0);
  EXPECT_EQ(slip_onset_factor(still, critical), never);
  EXPECT_EQ(slip_onset_factor(pushed, critical), 0.0);
}

TEST(tipping_onset, on_a_flat_roof_is_at_gravity_times_width_over_twice_the_height) {
  for (const double peak : {3.0, -3.0}) {
    const auto a = triangle(peak);
    EXPECT_DOUBLE_EQ(tipping_onset_factor(RoofTable(dt_s, a), rough(0.0), slender), 0.25 * g / 3.0);
    EXPECT_DOUBLE_EQ(
        tipping_onset_factor({.dt_s = dt_s, .horizontal_mps2 = a}, rough(0.0), slender),
        0.25 * g / 3.0);
  }
}

// Static equilibrium of the tilted body: about the lower edge when pushed toward -x, about the
// upper when pushed toward +x.
TEST(tipping_onset, on_a_slope_is_at_the_angle_of_the_body_less_or_plus_that_of_the_roof) {
  const double slope = 0.1, alpha = std::atan(0.25);
  const RoofTable toward_minus_x(dt_s, triangle(-2.0)), toward_plus_x(dt_s, triangle(2.0));
  const double over_lower_edge = g * std::tan(alpha - slope) / 2.0,
               over_upper_edge = g * std::tan(alpha + slope) / 2.0;
  EXPECT_NEAR(tipping_onset_factor(toward_minus_x, rough(slope), slender), over_lower_edge, 1e-14);
  EXPECT_NEAR(tipping_onset_factor(toward_plus_x, rough(slope), slender), over_upper_edge, 1e-14);
  EXPECT_NEAR(tipping_onset_factor(toward_plus_x, rough(-slope), slender), over_lower_edge, 1e-14);
  EXPECT_NEAR(tipping_onset_factor(toward_minus_x, rough(-slope), slender), over_upper_edge, 1e-14);
}

TEST(tipping_onset, with_the_vertical_in_step_comes_at_a_over_g_plus_w) {
  // f A = mu_t (g + f W)
  for (const double up : {-2.0, 2.0}) {
    EXPECT_NEAR(
        tipping_onset_factor(RoofTable(dt_s, triangle(3.0), triangle(up)), rough(0.0), slender),
        0.25 * g / (3.0 - 0.25 * up), 1e-14);
  }
}

TEST(tipping_onset, never_comes_where_friction_lets_the_body_slide_first) {
  const auto a = triangle(50.0);
  Block block{.friction = 0.25};
  EXPECT_EQ(tipping_onset_factor(RoofTable(dt_s, a), block, slender), never);
  EXPECT_EQ(tipping_onset_factor({.dt_s = dt_s, .horizontal_mps2 = a}, block, slender), never);
  block.friction = std::nextafter(0.25, 1.0);
  EXPECT_DOUBLE_EQ(tipping_onset_factor(RoofTable(dt_s, a), block, slender), 0.25 * g / 50.0);
}

TEST(tipping_onset, needs_no_motion_where_the_roof_is_steeper_than_the_body) {
  const RoofTable still(dt_s, std::vector<double>(5, 0.0));
  EXPECT_EQ(tipping_onset_factor(still, rough(0.26), slender), 0.0);  // tan > 0.25
  EXPECT_EQ(tipping_onset_factor(still, rough(-0.26), slender), 0.0);
  EXPECT_EQ(tipping_onset_factor(still, rough(0.24), slender), never);
}

TEST(tipping_onset, looks_at_both_edges_whatever_way_the_block_may_slip) {
  Block block = rough(0.05);
  const RoofTable upslope(dt_s, triangle(3.0));
  const double both = tipping_onset_factor(upslope, block, slender);
  block.directions = SlipDirections::downslope_only;
  EXPECT_EQ(tipping_onset_factor(upslope, block, slender), both);
  EXPECT_EQ(slip_onset_factor(upslope, block), never);
}

// -- invariants

TEST(tipping_onset, is_mirrored_with_motion_and_slope_to_the_last_bit) {
  for_each_scene([](const Scene& scene) {
    const RoofTable roof = tabulated(scene);
    Block block = rough(scene.block.slope_rad);
    const double one = tipping_onset_factor(roof, block, slender);
    block.slope_rad *= -1.0;
    const double other = tipping_onset_factor(roof, block, slender, {-1.0, 1.0});
    EXPECT_EQ(one, other);
  });
}

TEST(tipping_onset, scales_with_gravity_and_against_the_unit_to_the_last_bit) {
  for_each_scene([](const Scene& scene) {
    const RoofTable roof = tabulated(scene);
    Block block = rough(scene.block.slope_rad);
    const double one = tipping_onset_factor(roof, block, slender);
    EXPECT_EQ(tipping_onset_factor(roof, block, slender, {4.0, 4.0}), 0.25 * one);
    block.gravity_mps2 *= 4.0;
    EXPECT_EQ(tipping_onset_factor(roof, block, slender), 4.0 * one);
    EXPECT_EQ(tipping_onset_factor(roof, block, {4.0, 2.0}), 4.0 * one);  // as slender
  });
}

// -- one answer whichever way it is asked

TEST(slip_onset, is_where_the_kernel_begins_to_slip) {
  const int scenes = for_each_scene([](const Scene& scene) {
    const RoofTable roof = tabulated(scene);
    for (const auto directions : {SlipDirections::both, SlipDirections::downslope_only}) {
      Block block = scene.block;
      block.directions = directions;
      const MotionFactors per_unit{-0.7, 1.2};
      const auto slip = [&](double factor) {
        return peak_slip(roof, block,
                         {factor * per_unit.horizontal[0], factor * per_unit.vertical});
      };
      const double onset = slip_onset_factor(roof, block, per_unit);
      ASSERT_LT(onset, 20.0);
      EXPECT_EQ(slip(0.999 * onset).peak_displacement_m, 0.0);
      EXPECT_EQ(slip((1.0 - 1e-9) * onset).slip_phases, 0u);
      EXPECT_GT(slip(1.001 * onset).peak_displacement_m, 0.0);
    }
  });
  EXPECT_EQ(scenes, 4 * 2 * 4 * 3 * 2);
}

/// The largest |d| h less (N/m) b / 2 over the samples, by (N/m) b / 2: positive where it rocks.
double largest_excess_moment(const RoofMotion& roof, double factor, double slope_rad,
                             const RigidBase& base) {
  double largest = -never;
  for (std::size_t i = 0; i < roof.horizontal_mps2.size(); ++i) {
    const double a = factor * roof.horizontal_mps2[i];
    const double up = roof.vertical_mps2.empty() ? 0.0 : factor * roof.vertical_mps2[i];
    const double along = (g + up) * std::sin(slope_rad) - a * std::cos(slope_rad);
    const double normal = (g + up) * std::cos(slope_rad) + a * std::sin(slope_rad);
    const double righting = 0.5 * normal * base.width_m;
    const double overturning = std::abs(along) * base.centre_of_mass_height_m;
    largest = std::max(largest, (overturning - righting) / righting);
  }
  return largest;
}

// The table against moments about the edges, sample by sample, of the roof's motion at 4,000
// samples a period: off by (2 pi / 4000)^2 / 8 = 3e-7 of the peak.
TEST(tipping_onset, is_where_the_moments_about_an_edge_balance) {
  for_each_scene([](const Scene& scene) {
    const RoofMotion fine = roof_motion(
        scene.ground, scene.building,
        {.quiet_horizontal_mps2 = 0.01, .quiet_vertical_mps2 = 0.01, .steps_per_period = 4000});
    const Block block = rough(scene.block.slope_rad);
    const double onset = tipping_onset_factor(tabulated(scene), block, slender);
    EXPECT_LT(largest_excess_moment(fine, (1.0 - 1e-6) * onset, block.slope_rad, slender), 0.0);
    EXPECT_GT(largest_excess_moment(fine, (1.0 + 1e-6) * onset, block.slope_rad, slender), 0.0);
    const RoofAcceleration samples{fine.dt_s, fine.horizontal_mps2, fine.vertical_mps2};
    EXPECT_NEAR(tipping_onset_factor(samples, block, slender), onset, 1e-6 * onset);
  });
}

TEST(slip_onset, on_a_rigid_roof_is_the_reference_s_to_the_last_bit) {
  for_each_scene([](const Scene& scene) {
    if (scene.building.horizontal.period_s > 0.0) return;
    const double by_samples = slip_onset_factor({.dt_s = dt_s,
                                                 .horizontal_mps2 = scene.ground.horizontal_mps2,
                                                 .vertical_mps2 = scene.ground.vertical_mps2,
                                                 .horizontal_factor = -0.7,
                                                 .vertical_factor = 1.2},
                                                scene.block);
    EXPECT_EQ(slip_onset_factor(tabulated(scene), scene.block, {-0.7, 1.2}), by_samples);
  });
}

/// On a flat roof the drives are -a - mu w and a - mu w, less mu g.
double onset_looking_into_every_interval(const RoofTable& roof, double friction) {
  const MotionNodes a = roof.horizontal->at_nodes();
  const std::size_t last = std::max(roof.horizontal->end, roof.vertical ? roof.vertical->end : 0);
  double onset = never;
  for (const double direction : {-1.0, 1.0}) {
    double push = 0.0;
    for (std::size_t i = 0; i < last; ++i) {
      Quartic drive = a.acceleration_after(i);
      for (double& b : drive.b) b *= direction;
      if (roof.vertical) {
        const Quartic w = roof.vertical->at_nodes().acceleration_after(i);
        for (int k = 0; k < 5; ++k) drive.b[k] += -friction * w.b[k];
      }
      raise_to_largest(drive, push);
    }
    onset = std::min(onset, friction * g / push);
  }
  return onset;
}

TEST(slip_onset, passes_nothing_over_that_looking_into_every_interval_would_find) {
  for_each_scene([](const Scene& scene) {
    const RoofTable roof = tabulated(scene);
    const double mu = scene.block.friction.along;
    EXPECT_EQ(slip_onset_factor(roof, {.friction = mu}),
              onset_looking_into_every_interval(roof, mu));
  });
}

TEST(slip_onset, finds_a_peak_between_nodes) {
  // As in peak_slip_building_test: twenty nodes a period, so a free vibration peaks between two.
  const std::vector<double> pulse{0.0, 3.0, 0.0};
  const RoofTable roof =
      tabulate_roof({dt_s, pulse}, {.horizontal = {0.2, 0.02}}, {.quiet_horizontal_mps2 = 0.01});
  const double peak = peak_acceleration_mps2(*roof.horizontal);
  EXPECT_NEAR(slip_onset_factor(roof, {.friction = 0.3}), 0.3 * g / peak, 2e-12);
}

}  // namespace tipping_test
}  // namespace glissade
