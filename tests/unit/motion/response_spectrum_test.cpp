// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/response_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "glissade/core/random.hpp"

namespace glissade {
namespace {

constexpr double pi = std::numbers::pi;

double sa(double dt_s, const std::vector<double>& acceleration, double period_s, double damping) {
  return pseudo_acceleration_spectrum(dt_s, acceleration, std::vector{period_s}, damping).front();
}

/// A made-up record that starts from zero: noise under an envelope.
std::vector<double> noise(std::size_t length) {
  std::vector<double> acceleration(length);
  for (std::size_t n = 0; n < length; ++n) {
    const double envelope = std::sin(pi * static_cast<double>(n) / static_cast<double>(length));
    acceleration[n] = envelope * keyed_normal(1, RandomPurpose::test, n, 0);
  }
  return acceleration;
}

/// Independent reference: the classical Runge-Kutta scheme in long double, with `substeps` in each
/// interval, through the interval to zero and a full period of free vibration; the peak is the
/// largest |omega^2 u| at all these points.
double runge_kutta_sa(double dt_s, const std::vector<double>& acceleration, double period_s,
                      double damping, int substeps) {
  using Real = long double;
  const Real omega = 2 * std::numbers::pi_v<Real> / period_s;
  const Real zeta = damping;
  const Real h = Real(dt_s) / substeps;
  const auto sample = [&](std::size_t n) -> Real {
    return n < acceleration.size() ? acceleration[n] : 0;
  };
  const std::size_t intervals =
      acceleration.size() + static_cast<std::size_t>(std::ceil(period_s / dt_s));
  Real u = 0, u_dot = 0, peak = 0;
  for (std::size_t n = 0; n < intervals; ++n) {
    const auto force = [&](Real substep) {
      return sample(n) + (sample(n + 1) - sample(n)) * substep / substeps;
    };
    const auto slope = [&](Real position, Real velocity, Real a) {
      return -(2 * zeta * omega * velocity + omega * omega * position + a);
    };
    for (int k = 0; k < substeps; ++k) {
      const Real a0 = force(k), am = force(k + Real(0.5)), a1 = force(k + 1);
      const Real p1 = u_dot, q1 = slope(u, u_dot, a0);
      const Real p2 = u_dot + h / 2 * q1, q2 = slope(u + h / 2 * p1, p2, am);
      const Real p3 = u_dot + h / 2 * q2, q3 = slope(u + h / 2 * p2, p3, am);
      const Real p4 = u_dot + h * q3, q4 = slope(u + h * p3, p4, a1);
      u += h / 6 * (p1 + 2 * p2 + 2 * p3 + p4);
      u_dot += h / 6 * (q1 + 2 * q2 + 2 * q3 + q4);
      peak = std::max(peak, std::abs(omega * omega * u));
    }
  }
  return static_cast<double>(peak);
}

// A suddenly applied constant force: omega^2 u peaks at 1 + exp(-pi zeta / sqrt(1 - zeta^2)) half a
// damped period later (any text on dynamics; Chopra, Dynamics of Structures, section 4.3). The
// periods put that between samples.
TEST(pseudo_acceleration, to_a_step_is_the_closed_form) {
  const std::vector<double> step(1000, 1.0);
  for (const double damping : {0.0, 0.02, 0.05, 0.3, 0.7}) {
    const double expected = 1.0 + std::exp(-pi * damping / std::sqrt(1.0 - damping * damping));
    for (const double period_s : {0.0037, 0.0101, 0.07, 0.333, 1.7, 7.1}) {
      EXPECT_NEAR(sa(0.01, step, period_s, damping), expected, 1e-11)
          << period_s << " s, " << damping;
    }
  }
}

// A ramp to 1 over t_r, then constant, undamped: 1 + |sin(pi t_r/T)| / (pi t_r/T) (Chopra,
// section 4.5).
TEST(pseudo_acceleration, to_a_ramp_is_the_closed_form) {
  const double dt_s = 0.01;
  std::vector<double> ramp(1500, 1.0);
  for (std::size_t n = 0; n < 40; ++n) ramp[n] = static_cast<double>(n) / 40.0;
  for (const double period_s : {0.0123, 0.31, 0.9, 5.3}) {
    const double x = pi * 0.4 / period_s;
    EXPECT_NEAR(sa(dt_s, ramp, period_s, 0.0), 1.0 + std::abs(std::sin(x)) / x, 1e-11) << period_s;
  }
}

// One sample of 1: an impulse of dt/2 for a period that is long beside dt, so omega^2 u peaks at
// omega dt/2 to a relative order (omega dt)^2; coefficients that cancel would lose it altogether.
TEST(pseudo_acceleration, of_very_long_periods_is_that_of_an_impulse) {
  for (const double period_s : {1e3, 1e5, 1e7}) {
    const double omega_dt = 2.0 * pi * 0.01 / period_s;
    EXPECT_NEAR(sa(0.01, {1.0}, period_s, 0.0) / (0.5 * omega_dt), 1.0, omega_dt * omega_dt + 1e-14)
        << period_s;
  }
}

// The sampled reference misses at most (omega h)^2/8 of a peak, h its step: 1.2e-6 at T = 5 dt and
// below that elsewhere.
TEST(pseudo_acceleration, agrees_with_runge_kutta_in_long_double) {
  const double dt_s = 0.01;
  const std::vector<double> record = noise(120);
  for (const double damping : {0.0, 0.05, 0.5, 0.95}) {
    for (const double period_s : {0.05, 0.063, 0.11, 0.3, 1.0, 4.0}) {
      const double reference = runge_kutta_sa(dt_s, record, period_s, damping, 400);
      EXPECT_NEAR(sa(dt_s, record, period_s, damping) / reference, 1.0, 2e-6)
          << period_s << " s, " << damping;
    }
  }
}

TEST(pseudo_acceleration, agrees_with_runge_kutta_for_periods_below_the_sample_interval) {
  const double dt_s = 0.01;
  const std::vector<double> record = noise(40);
  for (const double period_s : {0.0015, 0.004, 0.009, 0.02}) {
    const double reference = runge_kutta_sa(dt_s, record, period_s, 0.05, 4000);
    EXPECT_NEAR(sa(dt_s, record, period_s, 0.05) / reference, 1.0, 2e-5) << period_s;
  }
}

TEST(pseudo_acceleration, at_period_zero_is_the_peak_ground_acceleration) {
  const std::vector<double> record = noise(300);
  const double pga = std::abs(std::ranges::max(record, {}, [](double a) { return std::abs(a); }));
  EXPECT_EQ(sa(0.01, record, 0.0, 0.05), pga);
}

// Each kink sets off a free vibration of (change of slope)/omega, here at most 4 peaks per dt: 4/(2
// pi 1000) of the peak, and what damping leaves of those before (1000 cycles per dt at 5 %:
// nothing).
TEST(pseudo_acceleration, tends_to_the_peak_ground_acceleration_at_short_periods) {
  const std::vector<double> record = noise(300);
  const double pga = sa(0.01, record, 0.0, 0.05);
  EXPECT_NEAR(sa(0.01, record, 1e-5, 0.05) / pga, 1.0, 4.0 / (2.0 * pi * 1000.0));
}

TEST(pseudo_acceleration, does_not_change_when_zeros_are_appended) {
  const std::vector<double> record = noise(150);
  std::vector<double> padded = record;
  padded.resize(2000, 0.0);
  for (const double damping : {0.0, 0.05, 0.8}) {
    for (const double period_s : {0.03, 0.2, 1.1, 6.0, 60.0}) {
      EXPECT_NEAR(sa(0.01, padded, period_s, damping) / sa(0.01, record, period_s, damping), 1.0,
                  1e-12)
          << period_s << " s, " << damping;
    }
  }
}

TEST(pseudo_acceleration, does_not_change_when_zeros_come_first) {
  const std::vector<double> record = noise(150);
  std::vector<double> late(77, 0.0);
  late.insert(late.end(), record.begin(), record.end());
  for (const double period_s : {0.03, 0.2, 1.1, 6.0}) {
    EXPECT_EQ(sa(0.01, late, period_s, 0.05), sa(0.01, record, period_s, 0.05)) << period_s;
  }
}

TEST(pseudo_acceleration, does_not_change_when_samples_are_interpolated) {
  const std::vector<double> record = noise(150);
  std::vector<double> finer;
  for (std::size_t n = 0; n < record.size(); ++n) {
    const double next = n + 1 < record.size() ? record[n + 1] : 0.0;
    for (int k = 0; k < 4; ++k) finer.push_back(std::lerp(record[n], next, 0.25 * k));
  }
  for (const double period_s : {0.004, 0.03, 0.2, 1.1, 6.0}) {
    EXPECT_NEAR(sa(0.0025, finer, period_s, 0.05) / sa(0.01, record, period_s, 0.05), 1.0, 1e-11)
        << period_s;
  }
}

TEST(pseudo_acceleration, is_linear_in_the_motion) {
  std::vector<double> record = noise(150);
  const double once = sa(0.01, record, 0.4, 0.05);
  for (double& a : record) a *= -4.0;  // a power of two: exact
  EXPECT_EQ(sa(0.01, record, 0.4, 0.05), 4.0 * once);
}

TEST(pseudo_acceleration, at_a_period_does_not_depend_on_the_other_periods) {
  const std::vector<double> record = noise(150);
  const std::vector<double> periods_s = {3.0, 0.01, 0.0, 0.5,  0.002, 0.3,
                                         0.1, 1.0,  2.0, 0.05, 0.7,   0.03};
  const std::vector<double> together = pseudo_acceleration_spectrum(0.01, record, periods_s);
  for (std::size_t i = 0; i < periods_s.size(); ++i) {
    EXPECT_EQ(together[i], sa(0.01, record, periods_s[i], 0.05)) << periods_s[i];
  }
}

}  // namespace
}  // namespace glissade
