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
  // What the above give, since a division costs as much as all else of a line.
  double omega2 = 0.0, per_omega = 0.0, per_omega2 = 0.0, per_beta = 0.0, per_mass = 0.0;
  double angle = 0.0, per_angle = 0.0;  ///< omega dt
  double s2_size = 0.0;                 ///< |s^2|
  Amplitude s, s2, s_dt;                ///< s, s^2, s dt

  RegimeOscillator() = default;
  RegimeOscillator(const ContactRegime& contact, double gravity_mps2,
                   const BuildingOscillator& building, double dt_s);

  /// Of the scaled state (x, y) of a free vibration, without particular part.
  Amplitude free_amplitude(const RoofState& state) const {
    const double u = state.x * per_omega2, rate = state.y * per_omega;
    return {u, -(rate + alpha_radps * u) * per_beta};
  }
  RoofState free_state(Amplitude z) const { return {omega2 * z.re, omega_radps * real(s, z)}; }
  Amplitude amplitude(const RoofState& state, const LinearGround& ground) const {
    return free_amplitude(state - particular(ground));
  }
  /// Of the roof, in a state under this vertical.
  double acceleration_mps2(const RoofState& roof, double w) const {
    const double resisting = -(roof.x + lag * angle * roof.y);
    return (resisting - contact.weight * (gravity_mps2 + w)) * per_mass;
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
    // Even and odd powers side by side, since each waits for its own last term.
    const double square = tau * tau;
    Amplitude even{}, odd{};
    for (std::size_t k = even_terms; k >= 2; k -= 2) {
      even = square * even + taylor[k];
      odd = square * odd + taylor[k + 1];
    }
    const Amplitude minus_line = square * (even + tau * odd), minus_one = tau * s_dt + minus_line;
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

  std::size_t even_terms = 2;              ///< highest even power of s dt that counts in exp(s dt)
  std::array<Amplitude, 20> taylor{};      ///< (s dt)^k / k!
  std::array<Amplitude, window> powers{};  ///< exp(s dt n)
  std::array<float, window> power_re{}, power_im{};  ///< the same
  std::array<Amplitude, 32> squares{};               ///< exp(s dt window 2^k)

 private:
  RoofState particular(const LinearGround& ground) const {
    const Roof &at = ground.at, &change = ground.change;
    const double h = contact.mass * at.a + contact.weight * (gravity_mps2 + at.w),
                 rise = contact.mass * change.a + contact.weight * change.w;
    return {lag * rise - h, -rise * per_angle};
  }
};

}  // namespace glissade::block_detail
