// SPDX-License-Identifier: GPL-3.0-or-later
// Stop of a block on a building.
#include "block/full_model/body.hpp"

namespace glissade::block_detail {

/// Whether friction can bring the block to rest within this time.
bool FullModelBody::may_stop(const UncoupledRoof& uncoupled, double left_s) const {
  constexpr double margin = 1.1;  // for the load between both ends
  const auto load_at = [&](double fraction) {
    const Axes e = uncoupled.e(fraction);
    return contact_.loading().at(e[0], e[1], uncoupled.excitation.w(fraction));
  };
  const Load begin = load_at(0.0), end = load_at(left_s / uncoupled.excitation.length_s);
  const auto rate_bound = [&](const Load& load) {
    return length(load.drive) + friction_bound_ * std::max(load.normal, 0.0);
  };
  return std::max(begin.normal, end.normal) > 0.0 &&
         !(length(now_.v) > margin * left_s * std::max(rate_bound(begin), rate_bound(end)));
}

/// E after a time of constant interaction, which changes the building to the second order of time.
Axes FullModelBody::e_after(const UncoupledRoof& uncoupled, double after_s,
                            const Axes& interaction) const {
  Axes e = uncoupled.e(after_s / uncoupled.excitation.length_s);
  for (std::size_t n = 0; n < 2; ++n)
    for (const AxisMode& mode : axes_[n].modes()) {
      const double phase = mode.omega_radps * after_s, damping = mode.twice_zeta;
      e[n] += interaction[n] * mode.gain() * phase *
              (damping + 0.5 * (axes_[n].stiffness() - damping * damping) * phase);
    }
  return e;
}

/// Along the line of its velocity, with the net acceleration now and at the stop as start and end
/// of a straight line. The error is estimated by the acceleration half way, and by the transverse
/// load.
FullModelBody::StraightStop FullModelBody::find_straight_stop(const UncoupledRoof& uncoupled,
                                                              double left_s) const {
  StraightStop stop;
  const double speed = length(now_.v);
  const ExcitationPiece& piece = uncoupled.excitation;
  const Vector heading = speed > 0.0 ? now_.v : now_.a;
  const double size = length(heading);
  if (size == 0.0) return stop;  // on the threshold: the load leaves it, and cannot stop it soon
  const Vector along = stop.along = (1.0 / size) * heading;
  const Vector friction = contact_.friction().sliding(along);

  const auto state_at = [&](double t, double at_speed) {
    const double k = contact_.factor(at_speed);
    return contact_.with_friction(k * friction, e_after(uncoupled, t, stop.interaction),
                                  piece.w(t / piece.length_s), accelerance_);
  };
  const ContactState first = state_at(0.0, speed);
  stop.interaction = first.interaction;
  const double begin_rate = stop.begin_rate = dot(along, first.a);
  if (speed == 0.0 && !(begin_rate > 0.0)) return stop;  // rounding on the threshold: it starts
  double t = left_s;
  Vector last;
  for (int i = 0; i < 4; ++i) {
    last = state_at(t, 0.0).a;
    stop.end_rate = dot(along, last);
    const double jerk = (stop.end_rate - begin_rate) / t;
    const double next = time_to_stop(speed, {begin_rate, jerk, begin_rate + jerk * left_s}, left_s);
    if (next == never || !(next > 0.0)) return stop;
    const bool same = std::abs(next - t) <= 1e-12 * left_s;
    t = next;
    if (same) break;
  }
  stop.time_s = t;
  stop.e_end = e_after(uncoupled, t, stop.interaction);
  const double half_speed = std::max(speed + 0.125 * t * (3.0 * begin_rate + stop.end_rate), 0.0);
  const double bend =
      std::abs(dot(along, state_at(0.5 * t, half_speed).a) - 0.5 * (begin_rate + stop.end_rate));
  const double transverse = std::max(std::abs(cross(along, first.a)), std::abs(cross(along, last)));
  stop.residual_speed = t * (transverse + bend);
  return stop;
}

Stop FullModelBody::find_stop(const UncoupledRoof& uncoupled, double left_s,
                              std::array<Ramp, 2>& interaction) {
  if (!may_stop(uncoupled, left_s)) return {};
  const StraightStop straight = find_straight_stop(uncoupled, left_s);
  if (straight.time_s == never) return {};
  const ExcitationPiece& piece = uncoupled.excitation;
  const double t = straight.time_s, speed = length(now_.v), cosine = contact_.loading().cos_slope();
  const double allowed = stop_tolerance * tolerance_ * track_.path_length() / (cosine * cosine);
  const Axes e0 = uncoupled.e(0.0);
  // A block that the load then leaves at rest has at most moved sideways; one that it moves on
  // keeps the error in velocity.
  const auto load = [&](double at_s) {
    return load_at_rest(uncoupled, at_s, straight.interaction);
  };
  const double residual_speed = straight.residual_speed;
  constexpr double of_tolerance = 0.1;  // a speed that counts as none (on_building.hpp)
  if (residual_speed <= of_tolerance * tolerance_ * peak_speed_ ||
      0.5 * residual_speed * certain_rest_s(residual_speed, t, left_s, contact_.friction(), load) <=
          allowed) {
    const double rate0 = straight.begin_rate, rate1 = straight.end_rate;
    const Vector along = straight.along;
    const Axes begin = interaction_of(rate0 * along, e0, piece.w(0.0)),
               end = interaction_of(rate1 * along, straight.e_end, piece.w(t / piece.length_s));
    interaction = {Ramp{begin[0], end[0]}, Ramp{begin[1], end[1]}};
    const double path = std::max(0.0, t * (speed + t * (rate0 / 3.0 + rate1 / 6.0)));
    const double fastest =
        rate0 > 0.0 && rate1 < rate0 ? speed + 0.5 * rate0 * rate0 * t / (rate0 - rate1) : speed;
    return {t, path * along, path, fastest};
  }
  step_s_ = std::min(step_s_, approach_to_stop * t);
  if (!contact_.friction().is_circle() || speed == 0.0) return {};
  return find_curved_stop(uncoupled, left_s, allowed, interaction);
}

/// By the balance of momentum of a block with this acceleration.
Axes FullModelBody::interaction_of(Vector acceleration, const Axes& e, double w) const {
  const Axes a = contact_.with_acceleration(acceleration, e, w, accelerance_).a;
  return {e[0] - a[0], e[1] - a[1]};
}

/// The load that friction must balance if the block rests after a time of constant interaction.
Load FullModelBody::load_at_rest(const UncoupledRoof& uncoupled, double after_s,
                                 const Axes& interaction) const {
  const double w = uncoupled.excitation.w(after_s / uncoupled.excitation.length_s);
  return contact_.with_acceleration({}, e_after(uncoupled, after_s, interaction), w, accelerance_)
      .load;
}

/// Under constant load, where R is as good as isotropic.
Stop FullModelBody::find_curved_stop(const UncoupledRoof& uncoupled, double left_s, double allowed,
                                     std::array<Ramp, 2>& interaction) const {
  const ExcitationPiece& piece = uncoupled.excitation;
  const double mu = contact_.friction().along(), tangent = contact_.loading().tan_slope();
  const auto load_at = [&](double t) {
    const double fraction = t / piece.length_s;
    const Axes e = uncoupled.e(fraction);
    return contact_.loading().at(e[0], e[1], piece.w(fraction));
  };
  const Vector now_f = contact_.friction().sliding(now_.v);
  const auto effective = [&](const Load& load) {
    const Vector response = accelerance_ * Vector{tangent - now_f.s, -now_f.y};
    const double normal = std::max(load.normal, 0.0) / (1.0 + tangent * response.s);
    return Load{load.drive + normal * (accelerance_ * Vector{tangent, 0.0}),
                normal * (1.0 + accelerance_.mean)};
  };
  const Load now = effective(load_at(0.0)), end = effective(load_at(left_s));
  const double guess_s = stop_under_constant_load(now_.v, now.drive, mu * now.normal).time_s;
  if (guess_s > left_s) return {};
  // The load after a third of the time gives the displacement of a straight path to the second
  // order of its change.
  const Load third = effective(load_at(guess_s / 3.0));
  const Stop stop = stop_under_constant_load(now_.v, third.drive, mu * third.normal);
  if (stop.time_s > left_s) return {};
  const auto change = [&](const Load& a, const Load& b) {
    return length(b.drive - a.drive) + mu * std::abs(b.normal - a.normal);
  };
  const double t = guess_s, drag = mu * now.normal;
  double building_rate = 0.0;
  for (std::size_t n = 0; n < 2; ++n)
    for (const AxisMode& mode : axes_[n].modes())
      building_rate += accelerance_.axis[n] * mode.gain() * mode.omega_radps *
                       (mode.twice_zeta + mode.omega_radps * t);
  const double jerk = std::max(change(now, end) / left_s, change(now, third) * 3.0 / t) +
                      building_rate * (drag + std::abs(now.normal) * tangent);
  const double anisotropy =
      std::max(accelerance_.ss, accelerance_.yy) - accelerance_.mean + std::abs(accelerance_.sy) +
      2.0 * mu * tangent * (std::abs(accelerance_.ss) + std::abs(accelerance_.sy));
  const double residual_speed = drag * (anisotropy + std::abs(contact_.factor(now_.v) - 1.0));
  const Axes mean = interaction_of((-1.0 / stop.time_s) * now_.v, uncoupled.e(0.0), piece.w(0.0));
  interaction = {Ramp{mean[0], mean[0]}, Ramp{mean[1], mean[1]}};
  const auto load = [&](double at_s) { return load_at_rest(uncoupled, at_s, mean); };
  const double fast = t * (0.5 * jerk * t + residual_speed);  // it may still be at the stop
  const bool is_exact =
      t * t * (jerk * t / 12.0 + 0.5 * residual_speed) <= allowed &&
      certain_rest_s(fast, stop.time_s, left_s, contact_.friction(), load) != never;
  return is_exact && (stop.path <= allowed ||
                      (passes_no_peak(third.drive) && !track_.is_wanted(stop.path)))
             ? stop
             : Stop{};
}

/// Until the block rests the velocity turns to the drive's direction: between the two, neither an
/// axis nor the displacement's own direction is passed.
bool FullModelBody::passes_no_peak(Vector drive) const {
  const Vector v = now_.v, out = scaled(track_.displacement(), contact_.loading().to_plan());
  return v.s * drive.s >= 0.0 && v.y * drive.y >= 0.0 && dot(out, v) * dot(out, drive) >= 0.0;
}

bool FullModelBody::stop_there(const Stop& stop, const UncoupledRoof& uncoupled,
                               const std::array<Ramp, 2>& interaction) {
  const double fraction = stop.time_s / uncoupled.excitation.length_s;
  AxisSeries motion[2];
  for (std::size_t n = 0; n < 2; ++n) {
    const Ramp& ground = uncoupled.excitation.ground[n];
    motion[n] =
        axes_[n].motion(stop.time_s, {ground.begin, ground.at(fraction)}, 1.0, interaction[n]);
    if (axes_[n].next_yield(motion[n]) <= 1.0) return false;
  }
  for (std::size_t n = 0; n < 2; ++n) {
    raise_peaks(n, motion[n], 1.0);
    axes_[n].follow(motion[n], 1.0);
  }
  track_.stop(stop, length(now_.v), time_s_);
  sliding_ = false;
  return true;
}

}  // namespace glissade::block_detail
