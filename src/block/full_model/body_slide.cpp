// SPDX-License-Identifier: GPL-3.0-or-later
// Block and building while the block slides.
#include "block/full_model/body.hpp"

namespace glissade::block_detail {
namespace {

/// The effect of the block on an axis over a step that ends at fraction tau of the piece: cubics
/// through values and slopes at both ends, added to the response of the building alone.
/// @param interaction at both ends: reduction of the roof's acceleration by the block
AxisSeries with_added(AxisSeries m, const BuildingAxis& axis, const Added* end,
                      const double* end_rate, const Ramp& interaction, double length_s,
                      double tau) {
  for (std::size_t n = 0; n < axis.modes().size(); ++n) {
    const AxisMode& mode = axis.modes()[n];
    const double x_slope = mode.omega_radps * length_s * end[n].y,
                 r0 = -mode.omega_radps * (mode.kappa * interaction.begin) * length_s,
                 r1 = end_rate[n] * length_s;
    const double x[4] = {0.0, 0.0, 3.0 * end[n].x - x_slope, x_slope - 2.0 * end[n].x};
    const double v[4] = {0.0, r0, 3.0 * end[n].y - 2.0 * r0 - r1, r0 + r1 - 2.0 * end[n].y};
    double scale = 1.0, bound_x = 0.0, bound_y = 0.0;
    for (std::size_t k = 1; k < 4; ++k) {
      bound_x += std::abs(x[k]);
      bound_y += std::abs(v[k]);
      scale /= tau;
      const double e = scale * (mode.twice_zeta * v[k] + axis.stiffness() * x[k]);
      m.x[n].c[k] += scale * x[k];
      m.y[n].c[k] += scale * v[k];
      m.resisting.c[k] -= mode.participation * e;
      if (axis.one_mass()) continue;
      m.shear.c[k] -= mode.mass_share * e;
      m.roof_x.c[k] += mode.roof_per_x * (scale * x[k]);
    }
    const double bound = mode.twice_zeta * bound_y + bound_x;
    m.resisting_bound += std::abs(mode.participation) * bound;
    m.shear_bound += mode.mass_share * bound;
    m.x_bound += std::abs(mode.roof_per_x) * bound_x;
  }
  if (axis.one_mass()) return m;
  const double in_shear = axis.shear_per_interaction();
  m.shear.c[0] += in_shear * interaction.begin;
  m.shear.c[1] += in_shear * (interaction.end - interaction.begin) / tau;
  m.shear_bound +=
      std::abs(in_shear) * std::max(std::abs(interaction.begin), std::abs(interaction.end));
  return m;
}

}  // namespace

FullModelBody::UncoupledRoof FullModelBody::uncoupled_motion(const ExcitationPiece& piece) const {
  return {{axes_[0].motion(piece.length_s, piece.ground[0], 1.0),
           axes_[1].motion(piece.length_s, piece.ground[1], 1.0)},
          piece,
          piece.largest_w()};
}

/// For a step that ends at a fraction of the piece.
StageLoads FullModelBody::UncoupledRoof::at_stages(double fraction) const {
  constexpr std::size_t stages = Sdirk4::stages;
  StageLoads loads;
  double tau[stages];
  for (std::size_t i = 0; i < stages; ++i) tau[i] = fraction * Sdirk4::at[i];
  const auto values = [&](const double* c, int terms, double(&sum)[stages]) {
    for (double& s : sum) s = 0.0;
    for (int k = terms; k-- > 0;)
      for (std::size_t i = 0; i < stages; ++i) sum[i] = sum[i] * tau[i] + c[k];
  };
  for (std::size_t n = 0; n < 2; ++n)
    values(axis[n].resisting.c.data(), axis[n].resisting.terms, loads.e[n]);
  values(excitation.vertical.data(), excitation.vertical_terms, loads.w);
  return loads;
}

double FullModelBody::slide(const ExcitationPiece& piece) {
  const UncoupledRoof uncoupled = uncoupled_motion(piece);
  const TwoAxisLoading& loading = contact_.loading();
  const double tangent = loading.tan_slope(),
               load_change = normal_force_bound(uncoupled) - loading.gravity();
  double longest = 1.0;
  if (!(loading.gravity() > load_change)) {
    const Axes e = uncoupled.e(0.0);
    uplift_ = uplift_ || loading.at(e[0], e[1], piece.w(0.0)).normal < 0.0;
    longest = first_lift(uncoupled);
  }
  const double roof =
      length({uncoupled.axis[0].resisting_bound, uncoupled.axis[1].resisting_bound});
  const double most =
      normal_force_bound(uncoupled) * (tangent + friction_bound_) + roof / loading.cos_slope();
  if (length(now_.v) > piece.length_s * most) return step(uncoupled, longest);  // it cannot stop
  std::array<Ramp, 2> interaction;
  const Stop stop = find_stop(uncoupled, longest * piece.length_s, interaction);
  if (stop.time_s != never && stop_there(stop, uncoupled, interaction))
    return stop.time_s / piece.length_s;
  return step(uncoupled, longest);
}

/// Upper bound of the normal force on an uncoupled roof.
double FullModelBody::normal_force_bound(const UncoupledRoof& uncoupled) const {
  const TwoAxisLoading& loading = contact_.loading();
  return loading.gravity() + uncoupled.largest_w +
         loading.tan_slope() *
             (uncoupled.axis[0].resisting_bound + uncoupled.axis[1].resisting_bound);
}

/// Friction ends when the normal force becomes zero. The time is that of the building alone: the
/// effect of the block changes it by little, which the error estimate of the step includes.
double FullModelBody::first_lift(const UncoupledRoof& uncoupled) const {
  const TwoAxisLoading& loading = contact_.loading();
  const ExcitationPiece& piece = uncoupled.excitation;
  const double tangent = loading.tan_slope();
  const double c = tangent * loading.cos_azimuth(), s = tangent * loading.sin_azimuth();
  const Series &a1 = uncoupled.axis[0].resisting, &a2 = uncoupled.axis[1].resisting;
  Series normal;
  normal.terms = std::max({a1.terms, a2.terms, piece.vertical_terms});
  for (int k = 0; k < normal.terms; ++k)
    normal.c[k] = c * coefficient(a1, k) + s * coefficient(a2, k) + piece.coefficient(k);
  const double g = loading.gravity();
  normal.c[0] += g;
  constexpr double just_lifted = 1e-9;    // of gravity: the normal force is zero
  constexpr double shortest_lift = 1e-6;  // of the piece, so that time passes
  if (std::abs(normal.c[0]) <= just_lifted * g) normal.c[0] = 0.0;
  int first = 0;
  while (first + 1 < normal.terms && normal.c[first] == 0.0) ++first;
  return std::clamp(first_fall(normal, normal.c[first] < 0.0 ? Sign::minus : Sign::plus),
                    shortest_lift, 1.0);
}

/// An axis over a step, with the effect of the block.
AxisSeries FullModelBody::with_block(const UncoupledRoof& uncoupled, const BuildingStep& step,
                                     std::size_t n, double length_s) const {
  if (accelerance_.axis[n] == 0.0) return uncoupled.axis[n];
  const Axes e = uncoupled.e(0.0);
  const Axes a = contact_.with_acceleration(now_.a, e, uncoupled.excitation.w(0.0), accelerance_).a;
  const Ramp reduction{e[n] - a[n], accelerance_.axis[n] * force_on_roof(step.end)[n]};
  return with_added(uncoupled.axis[n], axes_[n], step.added[n].data(), step.added_rate[n].data(),
                    reduction, length_s, length_s / uncoupled.excitation.length_s);
}

/// Over the array's mass, against the roof's acceleration.
Axes FullModelBody::force_on_roof(const ContactState& contact) const {
  const Vector friction = contact.friction;
  return contact_.to_building(contact.normal *
                              Vector{contact_.loading().tan_slope() - friction.s, -friction.y});
}

void FullModelBody::raise_peaks(std::size_t n, const UncoupledRoof& uncoupled,
                                const BuildingStep& step, double length_s) {
  const double fraction = length_s / uncoupled.excitation.length_s;
  if (axes_[n].rigid() && mass_ratio_ > 0.0) {  // it carries the block too
    const double carried =
        uncoupled.axis[n].resisting.at(fraction) + mass_ratio_ * force_on_roof(step.end)[n];
    peaks_.shear[n] = std::max(peaks_.shear[n], std::abs(carried));
    return;
  }
  if (accelerance_.axis[n] == 0.0) return raise_peaks(n, uncoupled.axis[n], fraction);
  // What the block adds is no more than its interaction over the step would leave undamped.
  const double phase = axes_[n].omega_radps() * length_s;
  const double added = 2.0 * mass_ratio_ * normal_force_bound(uncoupled) *
                       (contact_.loading().tan_slope() + friction_bound_) * phase *
                       (axes_[n].twice_zeta() + phase);
  if (!axes_[n].one_mass() || uncoupled.axis[n].resisting_bound + added > peaks_.shear[n] ||
      uncoupled.axis[n].x_bound + added > peaks_.x[n]) {
    raise_peaks(n, with_block(uncoupled, step, n, length_s), fraction);
  }
}

/// A step within the tolerance, and not across a yielding event of the building.
double FullModelBody::step(const UncoupledRoof& uncoupled, double longest) {
  const ExcitationPiece& piece = uncoupled.excitation;
  const double left_s = longest * piece.length_s;
  const Axes e = uncoupled.e(0.0);
  const Load load = contact_.loading().at(e[0], e[1], piece.w(0.0));
  const double rounding = rounding_of(load);
  double length_s = std::min({step_s_, left_s, contact_.longest_step_s(load, accelerance_)});
  if (length_s < left_s && length_s > 0.5 * left_s) length_s = 0.5 * left_s;
  // A step from rest at whose end the load would let the block rest may miss its sliding.
  if (now_.v.s == 0.0 && now_.v.y == 0.0) {
    const RestingRoof resting = resting_motion(piece);
    while (length_s > shortest_start * left_s &&
           contact_.friction().may_rest(load_at(resting, length_s / piece.length_s)))
      length_s *= 0.5;
  }
  Axes yields{never, never};
  bool to_yield = false;
  for (;;) {
    const BuildingStep trial = try_step(uncoupled, length_s);
    // The first step of all is judged by the speed it would reach.
    const double speed = std::max(peak_speed_, length(trial.end.v));
    const double allowed = tolerance_ * speed + length_s * rounding;
    const double ratio = error_ratio(allowed, trial.error);
    const double next_s = length_s * step_factor(ratio);
    if (ratio < 1.0 && length_s > shortest_step * left_s) {
      length_s = step_s_ = next_s;
      to_yield = false;
      continue;
    }
    if (!to_yield) {
      yields = next_yields(uncoupled, trial, length_s);
      const double first = std::min(yields[0], yields[1]), tau = length_s / piece.length_s;
      if (first <= 1e-9 * tau) return yield(yields), 0.0;
      if (first < tau) {
        length_s = first * piece.length_s;
        to_yield = true;
        continue;
      }
    }
    step_s_ = next_s;
    peak_speed_ = speed;
    take(uncoupled, trial, length_s);
    if (to_yield) yield(yields);
    return length_s / piece.length_s;
  }
}

BuildingStep FullModelBody::try_step(const UncoupledRoof& uncoupled, double length_s) const {
  const StageLoads loads = uncoupled.at_stages(length_s / uncoupled.excitation.length_s);
  const auto sdirk4 = accelerance_.none()                          ? building_sdirk4<0>
                      : axes_[0].one_mass() && axes_[1].one_mass() ? building_sdirk4<1>
                                                                   : building_sdirk4<most_modes>;
  constexpr double of_tolerance = 1e-3;  // for the iterations of a stage: they add no error
  return sdirk4(now_.v, friction_now_, length_s, of_tolerance * tolerance_ * peak_speed_, loads,
                contact_, axes_, accelerance_);
}

/// When each axis yields, or never.
Axes FullModelBody::next_yields(const UncoupledRoof& uncoupled, const BuildingStep& step,
                                double length_s) const {
  Axes when{never, never};
  for (std::size_t n = 0; n < 2; ++n)
    if (axes_[n].yields()) when[n] = axes_[n].next_yield(with_block(uncoupled, step, n, length_s));
  return when;
}

/// The first of them.
void FullModelBody::yield(const Axes& when) {
  const double first = std::min(when[0], when[1]);
  for (std::size_t n = 0; n < 2; ++n)
    if (when[n] == first) axes_[n].yield();
}

void FullModelBody::take(const UncoupledRoof& uncoupled, const BuildingStep& step,
                         double length_s) {
  for (std::size_t n = 0; n < 2; ++n) {
    raise_peaks(n, uncoupled, step, length_s);
    axes_[n].follow(uncoupled.axis[n], length_s / uncoupled.excitation.length_s,
                    step.added[n].data());
  }
  uplift_ = uplift_ || step.end.normal < 0.0;
  const Sliding end{step.end.v, step.end.a};
  track_.slide(now_, end, length_s, time_s_);
  now_ = end;
  friction_now_ = step.end.friction;
  if (end.v.s == 0.0 && end.v.y == 0.0) sliding_ = false;
}

}  // namespace glissade::block_detail
