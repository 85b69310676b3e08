// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/two_axis_contact.hpp"

namespace glissade::block_detail {

/// Permitted error of the displacement of a stop, of tolerance times path: nothing later corrects
/// it, and stops are many.
constexpr double stop_tolerance = 1e-3;
/// A step toward a stop that is not yet found ends after this fraction of the time to it: the load
/// then changes less until the stop, whose error falls with the cube of what is left.
constexpr double approach_to_stop = 0.6;

/// Stop of a block.
struct Stop {
  double time_s = never;
  Vector displacement;
  double path = 0.0;
  double fastest = 0.0;  ///< before it

  /// The fraction of a straight path after a fraction of the time, and its rate, from the speed at
  /// its start: the cubic that ends at rest.
  struct PathFraction {
    double path, rate;
  };
  PathFraction path_fraction(double tau, double speed) const {
    const double begin = path > 0.0 ? speed * time_s / path : 0.0;
    // path = begin tau + b tau^2 + c tau^3 with path(1) = 1, path'(1) = 0
    const double c = begin - 2.0, b = 1.0 - begin - c;
    return {tau * (begin + tau * (b + tau * c)), begin + tau * (2.0 * b + tau * 3.0 * c)};
  }
  /// The same cubic by its Bernstein coefficients of degree 4.
  std::array<double, 5> path_points(double speed) const {
    const double begin = path > 0.0 ? speed * time_s / path : 0.0;
    return {0.0, 0.25 * begin, 0.5 + begin / 6.0, 1.0, 1.0};
  }
};

/// With d and n = mu N constant on a circle (two_axis.hpp): never, where |d| >= n.
inline Stop stop_under_constant_load(Vector v, Vector d, double n) {
  const double margin = n * n - dot(d, d);
  if (!(n > 0.0 && margin > 0.0)) return {};
  const double speed = length(v), vd = dot(v, d);
  const double beta = (2.0 * n * speed + vd) / (4.0 * n * n - dot(d, d));
  const double gamma = (speed * speed + 3.0 * beta * vd) / (4.0 * margin);
  const Vector displacement = beta * v + gamma * d;
  // The speed changes by d cos(psi) - n: its integral over the path is the work balance.
  return {(n * speed + vd) / margin, displacement, (0.5 * speed * speed + dot(d, displacement)) / n,
          speed};
}

/// When a block that should stop after `t_s`, but may then still have the speed `off`, rests for
/// sure; never, if the load may set it in motion before that: near the threshold friction takes
/// hardly anything of a velocity along the load.
/// @param load of which it rests, at a time
template <class LoadAt>
double certain_rest_s(double off, double t_s, double left_s, const FrictionEllipse& friction,
                      const LoadAt& load) {
  const double deceleration = friction.least_deceleration(load(t_s));
  if (!(deceleration > 0.0)) return never;
  // As a function of time it is concave: after half the time at least half of it is left.
  const double rests_s = t_s + 4.0 * off / deceleration;
  return rests_s <= left_s && friction.may_rest(load(rests_s)) ? rests_s : never;
}

}  // namespace glissade::block_detail
