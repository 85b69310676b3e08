// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "block/polynomial/power_series.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/building/yielding.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail {

/// A quantity linear over a piece of time.
struct Ramp {
  double begin = 0.0, end = 0.0;
  double at(double fraction) const { return begin + fraction * (end - begin); }
};

/// An axis of the building over a piece of time, tau in [0, 1] the elapsed fraction.
struct AxisSeries {
  Series x, y;                                  ///< scaled state (core/oscillator.hpp)
  Series resisting;                             ///< E, see BuildingAxis
  double resisting_bound = 0.0, x_bound = 0.0;  ///< no |value| is larger
};

/// One axis of the building: mass a = E - interaction with E = -(2 zeta y + s), in accelerations: x
/// = omega^2 u, y = omega u', s the spring's force per mass of the building. A yielding spring is
/// s = hardening x + (1 - hardening) z, where z is x limited to the yield force (decomposition of
/// the bilinear spring by Bouc): z follows x, or is constant at +- the yield force (yielding).
class BuildingAxis {
 public:
  BuildingAxis(const Oscillator& oscillator, const Yielding& yielding, double mass_ratio,
               double piece_s);

  bool rigid() const { return omega_ == 0.0; }
  bool yields() const { return yields_; }
  double omega_radps() const { return omega_; }
  double twice_zeta() const { return twice_zeta_; }
  double x() const { return x_; }
  double y() const { return y_; }
  double resisting() const { return -(twice_zeta_ * y_ + spring()); }
  double spring() const { return hardening_ * x_ + (1.0 - hardening_) * z_; }
  /// Distance of z from its limits, in either direction.
  double yield_left() const { return yields_ ? yield_ - std::abs(z_) : never; }
  double stiffness() const {
    return yield_direction_ == 0 ? 1.0 : hardening_;
  }  ///< tangent, over that of the elastic spring

  /// Over a piece with linear ground and interaction, with the spring in its present state.
  AxisSeries motion(double length_s, const Ramp& ground, double mass,
                    const Ramp& interaction = {}) const;

  /// Time at which the spring first yields or unloads, or never.
  double next_yield(const AxisSeries& motion) const;
  /// The state at a fraction of the piece, with the addition since then.
  void follow(const AxisSeries& motion, double fraction, double add_x = 0.0, double add_y = 0.0);
  /// Applies the event that next_yield() found.
  void yield();

  /// Sets spring force and state after whole pieces of rest (RestSteps).
  void rest_to(double spring_force, double y) {
    const double change = spring_force - spring();
    x_ = yields_ ? x_ + change : spring_force;
    if (yields_) z_ += change;
    y_ = y;
  }
  bool yielding() const { return yield_direction_ != 0; }

  /// |a| never exceeds this again while the block rests and the ground is at rest.
  double largest_to_come_mps2() const;

  /// Coefficients of a piece at rest, in the spring force s and y: exact at its end (Nigam &
  /// Jennings 1969, core/oscillator.hpp) while the spring does not yield.
  struct RestStep {
    double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
    double x_start = 0.0, x_end = 0.0, y_start = 0.0, y_end = 0.0;
  };
  const RestStep& rest_step() const { return rest_; }
  double phase() const { return phase_; }

 private:
  double omega_ = 0.0, twice_zeta_ = 0.0;
  int terms_ = 2;
  bool yields_ = false;
  double hardening_ = 1.0, yield_ = 0.0;  // hardening ratio; yield force
  double stuck_mass_ = 1.0, phase_ = 0.0;
  RestStep rest_;

  double x_ = 0.0, y_ = 0.0, z_ = 0.0;
  int yield_direction_ = 0;  // +1, -1: direction of yielding
};

}  // namespace glissade::block_detail
