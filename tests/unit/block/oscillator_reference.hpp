// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "glissade/block/crossing.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::test {

/// A block on an oscillator with the roof's motion in closed form at any time, not only at samples
/// (core/oscillator.hpp from the sample before, over the time since). Events are looked for in
/// `looks` parts of every sample interval and bisected; phases are integrated by V and U. Written
/// without tables or interpolation; slow. Horizontal only, slope >= 0, no uplift.
class OscillatorReference {
 public:
  double down = 0.0, up = 0.0, residual = 0.0;  ///< in plan, m
  std::vector<Crossing> crossings;              ///< of the thresholds that are reached

  OscillatorReference(double dt_s, std::span<const double> ground_mps2, double period_s,
                      double damping, double factor, const Block& block, double ring_down_s,
                      int looks = 64, std::span<const double> thresholds_m = {})
      : dt_(dt_s),
        ground_(ground_mps2.begin(), ground_mps2.end()),
        omega_(2.0 * std::numbers::pi / period_s),
        zeta_(damping),
        factor_(factor) {
    const double c = std::cos(block.slope_rad), s = std::sin(block.slope_rad),
                 g = block.gravity_mps2, mu = block.friction.along;
    drive_[0] = {-(c + mu * s), g * (s - mu * c)};
    drive_[1] = {c - mu * s, g * (-s - mu * c)};
    ground_.push_back(0.0);
    ground_.resize(ground_.size() + static_cast<std::size_t>(ring_down_s / dt_s), 0.0);
    states_.push_back({});
    const OscillatorStep step = oscillator_step(omega_ * dt_, zeta_);
    for (std::size_t i = 0; i + 1 < ground_.size(); ++i)
      states_.push_back(next(states_.back(), step, dt_, ground_[i], ground_[i + 1]));

    int direction = 0;
    Roof start;  // of the phase
    double slip = 0.0, far_down = 0.0, far_up = 0.0;
    const double look = 1.0 / looks;
    for (std::size_t i = 0; i + 1 < ground_.size(); ++i) {
      for (int k = 0; k < looks; ++k) {
        double from = k * look;
        const double to = (k + 1) * look;
        for (int events = 0; events < 8; ++events) {
          if (direction == 0) {
            int begins = 0;
            double at = 2.0;
            for (int d = 0; d < 2; ++d) {
              const auto drive = [&](double y) { return push(d, roof(i, y)); };
              double begin = 2.0;
              if (drive(from) > 0.0 && events == 0)
                begin = from;
              else if (drive(from + 1e-12) > 0.0)
                begin = from;
              else if (drive(to) > 0.0)
                begin = bisect(drive, from, to);
              if (begin < at) at = begin, begins = d == 0 ? 1 : -1;
            }
            if (begins == 0) break;
            direction = begins;
            start = roof(i, at);
            from = at;
          }
          const int d = direction > 0 ? 0 : 1;
          const auto slowing = [&](double y) { return -speed(d, start, roof(i, y)); };
          const bool stops = slowing(to) > 0.0;
          const double at = stops ? bisect(slowing, from, to) : to;
          while (crossings.size() < thresholds_m.size()) {
            const auto beyond = [&](double y) {
              return std::abs(slip + direction * way(d, start, roof(i, y))) * c -
                     thresholds_m[crossings.size()];
            };
            if (!(beyond(at) >= 0.0)) break;
            const Roof here = roof(i, bisect(beyond, from, at));
            crossings.push_back({here.time, c * speed(d, start, here)});
          }
          if (!stops) break;
          slip += direction * way(d, start, roof(i, at));
          far_down = std::max(far_down, slip);
          far_up = std::min(far_up, slip);
          direction = 0;
          from = at;
        }
      }
    }
    if (direction != 0)
      slip += direction * way(direction > 0 ? 0 : 1, start, roof(ground_.size() - 2, 1.0));
    down = std::max(far_down, slip) * c;
    up = -std::min(far_up, slip) * c;
    residual = slip * c;
  }

 private:
  struct State {
    double x = 0.0, y = 0.0, ground_v = 0.0, ground_u = 0.0;
  };
  struct Roof {
    double time = 0.0, a = 0.0, v = 0.0, u = 0.0;
  };
  struct Drive {
    double a, constant;
  };

  static State next(const State& s, const OscillatorStep& step, double h, double a0, double a1) {
    return {step.xx * s.x + step.xy * s.y - (step.x_start * a0 + step.x_end * a1),
            step.yy * s.y - step.xy * s.x - (step.y_start * a0 + step.y_end * a1),
            s.ground_v + 0.5 * h * (a0 + a1),
            s.ground_u + h * (s.ground_v + h * (2.0 * a0 + a1) / 6.0)};
  }

  Roof roof(std::size_t i, double y) const {
    State s = states_[i];
    if (y > 0.0) {
      const double a1 = ground_[i] + y * (ground_[i + 1] - ground_[i]);
      s = next(s, oscillator_step(omega_ * dt_ * y, zeta_), dt_ * y, ground_[i], a1);
    }
    return {dt_ * (static_cast<double>(i) + y), -factor_ * (s.x + 2.0 * zeta_ * s.y),
            factor_ * (s.y / omega_ + s.ground_v),
            factor_ * (s.x / (omega_ * omega_) + s.ground_u)};
  }

  double push(int d, const Roof& r) const { return drive_[d].a * r.a + drive_[d].constant; }
  double speed(int d, const Roof& from, const Roof& r) const {
    return drive_[d].a * (r.v - from.v) + drive_[d].constant * (r.time - from.time);
  }
  double way(int d, const Roof& from, const Roof& r) const {
    const double t = r.time - from.time;
    return drive_[d].a * (r.u - from.u - from.v * t) + 0.5 * drive_[d].constant * t * t;
  }

  template <class F>
  static double bisect(F f, double low, double high) {
    for (int i = 0; i < 60; ++i) {
      const double mid = 0.5 * (low + high);
      (f(mid) > 0.0 ? high : low) = mid;
    }
    return high;
  }

  double dt_;
  std::vector<double> ground_;
  std::vector<State> states_;
  double omega_, zeta_, factor_;
  Drive drive_[2];
};

}  // namespace glissade::test
