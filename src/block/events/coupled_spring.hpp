// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "block/polynomial/power_series.hpp"
#include "glissade/building/yielding.hpp"

namespace glissade::block_detail {

/// Force of a spring per mass until its next event: force + stiffness (x - x now).
struct SpringLine {
  double force = 0.0, stiffness = 1.0;
};

/// The building's spring in the scaled state x = omega^2 u. Its force per mass is alpha x +
/// (1 - alpha) z = z + alpha (x - z). Elastic, z changes with x; yielding, it is constant at its
/// limit, the yield acceleration. So z keeps its digits at any drift of the building
/// (theory.md, 2.3: eta).
class Spring {
 public:
  explicit Spring(const Yielding& yielding)
      : limit_(yielding.yield_acceleration_mps2),
        alpha_(yielding.yields() ? yielding.hardening_ratio : 0.0) {}

  bool yields() const { return limit_ < never; }
  bool yielding() const { return direction_ != 0; }
  SpringLine line(double x) const { return {force(x), yielding() ? alpha_ : 1.0}; }
  double force(double x) const { return yields() ? z_ + alpha_ * plastic(x) : x; }
  /// x where the force is zero.
  double offset(double x) const { return (1.0 - alpha_) * plastic(x); }
  double limit() const { return limit_; }
  /// Elastic energy, per mass.
  double stored_m2ps2(double x, double per_omega_s) const {
    const double u = x * per_omega_s, z = (x - plastic(x)) * per_omega_s;
    return 0.5 * (alpha_ * u * u + (1.0 - alpha_) * z * z);
  }
  /// Energy dissipated by yielding, times omega^2.
  double dissipated() const { return dissipated_; }
  /// Whether it can yield while no |force| exceeds this.
  bool may_yield(double x, double largest_force) const {
    return yields() && (yielding() || largest_force + alpha_ * std::abs(plastic(x)) >= limit_);
  }

  /// Time at which z reaches its limit on this side.
  double yield_fraction(const Series& x, int side) const;
  /// Time at which x reverses while yielding.
  double unload_fraction(const Series& y) const;
  /// The fraction of a piece passes; @pre yields().
  void pass(const Series& x, double fraction);
  void yield(int side);
  /// @param y where it reverses: zero, but for rounding
  /// @return y, which does not go on in the direction of yielding
  double unload(double y) {
    const double reversed = direction_ > 0 ? std::min(y, 0.0) : std::max(y, 0.0);
    direction_ = 0;
    return reversed;
  }

 private:
  double plastic(double x) const { return yields() ? x - z_ : 0.0; }

  double limit_, alpha_;
  double z_ = 0.0, dissipated_ = 0.0;
  int direction_ = 0;  // +1, -1: direction of yielding
};

}  // namespace glissade::block_detail
