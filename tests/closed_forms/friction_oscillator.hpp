// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

namespace glissade::closed_forms {

/// An undamped oscillator (natural frequency omega, mass M) on a base that moves by
/// a cos(drive t), under a level body of mass r M connected by friction mu alone: the steady motion
/// in which the body never rests.
///
/// Over the half cycle in which the body moves toward +x on the oscillator, with
/// f = r mu g / omega^2, V = 1 / (1 - (drive/omega)^2), psi = pi omega / drive:
///   X = f + a V cos(drive t + phi) + A cos(omega t) + B sin(omega t)
///   body's velocity = mu g (pi / (2 drive) - t)
/// The next half cycle is minus this one, so A = -f, B = -f tan(psi / 2), and both velocities agree
/// at t = 0. The slip goes between +- X(0) = +- a V cos(phi).
///
/// r to infinity at r mu = const. is Den Hartog's oscillator (1931, Trans. ASME 53:107-115): the
/// body is the fixed ground that rubs, k a the amplitude of the force.
struct FrictionOscillator {
  double omega_radps, drive_radps;
  double base_amplitude_m;
  double mass_ratio, friction, gravity_mps2;

  double slip_amplitude_m() const {
    const double beta = drive_radps / omega_radps, psi = std::numbers::pi / beta;
    const double response = base_amplitude_m / (1.0 - beta * beta);
    const double rub = friction * gravity_mps2;
    const double f = mass_ratio * rub / (omega_radps * omega_radps);
    const double out_of_phase =
        rub * std::numbers::pi / (2.0 * drive_radps * drive_radps) + f * std::tan(0.5 * psi) / beta;
    return std::sqrt(response * response - out_of_phase * out_of_phase);
  }
};

/// Den Hartog's oscillator when it stops once every half cycle, on fixed rubbing ground: x stays
/// at `amplitude` until the force reaches k (amplitude - x_f), then slides to -amplitude.
/// @param friction_m x_f = friction force over stiffness; @param force_m force amplitude over k
struct OneStop {
  double omega_radps, drive_radps, friction_m, force_m;

  double amplitude_m() const {
    // The phase of the force at the start of sliding, by bisection on where the slide ends.
    double early = 0.5 * std::numbers::pi, late = std::numbers::pi;
    double best = 0.0;
    for (int i = 0; i < 200; ++i) {
      const double phase = 0.5 * (early + late);
      const double begin = friction_m + force_m * std::cos(phase), miss = slide(phase) + begin;
      (miss > 0.0 ? early : late) = phase;
      best = begin;
    }
    return best;
  }
  /// Where a slide that begins at rest at x_f + force_m cos(phase) ends.
  double slide(double phase) const {
    const double beta = drive_radps / omega_radps, response = force_m / (1.0 - beta * beta);
    const double c = force_m * std::cos(phase) - response * std::cos(phase),
                 s = response * beta * std::sin(phase);
    const auto x = [&](double t) {
      return friction_m + response * std::cos(drive_radps * t + phase) +
             c * std::cos(omega_radps * t) + s * std::sin(omega_radps * t);
    };
    const auto velocity = [&](double t) {
      return -response * drive_radps * std::sin(drive_radps * t + phase) +
             omega_radps * (s * std::cos(omega_radps * t) - c * std::sin(omega_radps * t));
    };
    double t = 0.0;
    const double look = 1e-3 / std::max(omega_radps, drive_radps);
    do t += look;
    while (velocity(t) < 0.0);
    double low = t - look, high = t;
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (velocity(middle) < 0.0 ? low : high) = middle;
    }
    return x(high);
  }
};

}  // namespace glissade::closed_forms
