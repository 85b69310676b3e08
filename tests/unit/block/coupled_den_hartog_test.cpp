// SPDX-License-Identifier: GPL-3.0-or-later
// Steady motion of oscillators with dry friction, in closed form
// (closed_forms/friction_oscillator.hpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "closed_forms/friction_oscillator.hpp"
#include "glissade/block/coupled.hpp"

namespace glissade {
namespace {

using closed_forms::FrictionOscillator;
using closed_forms::OneStop;

constexpr int samples_per_cycle = 1000;
constexpr double g = 9.81;

/// Half the range of slip over the last cycle. The base's acceleration is given in samples; a
/// straight line between them has the sine's own amplitude times sinc^2(pi / n), which is taken
/// out, and overtones of n^-2, which an oscillator's displacement shows to n^-4.
double steady_slip_m(const FrictionOscillator& o, int cycles) {
  const double n = samples_per_cycle, dt = 2.0 * std::numbers::pi / (o.drive_radps * n);
  const double sinc = std::sin(std::numbers::pi / n) / (std::numbers::pi / n);
  const double amplitude = o.base_amplitude_m * o.drive_radps * o.drive_radps / (sinc * sinc);
  std::vector<double> base;
  for (int i = 0; i <= cycles * samples_per_cycle; ++i)
    base.push_back(-amplitude * std::cos(2.0 * std::numbers::pi * (i % samples_per_cycle) / n));
  std::vector<CoupledPoint> history;
  slide_coupled({dt, base}, {}, {{2.0 * std::numbers::pi / o.omega_radps, 0.0}, o.mass_ratio},
                {.friction = o.friction, .gravity_mps2 = o.gravity_mps2}, history);
  const double end = static_cast<double>(cycles * samples_per_cycle) * dt;
  double least = 1e300, most = -1e300;
  for (const CoupledPoint& p : history) {
    if (p.time_s < end - samples_per_cycle * dt || p.time_s > end) continue;
    least = std::min(least, p.displacement_m);
    most = std::max(most, p.displacement_m);
  }
  return 0.5 * (most - least);
}

TEST(dry_friction_oscillator, slides_without_rest_as_in_closed_form) {
  for (const double mass_ratio : {0.3, 0.5}) {
    for (const double beta : {0.7, 0.8, 1.4}) {
      const FrictionOscillator o{10.0, 10.0 * beta, 0.05, mass_ratio, 0.06, g};
      const double expected = o.slip_amplitude_m();
      EXPECT_NEAR(steady_slip_m(o, 700), expected, 1e-8 * expected);
    }
  }
}

constexpr double far_heavier = 1e9;  // than the oscillator: it stands still, but for 1e-9

TEST(den_hartog, slides_without_rest_as_in_his_eq) {
  for (const double beta : {0.7, 0.8, 1.4}) {
    const double force_m = 0.05, friction_m = 0.2 * force_m;
    const FrictionOscillator o{
        10.0, 10.0 * beta, force_m, far_heavier, friction_m * 100.0 / (far_heavier * g), g};
    const double v = 1.0 / (1.0 - beta * beta), psi = std::numbers::pi / beta,
                 u = std::sin(psi) / (beta * (1.0 + std::cos(psi)));
    const double expected =
        force_m * std::sqrt(v * v - u * u * friction_m * friction_m / (force_m * force_m));
    EXPECT_NEAR(steady_slip_m(o, 300), expected, 1e-8 * force_m);
  }
}

TEST(den_hartog, stops_once_every_half_cycle_as_in_closed_form) {
  for (const double beta : {0.6, 0.8, 1.2}) {
    const double force_m = 0.05, friction_m = 0.9 * force_m;
    const FrictionOscillator o{
        10.0, 10.0 * beta, force_m, far_heavier, friction_m * 100.0 / (far_heavier * g), g};
    const double expected = OneStop{10.0, 10.0 * beta, friction_m, force_m}.amplitude_m();
    EXPECT_NEAR(steady_slip_m(o, 60), expected, 1e-8 * force_m);
  }
}

}  // namespace
}  // namespace glissade
