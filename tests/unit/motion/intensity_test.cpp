// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/intensity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glissade/motion/response_spectrum.hpp"

namespace glissade {
namespace {

Motion two_components() {
  Motion motion;
  motion.dt_s = 0.1;
  motion.horizontal_mps2 = {{{0.0, 3.0, -1.0, 0.5}, {0.0, -4.0, 2.0, 0.0}}};
  return motion;
}

Motion one_component() {
  Motion motion = two_components();
  motion.horizontal_mps2[1] = {};
  return motion;
}

TEST(peak_ground_acceleration, is_the_largest_magnitude_of_either_sign) {
  EXPECT_EQ(peak_ground_acceleration_mps2(std::vector{1.0, -2.5, 2.0}), 2.5);
}

// One sample of 2 m/s2 that falls to zero over 0.5 s: half of 2 x 0.5.
TEST(peak_ground_velocity, includes_the_interval_to_zero_after_the_last_sample) {
  EXPECT_DOUBLE_EQ(peak_ground_velocity_mps(0.5, std::vector{2.0}), 0.5);
}

// An acceleration that falls from 2 to 0 over 1 s moves by (2 x 2 + 0) / 6.
TEST(peak_ground_displacement, is_integrated_exactly_from_rest) {
  EXPECT_DOUBLE_EQ(peak_ground_displacement_m(1.0, std::vector{2.0}), 2.0 / 3.0);
  // 1 m/s2 over ten steps of 0.1 s, from rest: t^2 / 2 at 0.9 s, and the tail.
  const double at_end = 0.5 * 0.9 * 0.9 + 0.1 * (0.9 + 0.1 * 2.0 / 6.0);
  EXPECT_NEAR(peak_ground_displacement_m(0.1, std::vector<double>(10, 1.0)), at_end, 1e-12);
}

// Of a constant |a| the integral of a^2 rises evenly: 90 % of the time. Two components count
// together: the second, as strong and as long after the first, doubles the time.
TEST(significant_duration, is_the_time_from_5_to_95_percent_of_the_integral_of_squares) {
  const std::vector<double> first(1000, 2.0);
  EXPECT_NEAR(significant_duration_s(0.01, first), 9.0, 0.01);
  std::vector<double> second(2000, 0.0);
  std::fill(second.begin() + 1000, second.end(), 2.0);
  EXPECT_NEAR(significant_duration_s(0.01, first, second), 18.0, 0.02);
  EXPECT_EQ(significant_duration_s(0.01, std::vector<double>(10, 0.0)), 0.0);
}

// From 3 to -1 over 1 s: the velocity peaks at 3/4 s, at 3 x 0.75 / 2 = 1.125; at the samples it is
// 1 and, after the tail, 0.5.
TEST(peak_ground_velocity, finds_the_peak_between_samples) {
  EXPECT_DOUBLE_EQ(peak_ground_velocity_mps(1.0, std::vector{3.0, -1.0}), 1.125);
}

TEST(peak_ground_velocity, is_the_same_for_the_mirrored_and_for_the_interpolated_record) {
  const std::vector<double> record = {0.0, 3.0, -1.0, -2.0, 0.5};
  const std::vector<double> mirrored = {0.0, -3.0, 1.0, 2.0, -0.5};
  const std::vector<double> finer = {0.0, 1.5, 3.0, 1.0, -1.0, -1.5, -2.0, -0.75, 0.5, 0.25};
  const double expected = peak_ground_velocity_mps(0.02, record);
  EXPECT_EQ(peak_ground_velocity_mps(0.02, mirrored), expected);
  EXPECT_NEAR(peak_ground_velocity_mps(0.01, finer), expected, 1e-15);
}

TEST(horizontal_combination, is_five_and_root_twelve_for_three_and_four) {
  EXPECT_DOUBLE_EQ(combine(HorizontalCombination::srss, 3.0, 4.0), 5.0);
  EXPECT_DOUBLE_EQ(combine(HorizontalCombination::geometric_mean, 3.0, 4.0), std::sqrt(12.0));
}

TEST(horizontal_pga, combines_the_peaks_of_the_two_components) {
  EXPECT_DOUBLE_EQ(horizontal_pga_mps2(two_components(), HorizontalCombination::srss), 5.0);
}

TEST(horizontal_measures, of_one_component_are_those_of_that_component) {
  const Motion motion = one_component();
  const std::vector<double> periods_s = {0.0, 0.5, 1.0};
  const std::vector<double> alone =
      pseudo_acceleration_spectrum(motion.dt_s, motion.horizontal_mps2[0], periods_s);
  for (const auto combination :
       {HorizontalCombination::srss, HorizontalCombination::geometric_mean}) {
    EXPECT_EQ(horizontal_pga_mps2(motion, combination), 3.0);
    EXPECT_EQ(horizontal_pgv_mps(motion, combination),
              peak_ground_velocity_mps(motion.dt_s, motion.horizontal_mps2[0]));
    EXPECT_EQ(horizontal_spectrum_mps2(motion, periods_s, combination), alone);
  }
  EXPECT_NEAR(average_sa_mps2(motion, periods_s), std::cbrt(alone[0] * alone[1] * alone[2]), 1e-14);
}

TEST(horizontal_measures, leave_the_motions_scale_out) {
  Motion scaled = two_components();
  scaled.scale = 3.0;
  EXPECT_EQ(horizontal_pga_mps2(scaled, HorizontalCombination::srss),
            horizontal_pga_mps2(two_components(), HorizontalCombination::srss));
}

// Eads, Miranda & Lignos (2015): the geometric mean over periods, and here over both components: n
// = 2 x 2 values.
TEST(average_sa, is_the_geometric_mean_over_periods_and_components) {
  const Motion motion = two_components();
  const std::vector<double> periods_s = {0.4, 1.1};
  double product = 1.0;
  for (const Samples& component : motion.horizontal_mps2) {
    for (const double sa : pseudo_acceleration_spectrum(motion.dt_s, component, periods_s))
      product *= sa;
  }
  EXPECT_NEAR(average_sa_mps2(motion, periods_s), std::pow(product, 0.25), 1e-14);
}

}  // namespace
}  // namespace glissade
