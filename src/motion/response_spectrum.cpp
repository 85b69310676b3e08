// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/response_spectrum.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/oscillator.hpp"
#include "glissade/motion/intensity.hpp"
#include "oscillator_block.hpp"

namespace glissade {
namespace {

// As in core/oscillator.hpp: tau = omega t, x = omega^2 u, y = dx/dtau = omega u', h = omega dt;
// and v = dy/dtau = -(x + 2 zeta y + a).

struct State {
  double x, y, v;
};

/// An interval of one oscillator, h <= 1: its state at the start, and a linear ground acceleration.
struct OscillatorInterval {
  double h, zeta;
  State start;
  double a_start, a_end;

  State at(double tau) const {
    if (tau <= 0.0) return start;
    const OscillatorStep to = oscillator_step(tau, zeta);
    const double a = std::lerp(a_start, a_end, tau / h);
    const auto [x, y] = to.after({start.x, start.y}, a_start, a);
    return {x, y, -(x + 2.0 * zeta * y + a)};
  }

  /// |x| at the time between `from` and `to` at which y = 0, or 0 if y does not change sign.
  /// Newton's method from the zero of the chord: an error e in tau is an error v e^2 / 2 in x, so
  /// four steps reach rounding.
  double extremum(double from, double y_from, double to, double y_to) const {
    if (y_from * y_to >= 0.0) return 0.0;
    double tau = from + (to - from) * y_from / (y_from - y_to);
    State state = at(tau);
    for (int step = 1; step < 4 && state.v != 0.0; ++step) {
      tau = std::clamp(tau - state.y / state.v, from, to);
      state = at(tau);
    }
    return std::abs(state.x);
  }

  /// The largest |x| where y = 0. y is monotone except for one turning point, near the zero of the
  /// chord of v, which is a free vibration.
  double peak(const State& end) const {
    if (start.v * end.v >= 0.0) return extremum(0.0, start.y, h, end.y);
    const double turn = h * start.v / (start.v - end.v);
    const double y_turn = at(turn).y;
    return std::max(extremum(0.0, start.y, turn, y_turn), extremum(turn, y_turn, h, end.y));
  }
};

using motion_detail::OscillatorBlock;

void load(OscillatorBlock& block, std::size_t k, double h) {
  block.h[k] = h;
  block.bulge[k] = h <= 1.0 ? 0.15 * h * h : 0.0;
  block.steps.set(k, oscillator_step(h, block.zeta));
}

/// An oscillator is searched if by the result of the lanes its peak may have increased.
void look_inside(OscillatorBlock& block, std::size_t first, std::size_t last, double a_start,
                 double a_end) {
  const auto& [x0, y0, v0] = block.now;
  const auto& [x1, y1, v1] = block.next;
  for (std::size_t k = first; k < last; ++k) {
    const double x_ends = std::max(std::abs(x1[k]), std::abs(x0[k]));
    const double v_ends = std::max(std::abs(v1[k]), std::abs(v0[k]));
    if (x_ends + block.bulge[k] * v_ends - block.peak[k] <= 0.0) continue;
    if (std::max(-y1[k] * y0[k], -v1[k] * v0[k]) <= 0.0) continue;
    const OscillatorInterval interval{
        block.h[k], block.zeta, {x0[k], y0[k], v0[k]}, a_start, a_end};
    block.peak[k] = std::max(block.peak[k], interval.peak({x1[k], y1[k], v1[k]}));
  }
}

/// The largest |x| of the free vibration from now on: its first extremum is where
/// tan(beta tau) = beta y / (x + zeta y), and exp(2 zeta tau) (x^2 + 2 zeta x y + y^2) is constant.
double free_vibration_peak(double x, double y, double zeta) {
  const double beta = std::sqrt(1.0 - zeta * zeta);
  double angle = std::atan2(beta * y, x + zeta * y);
  if (angle < 0.0) angle += std::numbers::pi;
  return std::exp(-zeta * angle / beta) * std::sqrt(x * x + 2.0 * zeta * x * y + y * y);
}

double peak(const OscillatorBlock& block, std::size_t k) {
  return std::max(block.peak[k], free_vibration_peak(block.now.x[k], block.now.y[k], block.zeta));
}

/// Steps per sample interval for which omega dt <= 1: the motion is linear in between, so that
/// smaller steps lose no accuracy. At most 64: beyond that the oscillator practically follows the
/// ground.
int substeps_for(double dt_s, double period_s) {
  return static_cast<int>(
      std::clamp(std::ceil(2.0 * std::numbers::pi * dt_s / period_s), 1.0, 64.0));
}

void advance_through(std::span<const double> acceleration, int substeps, std::size_t count,
                     OscillatorBlock& block) {
  constexpr std::size_t stretch = 256;
  for (std::size_t k = 0; k < count; ++k) block.now.v[k] = -acceleration.front();
  std::vector<double> ground;
  for (std::size_t begin = 0; begin < acceleration.size(); begin += stretch) {
    const std::size_t end = std::min(begin + stretch, acceleration.size());
    ground.assign(1, acceleration[begin]);
    for (std::size_t n = begin; n < end; ++n) {
      const double a_first = acceleration[n];
      const double a_last = n + 1 < acceleration.size() ? acceleration[n + 1] : 0.0;
      for (int step = 1; step < substeps; ++step)
        ground.push_back(a_first + (a_last - a_first) * step / substeps);
      ground.push_back(a_last);
    }
    motion_detail::advance(block, count, ground, look_inside);
  }
}

}  // namespace

std::vector<double> pseudo_acceleration_spectrum(double dt_s,
                                                 std::span<const double> acceleration_mps2,
                                                 std::span<const double> periods_s,
                                                 double damping_ratio) {
  GLISSADE_EXPECTS(dt_s > 0.0 && !acceleration_mps2.empty());
  GLISSADE_EXPECTS(damping_ratio >= 0.0 && damping_ratio < 1.0);
  GLISSADE_EXPECTS(std::ranges::all_of(periods_s, [](double period_s) { return period_s >= 0.0; }));
  std::vector<double> spectrum(periods_s.size(), peak_ground_acceleration_mps2(acceleration_mps2));

  // The periods of a block have the same number of substeps, so that the value at a period does not
  // depend on the other periods.
  std::map<int, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < periods_s.size(); ++i) {
    if (periods_s[i] > 0.0) groups[substeps_for(dt_s, periods_s[i])].push_back(i);
  }
  for (const auto& [substeps, group] : groups) {
    for (std::size_t first = 0; first < group.size(); first += OscillatorBlock::size) {
      const std::size_t count = std::min(OscillatorBlock::size, group.size() - first);
      OscillatorBlock block{.zeta = damping_ratio};
      for (std::size_t k = 0; k < count; ++k) {
        load(block, k, 2.0 * std::numbers::pi * dt_s / (periods_s[group[first + k]] * substeps));
      }
      advance_through(acceleration_mps2, substeps, count, block);
      for (std::size_t k = 0; k < count; ++k) spectrum[group[first + k]] = peak(block, k);
    }
  }
  return spectrum;
}

}  // namespace glissade
