// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/rotated_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/error.hpp"
#include "glissade/motion/response_spectrum.hpp"

namespace glissade {
namespace {

Motion motion_of(std::vector<double> first, std::vector<double> second, double dt_s = 0.01) {
  Motion motion;
  motion.id = "m";
  motion.dt_s = dt_s;
  motion.horizontal_mps2 = {std::move(first), std::move(second)};
  return motion;
}

std::vector<double> sweep(double phase, double growth) {
  std::vector<double> a;
  for (int i = 0; i < 1500; ++i) {
    const double t = 0.01 * i;
    a.push_back(std::sin(0.2 * t) * std::sin(3.0 * t + growth * t * t + phase));
  }
  return a;
}

// One line: |cos theta| is above cos 45 degrees along half of all directions.
TEST(rotated_spectrum, of_a_motion_along_one_line_is_its_spectrum_and_that_over_root_two) {
  const std::vector<double> a = sweep(0.0, 0.5);
  std::vector<double> b = a;
  for (double& value : b) value *= -0.75;
  const std::vector<double> periods_s{0.0, 0.2, 1.0, 3.0};
  const RotatedSpectrum s = rotated_spectrum(motion_of(a, b), periods_s);
  const std::vector<double> one = pseudo_acceleration_spectrum(0.01, a, periods_s);
  for (std::size_t i = 0; i < periods_s.size(); ++i) {
    EXPECT_NEAR(s.rotd100_mps2[i] / (1.25 * one[i]), 1.0, 6e-5) << periods_s[i];
    EXPECT_NEAR(s.rotd50_mps2[i] / s.rotd100_mps2[i], std::numbers::sqrt2 / 2.0, 1e-12);
  }
}

// Peaks of 3 and 4 along the axes: the support is max(3 |cos|, 4 |sin|). Its median m has, in a
// quarter turn, asin(m/4) - acos(m/3) = 45 degrees.
TEST(rotated_spectrum, of_two_peaks_at_right_angles_is_exact) {
  const RotatedSpectrum s = rotated_spectrum(motion_of({0.0, 3.0, 0.0, 0.0}, {0.0, 0.0, 0.0, -4.0}),
                                             std::vector<double>{0.0});
  EXPECT_EQ(s.rotd100_mps2[0], 4.0);
  const double m = s.rotd50_mps2[0];
  EXPECT_NEAR(std::asin(m / 4.0) - std::acos(m / 3.0), std::numbers::pi / 4.0, 1e-12);
}

TEST(rotated_spectrum, of_a_turning_motion_is_the_same_along_all_directions) {
  std::vector<double> a, b;
  for (int i = 0; i < 4000; ++i) {
    a.push_back(std::cos(2.0 * std::numbers::pi * i / 4000.0));
    b.push_back(std::sin(2.0 * std::numbers::pi * i / 4000.0));
  }
  const RotatedSpectrum s = rotated_spectrum(motion_of(a, b), std::vector<double>{0.0});
  EXPECT_NEAR(s.rotd100_mps2[0], 1.0, 1e-12);
  EXPECT_NEAR(s.rotd50_mps2[0], 1.0, 1e-6);
}

// An independent way: the exact spectrum along each of 1,800 directions.
void expect_spectra_along_many_directions(const std::vector<double>& a,
                                          const std::vector<double>& b) {
  const std::vector<double> periods_s{0.05, 0.3, 1.1};
  const RotatedSpectrum s = rotated_spectrum(motion_of(a, b), periods_s);
  constexpr int directions = 1800;
  std::vector<std::vector<double>> along(periods_s.size());
  for (int k = 0; k < directions; ++k) {
    const double angle = std::numbers::pi * k / directions;
    std::vector<double> turned;
    for (std::size_t i = 0; i < a.size(); ++i)
      turned.push_back(a[i] * std::cos(angle) + b[i] * std::sin(angle));
    const std::vector<double> sa = pseudo_acceleration_spectrum(0.01, turned, periods_s);
    for (std::size_t i = 0; i < sa.size(); ++i) along[i].push_back(sa[i]);
  }
  for (std::size_t i = 0; i < periods_s.size(); ++i) {
    std::ranges::sort(along[i]);
    EXPECT_NEAR(s.rotd100_mps2[i] / along[i].back(), 1.0, 6e-5) << periods_s[i];
    const double median = 0.5 * (along[i][directions / 2 - 1] + along[i][directions / 2]);
    EXPECT_NEAR(s.rotd50_mps2[i] / median, 1.0, 6e-4) << periods_s[i];
  }
}

TEST(rotated_spectrum, agrees_with_spectra_along_many_directions) {
  const std::vector<double> a = sweep(0.3, 0.4), b = sweep(1.9, 0.7);
  expect_spectra_along_many_directions(a, b);
  std::vector<double> nearly_a = b;  // along a line of 31 degrees but for a hundredth
  for (std::size_t i = 0; i < a.size(); ++i) nearly_a[i] = 0.6 * a[i] + 0.01 * b[i];
  expect_spectra_along_many_directions(a, nearly_a);
  std::vector<double> pulse = b;  // most of it in one short pulse
  for (std::size_t i = 700; i < 715; ++i) pulse[i] += 20.0;
  expect_spectra_along_many_directions(a, pulse);
}

TEST(rotated_spectrum, needs_two_horizontals) {
  EXPECT_THROW(rotated_spectrum(motion_of({1.0, 2.0}, {}), std::vector<double>{0.1}), InputError);
  const RotatedSpectrum s =
      rotated_spectrum(motion_of({0.0, 0.0}, {0.0, 0.0}), std::vector<double>{0.1});
  EXPECT_EQ(s.rotd50_mps2[0], 0.0);
}

}  // namespace
}  // namespace glissade
