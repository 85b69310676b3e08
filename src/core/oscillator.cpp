// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/oscillator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"

namespace glissade {
namespace {

// In the time tau = omega t the step over an interval of length h = omega dt follows from the
// impulse response g, g'' + 2 zeta g' + g = 0, g(0) = 0, g'(0) = 1.
struct IntervalResponse {
  double impulse;  ///< g(h)
  double step;     ///< S(h), the integral of g
  double ramp;     ///< R(h) = (integral of S) / h: the response to a ramp that reaches 1 at h
};

/// g = exp(-zeta h) sin(beta h) / beta, S = 1 - g' - 2 zeta g, R = 1 - (g + 2 zeta S) / h, beta^2 =
/// 1 - zeta^2; above critical damping sinh and cosh, and beta^2 = zeta^2 - 1.
IntervalResponse closed_form(double h, double zeta) {
  const double beta = std::sqrt(std::abs(1.0 - zeta * zeta));
  double g = 0.0, even = 0.0;  // exp(-zeta h) times sin(beta h) / beta, and times cos(beta h)
  if (zeta < 1.0) {
    const double decay = std::exp(-zeta * h);
    g = decay * std::sin(beta * h) / beta;
    even = decay * std::cos(beta * h);
  } else {
    const double slow = std::exp(-h / (zeta + beta)), lost = -std::expm1(-2.0 * beta * h);
    g = beta > 0.0 ? slow * lost / (2.0 * beta) : slow * h;
    even = slow * (1.0 - 0.5 * lost);
  }
  const double s = 1.0 - even - zeta * g;
  return {g, s, 1.0 - (g + 2.0 * zeta * s) / h};
}

/// The power series of the same, for small h, where the closed forms of S ~ h^2/2 and R ~ h^2/6
/// have cancellation. Twenty-four terms are exact to rounding for h <= 1 and zeta h <= 1.
IntervalResponse power_series(double h, double zeta) {
  IntervalResponse sum{0.0, 0.0, 0.0};
  double term = h;  // c_k h^k
  double previous = 0.0;
  for (int k = 1; k <= 24; ++k) {
    // From k = 2 the larger of two successive terms never grows: the rest is below rounding.
    if (k > 2 && std::max(std::abs(term), std::abs(previous)) < 0x1p-70 * h) break;
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
  GLISSADE_EXPECTS(damping_ratio >= 0.0);
  const bool short_step = phase <= 1.0 && phase * damping_ratio <= 1.0;
  const auto [g, s, r] =
      short_step ? power_series(phase, damping_ratio) : closed_form(phase, damping_ratio);
  return {.xx = 1.0 - s,
          .xy = g,
          .yx = g,
          .yy = 1.0 - s - 2.0 * damping_ratio * g,
          .x_start = s - r,
          .x_end = r,
          .y_start = g - s / phase,
          .y_end = s / phase};
}

OscillatorStep oscillator_step(double phase, double damping_ratio, double mass, double root) {
  const OscillatorStep own = oscillator_step(phase / root, damping_ratio / root);
  return {.xx = own.xx,
          .xy = own.xy * root,
          .yx = own.yx / root,
          .yy = own.yy,
          .x_start = mass * own.x_start,
          .x_end = mass * own.x_end,
          .y_start = root * own.y_start,
          .y_end = root * own.y_end};
}

Envelope free_vibration_envelope(double x, double y, double damping_ratio) {
  if (damping_ratio < 1.0) {
    // exp(2 zeta tau) (x^2 + 2 zeta x y + y^2) is constant, and the quadratic form is at least
    // (1 - zeta) (x^2 + y^2).
    const double invariant = x * x + 2.0 * damping_ratio * x * y + y * y;
    return {std::sqrt(invariant / (1.0 - damping_ratio)), damping_ratio};
  }
  // With the slower rate r = zeta - beta, |x| <= exp(-r tau) (|x| + |y + r x| tau), and tau
  // exp(-r tau / 2) <= 2 / (e r). y obeys the same equation, with y' = -x - 2 zeta y.
  const double slow = 1.0 / (damping_ratio + std::sqrt(damping_ratio * damping_ratio - 1.0));
  const auto bound = [&](double value, double rate) {
    return std::abs(value) + std::abs(rate + slow * value) * 2.0 / (std::numbers::e * slow);
  };
  return {std::max(bound(x, y), bound(y, -x - 2.0 * damping_ratio * y)), 0.5 * slow};
}

}  // namespace glissade
