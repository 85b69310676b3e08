// SPDX-License-Identifier: GPL-3.0-or-later
// The independent solver of tests/two_axis_truth against closed forms and against itself.
#include "two_axis_truth/two_axis_truth.hpp"

#include <gtest/gtest.h>

#include "glissade/block/coupled.hpp"
#include "unit/block/oscillator_reference.hpp"
#include "unit/block/reference.hpp"
#include "unit/block/truth_scenes.hpp"

namespace glissade {
namespace two_axis_truth_test {

using test::Long;
using test::TruthScene;
using test::TwoAxisTruth;

constexpr double g = standard_gravity_mps2;

void expect_near(Long actual, Long expected, Long tolerance) {
  EXPECT_NEAR(static_cast<double>(actual), static_cast<double>(expected),
              static_cast<double>(tolerance));
}

TEST(two_axis_truth, is_one_axis_in_fifty_digits) {
  int slid = 0;
  for (const unsigned seed : {1u, 2u})
    for (const double mu : {0.1, 0.3})
      for (const double slope_deg : {0.0, 4.0}) {
        const auto a = test::made_up_record(200, seed, 9.0);
        const auto w = test::made_up_record(200, seed + 10, 3.0);
        const double slope = slope_deg * rad_per_deg;
        const test::Reference r({0.01, a, w}, {mu, slope});
        const TwoAxisTruth truth({0.01, {a}, w, {}, {}, {{mu, mu}, slope}});
        const auto peak = static_cast<Long>(std::max(r.down, r.up));
        expect_near(truth.peak_m, peak, 1e-11L * peak);
        expect_near(truth.along_m, static_cast<Long>(r.slip), 1e-11L * peak);
        EXPECT_EQ(truth.peak_across_m, 0.0L);
        slid += peak > 1e-3L ? 1 : 0;
      }
  EXPECT_GE(slid, 6);
}

// Acceleration A for a time T, then linearly to zero over dt, at an angle of 0.7: v = (A - mu g) T
// and so on, against the acceleration.
TEST(two_axis_truth, slides_straight_under_a_constant_acceleration_at_an_angle) {
  const Long dt = 0.01, mu = 0.3, a = 5.0, brake = mu * g, lasts = 50.0L * dt;
  const Long v0 = (a - brake) * lasts, v1 = v0 + (0.5L * a - brake) * dt;
  const Long distance =
      0.5L * v0 * lasts + v0 * dt + (a / 3.0L - 0.5L * brake) * dt * dt + 0.5L * v1 * v1 / brake;
  const std::vector<double> one(51, 1.0);
  const double angle = 0.7;
  const MotionFactors factors{{5.0 * std::cos(angle), 5.0 * std::sin(angle)}, 1.0};
  const TwoAxisTruth truth({0.01, {one, one}, {}, factors, {}, {{0.3, 0.3}, 0.0, 0.0}});
  expect_near(truth.peak_m, distance, 1e-11L * distance);
  expect_near(truth.along_m, -distance * std::cos(0.7L), 1e-11L * distance);
  expect_near(truth.across_m, -distance * std::sin(0.7L), 1e-11L * distance);
  EXPECT_EQ(truth.phases, 1);
}

TEST(two_axis_truth, slides_freely_where_gravity_exceeds_friction) {
  const double slope = 0.2;
  const std::vector<double> rest(101, 0.0);
  const TwoAxisTruth truth({0.01, {rest, rest}, {}, {}, {}, {{0.1, 0.1}, slope, 0.3}});
  const Long gain = g * (std::sin(0.2L) - static_cast<Long>(0.1) * std::cos(0.2L));
  const Long distance = 0.5L * gain * std::cos(0.2L);
  expect_near(truth.along_m, distance, 1e-11L * distance);
  EXPECT_EQ(truth.across_m, 0.0L);
}

// The same equations on one axis: uncoupled in closed form at all times, coupled by
// slide_coupled().
TEST(two_axis_truth, is_one_axis_on_a_building) {
  const auto a = test::made_up_record(150, 3, 12.0);
  for (const double period_s : {0.2, 0.6}) {
    BiaxialBuilding building{.horizontal = {Oscillator{period_s, 0.05}, Oscillator{0.0}}};
    const Block block{{0.3, 0.3}, 0.03};
    const test::OscillatorReference smooth(0.01, a, period_s, 0.05, 1.0, {0.3, 0.03}, 10.0);
    const double peak_m = std::max(smooth.down, smooth.up);
    expect_near(TwoAxisTruth({0.01, {a}, {}, {}, building, block}).peak_m, peak_m, 1e-11 * peak_m);
    building.mass_ratio = 0.2;
    const CoupledResult r = slide_coupled({0.01, a, {}}, {}, {{period_s, 0.05}, 0.2}, {0.3, 0.03});
    const TwoAxisTruth truth({0.01, {a}, {}, {}, building, block});
    expect_near(truth.peak_m, r.slip.peak_displacement_m, 1e-11 * r.slip.peak_displacement_m);
    expect_near(truth.along_m, r.slip.residual.along_m, 1e-11 * r.slip.peak_displacement_m);
    EXPECT_GT(r.slip.peak_displacement_m, 1e-3);
  }
}

// The order is 9: a 512th of the tolerance halves the step.
TEST(two_axis_truth, is_the_same_with_half_the_step) {
  std::mt19937 random(3);
  for (const test::Roof roof : test::all_roofs)
    for (const test::Law law : test::all_laws) {
      const test::OnBuilding made = test::truth_scene(random, roof, law, 60);
      const TwoAxisTruth coarse(test::as_truth(made)), fine(test::as_truth(made), 1e-11 / 512.0);
      expect_near(coarse.peak_m, fine.peak_m, 1e-11L * fine.peak_m);
      expect_near(coarse.along_m, fine.along_m, 1e-11L * fine.peak_m);
      expect_near(coarse.across_m, fine.across_m, 1e-11L * fine.peak_m);
      EXPECT_EQ(coarse.phases, fine.phases);
    }
}

}  // namespace two_axis_truth_test
}  // namespace glissade
