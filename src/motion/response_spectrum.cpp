// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/response_spectrum.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/oscillator.hpp"
#include "glissade/motion/intensity.hpp"

namespace glissade {
namespace {

// As in core/oscillator.hpp: tau = omega t, x = omega^2 u, y = dx/dtau = omega u', h = omega dt;
// and v = dy/dtau = -(x + 2 zeta y + a).

struct State {
  double x, y, v;
};

/// An interval of one oscillator, h <= 1: its state at the start, and a linear ground acceleration.
struct Interval {
  double h, zeta;
  State start;
  double a_start, a_end;

  State at(double tau) const {
    if (tau <= 0.0) return start;
    const OscillatorStep to = oscillator_step(tau, zeta);
    const double a = std::lerp(a_start, a_end, tau / h);
    const double x = to.xx * start.x + to.xy * start.y - (to.x_start * a_start + to.x_end * a);
    const double y = -to.xy * start.x + to.yy * start.y - (to.y_start * a_start + to.y_end * a);
    return {x, y, -(x + 2.0 * zeta * y + a)};
  }

  /// |x| at the moment between `from` and `to` at which y = 0, or 0 where y keeps its sign.
  /// Newton's method, begun at the chord's zero: an error e in tau is one of v e^2 / 2 in x, so
  /// that four steps reach rounding.
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

  /// The largest |x| where y = 0. y is monotone but for one turning point, near the chord's zero of
  /// v, which is a free vibration.
  double peak(const State& end) const {
    if (start.v * end.v >= 0.0) return extremum(0.0, start.y, h, end.y);
    const double turn = h * start.v / (start.v - end.v);
    const double y_turn = at(turn).y;
    return std::max(extremum(0.0, start.y, turn, y_turn), extremum(turn, y_turn, h, end.y));
  }
};

/// Oscillators advanced in lockstep: Eigen keeps them in SIMD registers.
constexpr std::size_t lanes = 8;
using Lanes = Eigen::Array<double, int{lanes}, 1>;

class OscillatorBlock {
 public:
  explicit OscillatorBlock(double zeta) : zeta_(zeta) {}

  void set(std::size_t lane, double h) {
    const OscillatorStep step = oscillator_step(h, zeta_);
    h_[lane] = h;
    bulge_[lane] = h <= 1.0 ? 0.15 * h * h : 0.0;
    xx_[lane] = step.xx;
    xy_[lane] = step.xy;
    yy_[lane] = step.yy;
    x_start_[lane] = step.x_start;
    x_end_[lane] = step.x_end;
    y_start_[lane] = step.y_start;
    y_end_[lane] = step.y_end;
  }

  /// Before the first interval.
  void start(double acceleration) { v_ = -acceleration; }

  void advance(double a_start, double a_end) {
    const Lanes x = xx_ * x_ + xy_ * y_ - (x_start_ * a_start + x_end_ * a_end);
    const Lanes y = yy_ * y_ - xy_ * x_ - (y_start_ * a_start + y_end_ * a_end);
    const Lanes v = -(x + 2.0 * zeta_ * y + a_end);
    const Lanes x_ends = x.abs().max(x_.abs());
    peak_ = peak_.max(x_ends);
    // Inside the interval |x| exceeds its ends' by at most h^2/8 max|v|; and v, which is a free
    // vibration there, exceeds its own ends' by at most 15 % when h <= 1. And y must pass zero,
    // once or twice.
    const Lanes excess = x_ends + bulge_ * v.abs().max(v_.abs()) - peak_;
    const Lanes look = excess.min((-y * y_).max(-v * v_));
    if (look.maxCoeff() > 0.0) look_inside(look, {x, y, v}, a_start, a_end);
    x_ = x;
    y_ = y;
    v_ = v;
  }

  double peak(std::size_t lane) const { return std::max(peak_[lane], free_vibration_peak(lane)); }

 private:
  struct States {
    const Lanes &x, &y, &v;
  };

  void look_inside(const Lanes& look, const States& end, double a_start, double a_end) {
    for (std::size_t i = 0; i < lanes; ++i) {
      if (look[i] <= 0.0) continue;
      const Interval interval{h_[i], zeta_, {x_[i], y_[i], v_[i]}, a_start, a_end};
      peak_[i] = std::max(peak_[i], interval.peak({end.x[i], end.y[i], end.v[i]}));
    }
  }

  /// The largest |x| of the free vibration from now on: its first extremum is where
  /// tan(beta tau) = beta y / (x + zeta y), and exp(2 zeta tau) (x^2 + 2 zeta x y + y^2) does not
  /// change.
  double free_vibration_peak(std::size_t lane) const {
    const double x = x_[lane];
    const double y = y_[lane];
    const double beta = std::sqrt(1.0 - zeta_ * zeta_);
    double angle = std::atan2(beta * y, x + zeta_ * y);
    if (angle < 0.0) angle += std::numbers::pi;
    return std::exp(-zeta_ * angle / beta) * std::sqrt(x * x + 2.0 * zeta_ * x * y + y * y);
  }

  static Lanes zero() { return Lanes::Zero(); }

  double zeta_;
  Lanes h_ = zero(), bulge_ = zero();
  Lanes xx_ = zero(), xy_ = zero(), yy_ = zero();  // transition; yx = -xy
  Lanes x_start_ = zero(), x_end_ = zero(), y_start_ = zero(),
        y_end_ = zero();  // forcing by a at both ends
  Lanes x_ = zero(), y_ = zero(), v_ = zero(), peak_ = zero();
};

/// Steps per sample interval for which omega dt <= 1: the motion is linear in between, so that
/// smaller steps cost no accuracy. At most 64: beyond, the oscillator as good as follows the
/// ground.
int substeps_for(double dt_s, double period_s) {
  return static_cast<int>(
      std::clamp(std::ceil(2.0 * std::numbers::pi * dt_s / period_s), 1.0, 64.0));
}

void advance_through(std::span<const double> acceleration, int substeps, OscillatorBlock& block) {
  block.start(acceleration.front());
  for (std::size_t n = 0; n < acceleration.size(); ++n) {
    const double a_first = acceleration[n];
    const double a_last = n + 1 < acceleration.size() ? acceleration[n + 1] : 0.0;
    double a_start = a_first;
    for (int step = 1; step < substeps; ++step) {
      const double a_end = a_first + (a_last - a_first) * step / substeps;
      block.advance(a_start, a_end);
      a_start = a_end;
    }
    block.advance(a_start, a_last);
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

  // A block is of periods with as many substeps, so that the value at a period does not depend on
  // the other periods.
  std::map<int, std::vector<std::size_t>> groups;
  for (std::size_t i = 0; i < periods_s.size(); ++i) {
    if (periods_s[i] > 0.0) groups[substeps_for(dt_s, periods_s[i])].push_back(i);
  }
  for (const auto& [substeps, group] : groups) {
    for (std::size_t first = 0; first < group.size(); first += lanes) {
      const std::size_t count = std::min(lanes, group.size() - first);
      OscillatorBlock block(damping_ratio);
      for (std::size_t k = 0; k < count; ++k) {
        block.set(k, 2.0 * std::numbers::pi * dt_s / (periods_s[group[first + k]] * substeps));
      }
      advance_through(acceleration_mps2, substeps, block);
      for (std::size_t k = 0; k < count; ++k) spectrum[group[first + k]] = block.peak(k);
    }
  }
  return spectrum;
}

}  // namespace glissade
