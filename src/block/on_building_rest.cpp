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
  const Load begin = contact_.loading().at(motion[0].elastic.c[0] / mass,
                                           motion[1].elastic.c[0] / mass, piece.w(0.0));
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

/// Whole pieces in which nothing happens, as bounds on how far the motion leaves its chord tell:
/// while m = N - |M^-1 F| > 0 the block rests, and m is concave, so that on the chord it is no less
/// than at the ends.
template <class Nodes>
std::size_t OnBuildingBody::rest_over(const Nodes& nodes, std::size_t from, std::size_t to) {
  const FrictionEllipse& friction = contact_.friction_at_rest();
  if (axes_[0].flows() || axes_[1].flows() || friction.smallest() == 0.0) return from;
  const TwoAxisLoading& loading = contact_.loading();
  const double mass = 1.0 + mass_ratio_, per_mass = 1.0 / mass;
  const double per_along = 1.0 / friction.along(), per_across = 1.0 / friction.across();
  struct Node {
    BuildingAxis::State state;
    double ground, elastic;
  };
  Node now[2], next[2];
  const auto elastic = [&](const Node& node, std::size_t n) {
    return axes_[n].rigid() ? mass * node.ground : axes_[n].elastic(node.state);
  };
  const auto margin = [&](const Node(&node)[2], double w) {
    const Load load = loading.at(node[0].elastic * per_mass, node[1].elastic * per_mass, w);
    return load.normal - length({per_along * load.drive.s, per_across * load.drive.y});
  };
  for (std::size_t n = 0; n < 2; ++n) {
    now[n] = {axes_[n].state(), nodes.ground(n, from), 0.0};
    now[n].elastic = elastic(now[n], n);
  }
  double before = margin(now, nodes.w(from));
  std::size_t i = from;
  for (; i < to; ++i) {
    double sag = 0.0;
    bool may_peak[2], may_yield = false;
    for (std::size_t n = 0; n < 2; ++n) {
      const BuildingAxis& axis = axes_[n];
      next[n].ground = nodes.ground(n, i + 1);
      BuildingAxis::Sag own{0.0, 0.0};
      if (!axis.rigid()) {
        next[n].state = axis.rest_end(now[n].state, now[n].ground, next[n].ground);
        own = axis.sag(now[n].state, now[n].elastic, now[n].ground, next[n].ground);
        may_yield |=
            axis.may_yield_at(now[n].state, own.x) || axis.may_yield_at(next[n].state, own.x);
      }
      next[n].elastic = elastic(next[n], n);
      may_peak[n] =
          std::max(std::abs(now[n].elastic), std::abs(next[n].elastic)) + own.elastic >
              peaks_.elastic[n] ||
          std::max(std::abs(now[n].state.x), std::abs(next[n].state.x)) + own.x > peaks_.x[n];
      sag += own.elastic * per_mass;
    }
    const double after = margin(next, nodes.w(i + 1));
    const double needed = sag * margin_per_a_ + nodes.w_sag(i) * margin_per_w_;
    if (may_yield || !(std::min(before, after) > needed * (1.0 + 1e-9))) break;
    for (std::size_t n = 0; n < 2; ++n) {
      if (may_peak[n]) {
        axes_[n].set(now[n].state);
        raise_peaks(n, axes_[n].motion(nodes.dt_s(), {now[n].ground, next[n].ground}, mass), 1.0);
      }
      now[n] = next[n];
    }
    before = after;
  }
  for (std::size_t n = 0; n < 2; ++n) axes_[n].set(now[n].state);
  return i;
}

std::size_t OnBuildingBody::rest_through(const Shaken& shaken, std::size_t from, std::size_t to) {
  const std::size_t i = rest_over(shaken, from, to);
  time_s_ = static_cast<double>(i) * shaken.dt_s();
  return i;
}

bool OnBuildingBody::rest_quickly(const Shaking& piece) {
  struct Ends {
    const Shaking& piece;
    double dt_s() const { return piece.length_s; }
    double ground(std::size_t n, std::size_t i) const {
      return i == 0 ? piece.ground[n].begin : piece.ground[n].end;
    }
    double w(std::size_t i) const { return piece.w(i == 0 ? 0.0 : 1.0); }
    double w_sag(std::size_t) const { return piece.w_sag(); }
  };
  return rest_over(Ends{piece}, 0, 1) == 1;
}

}  // namespace glissade::block_detail
