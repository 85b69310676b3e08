// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "glissade/block/on_building.hpp"

namespace glissade::test {

/// A block and a building of several modes on one axis by another method than src/block: the
/// equations of theory.md, 3.4, between one event and the next by Runge & Kutta's rule of order 4
/// on equal substeps, in long double; an event is bisected within its substep. Coulomb friction.
struct ModesReference {
  double peak_m = 0.0, residual_m = 0.0;  ///< in plan
  double base_shear = 0.0;                ///< BuildingSlip::peak_base_shear, at the substeps
  int phases = 0;

  /// @param quiet_s of zeros that follow the record
  ModesReference(const std::vector<double>& ground_mps2, double dt_s, const Modes& modes,
                 double mass_ratio, const Block& block, double quiet_s, int substeps = 400)
      : modes_(modes),
        mass_ratio_(mass_ratio),
        mu_(block.friction.along),
        sine_(std::sin(static_cast<Long>(block.slope_rad))),
        cosine_(std::cos(static_cast<Long>(block.slope_rad))),
        g_(block.gravity_mps2) {
    const Long h = static_cast<Long>(dt_s) / substeps;
    const auto sample = [&](std::size_t i) {
      return i < ground_mps2.size() ? ground_mps2[i] : 0.0;
    };
    const std::size_t n = ground_mps2.size() + static_cast<std::size_t>(quiet_s / dt_s);
    for (std::size_t i = 0; i < n; ++i)
      for (int k = 0; k < substeps; ++k) {
        rise_ = (static_cast<Long>(sample(i + 1)) - sample(i)) / dt_s;
        ground_ = sample(i) + rise_ * (k * h);
        substep(h);
      }
    residual_m = static_cast<double>(y_.slip * cosine_);
  }

 private:
  using Long = long double;
  struct State {
    Long d[most_modes] = {}, rate[most_modes] = {}, slip = 0, v = 0;
  };
  /// Of block and roof at an instant.
  struct Contact {
    Long roof, push,
        v_rate;  ///< acceleration of the roof; reaction of the block on it; of the block
  };

  Contact contact(const State& y, Long ground) const {
    Long e = modes_.ground_share() * ground;
    for (std::size_t n = 0; n < modes_.size(); ++n) {
      const Long omega = 2 * std::numbers::pi_v<Long> / modes_[n].period_s;
      e -= modes_[n].participation * omega *
           (2 * modes_[n].damping_ratio * y.rate[n] + omega * y.d[n]);
    }
    const Long r = mass_ratio_ * modes_.accelerance();
    if (direction_ == 0) return {e / (1 + r), e / (1 + r), 0};
    const Long q = sine_ - direction_ * mu_ * cosine_,
               normal = (g_ * cosine_ + e * sine_) / (1 + r * sine_ * q), a = e - r * normal * q;
    return {a, normal * q, g_ * sine_ - a * cosine_ - direction_ * mu_ * normal};
  }
  State slope(const State& y, Long ground) const {
    const Contact c = contact(y, ground);
    State s;
    for (std::size_t n = 0; n < modes_.size(); ++n) {
      const Mode& mode = modes_[n];
      const Long omega = 2 * std::numbers::pi_v<Long> / mode.period_s;
      s.d[n] = y.rate[n];
      s.rate[n] = -ground - omega * (2 * mode.damping_ratio * y.rate[n] + omega * y.d[n]) -
                  mode.participation / mode.mass_share * mass_ratio_ * c.push;
    }
    s.slip = y.v;
    s.v = c.v_rate;
    return s;
  }
  static State sum(const State& y, Long h, const State& s) {
    State z = y;
    for (std::size_t n = 0; n < most_modes; ++n) {
      z.d[n] += h * s.d[n];
      z.rate[n] += h * s.rate[n];
    }
    z.slip += h * s.slip;
    z.v += h * s.v;
    return z;
  }
  State after(Long h) const {
    const State a = slope(y_, ground_), b = slope(sum(y_, h / 2, a), ground_ + rise_ * h / 2),
                c = slope(sum(y_, h / 2, b), ground_ + rise_ * h / 2),
                d = slope(sum(y_, h, c), ground_ + rise_ * h);
    return sum(sum(sum(sum(y_, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
  }
  /// In which direction the block at rest starts to slide; 0: it stays.
  int starts(const State& y, Long ground) const {
    const Contact c = contact(y, ground);
    const Long drive = g_ * sine_ - c.roof * cosine_, most = mu_ * (g_ * cosine_ + c.roof * sine_);
    return drive > most ? 1 : drive < -most ? -1 : 0;
  }
  void substep(Long h) {
    while (h > 0) {
      const auto happens = [&](Long t) {
        const State y = after(t);
        return direction_ == 0 ? starts(y, ground_ + rise_ * t) != 0 : direction_ * y.v < 0;
      };
      Long low = 0, high = h;
      const bool is_event = happens(h);
      while (is_event && high - low > 1e-15L * h) {
        const Long middle = (low + high) / 2;
        (happens(middle) ? high : low) = middle;
      }
      y_ = after(high);
      ground_ += rise_ * high;
      h -= high;
      peak_m = std::max(peak_m, static_cast<double>(std::abs(y_.slip * cosine_)));
      if (is_event) change();
      raise_shear();
      if (!is_event) return;
    }
  }
  void change() {
    const int before = direction_;
    direction_ = 0;
    y_.v = 0;
    direction_ = starts(y_, ground_);
    if (direction_ == before) direction_ = 0;  // it has just stopped
    if (before == 0 || direction_ != 0) ++phases;
  }
  void raise_shear() {
    const Contact c = contact(y_, ground_);
    Long shear = ground_ * (1 - mass_of({modes_.begin(), modes_.size()}));
    for (const Mode& mode : modes_) {
      const auto n = static_cast<std::size_t>(&mode - modes_.begin());
      const Long omega = 2 * std::numbers::pi_v<Long> / mode.period_s;
      shear -= mode.mass_share * omega * (2 * mode.damping_ratio * y_.rate[n] + omega * y_.d[n]);
    }
    shear += modes_.ground_share() * mass_ratio_ * c.push;
    base_shear = std::max(base_shear, static_cast<double>(std::abs(shear) / g_));
  }

  Modes modes_;
  Long mass_ratio_, mu_, sine_, cosine_, g_;
  State y_;
  Long ground_ = 0, rise_ = 0;
  int direction_ = 0;  ///< of sliding; 0: at rest
};

}  // namespace glissade::test
