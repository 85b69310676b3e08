// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/two_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glissade/block/slide.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace two_axis_test {

using test::made_up_record;
constexpr double g = standard_gravity_mps2;

struct Scene {
  std::vector<double> first = made_up_record(1200, 1, 8.0), second = made_up_record(1200, 51, 6.0),
                      up = made_up_record(1200, 101, 3.0);
  double dt_s = 0.005, factor = 1.0;
  Block block{{0.3, 0.3}, 2.0 * rad_per_deg, 0.4};
  double tolerance = 1e-6;
  SlipResult result() const {
    return slide_two_axis({dt_s, {first, second}, up, factor, factor}, block, tolerance);
  }
};

void expect_one_axis(const SlipResult& one, const SlipResult& two, double along, double across,
                     double relative) {
  const double tolerance_m = relative * one.peak_displacement_m;
  EXPECT_NEAR(two.peak_displacement_m, one.peak_displacement_m, tolerance_m);
  EXPECT_NEAR(two.residual.along_m, along * one.residual.along_m, tolerance_m);
  EXPECT_NEAR(two.residual.across_m, across * one.residual.along_m, tolerance_m);
  EXPECT_NEAR(two.peak_by_axis.along_m, std::abs(along) * one.peak_displacement_m, tolerance_m);
  EXPECT_NEAR(two.peak_velocity_mps, one.peak_velocity_mps, relative * one.peak_velocity_mps);
  EXPECT_NEAR(two.path_length_m, one.path_length_m, tolerance_m);
  EXPECT_NEAR(two.slip_duration_s, one.slip_duration_s, 1e-9 * one.slip_duration_s);
  EXPECT_EQ(two.uplift, one.uplift);
  EXPECT_EQ(two.free_sliding, one.free_sliding);
}

