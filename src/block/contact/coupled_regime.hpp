// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "block/events/coupled_motion.hpp"

namespace glissade::block_detail {

/// The complex amplitude of a free vibration: Re(z exp(s t)).
struct Amplitude {
  double re = 0.0, im = 0.0;
  double size() const { return std::sqrt(re * re + im * im); }
};
inline Amplitude operator*(double f, Amplitude p) { return {f * p.re, f * p.im}; }
inline Amplitude operator*(Amplitude p, Amplitude q) {
  return {p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re};
}

/// Ground at an instant of an interval, at its factors, and its change over the interval.
struct LinearGround {
  Roof at, change;
  LinearGround after(double tau) const {
    return {{at.a + tau * change.a, at.w + tau * change.w}, change};
  }
};

/// The building in one regime of contact (stuck, sliding down or up), underdamped: an oscillator
/// of frequency omega / sqrt(D) and damping ratio zeta / sqrt(D) under a constant force and the
/// ground. With H = (D a_g + W (g + w)) / omega^2, linear over an interval of length dt, and tau
/// the fraction of it that has passed
///   u  = -[H(tau) - lag dH] + Re(z exp(s dt tau)),   lag = 2 zeta / (omega dt)
///   u' = -dH / dt + Re(s z exp(s dt tau)),   a = a_g(tau) + Re(s^2 z exp(s dt tau))
/// so z is the whole state of the roof there.
struct RegimeOscillator {
  static constexpr std::size_t window = 64;  ///< intervals whose powers are kept
  static constexpr double most_phase = 1.0;  ///< the bounds on an interval take no more

  ContactRegime contact;
  double gravity_mps2 = 0.0, omega_radps = 0.0, dt_s = 0.0, lag = 0.0;
  double alpha_radps = 0.0, beta_radps = 0.0;  ///< s = -alpha + i beta
  double phase = 0.0;                          ///< |s| dt
  // What the above give, since a division costs as much as all else of a line.
  double omega2 = 0.0, per_omega = 0.0, per_omega2 = 0.0, per_beta = 0.0, per_mass = 0.0;
  double angle = 0.0, per_angle = 0.0;  ///< omega dt
  double s2_size = 0.0;                 ///< |s^2|
  Amplitude s, s2;                      ///< s, s^2

  RegimeOscillator() = default;
  RegimeOscillator(const ContactRegime& contact, double gravity_mps2,
                   const BuildingOscillator& building, double dt_s);

  /// exp(s dt n), by products of powers of exp(s dt).
  Amplitude power(std::size_t n) const {
    Amplitude p = powers[n % window];
    for (std::size_t k = 0, rest = n / window; rest != 0; ++k, rest /= 2)
      if (rest % 2 != 0) p = p * squares[k];
    return p;
  }

  std::array<Amplitude, window> powers{};            ///< exp(s dt n)
  std::array<float, window> power_re{}, power_im{};  ///< the same
  std::array<Amplitude, 32> squares{};               ///< exp(s dt window 2^k)
};

}  // namespace glissade::block_detail
