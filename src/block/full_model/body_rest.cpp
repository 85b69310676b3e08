// SPDX-License-Identifier: GPL-3.0-or-later
// Block and building while the block sticks.
#include "block/full_model/body.hpp"
#include "block/full_model/resting_axis.hpp"

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
              const AxisSeries (&axis)[2], const Axes& mass, const ExcitationPiece& excitation) {
  Series s, y, n;
  s.terms = y.terms = n.terms =
      std::max({axis[0].resisting.terms, axis[1].resisting.terms, excitation.vertical_terms});
  for (int k = 0; k < s.terms; ++k) {
    const double a1 = coefficient(axis[0].resisting, k) / mass[0],
                 a2 = coefficient(axis[1].resisting, k) / mass[1];
    const double w = excitation.coefficient(k);
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

/// Lifted or not, a block stays where it is on a flat roof that does not move sideways.
bool drives(const TwoAxisLoading& loading, const AxisSeries (&axis)[2]) {
  const auto moves = [](const AxisSeries& motion) {
    const Series& e = motion.resisting;
    return std::any_of(e.c.begin(), e.c.begin() + e.terms, [](double c) { return c != 0.0; });
  };
  return loading.tan_slope() != 0.0 || moves(axis[0]) || moves(axis[1]);
}

}  // namespace

FullModelBody::RestingRoof FullModelBody::resting_motion(const ExcitationPiece& piece) const {
  const Axes mass{axes_[0].stuck_mass(), axes_[1].stuck_mass()};
  return {{axes_[0].motion(piece.length_s, piece.ground[0], mass[0]),
           axes_[1].motion(piece.length_s, piece.ground[1], mass[1])},
          mass,
          piece};
}

Load FullModelBody::load_at(const RestingRoof& resting, double fraction) const {
  return contact_.loading().at(resting.a(0, fraction), resting.a(1, fraction),
                               resting.excitation.w(fraction));
}

double FullModelBody::rest(const ExcitationPiece& piece) {
  const RestingRoof resting = resting_motion(piece);
  const AxisSeries(&motion)[2] = resting.axis;
  const FrictionEllipse& friction = contact_.friction_at_rest();
  const Load begin = load_at(resting, 0.0);
  uplift_ = uplift_ || begin.normal < 0.0;
  const double release =
      !drives(contact_.loading(), motion) ? never
      : friction.may_rest(begin)
          ? first_rise(excess(friction, contact_.loading(), motion, resting.mass, piece))
          : 0.0;
  double yield[2], fraction = std::min(release, 1.0);
  for (std::size_t n = 0; n < 2; ++n) {
    yield[n] = axes_[n].next_yield(motion[n]);
    fraction = std::min(fraction, yield[n]);
  }
  for (std::size_t n = 0; n < 2; ++n) {
    raise_peaks(n, motion[n], fraction);
    axes_[n].follow(motion[n], fraction);
  }
  if (fraction == 1.0) return 1.0;  // what happens there begins the next piece
  bool yielded = false;
  for (std::size_t n = 0; n < 2; ++n) {
    if (yield[n] != fraction) continue;
    axes_[n].yield();
    yielded = true;
  }
  if (yielded) return fraction;
  // Released by as much as Coulomb's law holds it back, a block has no acceleration yet.
  const bool jumps = fraction == 0.0 || contact_.law().static_over_sliding != 1.0;
  Vector a;
  if (jumps) {
    Axes e;
    for (std::size_t n = 0; n < 2; ++n) {
      const double ground = piece.ground[n].at(fraction);
      e[n] = axes_[n].rigid() ? ground : axes_[n].resisting(ground);
    }
    a = contact_.release_acceleration(e, piece.w(fraction), accelerance_);
  }
  start(a, piece);
  return fraction;
}

double FullModelBody::friction_margin(double a1, double a2, double w) const {
  const Load load = contact_.loading().at(a1, a2, w);
  return load.normal - length(scaled(load.drive, per_friction_));
}

/// The same as rest_over(), by maps of whole pieces.
template <class Nodes>
std::size_t FullModelBody::rest_over_on_modes(const Nodes& nodes, std::size_t from,
                                              std::size_t to) {
  if (axes_[0].yields() || axes_[1].yields()) return from;
  std::size_t i = from;
  for (; i < to; ++i) {
    RestMap::Row row[2];
    double begin[2], end[2], deviation = 0.0;
    for (std::size_t n = 0; n < 2; ++n) {
      const RestMap& map = rest_maps_[n];
      const double per_mass = 1.0 / axes_[n].stuck_mass();
      row[n] = axes_[n].rest_row({nodes.ground(n, i), nodes.ground(n, i + 1)});
      begin[n] = per_mass * map.value(map.e_begin, row[n]);
      end[n] = per_mass * map.value(map.e_end, row[n]);
      deviation += per_mass * map.bound(map.e_deviation, row[n]);
    }
    const double needed = deviation * margin_per_a_ + nodes.w_deviation(i) * margin_per_w_;
    const double margin = std::min(friction_margin(begin[0], begin[1], nodes.w(i)),
                                   friction_margin(end[0], end[1], nodes.w(i + 1)));
    if (!(margin > needed * (1.0 + 1e-9))) break;
    for (std::size_t n = 0; n < 2; ++n) {
      const RestMap& map = rest_maps_[n];
      if (map.bound(map.shear, row[n]) > peaks_.shear[n] ||
          map.bound(map.roof_x, row[n]) > peaks_.x[n])
        raise_peaks(n,
                    axes_[n].motion(nodes.dt_s(), {nodes.ground(n, i), nodes.ground(n, i + 1)},
                                    axes_[n].stuck_mass()),
                    1.0);
      axes_[n].rest_on(map, row[n]);
    }
  }
  return i;
}

/// Whole pieces without events, by bounds on the departure of the motion from its chord: while
/// m = N - |M^-1 F| > 0 the block sticks, and m is concave, so that on the chord it is not less
/// than at the ends.
template <class Nodes>
std::size_t FullModelBody::rest_over(const Nodes& nodes, std::size_t from, std::size_t to) {
  if (axes_[0].yielding() || axes_[1].yielding() || contact_.friction_at_rest().smallest() == 0.0)
    return from;
  if (!rest_maps_.empty()) return rest_over_on_modes(nodes, from, to);
  using BothAxes = std::array<RestingAxis::Node, 2>;
  const double mass = 1.0 + mass_ratio_, per_mass = 1.0 / mass;
  RestingAxis first(axes_[0], mass), second(axes_[1], mass);
  const auto margin = [&](const BothAxes& at, double w) {
    return friction_margin(at[0].e * per_mass, at[1].e * per_mass, w);
  };
  const auto hold = [&](const BothAxes& at) {
    first.hold(at[0]);
    second.hold(at[1]);
  };

  BothAxes now{first.now(nodes.ground(0, from)), second.now(nodes.ground(1, from))};
  double before = margin(now, nodes.w(from));
  std::size_t i = from;
  for (; i < to; ++i) {
    const BothAxes next{first.after(now[0], nodes.ground(0, i + 1)),
                        second.after(now[1], nodes.ground(1, i + 1))};
    const std::array deviation{first.deviation(now[0], next[0]), second.deviation(now[1], next[1])};
    const double after = margin(next, nodes.w(i + 1));
    const double needed = (deviation[0].e + deviation[1].e) * per_mass * margin_per_a_ +
                          nodes.w_deviation(i) * margin_per_w_;
    const bool sticks = std::min(before, after) > needed * (1.0 + 1e-9);
    if (!sticks || first.may_yield(now[0], next[0], deviation[0]) ||
        second.may_yield(now[1], next[1], deviation[1]))
      break;
    for (std::size_t n = 0; n < 2; ++n) {
      const RestingAxis& axis = n == 0 ? first : second;
      if (!axis.may_exceed(peaks_.shear[n], peaks_.x[n], now[n], next[n], deviation[n])) continue;
      hold(now);
      raise_peaks(n, axes_[n].motion(nodes.dt_s(), {now[n].ground, next[n].ground}, mass), 1.0);
    }
    now = next;
    before = after;
  }
  if (i > from) hold(now);
  return i;
}

std::size_t FullModelBody::rest_through(const Excitation& excitation, std::size_t from,
                                        std::size_t to) {
  const std::size_t i = rest_over(excitation, from, to);
  time_s_ = static_cast<double>(i) * excitation.dt_s();
  return i;
}

bool FullModelBody::rest_quickly(const ExcitationPiece& piece) {
  struct Ends {
    const ExcitationPiece& piece;
    double dt_s() const { return piece.length_s; }
    double ground(std::size_t n, std::size_t i) const {
      return i == 0 ? piece.ground[n].begin : piece.ground[n].end;
    }
    double w(std::size_t i) const { return piece.w(i == 0 ? 0.0 : 1.0); }
    double w_deviation(std::size_t) const { return piece.w_deviation(); }
  };
  return rest_over(Ends{piece}, 0, 1) == 1;
}

}  // namespace glissade::block_detail
