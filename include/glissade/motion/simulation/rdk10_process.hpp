// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "glissade/motion/simulation/rdk10_parameters.hpp"

namespace glissade {

/// q(t) = a1 t^(a2-1) exp(-a3 t), in g: its square is J times a gamma density, so that fractions of
/// the Arias intensity are gamma quantiles (RDK10). Where D5-95 is too long for the middle time
/// (D5-95 / t_mid > 4.925), a2 = 1, an envelope that begins at its peak, is the longest taken.
class Rdk10Envelope {
 public:
  explicit Rdk10Envelope(const Rdk10Parameters& parameters);
  double operator()(double time_s) const;  ///< time >= 0
  double arias_time_s(
      double fraction) const;  ///< time at which this fraction (in (0, 1)) of J is reached
  double a1() const { return a1_; }
  double a2() const { return 0.5 * (shape_ + 1.0); }
  double a3() const { return 0.5 / scale_s_; }

 private:
  double shape_, scale_s_, a1_;
};

/// q(t) x(t) in g before the high-pass: white noise (standard normal, one number per sample)
/// through the filter with changing frequency, scaled to unit variance, modulated by the envelope.
/// The first value is zero. Impulse responses end when they have decayed by exp(-11.5); the
/// frequency of the filter is at least 0.3 Hz, and constant outside 1 % to 99 % of the Arias
/// intensity. Cost: samples times the length of the impulse response.
std::vector<double> rdk10_process_g(const Rdk10Parameters& parameters, double dt_s,
                                    std::span<const double> noise);

/// High-pass filter of the model: acceleration of the critically damped oscillator z'' + 2 w z' +
/// w^2 z = x, a = z'' (bilinear, that is, exact for the trapezoidal velocity and displacement; both
/// return to zero after the motion).
void high_pass(std::span<double> acceleration, double dt_s, double corner_hz);

}  // namespace glissade
