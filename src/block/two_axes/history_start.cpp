// SPDX-License-Identifier: GPL-3.0-or-later
// How a block at rest begins to slide.
#include <algorithm>
#include <cmath>

#include "history.hpp"

namespace glissade::block_detail::two_axes {
namespace {

constexpr int terms = 5;

/// M v = y^2 (W_0 + W_1 y + ...), M = diag(1, aspect), of a block that leaves rest with M p = n M M
/// e: friction turns it with the load, since it is stiff where |v| is small. The series is
/// asymptotic: good as long as its terms fall.
struct StartSeries {
  Vector w[terms];
  double speed[terms] = {};  ///< of |W|
};

/// With (M v)' = p - n M M e, p and n as power series in y, p_0 = n_0 M M e_0:
///   (m + 2) W_m = p_m+1 - (n M M e)_m+1,   W = |W| e,   |e| = 1
StartSeries expand(const Vector (&p)[terms + 1], const double (&n)[terms + 1], double aspect) {
  const Vector squared{1.0, aspect * aspect};
  StartSeries z;
  Vector e[terms + 1];
  const Vector first{p[0].s, p[0].y / squared.y};
  e[0] = (1.0 / length(first)) * first;
  const Vector across{-e[0].y, e[0].s}, held = scaled(squared, e[0]),
                                        held_across = scaled(squared, across);
  for (int m = 0; m < terms; ++m) {
    Vector known = p[m + 1], before{};
    double bend = 0.0;
    for (int j = 1; j <= m + 1; ++j) known = known - n[j] * scaled(squared, e[m + 1 - j]);
    for (int j = 0; j < m; ++j) before = before + z.speed[j] * e[m - j];
    for (int j = 1; j <= m; ++j) bend -= 0.5 * dot(e[j], e[m + 1 - j]);
    const double order = m + 2.0;
    const double turn =
        ((dot(known, across) - order * dot(before, across)) / n[0] - bend * dot(across, held)) /
        dot(across, held_across);
    const double grips = bend * dot(e[0], held) + turn * dot(e[0], held_across);
    z.speed[m] = (dot(known, e[0]) - n[0] * grips) / order - dot(before, e[0]);
    z.w[m] = z.speed[m] * e[0] + before;
    e[m + 1] = bend * e[0] + turn * across;
  }
  return z;
}

}  // namespace

/// As far as the series goes within the tolerance. Leaves the spot as it is
/// where that is nothing.
void LaneHistory::start_smoothly(Spot& spot) {
  const Constants<double>& c = constants_;
  LaneMotion<double>& m = spot.motion;
  RoofPiece::Push push;
  RoofPiece rest_of_interval = piece(spot, push);
  const double left_s = rest_of_interval.length_s();
  const double uneven = 1.0 - c.per_kappa_y * c.kappa, gives = c.per_kappa_y * c.mu * c.gives;
  const int passes = roof_ == RoofKind::coupled ? 3 : 1;
  StartSeries z;
  double y = 0.0;
  for (int pass = 0; pass < passes; ++pass) {
    Vector p[terms + 1];
    double n[terms + 1];
    for (int k = 0; k <= terms; ++k) {
      const Load load = rest_of_interval.term(k);
      p[k] = (left_s * c.per_kappa_y) * Vector{load.drive.s, c.aspect * load.drive.y};
      n[k] = left_s * c.per_kappa_y * c.mu * load.normal;
      if (k == 0 || pass == 0) continue;
      const double rate_s = (k + 1.0) * z.w[k - 1].s;  // what is not the same in both directions
      p[k].s += uneven * rate_s;
      n[k] -= gives * rate_s;
    }
    n[0] = length({p[0].s, p[0].y * (c.per_aspect * c.per_aspect)});
    if (!(n[0] > 0.0)) return;
    z = expand(p, n, c.aspect);
    const double last = length(z.w[terms - 1]), before = length(z.w[terms - 2]);
    if (!(z.speed[0] > 0.0)) return;
    const double allowed = 0.1 * c.tolerance;
    y = 1.0;
    if (last > 0.0) {
      const double by_fastest = std::sqrt(std::cbrt(allowed * m.fastest / last));
      const double by_itself = std::sqrt(std::sqrt(allowed * z.speed[0] / last));
      y = std::min({1.0, std::max(by_fastest, by_itself), 0.5 * before / last});
    }
    y = std::min(y, 0.5 * z.speed[0] / (1e-300 + length(z.w[1])));
    if (y > 0.999) y = y < 1.0 ? 0.999 : 1.0;
    if (!(y > 1e-4)) return;
    if (passes == 1) break;
    Vector end{};
    for (int k = terms; k-- > 0;) end = y * end + z.w[k];
    const auto push_by = [&](Vector w) { return push_of({w.s, c.per_aspect * w.y}).begin; };
    push.curve = push_by(z.w[0]);
    push.bend = push_by((1.0 / y) * (end - z.w[0]));
    rest_of_interval = piece(spot, push);
  }
  Vector v{}, way{};
  for (int k = terms; k-- > 0;) {
    v = y * v + z.w[k];
    way = y * way + (1.0 / (k + 3.0)) * z.w[k];
  }
  v = (y * y) * Vector{v.s, c.per_aspect * v.y};
  way = (left_s * y * y * y) * Vector{way.s, c.per_aspect * way.y};
  const double begin_s = time_s(spot);
  rest_of_interval.move(spot, y);
  m.v_s = v.s;
  m.v_y = v.y;
  m.fastest = std::max(m.fastest, length(v));
  m.path += length(way);
  const Vector from{m.at_s, m.at_y}, to_plan{c.cosine2, c.cosine * c.per_aspect};
  const auto at = [&](double share) {
    const double x = share * y;
    Vector speed{}, moved{};
    for (int k = terms; k-- > 0;) {
      speed = x * speed + z.w[k];
      moved = x * moved + (1.0 / (k + 3.0)) * z.w[k];
    }
    return WayPoint{from + scaled((left_s * x * x * x) * moved, to_plan),
                    scaled((x * x) * speed, to_plan)};
  };
  move_way(spot, scaled(way, {c.cosine2, c.cosine}), at, begin_s, y * left_s);
}

}  // namespace glissade::block_detail::two_axes
