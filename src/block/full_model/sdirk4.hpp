// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/two_axis_contact.hpp"
#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail {

/// Tableau of SDIRK4, five stages, L-stable, with an embedded error estimate (Hairer & Wanner 1996,
/// IV.6; the last row holds the weights).
struct Sdirk4 {
  static constexpr int stages = 5;
  static constexpr double gamma = 0.25;
  static constexpr double at[stages] = {1.0 / 4, 3.0 / 4, 11.0 / 20, 1.0 / 2, 1.0};
  static constexpr double a[stages][stages - 1] = {{},
                                                   {1.0 / 2},
                                                   {17.0 / 50, -1.0 / 25},
                                                   {371.0 / 1360, -137.0 / 2720, 15.0 / 544},
                                                   {25.0 / 24, -49.0 / 48, 125.0 / 16, -85.0 / 12}};
  static constexpr double difference[stages] = {-3.0 / 16, -27.0 / 32, 25.0 / 32, 0.0, 1.0 / 4};
};

/// Velocity and acceleration, per cos(slope).
struct Sliding {
  Vector v, a;
};

struct SlidingStep {
  Sliding end;
  double error = 0.0;  ///< of end.v, estimated
};

/// Remainder of an error of the velocity after an implicit step of `gamma_h`: friction turns it
/// toward v at the rate |f| N / |v|, which is large for small v (Hairer & Wanner 1996, IV.8: an
/// estimate must not include the part that stiffness damps).
inline Vector damped(Vector error, Vector v, double gamma_h, double normal,
                     const FrictionEllipse& friction) {
  const double speed2 = dot(v, v);
  if (speed2 == 0.0) return error;
  const Vector along = (dot(error, v) / speed2) * v;
  const double stiffness = friction.smallest() * std::max(normal, 0.0) / std::sqrt(speed2);
  return along + 1.0 / (1.0 + gamma_h * stiffness) * (error - along);
}

/// Safety factor and limits of the change of a step (Hairer & Wanner 1996, IV.8).
constexpr double step_safety = 0.9, least_step_factor = 0.2, most_step_factor = 5.0;

/// By which to multiply the length of a step for its error to become `ratio` times as large; the
/// error of a step is of order 4.
inline double step_factor(double ratio) {
  return std::clamp(step_safety * std::sqrt(std::sqrt(ratio)), least_step_factor, most_step_factor);
}
/// Allowed over estimated error; a step without an error becomes as long as it may.
/// @throw NotConverged if the error is no number
inline double error_ratio(double allowed, double error) {
  if (!(error < never)) throw NotConverged("a step has no finite error");
  return error > 0.0 ? allowed / error : 1e4;
}
/// Allowance for rounding, per time, in the error of a step under a load.
inline double rounding_of(const Load& load) {
  return 16.0 * std::numeric_limits<double>::epsilon() *
         (std::abs(load.drive.s) + std::abs(load.drive.y) + std::abs(load.normal));
}
/// The shortest step, of what is left of an interval: far below what any tolerance requires.
constexpr double shortest_step = 1e-9;
/// The same of a step from rest that must not end where the load would let the block rest again.
constexpr double shortest_start = 1e-6;

/// Of gravity times the length of an interval: a speed that rounding alone may give a block on its
/// threshold, and which must not set the scale of the errors.
constexpr double rounding_speed = 1e-9;

/// SDIRK4 over `length_s` from velocity v.
/// @param rate (stage, known, gamma_h) -> v' at a stage, where v = known + gamma_h v'
/// @param normal () -> normal force at the end, by which friction turns the velocity
template <class Rate, class Normal>
[[gnu::always_inline]] inline SlidingStep sdirk4(Vector v, double length_s,
                                                 const FrictionEllipse& friction, const Rate& rate,
                                                 const Normal& normal) {
  using S = Sdirk4;
  const double gamma_h = S::gamma * length_s;
  Vector k[S::stages], stage_v, error;
  // Unrolled and inline, the tableau's numbers are constants and its zeros vanish: a third faster.
#pragma GCC unroll 5
  for (int i = 0; i < S::stages; ++i) {
    Vector known{};
#pragma GCC unroll 5
    for (int j = 0; j < i; ++j) known = known + S::a[i][j] * k[j];
    known = v + length_s * known;
    k[i] = rate(i, known, gamma_h);
    stage_v = known + gamma_h * k[i];
    error = error + S::difference[i] * k[i];
  }
  return {{stage_v, k[S::stages - 1]},
          length_s * length(damped(error, stage_v, gamma_h, normal(), friction))};
}

}  // namespace glissade::block_detail
