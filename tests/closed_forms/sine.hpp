// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

#include "closed_forms/slider.hpp"

/// Slip of a block under a half sine and under a harmonic. Starts are arcsines, stops roots of one
/// transcendental equation, and all else follows. alpha is the roof's acceleration against the
/// first slip. Derived here from the piecewise equation of motion; regimes and the condition for
/// sliding without stops on a flat roof as in Westermo & Udwadia (1983), "Periodic response of a
/// sliding oscillator system to harmonic excitation", EESD 11:135-146.
///
/// A record is linear between its samples, where a sine is not: what the block does under the
/// record is off by (w dt)^2 / 12 of the sine's amplitude and so of second order in dt.
namespace glissade::closed_forms {

/// What a result of second order in dt tends to, from n and 2 n samples (Richardson): the third
/// order is left, from starts and stops between samples.
template <class Result>
double extrapolated(const Result& result, int n) {
  return (4 * result(2 * n) - result(n)) / 3;
}

// Under alpha = A sin(phase), from rest at phase p, with eta = yield / A and in units of k A / w
// and k A / w^2:
//   speed = cos p - cos q - eta (q - p)
//   slip = (q - p) cos p - (sin q - sin p) - eta (q - p)^2 / 2
inline double sine_speed(double eta, double p, double q) {
  return std::cos(p) - std::cos(q) - eta * (q - p);
}
inline double sine_slip(double eta, double p, double q) {
  return (q - p) * std::cos(p) - (std::sin(q) - std::sin(p)) - eta * (q - p) * (q - p) / 2;
}

/// The phase q at which a slip from p stops. The speed rises until alpha falls through the yield,
/// at pi - asin(eta), and falls until it rises through it again, a cycle after asin(eta); there the
/// speed is negative (the mean of alpha is zero): one root, bisected to rounding.
inline double sine_stop(double eta, double p) {
  const auto speed = [&](double q) { return sine_speed(eta, p, q); };
  const auto close = [](double a, double b) {
    return b - a <= 2 * std::numeric_limits<double>::epsilon() * b;
  };
  std::uintmax_t iterations = 200;
  const auto [low, high] =
      boost::math::tools::toms748_solve(speed, std::numbers::pi - std::asin(eta),
                                        2 * std::numbers::pi + std::asin(eta), close, iterations);
  return (low + high) / 2;
}

// -- half sine

/// alpha = A sin(pi t / D), 0 <= t <= D, then zero; sampled at `parts` + 1 points, so linear
/// between them.
struct HalfSine {
  double amplitude_mps2, duration_s;
  std::vector<double> alpha(int parts) const {
    std::vector<double> samples;
    for (int i = 0; i < parts; ++i)
      samples.push_back(amplitude_mps2 * std::sin(std::numbers::pi * i / parts));
    samples.push_back(0.0);
    return samples;
  }
};

/// Slips from asin(eta); stops within the pulse if that is before pi (eta above 0.7246), else
/// coasts.
inline double slip(const HalfSine& p, const Way& way) {
  using std::numbers::pi;
  const double w = pi / p.duration_s, A = p.amplitude_mps2, eta = way.yield_mps2 / A,
               start = std::asin(eta), stop = sine_stop(eta, start), unit = way.gain * A / (w * w);
  if (stop <= pi) return unit * sine_slip(eta, start, stop);
  const double v = sine_speed(eta, start, pi);  // coasting v^2 / (2 eta)
  return unit * (sine_slip(eta, start, pi) + v * v / (2 * eta));
}

// -- harmonic

/// alpha = A sin(2 pi t / T + phase), sampled `parts` times a cycle, the last sample a whole number
/// of half cycles after the first.
struct Harmonic {
  double amplitude_mps2, period_s, phase = 0.0;
  std::vector<double> alpha(int parts, int half_cycles) const {
    std::vector<double> samples;
    for (int i = 0; i <= parts * half_cycles / 2; ++i)
      samples.push_back(amplitude_mps2 *
                        std::sin(2 * std::numbers::pi * (i % parts) / parts + phase));
    return samples;
  }
};

/// How the steady state goes, by its stops in a cycle.
enum class Regime {
  one_way,    ///< down, rest
  two_stops,  ///< down, rest, up, rest
  one_stop,   ///< down, at once up, rest
  no_stop     ///< down, at once up, at once down
};

/// One cycle of the steady state: phases of alpha at which slip down and up start and stop.
struct SteadyState {
  Regime regime;
  Strokes strokes;
  double down_start, down_stop, up_start, up_stop;
  double sliding_s;  ///< of each cycle
  double drift_m() const { return strokes.down_m - strokes.up_m; }
};

/// The excitation is A sin(phase) going down, A sin(phase - pi) going up, each from rest and with
/// its own eta = yield / A. For a block that yields sooner down than up (else mirror it).
///
/// With a rest before it, slip down starts at asin(eta_d) whatever came before, so the first cycle
/// is steady. Slip up starts where that stops, or pi + asin(eta_u) if later; not at all if alpha
/// is past its excursion by then, at 2 pi - asin(eta_u). If slip up stops before the cycle is over,
/// there is the rest.
///
/// If not, the block never rests. Down from p over d and up over the 2 pi - d that remain:
///   cos p - cos(p + d) = eta_d d = eta_u (2 pi - d)
/// so d = 2 pi eta_u / (eta_d + eta_u) and 2 sin(p + d/2) sin(d/2) = eta_d d, p + d/2 beyond the
/// quarter, for the drive to be positive at p. On a flat roof d = pi, cos p = pi eta / 2, the
/// stroke is 2 (A / w^2) sin p = 2 (A / w^2) sqrt(1 - (pi eta / 2)^2), and sin p > eta where eta <
/// 1 / sqrt(1 + pi^2 / 4).
inline SteadyState steady_state(const Harmonic& motion, const Slider& block) {
  using std::numbers::pi;
  const double A = motion.amplitude_mps2, w = 2 * pi / motion.period_s;
  const double down = block.down.yield_mps2 / A, up = block.up.yield_mps2 / A;
  const auto state = [&](Regime regime, double p, double q, double r, double s) {
    const double unit = block.plan * A / (w * w);
    return SteadyState{regime,
                       {unit * block.down.gain * sine_slip(down, p, q),
                        unit * block.up.gain * sine_slip(up, r - pi, s - pi)},
                       p,
                       q,
                       r,
                       s,
                       (q - p + s - r) / w};
  };
  const double start = std::asin(down), stop = sine_stop(down, start);
  if (up >= 1 || stop >= 2 * pi - std::asin(up))
    return state(Regime::one_way, start, stop, stop, stop);
  const double ready = pi + std::asin(up), back = std::max(stop, ready);
  const double end = sine_stop(up, back - pi) + pi;
  if (end <= 2 * pi + start)
    return state(stop < ready ? Regime::two_stops : Regime::one_stop, start, stop, back, end);
  const double d = 2 * pi * up / (down + up);
  const double p = pi - std::asin(down * d / (2 * std::sin(d / 2))) - d / 2;
  return state(Regime::no_stop, p, p + d, p + d, p + 2 * pi);
}

/// Above this ratio of mu g to the amplitude a block on a flat roof stops twice a cycle; below, it
/// never does.
inline double flat_roof_stops_above() {
  return 1 / std::sqrt(1 + std::numbers::pi * std::numbers::pi / 4);
}

/// Without stops on a flat roof, from steady state to coming to rest: the motion ends as alpha
/// falls through zero (phase pi), and the block, sliding down, coasts. How far beyond the middle of
/// its stroke it comes to rest.
inline double rest_beyond_middle(const Harmonic& motion, const Slider& block) {
  const SteadyState s = steady_state(motion, block);
  const double w = 2 * std::numbers::pi / motion.period_s,
               eta = block.down.yield_mps2 / motion.amplitude_mps2;
  const double v = sine_speed(eta, s.down_start, std::numbers::pi);
  return block.plan * block.down.gain * motion.amplitude_mps2 / (w * w) *
             (sine_slip(eta, s.down_start, std::numbers::pi) + v * v / (2 * eta)) -
         s.strokes.down_m / 2;
}

}  // namespace glissade::closed_forms
