// SPDX-License-Identifier: GPL-3.0-or-later
#include "elliptic_stop.hpp"

namespace glissade::block_detail::two_axes {
namespace {

struct Braking {
  Vector load, grip;  // M d, and n M M as a vector

  double at(Vector e) const { return dot(scaled(grip, e), e) - dot(load, e); }
  /// The turn of e while u falls by a factor: e' per -log u.
  Vector turn(Vector e) const {
    const Vector across{-e.y, e.s}, net = load - scaled(grip, e);
    return (dot(net, across) / at(e)) * across;
  }
  Vector turned(Vector e, double length) const {
    const Vector k1 = turn(e), k2 = turn(e + (0.5 * length) * k1),
                 k3 = turn(e + (0.5 * length) * k2), k4 = turn(e + length * k3);
    const Vector to = e + (length / 6.0) * (k1 + 2.0 * (k2 + k3) + k4);
    return (1.0 / block_detail::length(to)) * to;
  }
};

}  // namespace

EllipticStop stop_on_an_ellipse(Vector v, Vector d, double n, double aspect, double enough_m) {
  constexpr double to_middle = 0.28768207245178092;  // log(4/3)
  constexpr double to_end = 0.40546510810816438;     // log(3/2)
  const Vector to_w{1.0, aspect}, from_w{1.0, 1.0 / aspect};
  const Vector w = scaled(v, to_w), x = scaled(d, from_w);
  if (!(n > 0.0 && dot(x, x) < n * n)) return {};
  const Braking braking{scaled(d, to_w), {n, n * aspect * aspect}};
  double u = length(w), brake = 0.0;
  Vector e = (1.0 / u) * w, way{};
  Stop stop;
  stop.time_s = 0.0;
  stop.fastest = length(v);
  for (int halvings = 0; halvings < 12; ++halvings) {
    brake = braking.at(e);
    if (!(brake > 0.0)) return {};
    if (length(braking.turn(e)) * u * u < enough_m * brake) break;
    const Vector middle = braking.turned(e, to_middle), end = braking.turned(middle, to_end);
    const double at_middle = braking.at(middle), at_end = braking.at(end);
    if (!(at_middle > 0.0 && at_end > 0.0)) return {};
    const Vector per_u = (1.0 / brake) * e + (3.0 / at_middle) * middle + (0.5 / at_end) * end;
    const Vector step = (u * u / 12.0) * per_u;
    stop.time_s += u / 12.0 * (1.0 / brake + 4.0 / at_middle + 1.0 / at_end);
    stop.path += length(scaled(step, from_w));
    way = way + step;
    e = end;
    u *= 0.5;
    brake = at_end;
  }
  const Vector rest = (0.5 * u * u / brake) * e;
  stop.time_s += u / brake;
  stop.path += length(scaled(rest, from_w));
  stop.displacement = scaled(way + rest, from_w);
  return {stop, scaled(e, from_w)};
}

}  // namespace glissade::block_detail::two_axes
