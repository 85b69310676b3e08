// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/spectral_gain.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/motion/response_spectrum.hpp"
#include "glissade/motion/simulation/gain_calibration.hpp"

namespace glissade {
namespace {

constexpr double pi = std::numbers::pi;

TEST(spectral_gain, is_straight_in_logarithms_and_constant_outside) {
  const SpectralGain gain{{1.0, 4.0}, {1.0, 16.0}};
  EXPECT_DOUBLE_EQ(gain(0.0), 1.0);
  EXPECT_DOUBLE_EQ(gain(1.0), 1.0);
  EXPECT_NEAR(gain(2.0), 4.0, 1e-12);
  EXPECT_NEAR(gain(3.0), 9.0, 1e-12);
  EXPECT_DOUBLE_EQ(gain(100.0), 16.0);
}

TEST(apply_gain, multiplies_by_a_constant_gain) {
  std::vector<double> signal(777);
  for (std::size_t i = 0; i < signal.size(); ++i)
    signal[i] = std::sin(0.37 * static_cast<double>(i * i % 101));
  const std::vector<double> result = apply_gain(signal, 0.01, {{1.0, 2.0}, {3.0, 3.0}});
  ASSERT_EQ(result.size(), signal.size());
  for (std::size_t i = 0; i < signal.size(); ++i) EXPECT_NEAR(result[i], 3.0 * signal[i], 1e-12);
}

// A tone in a Gaussian window whose spectrum (sd 1/(2 pi 2 s) = 0.08 Hz) lies where the gain is
// constant.
TEST(apply_gain, multiplies_a_tone_by_the_gain_at_its_frequency_and_keeps_its_phase) {
  constexpr double dt_s = 0.01;
  const SpectralGain gain{{1.0, 1.5, 2.5, 4.0}, {0.5, 2.0, 2.0, 9.0}};
  std::vector<double> signal(3000);
  for (std::size_t i = 0; i < signal.size(); ++i) {
    const double t = static_cast<double>(i) * dt_s - 15.0;
    signal[i] = std::exp(-0.5 * t * t / 4.0) * std::cos(2 * pi * 2.0 * t);
  }
  const std::vector<double> result = apply_gain(signal, dt_s, gain);
  for (std::size_t i = 0; i < signal.size(); ++i) EXPECT_NEAR(result[i], 2.0 * signal[i], 1e-6);
}

TEST(apply_gain, keeps_a_symmetric_pulse_symmetric) {
  std::vector<double> signal(2001, 0.0);
  signal[1000] = 1.0;
  const std::vector<double> result = apply_gain(signal, 0.01, {{1.0, 5.0, 20.0}, {1.0, 3.0, 0.5}});
  for (std::size_t i = 0; i <= 1000; ++i) EXPECT_NEAR(result[1000 - i], result[1000 + i], 1e-12);
}

// One degree apart, as Boore (2010) defines it.
TEST(rotd50, is_near_the_median_over_all_orientations) {
  const RawMotion motion = simulate_raw_motion({7.0, 20.0, 400.0}, {1, 1}, 0.01);
  const auto& [first, second, vertical] = motion.acceleration_mps2;
  const std::vector<double> periods_s = {0.1, 0.3, 1.0};
  std::vector<std::vector<double>> sa(periods_s.size());
  std::vector<double> rotated(first.size());
  for (int degree = 0; degree < 180; ++degree) {
    for (std::size_t i = 0; i < first.size(); ++i)
      rotated[i] = std::cos(degree * pi / 180) * first[i] + std::sin(degree * pi / 180) * second[i];
    const auto spectrum = pseudo_acceleration_spectrum(motion.dt_s, rotated, periods_s);
    for (std::size_t p = 0; p < periods_s.size(); ++p) sa[p].push_back(spectrum[p]);
  }
  const auto rotd50 = horizontal_rotd50_mps2(motion, periods_s);
  for (std::size_t p = 0; p < periods_s.size(); ++p) {
    std::sort(sa[p].begin(), sa[p].end());
    EXPECT_NEAR(rotd50[p] / (0.5 * (sa[p][89] + sa[p][90])), 1.0, 0.03) << periods_s[p] << " s";
  }
}

}  // namespace
}  // namespace glissade
