// SPDX-License-Identifier: GPL-3.0-or-later
// How a block at rest begins to slide.
#include <algorithm>
#include <cmath>

#include "history.hpp"

namespace glissade::block_detail::two_axes {
namespace {

constexpr int terms = 5;

/// M v = tau^2 (W_0 + W_1 tau + ...), M = diag(1, aspect), of a block that leaves rest with M p = n
/// M M e: friction turns it with the load, since it is stiff where |v| is small. The series is
/// asymptotic: good as long as its terms fall.
struct StartSeries {
  Vector w[terms];
  double speed[terms] = {};  ///< of |W|
};

/// With (M v)' = p - n M M e, p and n as power series in tau, p_0 = n_0 M M e_0:
///   (m + 2) W_m = p_m+1 - (n M M e)_m+1,   W = |W| e,   |e| = 1
StartSeries expand(const Vector (&p)[terms + 1], const double (&n)[terms + 1], double aspect) {
  const Vector squared{1.0, aspect * aspect};
  StartSeries z;
  Vector e[terms + 1];
  const Vector first{p[0].s, p[0].y / squared.y};
  e[0] = (1.0 / length(first)) * first;
  const Vector across{-e[0].y, e[0].s}, squared_e = scaled(squared, e[0]),
                                        squared_across = scaled(squared, across);
  for (int m = 0; m < terms; ++m) {
    Vector known = p[m + 1], before{};
    double bend = 0.0;
    for (int j = 1; j <= m + 1; ++j) known = known - n[j] * scaled(squared, e[m + 1 - j]);
    for (int j = 0; j < m; ++j) before = before + z.speed[j] * e[m - j];
    for (int j = 1; j <= m; ++j) bend -= 0.5 * dot(e[j], e[m + 1 - j]);
    const double order = m + 2.0;
    const double rotation = ((dot(known, across) - order * dot(before, across)) / n[0] -
                             bend * dot(across, squared_e)) /
                            dot(across, squared_across);
    const double friction = bend * dot(e[0], squared_e) + rotation * dot(e[0], squared_across);
    z.speed[m] = (dot(known, e[0]) - n[0] * friction) / order - dot(before, e[0]);
    z.w[m] = z.speed[m] * e[0] + before;
    e[m + 1] = bend * e[0] + rotation * across;
  }
  return z;
}

/// The series under the load of a piece. What the block itself adds to the load is taken from the
/// series `before`, null: nothing yet. All zero where the load has no direction.
StartSeries series_under(const RoofPiece& piece, const Constants<double>& c,
                         const StartSeries* before) {
  const double left_s = piece.length_s(), anisotropy = 1.0 - c.per_kappa_y * c.kappa,
               coupling = c.per_kappa_y * c.mu * c.rho_sin_cos;
  Vector p[terms + 1];
  double n[terms + 1];
  for (int k = 0; k <= terms; ++k) {
    const Load load = piece.term(k);
    p[k] = (left_s * c.per_kappa_y) * Vector{load.drive.s, c.aspect * load.drive.y};
    n[k] = left_s * c.per_kappa_y * c.mu * load.normal;
    if (k == 0 || before == nullptr) continue;
    const double rate_s = (k + 1.0) * before->w[k - 1].s;
    p[k].s += anisotropy * rate_s;
    n[k] -= coupling * rate_s;
  }
  n[0] = length({p[0].s, p[0].y * (c.per_aspect * c.per_aspect)});
  return n[0] > 0.0 ? expand(p, n, c.aspect) : StartSeries{};
}

/// The elapsed fraction up to which the series is good: its last term below `allowed` of the speed
/// so far, or of its own, and its terms falling. 0 where that is next to nothing.
double usable_fraction(const StartSeries& z, double allowed, double fastest_mps) {
  constexpr double shortest = 1e-4, longest = 0.999;  // of an interval's rest, else all of it
  const double last = length(z.w[terms - 1]), before = length(z.w[terms - 2]);
  if (!(z.speed[0] > 0.0)) return 0.0;
  double tau = 1.0;
  if (last > 0.0) {
    const double by_fastest = std::sqrt(std::cbrt(allowed * fastest_mps / last));
    const double by_itself = std::sqrt(std::sqrt(allowed * z.speed[0] / last));
    tau = std::min({1.0, std::max(by_fastest, by_itself), 0.5 * before / last});
  }
  tau = std::min(tau, 0.5 * z.speed[0] / (1e-300 + length(z.w[1])));
  if (tau > longest) tau = tau < 1.0 ? longest : 1.0;
  return tau > shortest ? tau : 0.0;
}

}  // namespace

/// As far as the series goes within the tolerance. Leaves the state as it is
/// where that is nothing.
void LaneHistory::start_smoothly(HistoryState& state) {
  const Constants<double>& c = constants_;
  LaneMotion<double>& m = state.motion;
  RoofPiece::BlockVelocity block_velocity;
  RoofPiece rest_of_interval = piece(state, block_velocity);
  const double left_s = rest_of_interval.length_s();
  const int passes = roof_ == RoofKind::coupled ? 3 : 1;
  StartSeries z;
  double tau = 0.0;
  for (int pass = 0; pass < passes; ++pass) {
    z = series_under(rest_of_interval, c, pass == 0 ? nullptr : &z);
    tau = usable_fraction(z, 0.1 * c.tolerance, m.fastest);
    if (tau == 0.0) return;
    if (passes == 1) break;
    Vector end{};
    for (int k = terms; k-- > 0;) end = tau * end + z.w[k];
    const auto plan_velocity_of = [&](Vector w) {
      return plan_velocity({w.s, c.per_aspect * w.y}).begin;
    };
    block_velocity.curve = plan_velocity_of(z.w[0]);
    block_velocity.bend = plan_velocity_of((1.0 / tau) * (end - z.w[0]));
    rest_of_interval = piece(state, block_velocity);
  }
  Vector v{}, displacement{};
  for (int k = terms; k-- > 0;) {
    v = tau * v + z.w[k];
    displacement = tau * displacement + (1.0 / (k + 3.0)) * z.w[k];
  }
  v = (tau * tau) * Vector{v.s, c.per_aspect * v.y};
  displacement = (left_s * tau * tau * tau) * Vector{displacement.s, c.per_aspect * displacement.y};
  const double begin_s = time_s(state);
  rest_of_interval.move(state, tau);
  m.v_s = v.s;
  m.v_y = v.y;
  m.fastest = std::max(m.fastest, length(v));
  m.path += length(displacement);
  step_s_ = tau * left_s;  // the curve is smooth: a step as long as the series is no risk
  const Vector from{m.at_s, m.at_y}, to_plan{c.cosine2, c.cosine * c.per_aspect};
  const auto at = [&](double fraction) {
    const double x = fraction * tau;
    Vector speed{}, moved{};
    for (int k = terms; k-- > 0;) {
      speed = x * speed + z.w[k];
      moved = x * moved + (1.0 / (k + 3.0)) * z.w[k];
    }
    return PathPoint{from + scaled((left_s * x * x * x) * moved, to_plan),
                     scaled((x * x) * speed, to_plan)};
  };
  displace(state, scaled(displacement, {c.cosine2, c.cosine}), at, begin_s, tau * left_s);
}

}  // namespace glissade::block_detail::two_axes
