// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/building/yielding.hpp"
#include "power_series.hpp"

namespace glissade::block_detail {

/// A spring's force per mass until something happens to it: force + stiffness (x - x now).
struct SpringLine {
  double force = 0.0, stiffness = 1.0;
};

/// The building's spring in the scaled state x = omega^2 u. Its force per mass is alpha x +
/// (1 - alpha) z, where z = x - p, and p is the plastic part of x. Elastic, p stays; yielding, z is
/// held at its limit, the yield acceleration, and p follows x.
class Spring {
 public:
  explicit Spring(const Yielding& yielding)
      : limit_(yielding.yield_acceleration_mps2),
        alpha_(yielding.yields() ? yielding.hardening_ratio : 0.0) {}

  SpringLine line(double x) const { return {force(x), direction_ == 0 ? 1.0 : alpha_}; }
  double force(double x) const { return x - offset(); }
  /// x where it pulls nothing.
  double offset() const { return (1.0 - alpha_) * plastic_; }
  double limit() const { return limit_; }
  /// What it can give back, per mass.
  double stored_m2ps2(double x, double per_omega_s) const {
    const double u = x * per_omega_s, z = (x - plastic_) * per_omega_s;
    return 0.5 * (alpha_ * u * u + (1.0 - alpha_) * z * z);
  }
  /// What yielding took, times omega^2.
  double dissipated() const { return dissipated_; }
  /// Whether it can yield while no |force| exceeds this.
  bool may_yield(double largest_force) const {
    return direction_ != 0 || largest_force + alpha_ * std::abs(plastic_) >= limit_;
  }

  /// When z reaches its limit on this side.
  double yield_share(const Series& x, int side) const;
  /// When x, yielding, turns back.
  double unload_share(const Series& y) const;

  void pass(double x_begin, double x_end, double share);
  void yield(int side, double x);
  void unload();

  bool yielding() const { return direction_ != 0; }
  bool yields() const { return limit_ < never; }

 private:
  double limit_, alpha_;
  double plastic_ = 0.0, dissipated_ = 0.0;
  int direction_ = 0;  // +1, -1: yielding this way
  int at_limit_ = 0;   // z is exactly at the limit of this side where the rest of a piece begins
};

}  // namespace glissade::block_detail
