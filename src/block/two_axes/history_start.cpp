// SPDX-License-Identifier: GPL-3.0-or-later
// How a block at rest begins to slide.
#include <algorithm>
#include <cmath>

#include "history.hpp"

namespace glissade::block_detail::two_axes {
namespace {

constexpr int terms = 5;

/// v = y^2 (W_0 + W_1 y + ...) of a block that leaves rest with p = n e:
/// friction turns it with the load, since it is stiff where |v| is small. The
/// series is asymptotic: good as long as its terms fall.
struct StartSeries {
  Vector w[terms];
  double speed[terms] = {};  ///< of |W|
};

/// With v' = p - n e, p and n as power series in y, |p_0| = n_0:
///   (m + 2) W_m = p_m+1 - (n e)_m+1,   W = |W| e,   |e| = 1
StartSeries expand(const Vector (&p)[terms + 1], const double (&n)[terms + 1]) {
  StartSeries z;
  Vector e[terms + 1];
  e[0] = (1.0 / length(p[0])) * p[0];
  const Vector across{-e[0].y, e[0].s};
  for (int m = 0; m < terms; ++m) {
    Vector known = p[m + 1], before{};
    double bend = 0.0;
    for (int j = 1; j <= m + 1; ++j) known = known - n[j] * e[m + 1 - j];
    for (int j = 0; j < m; ++j) before = before + z.speed[j] * e[m - j];
    for (int j = 1; j <= m; ++j) bend -= 0.5 * dot(e[j], e[m + 1 - j]);
    const double order = m + 2.0;
    z.speed[m] = (dot(known, e[0]) - n[0] * bend) / order - dot(before, e[0]);
    z.w[m] = z.speed[m] * e[0] + before;
    const double turn = (dot(known, across) - order * dot(before, across)) / n[0];
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
      p[k] = (left_s * c.per_kappa_y) * load.drive;
      n[k] = left_s * c.per_kappa_y * c.mu * load.normal;
      if (k == 0 || pass == 0) continue;
      const double rate_s = (k + 1.0) * z.w[k - 1].s;  // what is not the same in both directions
      p[k].s += uneven * rate_s;
      n[k] -= gives * rate_s;
    }
    n[0] = length(p[0]);
    if (!(n[0] > 0.0)) return;
    z = expand(p, n);
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
    push.curve = push_of(end).begin;
    rest_of_interval = piece(spot, push);
  }
  Vector v{}, way{};
  for (int k = terms; k-- > 0;) {
    v = y * v + z.w[k];
    way = y * way + (1.0 / (k + 3.0)) * z.w[k];
  }
  v = (y * y) * v;
  way = (left_s * y * y * y) * way;
  rest_of_interval.move(spot, y);
  m.v_s = v.s;
  m.v_y = v.y;
  m.fastest = std::max(m.fastest, length(v));
  m.path += length(way);
  move_way(spot, scaled(way, {c.cosine2, c.cosine}));
}

}  // namespace glissade::block_detail::two_axes
