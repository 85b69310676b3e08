// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/contact/plane_vector.hpp"

namespace glissade::block_detail {

/// The change of sign of a function from not positive at `low` to positive at `high`.
template <class Function>
double rise_between(const Function& f, double low, double high) {
  for (int bisection = 0; bisection < 60; ++bisection) {
    const double middle = 0.5 * (low + high);
    (f(middle) > 0.0 ? high : low) = middle;
  }
  return high;
}

/// The fraction of a piece of path in [0, 1] at which its displacement first has the length
/// `radius_m`; 1 where it does not. Looked for in eight parts, and in more where they do not show
/// it.
/// @param displacement, velocity from the fraction to a vector in plan
template <class Displacement, class Velocity>
double first_reach(const Displacement& displacement, const Velocity& velocity, double radius_m) {
  const auto beyond = [&](double tau) { return length(displacement(tau)) - radius_m; };
  const auto recedes = [&](double tau) { return -dot(displacement(tau), velocity(tau)); };
  for (int parts = 8; parts <= 4096; parts *= 8) {
    double from = 0.0;
    for (int i = 1; i <= parts; ++i) {
      const double to = static_cast<double>(i) / parts;
      if (recedes(from) < 0.0 && recedes(to) > 0.0) {
        const double farthest = rise_between(recedes, from, to);
        if (beyond(farthest) >= 0.0) return rise_between(beyond, from, farthest);
      }
      if (beyond(to) >= 0.0) return rise_between(beyond, from, to);
      from = to;
    }
  }
  return 1.0;
}

}  // namespace glissade::block_detail
