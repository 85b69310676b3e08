// SPDX-License-Identifier: GPL-3.0-or-later
// Block and building while the block slides.
#include "block/full_model/on_building_body.hpp"

namespace glissade::block_detail {
namespace {

/// The effect of the block on an axis over a step that ends at fraction y of the piece: cubics
/// through values and slopes at both ends, added to the response of the building alone.
AxisSeries with_added(AxisSeries m, const BuildingAxis& axis, const Added& end, double begin_rate,
                      double end_rate, double length_s, double y) {
  const double way = axis.omega_radps() * length_s * end.y, r0 = begin_rate * length_s,
               r1 = end_rate * length_s;
  const double x[4] = {0.0, 0.0, 3.0 * end.x - way, way - 2.0 * end.x};
  const double v[4] = {0.0, r0, 3.0 * end.y - 2.0 * r0 - r1, r0 + r1 - 2.0 * end.y};
  while (m.x.terms < 4) {
    for (Series* s : {&m.x, &m.y, &m.elastic}) s->c[s->terms++] = 0.0;
  }
  double scale = 1.0, bound_x = 0.0, bound_y = 0.0;
  for (std::size_t k = 1; k < 4; ++k) {
    bound_x += std::abs(x[k]);
    bound_y += std::abs(v[k]);
    scale /= y;
    m.x.c[k] += scale * x[k];
    m.y.c[k] += scale * v[k];
    m.elastic.c[k] -= scale * (axis.twice_zeta() * v[k] + axis.stiffness() * x[k]);
  }
  m.largest_elastic += axis.twice_zeta() * bound_y + bound_x;
  m.largest_x += bound_x;
  return m;
}

}  // namespace

OnBuildingBody::Bare OnBuildingBody::alone(const Shaking& piece) const {
  return {{axes_[0].motion(piece.length_s, piece.ground[0], 1.0),
           axes_[1].motion(piece.length_s, piece.ground[1], 1.0)},
          piece,
          piece.largest_w()};
}

/// For a step that ends at a fraction of the piece.
StageLoads OnBuildingBody::Bare::at_stages(double share) const {
  constexpr std::size_t stages = Sdirk4::stages;
  StageLoads loads;
  double y[stages];
  for (std::size_t i = 0; i < stages; ++i) y[i] = share * Sdirk4::at[i];
  const auto values = [&](const double* c, int terms, double(&sum)[stages]) {
    for (double& s : sum) s = 0.0;
    for (int k = terms; k-- > 0;)
      for (std::size_t i = 0; i < stages; ++i) sum[i] = sum[i] * y[i] + c[k];
  };
  for (std::size_t n = 0; n < 2; ++n)
    values(axis[n].elastic.c.data(), axis[n].elastic.terms, loads.e[n]);
  values(shaking.vertical.data(), shaking.vertical_terms, loads.w);
  return loads;
}

double OnBuildingBody::slide(const Shaking& piece) {
  const Bare bare = alone(piece);
  const TwoAxisLoading& loading = contact_.loading();
  const double tangent = loading.tan_slope(), swing = heaviest(bare) - loading.gravity();
  double longest = 1.0;
  if (!(loading.gravity() > swing)) {
    const Axes e = bare.e(0.0);
    uplift_ = uplift_ || loading.at(e[0], e[1], piece.w(0.0)).normal < 0.0;
    longest = first_lift(bare);
  }
  const double roof = length({bare.axis[0].largest_elastic, bare.axis[1].largest_elastic});
  const double most = heaviest(bare) * (tangent + strongest_) + roof / loading.cos_slope();
  if (length(now_.v) > piece.length_s * most) return step(bare, longest);  // it cannot stop
  std::array<Ramp, 2> push;
  const Stop stop = find_stop(bare, longest * piece.length_s, push);
  if (stop.time_s != never && stop_there(stop, bare, push)) return stop.time_s / piece.length_s;
  return step(bare, longest);
}

/// Upper bound of the normal force on an uncoupled roof.
double OnBuildingBody::heaviest(const Bare& bare) const {
  const TwoAxisLoading& loading = contact_.loading();
  return loading.gravity() + bare.largest_w +
         loading.tan_slope() * (bare.axis[0].largest_elastic + bare.axis[1].largest_elastic);
}

/// Friction ends when the normal force becomes zero. The time is that of the building alone: the
/// effect of the block changes it by little, which the error estimate of the step includes.
double OnBuildingBody::first_lift(const Bare& bare) const {
  const TwoAxisLoading& loading = contact_.loading();
  const Shaking& piece = bare.shaking;
  const double tangent = loading.tan_slope();
  const double c = tangent * loading.cos_azimuth(), s = tangent * loading.sin_azimuth();
  const Series &a1 = bare.axis[0].elastic, &a2 = bare.axis[1].elastic;
  Series normal;
  normal.terms = std::max({a1.terms, a2.terms, piece.vertical_terms});
  for (int k = 0; k < normal.terms; ++k)
    normal.c[k] = c * coefficient(a1, k) + s * coefficient(a2, k) + piece.coefficient(k);
  const double g = loading.gravity();
  normal.c[0] += g;
  if (std::abs(normal.c[0]) <= 1e-9 * g) normal.c[0] = 0.0;  // just lifted or landed
  int first = 0;
  while (first + 1 < normal.terms && normal.c[first] == 0.0) ++first;
  return std::clamp(first_fall(normal, normal.c[first] < 0.0 ? Sign::minus : Sign::plus), 1e-6,
                    1.0);
}

/// An axis over a step, with the effect of the block.
AxisSeries OnBuildingBody::with_block(const Bare& bare, const BuildingStep& step, std::size_t n,
                                      double length_s) const {
  if (mobility_.axis[n] == 0.0) return bare.axis[n];
  const Axes e = bare.e(0.0);
  const Axes a = contact_.held(now_.a, e, bare.shaking.w(0.0), mobility_).a;
  return with_added(bare.axis[n], axes_[n], step.added[n], axes_[n].omega_radps() * (a[n] - e[n]),
                    step.added_rate[n], length_s, length_s / bare.shaking.length_s);
}

void OnBuildingBody::raise_peaks(std::size_t n, const Bare& bare, const BuildingStep& step,
                                 double length_s) {
  const double share = length_s / bare.shaking.length_s;
  if (axes_[n].rigid() && mass_ratio_ > 0.0) {  // it carries the block too
    const ContactState& c = step.end;
    const Axes force = contact_.to_building(
        c.normal * Vector{contact_.loading().tan_slope() - c.friction.s, -c.friction.y});
    const double carried = bare.axis[n].elastic.at(share) + mass_ratio_ * force[n];
    peaks_.elastic[n] = std::max(peaks_.elastic[n], std::abs(carried));
    return;
  }
  if (mobility_.axis[n] == 0.0) return raise_peaks(n, bare.axis[n], share);
  // What the block adds is no more than its push over the step would leave undamped.
  const double phase = axes_[n].omega_radps() * length_s;
  const double added = 2.0 * mass_ratio_ * heaviest(bare) *
                       (contact_.loading().tan_slope() + strongest_) * phase *
                       (axes_[n].twice_zeta() + phase);
  if (bare.axis[n].largest_elastic + added > peaks_.elastic[n] ||
      bare.axis[n].largest_x + added > peaks_.x[n]) {
    raise_peaks(n, with_block(bare, step, n, length_s), share);
  }
}

/// A step within the tolerance, and not across a yielding event of the building.
double OnBuildingBody::step(const Bare& bare, double longest) {
  constexpr double shortest = 1e-9;  // of what is left: far below what any tolerance requires
  const Shaking& piece = bare.shaking;
  const double left_s = longest * piece.length_s;
  const Axes e = bare.e(0.0);
  const Load load = contact_.loading().at(e[0], e[1], piece.w(0.0));
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() *
                          (std::abs(load.drive.s) + std::abs(load.drive.y) + std::abs(load.normal));
  double length_s = std::min({step_s_, left_s, contact_.longest_step_s(load, mobility_)});
  if (length_s < left_s && length_s > 0.5 * left_s) length_s = 0.5 * left_s;
  Axes yields{never, never};
  bool to_yield = false;
  for (;;) {
    const BuildingStep trial = try_step(bare, length_s);
    // The first step of all is judged by the speed it would reach.
    const double speed = std::max(peak_speed_, length(trial.end.v));
    const double allowed = tolerance_ * speed + length_s * rounding;
    const double share = trial.error > 0.0 ? allowed / trial.error : 1e4;
    const double next_s = length_s * std::clamp(0.9 * std::sqrt(std::sqrt(share)), 0.2, 5.0);
    if (share < 1.0 && length_s > shortest * left_s) {
      length_s = step_s_ = next_s;
      to_yield = false;
      continue;
    }
    if (!to_yield) {
      yields = next_yields(bare, trial, length_s);
      const double first = std::min(yields[0], yields[1]), y = length_s / piece.length_s;
      if (first <= 1e-9 * y) return yield(yields), 0.0;
      if (first < y) {
        length_s = first * piece.length_s;
        to_yield = true;
        continue;
      }
    }
    step_s_ = next_s;
    peak_speed_ = speed;
    take(bare, trial, length_s);
    if (to_yield) yield(yields);
    return length_s / piece.length_s;
  }
}

BuildingStep OnBuildingBody::try_step(const Bare& bare, double length_s) const {
  const auto response = [&](std::size_t n) {
    const BuildingAxis& axis = axes_[n];
    return AxisResponse{axis.omega_radps(), axis.twice_zeta(), axis.stiffness(), mobility_.axis[n]};
  };
  const StageLoads loads = bare.at_stages(length_s / bare.shaking.length_s);
  const auto sdirk4 = mobility_.none() ? building_sdirk4<false> : building_sdirk4<true>;
  return sdirk4(now_.v, friction_now_, length_s, 1e-3 * tolerance_ * peak_speed_, loads, contact_,
                {response(0), response(1)}, mobility_);
}

/// When each axis yields, or never.
Axes OnBuildingBody::next_yields(const Bare& bare, const BuildingStep& step,
                                 double length_s) const {
  Axes when{never, never};
  for (std::size_t n = 0; n < 2; ++n)
    if (axes_[n].yields()) when[n] = axes_[n].next_yield(with_block(bare, step, n, length_s));
  return when;
}

/// The first of them.
void OnBuildingBody::yield(const Axes& when) {
  const double first = std::min(when[0], when[1]);
  for (std::size_t n = 0; n < 2; ++n)
    if (when[n] == first) axes_[n].yield();
}

void OnBuildingBody::take(const Bare& bare, const BuildingStep& step, double length_s) {
  for (std::size_t n = 0; n < 2; ++n) {
    raise_peaks(n, bare, step, length_s);
    axes_[n].follow(bare.axis[n], length_s / bare.shaking.length_s, step.added[n].x,
                    step.added[n].y);
  }
  uplift_ = uplift_ || step.end.normal < 0.0;
  const Sliding end{step.end.v, step.end.a};
  track_.slide(now_, end, length_s, time_s_);
  now_ = end;
  friction_now_ = step.end.friction;
  if (end.v.s == 0.0 && end.v.y == 0.0) sliding_ = false;
}

}  // namespace glissade::block_detail
