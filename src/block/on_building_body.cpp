// SPDX-License-Identifier: GPL-3.0-or-later
#include "on_building_body.hpp"

#include <stdexcept>
#include <utility>

namespace glissade::block_detail {
namespace {

/// The block's part in an axis over a step that ends at share y of the piece: cubics through values
/// and slopes at both ends, added to what the building does by itself.
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

OnBuildingBody::OnBuildingBody(const BuildingContact& contact,
                               const std::array<BuildingAxis, 2>& axes, double mass_ratio,
                               int pieces, double tolerance, TwoAxisTrack track)
    : contact_(contact),
      axes_(axes),
      mass_ratio_(mass_ratio),
      mobility_(contact.mobility(
          {axes[0].rigid() ? 0.0 : mass_ratio, axes[1].rigid() ? 0.0 : mass_ratio})),
      pieces_(pieces),
      tolerance_(tolerance),
      strongest_(contact.strongest(mobility_)),
      track_(std::move(track)) {
  const FrictionEllipse& friction = contact_.friction_at_rest();
  const TwoAxisLoading& loading = contact_.loading();
  margin_per_a_ = loading.tan_slope() +
                  std::max(1.0 / friction.along(), 1.0 / (friction.across() * loading.cos_slope()));
  margin_per_w_ = 1.0 + loading.tan_slope() / friction.along();
}

void OnBuildingBody::interval(const Shaking& shaking, double end_s) {
  if (pieces_ == 1) return advance(shaking, end_s);
  const double begin_s = time_s_;
  for (int i = 0; i < pieces_; ++i) {
    Shaking piece = shaking;
    const double to = static_cast<double>(i + 1) / pieces_;
    piece.part(static_cast<double>(i) / pieces_, to);
    advance(piece, i + 1 == pieces_ ? end_s : begin_s + to * (end_s - begin_s));
  }
}

void OnBuildingBody::advance(Shaking piece, double end_s) {
  if (!sliding_ && rest_quickly(piece)) {
    time_s_ = end_s;
    return;
  }
  const double whole_s = piece.length_s;
  // Steps shrink geometrically toward a stop, so some dozens suffice; the bound only guards against
  // rounding.
  for (int steps = 0; steps < 1000000; ++steps) {
    const double share = sliding_ ? slide(piece) : rest(piece);
    if (!((1.0 - share) * piece.length_s > 1e-14 * whole_s)) {
      time_s_ = end_s;
      return;
    }
    time_s_ = std::min(time_s_ + share * piece.length_s, end_s);
    piece.cut(share);
  }
  throw std::logic_error("slide_on_building: too many steps inside one sample interval");
}

/// At a step that ends at a share of the piece.
StageLoads OnBuildingBody::Bare::at_stages(double share) const {
  constexpr std::size_t stages = StageLoads::stages;
  StageLoads loads;
  double y[stages];
  for (std::size_t i = 0; i < stages; ++i) y[i] = share * StageLoads::at[i];
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

OnBuildingBody::Bare OnBuildingBody::alone(const Shaking& piece) const {
  return {{axes_[0].motion(piece.length_s, piece.ground[0], 1.0),
           axes_[1].motion(piece.length_s, piece.ground[1], 1.0)},
          piece,
          piece.largest_w()};
}

void OnBuildingBody::raise_peaks(std::size_t axis, const AxisSeries& motion, double share) {
  const auto raise = [share](double& peak, const Series& of) {
    if (of.bound() > peak) peak = std::max(peak, largest(of, share));
  };
  if (motion.largest_elastic > peaks_.elastic[axis]) raise(peaks_.elastic[axis], motion.elastic);
  if (motion.largest_x > peaks_.x[axis]) raise(peaks_.x[axis], motion.x);
}

void OnBuildingBody::start(Vector acceleration, const Shaking& piece) {
  // What rounding alone sets in motion must not set the scale of the errors.
  const double gravity = contact_.loading().gravity() + piece.w(0.0);
  peak_speed_ = std::max(peak_speed_, 1e-9 * piece.length_s * std::abs(gravity));
  sliding_ = true;
  now_ = {{}, acceleration};
  friction_now_ = {};
  step_s_ = never;
  ++phases_;
}

double OnBuildingBody::slide(const Shaking& piece) {
  const Bare bare = alone(piece);
  const TwoAxisLoading& loading = contact_.loading();
  const double tangent = loading.tan_slope(), g = loading.gravity(),
               most = bare.axis[0].largest_elastic + bare.axis[1].largest_elastic;
  double longest = 1.0;
  if (!(g > bare.largest_w + tangent * most)) {
    const Axes e = bare.e(0.0);
    uplift_ = uplift_ || loading.at(e[0], e[1], piece.w(0.0)).normal < 0.0;
    longest = first_lift(bare);
  }
  const double heaviest = g + bare.largest_w + tangent * most;
  const double strongest = heaviest * (tangent + strongest_) + 2.0 * most / loading.cos_slope();
  if (length(now_.v) > piece.length_s * strongest) return step(bare, longest);
  std::array<Ramp, 2> push;
  const Stop stop = find_stop(bare, longest * piece.length_s, push);
  if (stop.time_s != never && stop_there(stop, bare, push)) return stop.time_s / piece.length_s;
  return step(bare, longest);
}

/// Friction ends where the normal force does. Where that is, is told by the building alone: what
/// the block adds on the way moves it by little, which the step's error sees.
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

/// An axis over a step, with the block's part.
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
    const Contact2& c = step.end;
    const Axes force = contact_.to_building(
        c.normal * Vector{contact_.loading().tan_slope() - c.friction.s, -c.friction.y});
    const double carried = bare.axis[n].elastic.at(share) + mass_ratio_ * force[n];
    peaks_.elastic[n] = std::max(peaks_.elastic[n], std::abs(carried));
    return;
  }
  if (mobility_.axis[n] == 0.0) return raise_peaks(n, bare.axis[n], share);
  // What the block adds is no more than its push over the step would leave undamped.
  const double phase = axes_[n].omega_radps() * length_s;
  const double heaviest = contact_.loading().gravity() + bare.largest_w +
                          contact_.loading().tan_slope() *
                              (bare.axis[0].largest_elastic + bare.axis[1].largest_elastic);
  const double added = 2.0 * mass_ratio_ * heaviest *
                       (contact_.loading().tan_slope() + strongest_) * phase *
                       (axes_[n].twice_zeta() + phase);
  if (bare.axis[n].largest_elastic + added > peaks_.elastic[n] ||
      bare.axis[n].largest_x + added > peaks_.x[n]) {
    raise_peaks(n, with_block(bare, step, n, length_s), share);
  }
}

double OnBuildingBody::step(const Bare& bare, double longest) {
  constexpr double shortest = 1e-9;  // of what is left: far below what any tolerance asks for
  const Shaking& piece = bare.shaking;
  const double left_s = longest * piece.length_s;
  const Axes e0 = bare.e(0.0);
  const Load load = contact_.loading().at(e0[0], e0[1], piece.w(0.0));
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() *
                          (std::abs(load.drive.s) + std::abs(load.drive.y) + std::abs(load.normal));
  const std::array<AxisResponse, 2> response{
      AxisResponse{axes_[0].omega_radps(), axes_[0].twice_zeta(), axes_[0].stiffness(),
                   mobility_.axis[0]},
      AxisResponse{axes_[1].omega_radps(), axes_[1].twice_zeta(), axes_[1].stiffness(),
                   mobility_.axis[1]}};
  double length_s = std::min({step_s_, left_s, contact_.longest_step_s(load, mobility_)});
  if (length_s < left_s && length_s > 0.5 * left_s) length_s = 0.5 * left_s;
  bool to_event = false, happens[2] = {};
  for (;;) {
    const double y = length_s / piece.length_s;
    const double enough = 1e-3 * tolerance_ * peak_speed_;
    const StageLoads loads = bare.at_stages(y);
    const auto sdirk4 = mobility_.none() ? building_sdirk4<false> : building_sdirk4<true>;
    const BuildingStep trial =
        sdirk4(now_.v, friction_now_, length_s, enough, loads, contact_, response, mobility_);
    // The first step of all is judged by the speed it would reach, taken or not.
    peak_speed_ = std::max(peak_speed_, length(trial.end.v));
    const double allowed = tolerance_ * peak_speed_ + length_s * rounding;
    const double share = trial.error > 0.0 ? allowed / trial.error : 1e4;
    const double next_s = length_s * std::clamp(0.9 * std::sqrt(std::sqrt(share)), 0.2, 5.0);
    if (share < 1.0 && length_s > shortest * left_s) {
      length_s = step_s_ = next_s;
      to_event = false;
      continue;
    }
    if (!to_event && (axes_[0].yields() || axes_[1].yields())) {
      Axes event;
      for (std::size_t n = 0; n < 2; ++n)
        event[n] = axes_[n].next_yield(with_block(bare, trial, n, length_s));
      const double first = std::min(event[0], event[1]);
      if (first <= 1e-9 * y) {
        for (std::size_t n = 0; n < 2; ++n)
          if (event[n] == first) axes_[n].yield();
        return 0.0;
      }
      if (first < y) {
        for (std::size_t n = 0; n < 2; ++n) happens[n] = event[n] == first;
        length_s = first * piece.length_s;
        to_event = true;
        continue;
      }
    }
    step_s_ = next_s;
    for (std::size_t n = 0; n < 2; ++n) {
      raise_peaks(n, bare, trial, length_s);
      axes_[n].follow(bare.axis[n], y, trial.added[n].x, trial.added[n].y);
      if (to_event && happens[n]) axes_[n].yield();
    }
    uplift_ = uplift_ || trial.end.normal < 0.0;
    const Sliding end{trial.end.v, trial.end.a};
    track_.slide(now_, end, length_s, time_s_);
    now_ = end;
    friction_now_ = trial.end.friction;
    if (end.v.s == 0.0 && end.v.y == 0.0) sliding_ = false;
    return y;
  }
}

void OnBuildingBody::coast(double step_s) {
  axes_ = {BuildingAxis({}, {}, 0.0, step_s), BuildingAxis({}, {}, 0.0, step_s)};
  mass_ratio_ = 0.0;
  mobility_ = {};
  strongest_ = contact_.strongest(mobility_);
  const Load load = contact_.loading().at(0.0, 0.0, 0.0);
  const double least_brake =
      contact_.least_factor(now_.v) * contact_.friction().along() * load.normal -
      std::abs(load.drive.s);
  for (int steps = 0; sliding_; ++steps) {
    if (steps == 100000) throw std::logic_error("slide_on_building: does not come to rest");
    Shaking still;
    // A quarter of the longest that can be left, straight down the slope.
    still.length_s = std::max(step_s, 0.25 * length(now_.v) / least_brake);
    advance(still, time_s_ + still.length_s);
  }
}

bool OnBuildingBody::will_stop() const {
  if (!sliding_) return true;
  const Load resting = contact_.loading().at(0.0, 0.0, 0.0);
  // Friction that exceeds the slope by rounding alone stops nothing within any record's length.
  const double mu = contact_.least_factor(now_.v) * contact_.friction().along();
  const double slope = resting.drive.s / resting.normal;
  return mu * mu - slope * slope > 1e-12 * mu * mu;
}

bool OnBuildingBody::is_settled() const {
  if (sliding_) return false;
  const double a1 = axes_[0].largest_to_come_mps2(), a2 = axes_[1].largest_to_come_mps2();
  if (a1 == never || a2 == never) return false;
  const TwoAxisLoading& of = contact_.loading();
  const double c = std::abs(of.cos_azimuth()), s = std::abs(of.sin_azimuth());
  const double along = c * a1 + s * a2, across = s * a1 + c * a2;
  const Load worst{{of.gravity() * of.tan_slope() + along, across / of.cos_slope()},
                   of.gravity() - along * of.tan_slope()};
  return contact_.friction_at_rest().may_rest(worst);
}

TwoAxisResult OnBuildingBody::result() const {
  TwoAxisResult r = track_.result();
  r.slip_phases = phases_;
  r.uplift = uplift_;
  return r;
}

}  // namespace glissade::block_detail
