// SPDX-License-Identifier: GPL-3.0-or-later
// Block and building while the block rests.
#include "on_building_body.hpp"

namespace glissade::block_detail {
namespace {

/// Without the terms beyond the last, which are below rounding on a piece of longest_phase.
Series product(const Series& a, const Series& b) {
  Series s;
  s.terms = std::min(a.terms + b.terms - 1, Series::most_terms);
  for (int k = 0; k < s.terms; ++k) {
    s.c[k] = 0.0;
    for (int i = std::max(0, k - b.terms + 1); i <= k && i < a.terms; ++i)
      s.c[k] += a.c[i] * b.c[k - i];
  }
  return s;
}

/// FrictionEllipse::excess over a piece.
Series excess(const FrictionEllipse& friction, const TwoAxisLoading& loading,
              const AxisSeries (&axis)[2], double mass, const Shaking& shaking) {
  Series s, y, n;
  s.terms = y.terms = n.terms =
      std::max({axis[0].elastic.terms, axis[1].elastic.terms, shaking.vertical_terms});
  for (int k = 0; k < s.terms; ++k) {
    const double a1 = coefficient(axis[0].elastic, k) / mass,
                 a2 = coefficient(axis[1].elastic, k) / mass;
    const double w = shaking.coefficient(k);
    const Load load = k == 0 ? loading.at(a1, a2, w) : loading.change(a1, a2, w);
    s.c[k] = load.drive.s;
    y.c[k] = friction.to_circle() * load.drive.y;
    n.c[k] = friction.along() * load.normal;
  }
  Series e = product(s, s);
  const Series y2 = product(y, y), n2 = product(n, n);
  for (int k = 0; k < e.terms; ++k) e.c[k] = (e.c[k] - n2.c[k]) + y2.c[k];
  return e;
}

}  // namespace

double OnBuildingBody::rest(const Shaking& piece) {
  const double mass = 1.0 + mass_ratio_;
  const AxisSeries motion[2] = {axes_[0].motion(piece.length_s, piece.ground[0], mass),
                                axes_[1].motion(piece.length_s, piece.ground[1], mass)};
  const FrictionEllipse& friction = contact_.friction_at_rest();
  const Load begin = contact_.loading().at(motion[0].elastic.c[0] / mass, motion[1].elastic.c[0] / mass,
                                            piece.w(0.0));
  const double release = friction.may_rest(begin)
                             ? first_rise(excess(friction, contact_.loading(), motion, mass, piece))
                             : 0.0;
  double yield[2], share = std::min(release, 1.0);
  for (std::size_t n = 0; n < 2; ++n) {
    yield[n] = axes_[n].next_yield(motion[n]);
    share = std::min(share, yield[n]);
  }
  for (std::size_t n = 0; n < 2; ++n) {
    raise_peaks(n, motion[n], share);
    axes_[n].follow(motion[n], share);
  }
  if (share == 1.0) return 1.0;  // what happens there begins the next piece
  bool yielded = false;
  for (std::size_t n = 0; n < 2; ++n) {
    if (yield[n] != share) continue;
    axes_[n].yield();
    yielded = true;
  }
  if (yielded) return share;
  // Released by as much as Coulomb's law holds it back, a block has no acceleration yet.
  const bool jumps = share == 0.0 || contact_.law().static_ratio != 1.0;
  Vector a;
  if (jumps) {
    Axes e;
    for (std::size_t n = 0; n < 2; ++n)
      e[n] = axes_[n].rigid() ? piece.ground[n].at(share) : axes_[n].elastic();
    a = contact_.release_acceleration(e, piece.w(share), mobility_);
  }
  start(a, piece);
  return share;
}

/// Over a whole piece in which nothing happens, as bounds on how far the motion leaves its chord
/// tell: while m = N - |M^-1 F| > 0 it rests, and m is concave, so that on the chord it is no less
/// than at the ends.
bool OnBuildingBody::rest_quickly(const Shaking& piece) {
  const FrictionEllipse& friction = contact_.friction_at_rest();
  if (axes_[0].flows() || axes_[1].flows() || friction.smallest() == 0.0) return false;
  const TwoAxisLoading& loading = contact_.loading();
  const double mass = 1.0 + mass_ratio_, per_mass = 1.0 / mass;
  const auto margin = [&](const Axes& e, double w) {
    const Load load = loading.at(e[0], e[1], w);
    const Vector held{load.drive.s / friction.along(), load.drive.y / friction.across()};
    return load.normal - length(held);
  };
  Axes a0, a1;
  BuildingAxis::State end[2];
  double sag = 0.0;
  bool may_peak[2];
  for (std::size_t n = 0; n < 2; ++n) {
    const BuildingAxis& axis = axes_[n];
    const Ramp& ground = piece.ground[n];
    if (axis.rigid()) {
      a0[n] = ground.begin;
      a1[n] = ground.end;
      may_peak[n] = true;
      continue;
    }
    const BuildingAxis::State begin = axis.state();
    end[n] = axis.rest_end(ground);
    const BuildingAxis::Sag own = axis.sag(ground);
    if (axis.may_yield_at(begin, own.x) || axis.may_yield_at(end[n], own.x)) return false;
    const double e0 = axis.elastic(begin), e1 = axis.elastic(end[n]);
    may_peak[n] =
        std::max(std::abs(e0), std::abs(e1)) + own.elastic > peaks_.elastic[n] ||
        std::max(std::abs(begin.x), std::abs(end[n].x)) + own.x > peaks_.x[n];
    sag += own.elastic * per_mass;
    a0[n] = e0 * per_mass;
    a1[n] = e1 * per_mass;
  }
  if (rest_margin_ < 0.0) rest_margin_ = margin(a0, piece.w(0.0));
  const double after = margin(a1, piece.w(1.0));
  const double needed = sag * margin_per_a_ + piece.w_sag() * margin_per_w_;
  if (!(std::min(rest_margin_, after) > needed * (1.0 + 1e-9))) return false;
  for (std::size_t n = 0; n < 2; ++n) {
    if (may_peak[n]) raise_peaks(n, axes_[n].motion(piece.length_s, piece.ground[n], mass), 1.0);
    if (!axes_[n].rigid()) axes_[n].set(end[n]);
  }
  rest_margin_ = after;
  return true;
}

}  // namespace glissade::block_detail
