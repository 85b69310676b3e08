// SPDX-License-Identifier: GPL-3.0-or-later
// Steady motion of oscillators with dry friction, in closed form
// (closed_forms/friction_oscillator.hpp).
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "closed_forms/steady_slip.hpp"

namespace glissade {
namespace coupled_den_hartog_test {

using closed_forms::FrictionOscillator;
using closed_forms::OneStop;
using closed_forms::steady_slip_m;

constexpr double g = 9.81;

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

}  // namespace coupled_den_hartog_test
}  // namespace glissade
