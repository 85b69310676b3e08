// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

/// Scaled state of a linear oscillator u'' + 2 zeta omega u' + omega^2 u = -a(t): x = omega^2 u,
/// y = omega u', both accelerations. The absolute acceleration of the mass is -(x + 2 zeta y).
struct OscillatorState {
  double x = 0.0, y = 0.0;
};

/// One interval of it with a linear in t, exact at the interval's end (Nigam & Jennings 1969, BSSA
/// 59(2):909-922, in scaled form).
struct OscillatorStep {
  double xx = 1.0, xy = 0.0, yx = 0.0, yy = 1.0;
  double x_start = 0.0, x_end = 0.0, y_start = 0.0, y_end = 0.0;

  /// @param a0, a1 at the interval's start and end
  OscillatorState after(const OscillatorState& s, double a0, double a1) const {
    return {xx * s.x + xy * s.y - (x_start * a0 + x_end * a1),
            yy * s.y - yx * s.x - (y_start * a0 + y_end * a1)};
  }
};

/// @param phase omega dt > 0, the interval in radians of the undamped oscillator
/// @param damping_ratio >= 0; from 1 on (critical damping) there is no oscillation
/// Accurate to a few ulp for any phase below critical damping, and above it to 1e-14 absolutely: a
/// power series is used where the closed form has cancellation.
/// @return xy = yx
OscillatorStep oscillator_step(double phase, double damping_ratio);

/// The step of an oscillator whose mass is `mass` times that to which x and y are scaled: x is the
/// force of its spring, -(x + 2 zeta y) / mass its acceleration.
/// @param root of the mass; omega and zeta are divided by it
OscillatorStep oscillator_step(double phase, double damping_ratio, double mass, double root);

/// |x| and |y| of a free vibration stay below amplitude exp(-decay omega t).
struct Envelope {
  double amplitude, decay;
};
Envelope free_vibration_envelope(double x, double y, double damping_ratio);

}  // namespace glissade
