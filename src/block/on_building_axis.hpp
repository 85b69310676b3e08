// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "glissade/building/roof_motion.hpp"
#include "glissade/building/yielding.hpp"
#include "glissade/core/oscillator.hpp"
#include "power_series.hpp"

namespace glissade::block_detail {

/// A quantity linear over a piece of time.
struct Ramp {
  double begin = 0.0, end = 0.0;
  double at(double share) const { return begin + share * (end - begin); }
};

/// A building's axis over a piece of time, y in [0, 1] its share.
struct AxisSeries {
  Series x, y;                                    ///< scaled state (core/oscillator.hpp)
  Series elastic;                                 ///< E, see BuildingAxis
  double largest_elastic = 0.0, largest_x = 0.0;  ///< no |value| is larger
};

/// One axis of the building: mass a = E - push with E = -(2 zeta y + s), in accelerations: x =
/// omega^2 u, y = omega u', s the spring's force per mass of the building. A yielding spring is
/// s = hardening x + (1 - hardening) z, where z is x itself kept within the yield force (Bouc's
/// decomposition of the bilinear spring): z follows x, or flows at +- the yield force.
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
  double elastic() const { return -(twice_zeta_ * y_ + spring()); }
  double spring() const { return share_ * x_ + (1.0 - share_) * z_; }
  double stiffness() const { return flow_ == 0 ? 1.0 : share_; }  ///< tangent, of the elastic

  /// Over a piece whose ground and push go linearly, with the spring as it is now.
  AxisSeries motion(double length_s, const Ramp& ground, double mass, const Ramp& push = {}) const;

  /// When the spring first yields or unloads, or never.
  double next_yield(const AxisSeries& motion) const;
  /// The state at a share of the piece, and what has been added to it since.
  void follow(const AxisSeries& motion, double share, double add_x = 0.0, double add_y = 0.0);
  /// What next_yield() found happens.
  void yield();

  struct State {
    double x = 0.0, y = 0.0, z = 0.0;
  };
  /// While the block rests, over a whole piece: exact at its end (Nigam & Jennings 1969). Only of a
  /// spring that does not flow.
  State rest_end(const State& from, double ground_begin, double ground_end) const {
    const double s = spring(from);
    const double s1 = rest_.xx * s + rest_.xy * from.y -
                      (rest_.x_start * ground_begin + rest_.x_end * ground_end);
    const double y1 = rest_.yy * from.y - rest_.yx * s -
                      (rest_.y_start * ground_begin + rest_.y_end * ground_end);
    return yields_ ? State{from.x + (s1 - s), y1, from.z + (s1 - s)} : State{s1, y1, 0.0};
  }
  void set(const State& state) {
    x_ = state.x;
    y_ = state.y;
    z_ = state.z;
  }
  double spring(const State& at) const { return share_ * at.x + (1.0 - share_) * at.z; }
  double elastic(const State& at) const { return -(twice_zeta_ * at.y + spring(at)); }
  /// By how much E and x can leave their chords over such a piece: a function leaves its
  /// chord by at most 1/8 of its largest second derivative. With z = a - a_ground, mass
  /// m, ' over the piece:
  ///   y' = phase z,  z' = -phase (y + 2 zeta z) / m - a_ground',
  /// so that |z| <= (|z_0| + phase |y_0| / m + |a_ground'|) / (1 - (phase^2 + 2 zeta phase) / m).
  struct Sag {
    double elastic, x;
  };
  Sag sag(const State& from, double elastic, double ground_begin, double ground_end) const {
    const double rise = std::abs(ground_end - ground_begin), y0 = std::abs(from.y);
    const double z0 = std::abs(elastic * per_mass_ - ground_begin);
    const double z = (z0 + phase_ * y0 * per_mass_ + rise) * per_left_;
    const double z_rate = phase_ * (y0 + (phase_ + twice_zeta_) * z) * per_mass_ + rise;
    const double x = 0.125 * phase_ * phase_ * z;
    return {x + 0.125 * phase_ * twice_zeta_ * z_rate, x};
  }
  bool may_yield_at(const State& state, double within) const {
    return yields_ && !(std::abs(state.z) + within < yield_);
  }
  State state() const { return {x_, y_, z_}; }
  bool flows() const { return flow_ != 0; }

  /// |a| never exceeds this again while the block rests and the ground is quiet.
  double largest_to_come_mps2() const;

 private:
  struct RestStep {
    double xx, xy, yx, yy, x_start, x_end, y_start, y_end;
  };

  double omega_ = 0.0, twice_zeta_ = 0.0;
  int terms_ = 2;
  bool yields_ = false;
  double share_ = 1.0, yield_ = 0.0;  // hardening ratio; yield force
  double stuck_mass_ = 1.0, per_mass_ = 1.0, phase_ = 0.0, per_left_ = 1.0;
  RestStep rest_{};

  double x_ = 0.0, y_ = 0.0, z_ = 0.0;
  int flow_ = 0;  // +1, -1: the spring flows that way
};

}  // namespace glissade::block_detail
