// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

/// Absolute acceleration of the roof of a linear oscillator (period T = 2 pi / w, damping ratio z <
/// 1), per unit of ground acceleration.
namespace glissade::closed_forms {

/// The ground's acceleration is suddenly 1 and stays: u'' + 2 z w u' + w^2 u = -1 from rest, roof
/// -(2 z w u' + w^2 u), so with W = w sqrt(1 - z^2)
///   1 - exp(-z w t) [cos W t - z / sqrt(1 - z^2) sin W t]
inline double roof_after_step(double period_s, double damping, double t) {
  const double w = 2 * std::numbers::pi / period_s, root = std::sqrt(1 - damping * damping);
  return 1 - std::exp(-damping * w * t) *
                 (std::cos(w * root * t) - damping / root * std::sin(w * root * t));
}

/// Its largest value and when: the derivative is zero where tan W t = -tan(2 asin z), first at
/// W t = pi - 2 asin z, and there the bracket is -1.
struct StepPeak {
  double time_s, value;
};
inline StepPeak roof_peak_after_step(double period_s, double damping) {
  const double root = std::sqrt(1 - damping * damping),
               phase = std::numbers::pi - 2 * std::asin(damping);
  return {phase * period_s / (2 * std::numbers::pi * root), 1 + std::exp(-damping * phase / root)};
}

/// (1 + 2 i z r) / (1 - r^2 + 2 i z r) at r = ground frequency / w; its modulus is
/// sqrt((1 + (2 z r)^2) / ((1 - r^2)^2 + (2 z r)^2)) (Chopra, Dynamics of Structures, section 3.6).
inline std::complex<double> transmission(double ratio, double damping) {
  const std::complex<double> lag(0, 2 * damping * ratio);
  return (1.0 + lag) / (1.0 - ratio * ratio + lag);
}

/// Where the modulus is largest: d|.|^2 / d(r^2) = 0 is 2 z^2 r^4 + r^2 - 1 = 0.
inline double ratio_of_peak(double damping) {
  return std::sqrt(std::sqrt(1 + 8 * damping * damping) - 1) / (2 * damping);
}

/// The same for a harmonic sampled n times a cycle and linear between: at the samples, the sum over
/// the harmonic's images w (1 + k n), whose amplitudes are sinc^2(pi (1 + k n) / n) (the Fourier
/// series of a linear interpolant). Terms k and -k cancel to k^-4.
inline std::complex<double> sampled_transmission(double ratio, double damping, int n) {
  std::complex<double> sum = 0;
  for (int k = 2000; k >= 0; --k)
    for (const int sign : {-1, 1}) {
      const double image = 1.0 + sign * k * static_cast<double>(n),
                   x = std::numbers::pi * image / n;
      if (k > 0 || sign > 0)
        sum +=
            std::pow(std::sin(std::numbers::pi / n) / x, 2) * transmission(ratio * image, damping);
    }
  return sum;
}

/// The complex amplitude of the first harmonic of a cycle of n samples, relative to sin.
inline std::complex<double> amplitude(const std::vector<double>& cycle) {
  std::complex<double> sum = 0;
  const double n = static_cast<double>(cycle.size());
  for (std::size_t i = 0; i < cycle.size(); ++i)
    sum += cycle[i] * std::polar(1.0, -2 * std::numbers::pi * static_cast<double>(i) / n);
  return 2.0 / n * std::complex<double>(0, 1) * sum;
}

}  // namespace glissade::closed_forms
