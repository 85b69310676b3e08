// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/oscillator.hpp"

#include <cmath>

#include "glissade/core/contract.hpp"

namespace glissade {
namespace {

// In the time tau = omega t everything about an interval of length h = omega dt follows from the
// impulse response g, g'' + 2 zeta g' + g = 0, g(0) = 0, g'(0) = 1.
struct IntervalResponse {
  double impulse;  ///< g(h)
  double step;     ///< S(h), the integral of g
  double ramp;     ///< R(h) = (integral of S) / h: the response to a ramp that reaches 1 at h
};

/// g = exp(-zeta h) sin(beta h) / beta, S = 1 - g' - 2 zeta g, R = 1 - (g + 2 zeta S) / h, beta^2 =
/// 1 - zeta^2.
IntervalResponse closed_form(double h, double zeta) {
  const double beta = std::sqrt(1.0 - zeta * zeta);
  const double decay = std::exp(-zeta * h);
  const double g = decay * std::sin(beta * h) / beta;
  const double s = 1.0 - decay * std::cos(beta * h) - zeta * g;
  return {g, s, 1.0 - (g + 2.0 * zeta * s) / h};
}

/// The power series of the same, for small h, where S ~ h^2/2 and R ~ h^2/6 would be what is left
/// of ones that cancel. Twenty-four terms are exact to rounding for h <= 1.
IntervalResponse power_series(double h, double zeta) {
  IntervalResponse sum{0.0, 0.0, 0.0};
  double term = h;  // c_k h^k
  double previous = 0.0;
  for (int k = 1; k <= 24; ++k) {
    sum.impulse += term;
    sum.step += term * h / (k + 1);
    sum.ramp += term * h / ((k + 1) * (k + 2));
    const double next = -(2.0 * zeta * h * k * term + h * h * previous) / (k * (k + 1));
    previous = term;
    term = next;
  }
  return sum;
}

}  // namespace

OscillatorStep oscillator_step(double phase, double damping_ratio) {
  GLISSADE_EXPECTS(phase > 0.0);
  GLISSADE_EXPECTS(damping_ratio >= 0.0 && damping_ratio < 1.0);
  const auto [g, s, r] =
      phase <= 1.0 ? power_series(phase, damping_ratio) : closed_form(phase, damping_ratio);
  return {.xx = 1.0 - s,
          .xy = g,
          .yy = 1.0 - s - 2.0 * damping_ratio * g,
          .x_start = s - r,
          .x_end = r,
          .y_start = g - s / phase,
          .y_end = s / phase};
}

double free_vibration_envelope(double x, double y, double damping_ratio) {
  // exp(2 zeta tau) (x^2 + 2 zeta x y + y^2) never changes, and the form is at least (1 - zeta)
  // (x^2 + y^2).
  const double invariant = x * x + 2.0 * damping_ratio * x * y + y * y;
  return std::sqrt(invariant / (1.0 - damping_ratio));
}

}  // namespace glissade
