// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/rdk10_process.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/random.hpp"

namespace glissade {
namespace {

constexpr double pi = std::numbers::pi;
constexpr Rdk10Parameters parameters{.arias_g2s = 0.03,
                                     .significant_duration_s = 8.0,
                                     .middle_time_s = 4.0,
                                     .middle_frequency_hz = 5.0,
                                     .frequency_slope_hzps = -0.3,
                                     .damping_ratio = 0.3};

std::vector<double> noise(std::size_t count, std::uint64_t item) {
  std::vector<double> values(count);
  for (std::size_t i = 0; i < count; ++i)
    values[i] = keyed_normal(5, RandomPurpose::test, item, static_cast<std::uint32_t>(i));
  return values;
}

/// The integral of q^2 to a time, by the midpoint rule.
double arias_until(const Rdk10Envelope& q, double end_s) {
  constexpr int steps = 200000;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) sum += std::pow(q((i + 0.5) * end_s / steps), 2);
  return sum * end_s / steps;
}

TEST(rdk10_envelope, holds_the_arias_intensity_and_its_times) {
  const Rdk10Envelope q(parameters);
  EXPECT_NEAR(arias_until(q, 60.0), parameters.arias_g2s, 1e-8);
  EXPECT_NEAR(arias_until(q, parameters.middle_time_s), 0.45 * parameters.arias_g2s, 1e-8);
  EXPECT_NEAR(arias_until(q, q.arias_time_s(0.95)), 0.95 * parameters.arias_g2s, 1e-8);
  EXPECT_NEAR(q.arias_time_s(0.95) - q.arias_time_s(0.05), parameters.significant_duration_s, 1e-9);
}

TEST(rdk10_envelope, begins_at_its_peak_where_the_duration_is_too_long_for_the_middle_time) {
  Rdk10Parameters early = parameters;
  early.middle_time_s = 1.0;  // the ratio 8 is beyond 4.925
  const Rdk10Envelope q(early);
  EXPECT_DOUBLE_EQ(q.a2(), 1.0);
  EXPECT_NEAR(q.arias_time_s(0.45), 1.0, 1e-12);
  EXPECT_NEAR(arias_until(q, 60.0), early.arias_g2s, 1e-8);
}

// The sum of Rezaeian & Der Kiureghian (2010), term by term: no recurrence, no truncation.
TEST(rdk10_process, is_the_filtered_noise_of_its_definition) {
  constexpr double dt_s = 0.01;
  const std::vector<double> u = noise(1203, 0);
  const std::vector<double> a = rdk10_process_g(parameters, dt_s, u);
  const Rdk10Envelope q(parameters);
  const double zeta = parameters.damping_ratio, damped = std::sqrt(1 - zeta * zeta);
  EXPECT_EQ(a[0], 0.0);
  for (const std::size_t i : {1u, 2u, 7u, 8u, 9u, 100u, 555u, 1200u, 1202u}) {
    double sum = 0.0, squares = 0.0;
    for (std::size_t j = 0; j <= i; ++j) {
      const double held_s =
          std::clamp(static_cast<double>(j) * dt_s, q.arias_time_s(0.01), q.arias_time_s(0.99));
      const double w =
          2 * pi *
          std::max(0.3, parameters.middle_frequency_hz +
                            parameters.frequency_slope_hzps * (held_s - parameters.middle_time_s));
      const double lag_s = static_cast<double>(i - j) * dt_s;
      const double h = w / damped * std::exp(-zeta * w * lag_s) * std::sin(w * damped * lag_s);
      sum += h * u[j];
      squares += h * h;
    }
    const double expected = q(static_cast<double>(i) * dt_s) * sum / std::sqrt(squares);
    // What is cut is below exp(-11.5) = 1e-5 of the impulse response.
    EXPECT_NEAR(a[i], expected, 3e-5 * q(static_cast<double>(i) * dt_s)) << "sample " << i;
  }
}

// Sample variance of n independent normals of variance one: within 1 +- 3.89 sqrt(2/n) at 99.99 %.
TEST(rdk10_process, has_the_variance_of_its_envelope) {
  constexpr int simulations = 2000;
  constexpr std::size_t sample = 150;
  double squares = 0.0;
  for (std::uint64_t k = 0; k < simulations; ++k)
    squares += std::pow(rdk10_process_g(parameters, 0.02, noise(sample + 1, k)).back(), 2);
  const double q = Rdk10Envelope(parameters)(sample * 0.02);
  EXPECT_NEAR(squares / simulations / (q * q), 1.0, 3.89 * std::sqrt(2.0 / simulations));
}

// z'' + 2 w z' + w^2 z = 1 from rest has z'' = (1 - w t) exp(-w t). The trapezoidal rule sees the
// step half a sample early.
TEST(high_pass, answers_a_step_as_the_critically_damped_oscillator) {
  constexpr double dt_s = 0.001, corner_hz = 0.5, w = 2 * pi * corner_hz;
  std::vector<double> a(3000, 1.0);
  high_pass(a, dt_s, corner_hz);
  for (const std::size_t i : {10u, 300u, 1000u, 2999u}) {
    const double t = (static_cast<double>(i) + 0.5) * dt_s;
    EXPECT_NEAR(a[i], (1 - w * t) * std::exp(-w * t), 1e-5);
  }
}

TEST(high_pass, brings_velocity_and_displacement_back_to_zero) {
  constexpr double dt_s = 0.01;
  std::vector<double> a(4000, 0.0);
  for (std::size_t i = 1; i < 1000; ++i)
    a[i] = 1.0 + keyed_normal(5, RandomPurpose::test, 9, static_cast<std::uint32_t>(i));
  high_pass(a, dt_s, 0.2);
  double velocity = 0.0, displacement = 0.0, peak_velocity = 0.0, peak_displacement = 0.0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {  // exact for piecewise-linear acceleration
    displacement += velocity * dt_s + (2 * a[i] + a[i + 1]) * dt_s * dt_s / 6;
    velocity += (a[i] + a[i + 1]) * dt_s / 2;
    peak_velocity = std::max(peak_velocity, std::abs(velocity));
    peak_displacement = std::max(peak_displacement, std::abs(displacement));
  }
  EXPECT_LT(std::abs(velocity), 1e-9 * peak_velocity);  // 30 s are 6 periods: exp(-37.7)
  EXPECT_LT(std::abs(displacement), 1e-9 * peak_displacement);
}

}  // namespace
}  // namespace glissade
