// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/history/elliptic_stop.hpp"

#include <cmath>

namespace glissade::block_detail::two_axes {
namespace {

constexpr double nothing_left =
    2e-4;  // of the speed: its square, which the path goes with, is 4e-8

struct Braking {
  Vector load, friction;  // M d, and n M M as a vector

  double at(Vector e) const { return dot(scaled(friction, e), e) - dot(load, e); }
  /// The rotation of e while u falls by a factor: e' per -log u.
  Vector rotation(Vector e) const {
    const Vector across{-e.y, e.s}, net = load - scaled(friction, e);
    return (dot(net, across) / at(e)) * across;
  }
  Vector rotated(Vector e, double length) const {
    const Vector k1 = rotation(e), k2 = rotation(e + (0.5 * length) * k1),
                 k3 = rotation(e + (0.5 * length) * k2), k4 = rotation(e + length * k3);
    const Vector to = e + (length / 6.0) * (k1 + 2.0 * (k2 + k3) + k4);
    return (1.0 / block_detail::length(to)) * to;
  }
};

/// With u falling by the ratio in each step.
EllipticStop by_steps(Vector v, Vector d, double n, double aspect, double enough_m, double ratio) {
  const double mean = 0.5 * (1.0 + ratio), to_middle = -std::log(mean),
               to_end = std::log(mean / ratio), sixth = (1.0 - ratio) / 6.0;
  const Vector to_w{1.0, aspect}, from_w{1.0, 1.0 / aspect};
  const Vector w = scaled(v, to_w);
  const Braking braking{scaled(d, to_w), {n, n * aspect * aspect}};
  const double first = length(w);
  double u = first, brake = 0.0;
  Vector e = (1.0 / u) * w, displacement{};
  Stop stop;
  stop.time_s = 0.0;
  stop.fastest = length(v);
  for (;;) {
    brake = braking.at(e);
    if (!(brake > 0.0)) return {};
    if (u < nothing_left * first || length(braking.rotation(e)) * u * u < enough_m * brake) break;
    const Vector middle = braking.rotated(e, to_middle), end = braking.rotated(middle, to_end);
    const double at_middle = braking.at(middle), at_end = braking.at(end);
    if (!(at_middle > 0.0 && at_end > 0.0)) return {};
    const Vector per_u =
        (1.0 / brake) * e + (4.0 * mean / at_middle) * middle + (ratio / at_end) * end;
    const Vector step = (sixth * u * u) * per_u;
    stop.time_s += sixth * u * (1.0 / brake + 4.0 / at_middle + 1.0 / at_end);
    stop.path += length(scaled(step, from_w));
    displacement = displacement + step;
    e = end;
    u *= ratio;
  }
  const Vector rest = (0.5 * u * u / brake) * e;
  stop.time_s += u / brake;
  stop.path += length(scaled(rest, from_w));
  stop.displacement = scaled(displacement + rest, from_w);
  return {stop, scaled(e, from_w)};
}

}  // namespace

EllipticStop stop_on_an_ellipse(Vector v, Vector d, double n, double aspect, double enough_m) {
  const Vector x = scaled(d, {1.0, 1.0 / aspect});
  if (!(n > 0.0 && dot(x, x) < n * n)) return {};
  double ratio = 0.5;
  EllipticStop found = by_steps(v, d, n, aspect, enough_m, ratio);
  for (int halvings = 0; halvings < 6; ++halvings) {
    ratio = std::sqrt(ratio);
    const EllipticStop finer = by_steps(v, d, n, aspect, enough_m, ratio);
    const double change = length(finer.stop.displacement - found.stop.displacement);
    found = finer;
    if (!(change > enough_m)) break;
  }
  return found;
}

}  // namespace glissade::block_detail::two_axes
