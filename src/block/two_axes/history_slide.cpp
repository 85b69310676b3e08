// SPDX-License-Identifier: GPL-3.0-or-later
// A history while the block slides too stiffly for the lanes, and how it stops.
#include <algorithm>
#include <cmath>
#include <utility>

#include "block/full_model/sdirk4.hpp"
#include "block/full_model/stop.hpp"
#include "block/slip_record/two_axis_extremes.hpp"
#include "elliptic_stop.hpp"
#include "history.hpp"

namespace glissade::block_detail::two_axes {
namespace {

/// Of the weight: least_weight of the lanes, and a margin, so that they can go on from here. Below
/// it, and where the block has lifted off, steps are SDIRK4.
constexpr double least_event_weight = 1.2 * least_weight;
/// Of the permitted error of a stop: a shorter path may pass a peak or a threshold unseen.
constexpr double negligible_stop = 50.0;
/// Of the permitted error of a step's acceleration: where the iteration of a stage ends. The first
/// pass over a step of a coupled building only says how fast the block moves.
constexpr double stage_tolerance = 1e-4, first_stage_tolerance = 1.0;

Vector velocity(const HistoryState& state) { return {state.motion.v_s, state.motion.v_y}; }

/// Where the iteration of a stage begins, and has ended.
struct StageState {
  Vector a;
  double sigma = -1.0;  ///< see ImplicitEllipse
};
using Stages = std::array<StageState, Sdirk4::stages>;

/// Coulomb friction and a roof that the block may accelerate: V' from V = known + gamma_h V'.
void stage(const Constants<double>& c, const FrictionEllipse& friction, Vector known,
           double gamma_h, const Load& load, double tolerance, StageState& state) {
  const double per_kappa = c.per_kappa_y;
  const bool closed = c.rho_sin_cos == 0.0 && friction.is_circle();  // by the first guess
  ImplicitEllipse on_ellipse = friction.implicit(closed ? -1.0 : state.sigma);
  Vector& a = state.a;
  double change = never;
  for (int i = 0; i < 12; ++i) {
    // What is not the same in both directions is taken from the last iterate.
    const double normal = load.normal - c.rho_sin_cos * a.s;
    const double effective = std::max(normal, 0.0) * per_kappa, lambda = gamma_h * effective;
    const Vector drive =
        per_kappa * Vector{load.drive.s + (1.0 / per_kappa - c.kappa) * a.s, load.drive.y};
    const Vector p = known + gamma_h * drive;
    Vector next = (-1.0 / gamma_h) * known;
    if (friction.excess({p, lambda}) > 0.0) {
      const Vector f = on_ellipse.next(p, lambda);
      next = drive - (effective / on_ellipse.size()) * f;
    }
    const double before = std::exchange(change, length(next - a));
    a = next;
    if (closed) break;
    // What is left to change is to this change as this is to the one before, at most.
    if (i > 0 && change * change <= tolerance * c.tolerance * c.mu * effective * before) break;
  }
  state.sigma = on_ellipse.sigma();
}

/// SDIRK4 over a fraction of a piece. @param stages of the last pass over the same step, if it is
/// not the first
SlidingStep sdirk4(const Constants<double>& c, const FrictionEllipse& friction, Vector v,
                   const RoofPiece& piece, double fraction, double tolerance, bool first,
                   Stages& stages) {
  Load load;
  const auto rate = [&](int i, Vector known, double gamma_h) {
    StageState& state = stages[static_cast<std::size_t>(i)];
    if (first) state = {i > 0 ? (&state - 1)->a : Vector{}};
    load = piece.load(fraction * Sdirk4::at[i]);
    stage(c, friction, known, gamma_h, load, tolerance, state);
    return state.a;
  };
  return sdirk4(v, fraction * piece.length_s(), friction, rate,
                [&] { return c.per_kappa_y * load.normal; });
}

/// When a speed is zero whose deceleration begins with a value and grows steadily; one that falls
/// is taken to last.
double first_zero_s(double speed, double deceleration, double growth) {
  const double root = std::sqrt(deceleration * deceleration + 2.0 * std::max(growth, 0.0) * speed);
  if (deceleration > 0.0) return 2.0 * speed / (deceleration + root);
  return growth > 0.0 ? (root - deceleration) / growth : never;
}

}  // namespace

RoofPiece::BlockVelocity LaneHistory::plan_velocity(Vector v, Vector rise) const {
  const auto by_axis = [&](Vector u) -> std::array<double, 2> {
    const double along = constants_.cosine2 * u.s, across = constants_.cosine * u.y;
    return {constants_.c * along - constants_.s * across,
            constants_.s * along + constants_.c * across};
  };
  return {by_axis(v), by_axis(rise)};
}

/// That of the cubic through the velocities and accelerations at both ends of a step over a
/// fraction of a piece.
RoofPiece::BlockVelocity LaneHistory::plan_velocity_between(const Sliding& begin,
                                                            const Sliding& end, double length_s,
                                                            double fraction) const {
  const Vector rise = length_s * begin.a, last = length_s * end.a, gain = end.v - begin.v;
  const auto of = [&](Vector term, double per_fraction) {
    return plan_velocity(per_fraction * term).begin;
  };
  const double per = 1.0 / fraction;
  return {plan_velocity(begin.v).begin, of(rise, per),
          of(3.0 * gain - 2.0 * rise - last, per * per),
          of(rise + last - 2.0 * gain, per * per * per)};
}

LaneHistory::Next LaneHistory::event(HistoryState& state) {
  step_s_ = never;
  return slide(state, true);
}

LaneHistory::Next LaneHistory::slide(HistoryState& state, bool from_lane) {
  for (bool first = from_lane;; first = false) {
    const LaneMotion<double>& m = state.motion;
    if (state.node >= static_cast<std::int64_t>(ground_.end)) return Next::unsupported;
    const Vector v = velocity(state);
    RoofPiece rest_of_interval = piece(state, plan_velocity(v));
    const Load load = rest_of_interval.load(0.0);
    const double speed = length(v);
    if (speed > 0.0 && frictionless_normal(load) > 0.0) {
      if (stop(state, rest_of_interval)) return rest(state);
      if (speed <= constants_.tolerance * m.fastest && reverse(state, rest_of_interval)) continue;
    }
    const double least_normal = std::min(load.normal, rest_of_interval.load(1.0).normal);
    if (!first && least_normal > least_event_weight * constants_.gravity &&
        constants_.mu * load.normal * rest_of_interval.length_s() <= stiffest * speed)
      return Next::slides;
    stiff_step(state);
    if (m.v_s == 0.0 && m.v_y == 0.0) return rest(state);
  }
}

/// In closed form, where it comes before the piece's end under a load that hardly changes.
bool LaneHistory::stop(HistoryState& state, const RoofPiece& piece) {
  const Constants<double>& c = constants_;
  const LaneMotion<double>& m = state.motion;
  const Vector v = velocity(state), to_circle{1.0, c.per_aspect};
  const auto effective = [&](double tau) {
    const Load load = piece.load(tau);
    return Load{c.per_kappa_y * load.drive, c.mu * c.per_kappa_y * load.normal};
  };
  const double length_s = piece.length_s(), allowed = stop_tolerance * c.tolerance * m.path;
  const Load now = effective(0.0);
  const double t =
      stop_under_constant_load(scaled(v, to_circle), scaled(now.drive, to_circle), now.normal)
          .time_s;
  if (!(t < length_s)) return false;
  // The load after a third of the time gives the displacement of a straight path to the second
  // order of its change.
  const Load third = effective(t / length_s / 3.0), end = effective(1.0);
  step_s_ = std::min(step_s_, approach_to_stop * t);
  const auto change = [](const Load& a, const Load& b) {
    return length(b.drive - a.drive) + std::abs(b.normal - a.normal);
  };
  const double jerk = std::max(change(now, end) / length_s, change(now, third) * 3.0 / t);
  const double anisotropy = now.normal * c.anisotropy;
  if (!(t * t * (jerk * t / 12.0 + 0.5 * anisotropy) <= allowed)) return false;
  const EllipticStop found =
      c.aspect == 1.0
          ? EllipticStop{stop_under_constant_load(v, third.drive, third.normal), third.drive}
          : stop_on_an_ellipse(v, third.drive, third.normal, c.aspect, allowed);
  const Stop& stop = found.stop;
  if (!(stop.time_s < length_s)) return false;
  const auto load_at = [&](double at_s) { return piece.load(at_s / length_s); };
  const double residual_speed = t * (0.5 * jerk * t + anisotropy);  // speed it may have at the stop
  if (certain_rest_s(residual_speed, stop.time_s, length_s, ellipse_, load_at) == never)
    return false;
  const Vector out = scaled({m.at_s, m.at_y}, {c.cosine2, c.cosine}), last = found.last;
  const bool passes_no_peak =
      v.s * last.s >= 0.0 && v.y * last.y >= 0.0 && dot(out, v) * dot(out, last) >= 0.0;
  const bool may_cross = crossings_.may_reach(std::sqrt(m.farthest2) + stop.path);
  if (!(passes_no_peak && !may_cross) && stop.path > negligible_stop * allowed) return false;
  take_stop(state, piece, stop);
  return true;
}

/// A speed within the tolerance, against the load, is zero after a time: from there friction and
/// load decide anew. A stiff step across a reversal would take one direction's friction for the
/// other's.
bool LaneHistory::reverse(HistoryState& state, const RoofPiece& piece) {
  const Vector v = velocity(state);
  const Load load = piece.load(0.0);
  if (dot(load.drive, v) > 0.0) return false;  // which turns it
  const double speed = length(v), time_s = speed / deceleration(load, v);
  if (!(time_s > 0.0 && time_s < piece.length_s())) return false;
  Stop zero;
  zero.time_s = time_s;
  zero.displacement = (0.5 * time_s) * v;
  zero.path = 0.5 * time_s * speed;
  take_stop(state, piece, zero);
  step_s_ = never;
  return true;
}

/// By which the speed of v falls under a load.
double LaneHistory::deceleration(const Load& load, Vector v) const {
  const double normal = std::max(load.normal, 0.0),
               along = dot(normal * ellipse_.sliding(v) - load.drive, v) / length(v);
  return constants_.per_kappa_y * along;
}

void LaneHistory::take_stop(HistoryState& state, const RoofPiece& piece, const Stop& stop) {
  const Constants<double>& c = constants_;
  LaneMotion<double>& m = state.motion;
  const Vector v = velocity(state), from{m.at_s, m.at_y};
  const double begin_s = time_s(state);
  piece.move(state, stop.time_s / piece.length_s());
  const Vector displacement = scaled(stop.displacement, {c.cosine2, c.cosine});
  if (roof_ == RoofKind::coupled) {
    // The block's mean velocity to the stop, in place of the one that it began with.
    const RoofPiece::BlockVelocity begin = plan_velocity(v);
    const double path_1 = c.c * displacement.s - c.s * displacement.y,
                 path_2 = c.s * displacement.s + c.c * displacement.y;
    const double less_1 = path_1 - begin.begin[0] * stop.time_s,
                 less_2 = path_2 - begin.begin[1] * stop.time_s;
    m.x_1 -= c.omega_1 * c.omega_rho_1 * less_1;
    m.x_2 -= c.omega_2 * c.omega_rho_2 * less_2;
    m.y_1 += c.omega_1 * c.omega_rho_1 * c.twice_zeta_1 * c.per_mass * less_1;
    m.y_2 += c.omega_2 * c.omega_rho_2 * c.twice_zeta_2 * c.per_mass * less_2;
  }
  m.v_s = m.v_y = 0.0;
  m.path += stop.path;
  const double speed = length(v);
  const auto at = [&](double tau) {
    const auto [fraction, rate] = stop.path_fraction(tau, speed);
    return PathPoint{from + fraction * displacement, (rate / stop.time_s) * displacement};
  };
  displace(state, displacement, at, begin_s, stop.time_s);
}

/// The normal force of a block that slides without friction: it has the sign of that with friction.
double LaneHistory::frictionless_normal(const Load& load) const {
  return load.normal - constants_.rho_sin_cos / constants_.kappa * load.drive.s;
}

/// The fraction of a piece after which the block lifts off, or lands: a step ends there.
double LaneHistory::until_contact_changes(const RoofPiece& piece) {
  const auto lift = [&](double tau) { return -frictionless_normal(piece.load(tau)); };
  const double begin = lift(0.0), end = lift(1.0);
  uplift_ = uplift_ || begin > 0.0 || end > 0.0;
  if ((begin > 0.0) == (end > 0.0)) return 1.0;
  const double tau = begin > 0.0 ? rise_by_secant([&](double t) { return -lift(t); }, -begin, -end)
                                 : rise_by_secant(lift, begin, end);
  constexpr double at_once = 1e-9;  // it was at the end of the last step
  return tau > at_once ? tau : 1.0;
}

/// The length to try first of what is left of the interval, `left_s`.
double LaneHistory::stiff_trial_s(const RoofPiece& rest_of_interval, Vector v,
                                  double fastest) const {
  const double left_s = rest_of_interval.length_s(), speed = length(v);
  const Load now = rest_of_interval.load(0.0);
  double length_s = std::min(step_s_, left_s);
  if (step_s_ == never && speed > 0.0 && now.normal > 0.0)
    length_s = std::min(length_s, speed / (now.normal * dot(ellipse_.sliding(v), v) / speed));
  // A step at whose end the load would let the block rest may not see it slide at all.
  while (speed == 0.0 && length_s > shortest_start * left_s &&
         ellipse_.may_rest(rest_of_interval.load(length_s / left_s)))
    length_s *= 0.5;
  // A stage of what comes after a reversal would not see what came before.
  if (speed > constants_.tolerance * fastest) {
    const double first = deceleration(now, v), last = deceleration(rest_of_interval.load(1.0), v);
    length_s =
        std::min(length_s, approach_to_stop * first_zero_s(speed, first, (last - first) / left_s));
  }
  return length_s;
}

void LaneHistory::stiff_step(HistoryState& state) {
  const Constants<double>& c = constants_;
  const Vector v = velocity(state);
  const double fastest = state.motion.fastest;
  RoofPiece rest_of_interval = piece(state, plan_velocity(v));
  const double left_s = rest_of_interval.length_s();
  const Load now = rest_of_interval.load(0.0);
  StageState at_once;
  stage(c, ellipse_, v, shortest_step * left_s, now, stage_tolerance, at_once);
  const Vector a = at_once.a;
  const double rounding = rounding_of(now);
  const double contact_s = left_s * until_contact_changes(rest_of_interval);
  double length_s = std::min(stiff_trial_s(rest_of_interval, v, fastest), contact_s);
  double fraction = 1.0;
  SlidingStep trial;
  Stages stages;
  for (;;) {
    // No remainder that is much shorter than the step.
    if (length_s < contact_s && length_s > 0.5 * contact_s) length_s = 0.5 * contact_s;
    fraction = length_s == left_s ? 1.0 : length_s / left_s;
    const bool coupled = roof_ == RoofKind::coupled;
    if (coupled) rest_of_interval = piece(state, plan_velocity(v, left_s * a));
    trial = sdirk4(c, ellipse_, v, rest_of_interval, fraction,
                   coupled ? first_stage_tolerance : stage_tolerance, true, stages);
    const double allowed =
        c.tolerance * std::max(fastest, length(trial.end.v)) + length_s * rounding;
    // Again with the velocity that it then has, until that changes nothing.
    double changed = coupled ? never : 0.0;
    for (int pass = 0; pass < 5 && changed > 0.01 * allowed; ++pass) {
      const Vector last = trial.end.v;
      rest_of_interval = piece(state, plan_velocity_between({v, a}, trial.end, length_s, fraction));
      trial = sdirk4(c, ellipse_, v, rest_of_interval, fraction, stage_tolerance, false, stages);
      changed = length(trial.end.v - last);
    }
    trial.error += changed;
    const double ratio = error_ratio(allowed, trial.error);
    step_s_ = length_s * step_factor(ratio);
    if (ratio >= 1.0 || length_s <= shortest_step * left_s) break;
    length_s = step_s_;
  }
  take_step(state, rest_of_interval, fraction, length_s, {v, a}, trial.end);
}

/// Over a fraction of a piece; the path is the cubic through both ends' velocities and
/// accelerations.
void LaneHistory::take_step(HistoryState& state, const RoofPiece& piece, double fraction,
                            double length_s, const Sliding& begin, const Sliding& end) {
  LaneMotion<double>& m = state.motion;
  const Vector to_plan{constants_.cosine2, constants_.cosine}, from{m.at_s, m.at_y};
  const Path path(length_s, from, scaled(begin.v, to_plan), scaled(begin.a, to_plan),
                  scaled(end.v, to_plan), scaled(end.a, to_plan));
  raise_peaks(path, m);
  const double begin_s = time_s(state), speed = length(end.v);
  piece.move(state, fraction);
  m.v_s = end.v.s;
  m.v_y = end.v.y;
  m.fastest = std::max(m.fastest, speed);
  m.path += 0.5 * length_s * (length(begin.v) + speed);
  const auto at = [&](double tau) { return PathPoint{path.displacement(tau), path.velocity(tau)}; };
  displace(state, path.end - from, at, begin_s, length_s);
}

void LaneHistory::raise_peaks(const Path& path, LaneMotion<double>& m) const {
  constexpr double unneeded_speed = never;
  Extremes extremes(std::sqrt(m.farthest2), unneeded_speed, {m.ahead_s, m.ahead_y},
                    {m.back_s, m.back_y});
  extremes.along(path);
  m.farthest2 = std::max(m.farthest2, extremes.displacement() * extremes.displacement());
  m.ahead_s = extremes.ahead().s;
  m.ahead_y = extremes.ahead().y;
  m.back_s = extremes.back().s;
  m.back_y = extremes.back().y;
}

void LaneHistory::crossed(const LaneStates& lanes, std::size_t lane) {
  const double* f = lanes.passed.fraction;
  const double h = lanes.passed.length_s[lane], end = f[lane];
  const auto at = [&](double tau) {
    const double t = tau * end;
    PathPoint point;
    for (std::size_t k = LaneStates::path_terms; k-- > 0;) {
      const Vector term{lanes.passed.path_s[k][lane], lanes.passed.path_y[k][lane]};
      point.velocity = t * point.velocity + point.displacement;
      point.displacement = t * point.displacement + term;
    }
    point.velocity = (1.0 / h) * point.velocity;
    return point;
  };
  crossings_.pass(at, lanes.passed.begin_s[lane], end * h, std::sqrt(lanes.motion.farthest2[lane]));
}

TwoAxisPeak LaneHistory::result(const HistoryState& state) const {
  const LaneMotion<double>& m = state.motion;
  TwoAxisPeak peak;
  peak.peak_displacement_m = std::sqrt(m.farthest2);
  peak.peak_by_axis = {std::max(m.ahead_s, m.back_s), std::max(m.ahead_y, m.back_y)};
  peak.peak_downslope_m = m.ahead_s;
  peak.peak_upslope_m = m.back_s;
  peak.residual = {m.at_s, m.at_y};
  peak.slip_phases = phases_;
  peak.uplift = uplift_;
  return peak;
}

}  // namespace glissade::block_detail::two_axes