TEST(slide_two_axis, is_slide_where_the_roof_moves_along_the_slope) {
  int slid = 0;
  for (unsigned seed = 1; seed <= 4; ++seed) {
    const auto w = made_up_record(1200, seed + 100, 3.0), none = std::vector<double>(1200, 0.0);
    for (const double peak_mps2 : {4.0, 8.0, 20.0}) {
      const auto a = made_up_record(1200, seed, peak_mps2);
      for (const double mu : {0.05, 0.3, 0.5}) {
        for (const double slope_deg : {0.0, 1.19, 4.0, 7.0}) {
          const SlipResult one = slide({0.005, a, w}, {mu, slope_deg * rad_per_deg});
          for (const double across : {mu, 0.6 * mu}) {
            const Block block{{mu, across}, slope_deg * rad_per_deg};
            expect_one_axis(one, slide_two_axis({0.005, {a, none}, w}, block), 1.0, 0.0, 1e-12);
          }
          slid += one.slip_phases > 0 ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(slid, 100);
}

TEST(slide_two_axis, is_slide_where_a_flat_roof_moves_along_any_line) {
  const auto a = made_up_record(1200, 2, 8.0), w = made_up_record(1200, 102, 3.0);
  const SlipResult one = slide({0.005, a, w}, {0.3});
  for (const double angle : {0.3, 1.0, 2.5}) {
    std::vector<double> x, y;
    for (const double sample : a) {
      x.push_back(std::cos(angle) * sample);
      y.push_back(std::sin(angle) * sample);
    }
    expect_one_axis(one, slide_two_axis({0.005, {x, y}, w}, {{0.3, 0.3}}), std::cos(angle),
                    std::sin(angle), 1e-10);
  }
}

TEST(slide_two_axis, stays_put_when_the_vector_stays_within_friction) {
  // 0.18 and 0.24 g at right angles are 0.3 g together.
  const std::vector<double> a = {0.0, 0.18 * g, -0.18 * g, 0.0}, b = {0.0, 0.24 * g, 0.24 * g, 0.0};
  EXPECT_EQ(slide_two_axis({0.01, {a, b}}, {{0.3001, 0.3001}}).slip_phases, 0u);
  EXPECT_GT(slide_two_axis({0.01, {a, b}}, {{0.2999, 0.2999}}).peak_displacement_m, 0.0);
  // On the ellipse (0.18 / 0.3)^2 + (0.24 / 0.3)^2 = 1 as well, with either axis changed.
  EXPECT_GT(slide_two_axis({0.01, {a, b}}, {{0.2999, 0.3}}).peak_displacement_m, 0.0);
  EXPECT_GT(slide_two_axis({0.01, {a, b}}, {{0.3, 0.2999}}).peak_displacement_m, 0.0);
  EXPECT_EQ(slide_two_axis({0.01, {a, b}}, {{0.3001, 0.31}}).slip_phases, 0u);
}

TEST(slide_two_axis, rests_at_critical_friction_and_slides_freely_beyond) {
  const std::vector<double> still(50, 0.0);
  for (const double slope_deg : {1.0, 4.0, 20.0}) {
    const double slope = slope_deg * rad_per_deg, mu = std::tan(slope);
    EXPECT_EQ(slide_two_axis({0.01, {still, still}}, {{mu, mu}, slope}).slip_phases, 0u);
    const SlipResult r = slide_two_axis({0.01, {still, still}}, {{0.9 * mu, mu}, slope});
    EXPECT_TRUE(r.free_sliding);
    const double drive_mps2 = g * (std::sin(slope) - 0.9 * mu * std::cos(slope));
    EXPECT_NEAR(r.residual.along_m, 0.5 * drive_mps2 * 0.49 * 0.49 * std::cos(slope), 1e-12);
  }
}

TEST(slide_two_axis, mirrors_exactly) {
  const SlipResult one = Scene{}.result();
  Scene mirrored;
  mirrored.block.azimuth_rad *= -1.0;
  for (double& x : mirrored.second) x = -x;
  const SlipResult other = mirrored.result();
  EXPECT_EQ(other.residual.along_m, one.residual.along_m);
  EXPECT_EQ(other.residual.across_m, -one.residual.across_m);
  EXPECT_EQ(other.peak_displacement_m, one.peak_displacement_m);
  EXPECT_EQ(other.path_length_m, one.path_length_m);
}

// theory.md, 1.7.
TEST(slide_two_axis, scales_exactly_with_the_whole_acceleration_field_and_with_the_clock) {
  for (const double across : {0.3, 0.2}) {
    Scene scene;
    scene.block.friction.across = across;
    const SlipResult one = scene.result();
    Scene doubled = scene;
    doubled.factor = 2.0;
    doubled.block.gravity_mps2 *= 2.0;
    const SlipResult two = doubled.result();
    EXPECT_EQ(two.peak_displacement_m, 2.0 * one.peak_displacement_m);
    EXPECT_EQ(two.residual.across_m, 2.0 * one.residual.across_m);
    EXPECT_EQ(two.peak_velocity_mps, 2.0 * one.peak_velocity_mps);
    Scene slower = scene;
    slower.dt_s *= 2.0;
    const SlipResult four = slower.result();
    EXPECT_EQ(four.peak_displacement_m, 4.0 * one.peak_displacement_m);
    EXPECT_EQ(four.path_length_m, 4.0 * one.path_length_m);
    EXPECT_EQ(four.slip_duration_s, 2.0 * one.slip_duration_s);
  }
}

TEST(slide_two_axis, zeros_after_the_record_change_not_a_bit) {
  const SlipResult one = Scene{}.result();
  Scene padded;
  for (auto* x : {&padded.first, &padded.second, &padded.up}) x->resize(1500, 0.0);
  const SlipResult other = padded.result();
  EXPECT_EQ(other.peak_displacement_m, one.peak_displacement_m);
  EXPECT_EQ(other.residual.along_m, one.residual.along_m);
  EXPECT_EQ(other.path_length_m, one.path_length_m);
  EXPECT_EQ(other.slip_duration_s, one.slip_duration_s);
}

TEST(slide_two_axis, turning_the_motion_turns_the_path_on_a_flat_roof) {
  Scene scene;
  scene.tolerance = 1e-9;
  scene.block.slope_rad = 0.0;
  scene.block.azimuth_rad = 0.0;
  const SlipResult one = scene.result();
  for (const double angle : {0.7, 2.0}) {
    Scene turned = scene;
    turned.block.azimuth_rad = angle;  // the axes turn on, the components turn back
    const SlipResult r = turned.result();
    const double tolerance_m = 1e-8 * one.peak_displacement_m;
    EXPECT_NEAR(r.peak_displacement_m, one.peak_displacement_m, tolerance_m);
    EXPECT_NEAR(r.residual.along_m,
                std::cos(angle) * one.residual.along_m + std::sin(angle) * one.residual.across_m,
                tolerance_m);
    EXPECT_NEAR(r.residual.across_m,
                std::cos(angle) * one.residual.across_m - std::sin(angle) * one.residual.along_m,
                tolerance_m);
    EXPECT_NEAR(r.path_length_m, one.path_length_m, 1e-8 * one.path_length_m);
  }
}

TEST(slide_two_axis, exchanging_both_axes_exchanges_the_result) {
  Scene scene;
  scene.tolerance = 1e-9;
  scene.block = {{0.3, 0.2}};
  const SlipResult one = scene.result();
  scene.block = {{0.2, 0.3}, 0.0, std::numbers::pi / 2};
  const SlipResult other = scene.result();
  const double tolerance_m = 1e-8 * one.peak_displacement_m;
  EXPECT_NEAR(other.peak_by_axis.along_m, one.peak_by_axis.across_m, tolerance_m);
  EXPECT_NEAR(other.peak_by_axis.across_m, one.peak_by_axis.along_m, tolerance_m);
  EXPECT_NEAR(other.peak_displacement_m, one.peak_displacement_m, tolerance_m);
}

TEST(slide_two_axis, an_ellipse_that_is_nearly_a_circle_gives_nearly_the_same) {
  Scene scene;
  const SlipResult circle = scene.result();
  scene.block.friction.across *= 1.0 + 1e-12;
  EXPECT_NEAR(scene.result().peak_displacement_m, circle.peak_displacement_m,
              1e-5 * circle.peak_displacement_m);
}

TEST(slide_two_axis, orders_its_measures) {
  for (const double slope_deg : {0.0, 3.0}) {
    Scene scene;
    scene.block.slope_rad = slope_deg * rad_per_deg;
    const SlipResult r = scene.result();
    EXPECT_LE(r.peak_displacement_m, srss_of_maxima_m(r));
    EXPECT_LE(srss_of_maxima_m(r), std::numbers::sqrt2 * r.peak_displacement_m);
    EXPECT_GE(r.peak_displacement_m, r.peak_by_axis.along_m);
    EXPECT_GE(r.peak_displacement_m, r.peak_by_axis.across_m);
    EXPECT_GE(r.peak_displacement_m, std::hypot(r.residual.along_m, r.residual.across_m));
    EXPECT_GE(r.path_length_m, r.peak_displacement_m);
  }
}

TEST(slide_two_axis, the_history_holds_the_peak_and_ends_where_the_result_does) {
  const Scene scene;
  std::vector<TwoAxisPoint> history;
  const SlipResult r =
      slide_two_axis({scene.dt_s, {scene.first, scene.second}, scene.up}, scene.block, history);
  double farthest_m = 0.0, time_s = 0.0;
  for (const TwoAxisPoint& point : history) {
    farthest_m =
        std::max(farthest_m, std::hypot(point.displacement.along_m, point.displacement.across_m));
    EXPECT_GE(point.time_s, time_s);
    time_s = point.time_s;
  }
  EXPECT_LE(farthest_m, r.peak_displacement_m * (1.0 + 1e-12));
  EXPECT_GE(farthest_m, r.peak_displacement_m * (1.0 - 1e-3));
  EXPECT_EQ(history.back().displacement.along_m, r.residual.along_m);
}

}  // namespace two_axis_test
}  // namespace glissade
