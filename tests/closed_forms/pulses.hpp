// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "closed_forms/slider.hpp"

/// Slip of a block from rest under single pulses and single cycles. alpha is the roof's
/// acceleration against the first slip; slips here are along the slope, strokes in plan.
namespace glissade::closed_forms {

// -- rectangular: alpha = A for a time D, then zero or -A

/// A record cannot jump. It is sampled here so that every jump but that at t = 0 is in the middle
/// of an interval: the ramp there gives the speed the jump gives, and moves the block by
///   (jump of v') dt^2 / 24
/// more, exactly (the difference of the two speeds, integrated), as long as it slides throughout.
inline double ramp_for_jump(double jump_mps2, double dt_s) { return jump_mps2 * dt_s * dt_s / 24; }

/// `on` + 1 samples of A: the jump is at D = (on + 1/2) dt.
struct RectangularPulse {
  double amplitude_mps2, dt_s;
  int on;
  double duration_s() const { return (on + 0.5) * dt_s; }
  std::vector<double> alpha() const {
    return std::vector<double>(static_cast<std::size_t>(on) + 1, amplitude_mps2);
  }
};

/// Speed k (A - y) D after the pulse, then k y less per second:
///   s = k (A - y) D^2 / 2 + [k (A - y) D]^2 / (2 k y) = k A (A - y) D^2 / (2 y)
/// (Newmark 1965, the single rectangular pulse).
inline double slip(const RectangularPulse& p, const Way& way) {
  const double A = p.amplitude_mps2, D = p.duration_s(), y = way.yield_mps2;
  return way.gain * A * (A - y) * D * D / (2 * y) + ramp_for_jump(-way.gain * A, p.dt_s);
}

/// alpha = A until D, then -A for another `back` dt, then zero.
struct RectangularCycle {
  RectangularPulse first;
  int back;
  std::vector<double> alpha() const {
    std::vector<double> samples = first.alpha();
    samples.resize(samples.size() + static_cast<std::size_t>(back), -first.amplitude_mps2);
    return samples;
  }
};

/// Down: k (A - y) D, lost at k (A + y) in t = D (A - y) / (A + y), so
///   s = k A (A - y) D^2 / (A + y),
/// with a jump of -2 A on the way. Then, at once, up for what is left of the second half, as under
/// a pulse. (For t < back dt and A > the upslope yield.)
inline Strokes strokes(const RectangularCycle& c, const Slider& block) {
  const double A = c.first.amplitude_mps2, D = c.first.duration_s(), dt = c.first.dt_s;
  const auto [k, y] = block.down;
  const double down = k * A * (A - y) * D * D / (A + y) + ramp_for_jump(-2 * k * A, dt);
  const double left = c.back * dt - D * (A - y) / (A + y);
  const auto [ku, yu] = block.up;
  const double up = ku * A * (A - yu) * left * left / (2 * yu) + ramp_for_jump(-ku * A, dt);
  return {down * block.plan, up * block.plan};
}

// -- triangular: piecewise linear, so the speed is a quadratic and slip a cubic of time

/// Corners on samples: up to A in rise dt, back to zero in fall dt.
struct TriangularPulse {
  double amplitude_mps2, dt_s;
  int rise, fall;
  std::vector<double> alpha() const {
    std::vector<double> samples;
    for (int i = 0; i < rise; ++i) samples.push_back(amplitude_mps2 * i / rise);
    for (int i = fall; i >= 0; --i) samples.push_back(amplitude_mps2 * i / fall);
    return samples;
  }
};

/// From the top of a triangle, sliding at speed v: alpha goes from A to zero in `fall_s`, and the
/// block coasts. With n = k (A - y) and b = A / fall: to the yield in tau = (A - y) / b, gaining
/// n tau / 2 and v tau + n tau^2 / 3; then v - k b t^2 / 2, which is zero at t = sqrt(2 v / (k b))
/// and 2/3 v t further, or, if alpha is zero before, at t = y / b, coasting v^2 / (2 k y) more.
inline double slip_from_top(const Way& way, double v, double A, double fall_s) {
  const auto [k, y] = way;
  const double b = A / fall_s, n = k * (A - y), tau = (A - y) / b;
  double s = v * tau + n * tau * tau / 3;
  v += n * tau / 2;
  const double stop = std::sqrt(2 * v / (k * b)), end = y / b;
  if (stop <= end) return s + 2 * v * stop / 3;
  s += v * end - k * b * end * end * end / 6;
  v -= k * b * end * end / 2;
  return s + v * v / (2 * k * y);
}

/// From the yield to the top in tau = (A - y) / (A / rise): n tau / 2 and n tau^2 / 6.
inline double slip(const TriangularPulse& p, const Way& way) {
  const double A = p.amplitude_mps2, n = way.gain * (A - way.yield_mps2);
  const double tau = p.rise * p.dt_s * (A - way.yield_mps2) / A;
  return n * tau * tau / 6 + slip_from_top(way, n * tau / 2, A, p.fall * p.dt_s);
}

/// Up to A in rise dt, down to -A in 2 fall dt, back to zero in last dt.
struct TriangularCycle {
  TriangularPulse first;
  int last;
  std::vector<double> alpha() const {
    std::vector<double> samples = first.alpha();
    for (int i = 1; i < first.fall; ++i) samples.push_back(-first.amplitude_mps2 * i / first.fall);
    for (int i = last; i >= 0; --i) samples.push_back(-first.amplitude_mps2 * i / last);
    return samples;
  }
};

/// The block that goes down stops while alpha falls (at t = sqrt(2 v / (k b)) after the yield, b =
/// A / fall, where -alpha = b t - y has not reached A) and goes up: at once, if -alpha is beyond
/// the upslope yield then, else when it gets there. From -alpha = x to A in tau = (A - x) / b with
/// the drive going from m = k (x - y) to n = k (A - y): (m + n) tau / 2 and (2 m + n) tau^2 / 6.
inline Strokes strokes(const TriangularCycle& c, const Slider& block) {
  const double A = c.first.amplitude_mps2, dt = c.first.dt_s, b = A / (c.first.fall * dt);
  const auto [k, y] = block.down;
  const double n = k * (A - y), rise = c.first.rise * dt * (A - y) / A, fall = (A - y) / b;
  const double v = n * (rise + fall) / 2, stop = std::sqrt(2 * v / (k * b));
  const double down =
      n * rise * rise / 6 + n * rise / 2 * fall + n * fall * fall / 3 + 2 * v * stop / 3;
  const auto [ku, yu] = block.up;
  const double x = std::max(b * stop - y, yu), tau = (A - x) / b;
  const double m = ku * (x - yu), top = ku * (A - yu);
  const double up =
      (2 * m + top) * tau * tau / 6 + slip_from_top(block.up, (m + top) * tau / 2, A, c.last * dt);
  return {down * block.plan, up * block.plan};
}

/// True where such a cycle stops and reverses in one instant.
inline bool reverses_at_once(const TriangularCycle& c, const Slider& block) {
  const double A = c.first.amplitude_mps2, b = A / (c.first.fall * c.first.dt_s);
  const auto [k, y] = block.down;
  const double rise = c.first.rise * c.first.dt_s * (A - y) / A, fall = (A - y) / b;
  return std::sqrt((A - y) * (rise + fall) / b) - y / b > block.up.yield_mps2 / b;
}

}  // namespace glissade::closed_forms
