// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

/// One interval of a linear oscillator u'' + 2 zeta omega u' + omega^2 u = -a(t) with a linear in
/// t, in the scaled state x = omega^2 u, y = omega u' (both accelerations), exact at the interval's
/// end (Nigam & Jennings 1969, BSSA 59(2):909-922, in scaled form):
///   x1 =  xx x0 + xy y0 - (x_start a0 + x_end a1)
///   y1 = -xy x0 + yy y0 - (y_start a0 + y_end a1)
/// The absolute acceleration of the mass is -(x + 2 zeta y).
struct OscillatorStep {
  double xx = 1.0, xy = 0.0, yy = 1.0;
  double x_start = 0.0, x_end = 0.0, y_start = 0.0, y_end = 0.0;
};

/// @param phase omega dt > 0, the interval in radians of the undamped oscillator
/// @param damping_ratio >= 0; from 1 on (critical damping) there is no oscillation
/// Accurate to a few ulp for any phase below critical damping, and above it to 1e-14 absolutely: a
/// power series is used where the closed form has cancellation.
OscillatorStep oscillator_step(double phase, double damping_ratio);

/// |x| and |y| of a free vibration stay below amplitude exp(-decay omega t).
struct Envelope {
  double amplitude, decay;
};
Envelope free_vibration_envelope(double x, double y, double damping_ratio);

}  // namespace glissade
