// SPDX-License-Identifier: GPL-3.0-or-later
// How the block of a history stops.
#include "block/full_model/stop.hpp"

#include <algorithm>
#include <cmath>

#include "block/two_axes/history/elliptic_stop.hpp"
#include "block/two_axes/history/history.hpp"

namespace glissade::block_detail::two_axes {
namespace {

/// Of the permitted error of a stop: a shorter path may pass a peak or a threshold unseen.
constexpr double negligible_stop = 50.0;
/// The block has moved by `less` more along the axes than the modes have taken it to
/// (RoofSeries::RespondModes).
void move_less(const SceneConstants& c, const std::array<double, 2>& less,
               ModeMotion<double>& modes) {
  const ModeConstants<double>& of = c.modes;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    double e[most_modes], sum = 0.0;
    for (std::size_t n = 0; n < c.count[axis]; ++n) {
      const double moved = of.omega_share[axis][n] * less[axis];
      modes.x[axis][n] -= of.omega[axis][n] * moved;
      sum += e[n] = of.twice_zeta[axis][n] * moved;
    }
    for (std::size_t n = 0; n < c.count[axis]; ++n)
      modes.y[axis][n] += of.omega[axis][n] * (e[n] - of.share[axis][n] * sum);
  }
}

}  // namespace

RoofPiece::BlockVelocity LaneHistory::plan_velocity(Vector v) const {
  const double along = constants_.cosine2 * v.s, across = constants_.cosine * v.y;
  return {
      {constants_.c * along - constants_.s * across, constants_.s * along + constants_.c * across}};
}

LaneHistory::Next LaneHistory::event(HistoryState& state) {
  LaneMotion<double>& m = state.motion;
  const bool diverged = m.trial == 0.0;
  if (diverged || state.node >= limit()) return Next::unsupported;
  const Vector v = velocity(state);
  const double speed = length(v);
  if (speed == 0.0) return rest(state);
  const RoofPiece rest_of_interval = piece(state, plan_velocity(v));
  if (frictionless_normal(rest_of_interval.load(0.0)) > 0.0) {
    if (stop(state, rest_of_interval)) return rest(state);
    if (speed <= constants_.no_speed * m.fastest && reverse(state, rest_of_interval)) {
      const bool holds = constants_.mu_at_rest > constants_.mu &&
                         friction_reserve(piece(state).load(0.0), constants_) >= 0.0;
      return holds ? rest(state) : go_on_from_rest(state);
    }
  }
  m.forced = 1.0;
  return Next::slides;
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
  const auto change = [](const Load& a, const Load& b) {
    return length(b.drive - a.drive) + std::abs(b.normal - a.normal);
  };
  const double jerk = std::max(change(now, end) / length_s, change(now, third) * 3.0 / t);
  const double law = std::abs(c.fast_excess) * -std::expm1(-c.speed_rate * length(v));
  const double anisotropy = now.normal * (c.anisotropy + law);  // and what else is not constant
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
  if (meets_spring_event(state, stop)) return false;
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
  if (meets_spring_event(state, zero)) return false;
  take_stop(state, piece, zero);
  return true;
}

/// What is left of the interval, with a velocity of the block that falls to zero over the stop.
RoofPiece LaneHistory::stopping_piece(const HistoryState& state, const Stop& stop) const {
  const double fraction = stop.time_s / (ground_.dt_s * state.motion.left);
  RoofPiece::BlockVelocity v = plan_velocity(velocity(state));
  for (std::size_t n = 0; n < 2; ++n) v.rise[n] = -v.begin[n] / fraction;
  return piece(state, v);
}

bool LaneHistory::meets_spring_event(const HistoryState& state, const Stop& stop) const {
  if (roof_ != RoofKind::yielding) return false;
  const RoofPiece piece = stopping_piece(state, stop);
  return piece.next_event(state.springs).at <= stop.time_s / piece.length_s();
}

/// By which the speed of v falls under a load.
double LaneHistory::deceleration(const Load& load, Vector v) const {
  const double normal = std::max(load.normal, 0.0),
               along = dot(normal * ellipse_.sliding(v) - load.drive, v) / length(v);
  return constants_.per_kappa_y * along;
}

void LaneHistory::take_stop(HistoryState& state, const RoofPiece& piece, const Stop& stop) {
  const SceneConstants& c = constants_;
  LaneMotion<double>& m = state.motion;
  const Vector v = velocity(state), from{m.at_s, m.at_y};
  const double begin_s = time_s(state);
  raise_shear(state, piece, stop);
  piece.move(state, stop.time_s / piece.length_s());
  const Vector displacement = scaled(stop.displacement, {c.cosine2, c.cosine});
  if (has_mass(roof_)) {
    // The block's mean velocity to the stop, in place of the one that it began with.
    const RoofPiece::BlockVelocity begin = plan_velocity(v);
    const double path_1 = c.c * displacement.s - c.s * displacement.y,
                 path_2 = c.s * displacement.s + c.c * displacement.y;
    const double less_1 = path_1 - begin.begin[0] * stop.time_s,
                 less_2 = path_2 - begin.begin[1] * stop.time_s;
    if (roof_ == RoofKind::coupled_modes) {
      move_less(c, {less_1, less_2}, state.modes);
    } else {
      const auto stiffness = [&](std::size_t n) {
        return state.springs.direction[n] == 0.0 ? 1.0 : c.springs.hardening[n];
      };
      m.x_1 -= stiffness(0) * (c.omega_1 * c.omega_rho_1 * less_1);
      m.x_2 -= stiffness(1) * (c.omega_2 * c.omega_rho_2 * less_2);
      m.y_1 += c.omega_1 * c.omega_rho_1 * c.twice_zeta_1 * c.per_mass * less_1;
      m.y_2 += c.omega_2 * c.omega_rho_2 * c.twice_zeta_2 * c.per_mass * less_2;
    }
  }
  m.v_s = m.v_y = 0.0;
  m.path += stop.path;
  const double speed = length(v);
  const auto at = [&](double tau) {
    const auto [fraction, rate] = stop.path_fraction(tau, speed);
    return PathPoint{from + fraction * displacement, (rate / stop.time_s) * displacement};
  };
  displace(state, displacement, at, begin_s, stop.time_s);
  duration_s_ += begin_s + stop.time_s - start_s_;
}

/// The normal force of a block that slides without friction: it has the sign of that with friction.
double LaneHistory::frictionless_normal(const Load& load) const {
  const SceneConstants& c = constants_;
  if (roof_ == RoofKind::coupled_modes)
    return load.normal - c.modes.lift_s * load.drive.s - c.modes.lift_y * load.drive.y;
  return load.normal - c.rho_sin_cos / c.kappa * load.drive.s;
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

BuildingPeak LaneHistory::result(const HistoryState& state) const {
  const LaneMotion<double>& m = state.motion;
  BuildingPeak peak;
  set_peaks({std::sqrt(m.farthest2), 0.0, {m.ahead_s, m.ahead_y}, {m.back_s, m.back_y}}, peak);
  peak.residual = {m.at_s, m.at_y};
  peak.slip_duration_s = duration_s_;
  peak.slip_phases = phases_;
  peak.uplift = uplift_;
  if (follows_shear())
    for (std::size_t n = 0; n < 2; ++n)
      peak.base_shear[n] = largest_a_[n] / (constants_.per_mass * constants_.gravity);
  return peak;
}

}  // namespace glissade::block_detail::two_axes
