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
inline Amplitude operator+(Amplitude p, Amplitude q) { return {p.re + q.re, p.im + q.im}; }
inline Amplitude operator-(Amplitude p, Amplitude q) { return {p.re - q.re, p.im - q.im}; }
inline Amplitude operator*(double f, Amplitude p) { return {f * p.re, f * p.im}; }
inline Amplitude operator*(Amplitude p, Amplitude q) {
  return {p.re * q.re - p.im * q.im, p.re * q.im + p.im * q.re};
}
inline RoofState operator+(RoofState p, RoofState q) { return {p.x + q.x, p.y + q.y}; }
inline RoofState operator-(RoofState p, RoofState q) { return {p.x - q.x, p.y - q.y}; }
/// Re(p q).
inline double real(Amplitude p, Amplitude q) { return p.re * q.re - p.im * q.im; }

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
  static constexpr double most_phase = 1.0;  ///< the series takes no more

  ContactRegime contact;
  double gravity_mps2 = 0.0, omega_radps = 0.0, dt_s = 0.0, lag = 0.0;
  double alpha_radps = 0.0, beta_radps = 0.0;  ///< s = -alpha + i beta
  double phase = 0.0;                          ///< |s| dt
  Amplitude s, s2, s_dt;                       ///< s, s^2, s dt
  int terms = 2;                               ///< of the series of exp(s dt)

  RegimeOscillator() = default;
  RegimeOscillator(const ContactRegime& contact, double gravity_mps2,
                   const BuildingOscillator& building, double dt_s);

  /// Of the scaled state (x, y) of a free vibration, without particular part.
  Amplitude free_amplitude(const RoofState& state) const {
    const double u = state.x / (omega_radps * omega_radps), rate = state.y / omega_radps;
    return {u, -(rate + alpha_radps * u) / beta_radps};
  }
  RoofState free_state(Amplitude z) const {
    return {omega_radps * omega_radps * z.re, omega_radps * real(s, z)};
  }
  Amplitude amplitude(const RoofState& state, const LinearGround& ground) const {
    return free_amplitude(state - particular(ground));
  }
  /// Of the roof, in a state under this vertical.
  double acceleration_mps2(const RoofState& roof, double w) const {
    const double resisting = -(roof.x + lag * omega_radps * dt_s * roof.y);
    return (resisting - contact.weight * (gravity_mps2 + w)) / contact.mass;
  }
  RoofState state(Amplitude z, const LinearGround& ground) const {
    return free_state(z) + particular(ground);
  }

  /// p = exp(q), p - 1 and p - 1 - q for q = s dt tau, without cancellation.
  struct Growth {
    Amplitude power, minus_one, minus_line;
  };
  /// 0 <= tau <= 1.
  Growth after(double tau) const {
    const Amplitude q = tau * s_dt;
    Amplitude sum{1.0, 0.0};
    for (int k = terms; k > 2; --k) {
      sum = Series::inverse[static_cast<std::size_t>(k)] * (q * sum);
      sum.re += 1.0;
    }
    const Amplitude minus_line = 0.5 * (q * (q * sum)), minus_one = q + minus_line;
    return {Amplitude{1.0 + minus_one.re, minus_one.im}, minus_one, minus_line};
  }
  /// exp(s dt n), by products of powers of exp(s dt).
  Amplitude power(std::size_t n) const {
    Amplitude p = powers[n % window];
    for (std::size_t k = 0, rest = n / window; rest != 0; ++k, rest /= 2)
      if (rest % 2 != 0) p = p * squares[k];
    return p;
  }
  Amplitude per_interval() const { return powers[1]; }

  std::array<Amplitude, window> powers{};            ///< exp(s dt n)
  std::array<float, window> power_re{}, power_im{};  ///< the same
  std::array<Amplitude, 32> squares{};               ///< exp(s dt window 2^k)

 private:
  RoofState particular(const LinearGround& ground) const {
    const Roof &at = ground.at, &change = ground.change;
    const double h = contact.mass * at.a + contact.weight * (gravity_mps2 + at.w),
                 rise = contact.mass * change.a + contact.weight * change.w;
    return {lag * rise - h, -rise / (omega_radps * dt_s)};
  }
};

}  // namespace glissade::block_detail
