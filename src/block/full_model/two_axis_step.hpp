// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/two_axis_contact.hpp"
#include "block/full_model/sdirk4.hpp"

namespace glissade::block_detail {

/// Velocity and acceleration, per cos(slope).
struct Sliding {
  Vector v, a;
};

struct SlidingStep {
  Sliding end;
  double error = 0.0;  ///< of end.v, estimated
};

/// Remainder of an error of the velocity after an implicit step of `own_s`: friction turns it
/// toward v at the rate |f| N / |v|, which is large for small v (Hairer & Wanner 1996, IV.8: an
/// estimate must not include the part that stiffness damps).
inline Vector damped(Vector error, Vector v, double own_s, const Load& load,
                     const FrictionEllipse& friction) {
  const double speed2 = dot(v, v);
  if (speed2 == 0.0) return error;
  const Vector along = (dot(error, v) / speed2) * v;
  const double stiffness = friction.smallest() * std::max(load.normal, 0.0) / std::sqrt(speed2);
  return along + 1.0 / (1.0 + own_s * stiffness) * (error - along);
}

/// SDIRK4 over `length_s`, in which the load goes linearly from `begin` to `end`.
inline SlidingStep sdirk4(Vector v, const Load& begin, const Load& end, double length_s,
                          const FrictionEllipse& friction) {
  using S = Sdirk4;
  const double own = S::gamma * length_s;
  Vector k[S::stages], stage_v, error;
  // Unrolled, the tableau's numbers are constants and its zeros vanish: a third faster.
#pragma GCC unroll 5
  for (int i = 0; i < S::stages; ++i) {
    Vector known{};
#pragma GCC unroll 5
    for (int j = 0; j < i; ++j) known = known + S::a[i][j] * k[j];
    known = v + length_s * known;
    const Load load = between(begin, end, S::at[i]);
    const double normal = std::max(load.normal, 0.0);
    const Vector p = known + own * load.drive;
    k[i] = load.drive - normal * friction.holding(p, own * normal);
    stage_v = known + own * k[i];
    error = error + S::difference[i] * k[i];
  }
  return {{stage_v, k[S::stages - 1]},
          length_s * length(damped(error, stage_v, own, end, friction))};
}

}  // namespace glissade::block_detail
