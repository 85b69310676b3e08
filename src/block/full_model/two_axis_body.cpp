// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/full_model/two_axis_body.hpp"

#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail {

void TwoAxisBody::interval(double length_s, double end_s, const Load& begin, const Load& end) {
  uplift_ = uplift_ || begin.normal < 0.0 || end.normal < 0.0;
  if ((begin.normal < 0.0) == (end.normal < 0.0)) return advance(length_s, end_s, begin, end);
  const double share = begin.normal / (begin.normal - end.normal);
  Load touch = between(begin, end, share);
  touch.normal = 0.0;
  const double before_s = share * length_s, after_s = (1.0 - share) * length_s;
  if (before_s > 0.0) advance(before_s, std::min(time_s_ + before_s, end_s), begin, touch);
  if (after_s > 0.0) advance(after_s, end_s, touch, end);
}

void TwoAxisBody::advance(double length_s, double end_s, const Load& begin, const Load& end) {
  double done_s = 0.0;
  Load now = begin;
  // Steps shrink geometrically toward a stop, so some dozens suffice; the bound only guards against
  // rounding.
  for (int steps = 0; steps < 1000000; ++steps) {
    const double left_s = length_s - done_s;
    double taken_s = 0.0;
    if (sliding_) {
      taken_s = step(now, end, left_s);
    } else {
      const double share = friction_.release(now, end);
      if (share == never) return rest_until(end_s);
      taken_s = share * left_s;
      // What rounding alone sets in motion must not set the scale of the errors.
      peak_speed_ = std::max(peak_speed_, 1e-9 * length_s * std::abs(now.normal));
      start(share > 0.0 ? Vector{} : friction_.release_acceleration(now));
    }
    done_s += taken_s;
    time_s_ = std::min(time_s_ + taken_s, end_s);
    if (!(done_s < length_s)) {
      time_s_ = end_s;
      return note();
    }
    note();
    now = between(begin, end, done_s / length_s);
  }
  throw NotConverged("slide_two_axis: too many steps inside one sample interval");
}

void TwoAxisBody::start(Vector acceleration) {
  sliding_ = true;
  now_ = {{}, acceleration};
  step_s_ = never;
  ++phases_;
}

double TwoAxisBody::step(const Load& now, const Load& end, double left_s) {
  const Stop stop = find_stop(now, end, left_s);
  if (stop.time_s != never) {
    rest_after(stop);
    return stop.time_s;
  }
  constexpr double shortest = 1e-9;  // of what is left: far below what any tolerance requires
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() *
                          (std::abs(now.drive.s) + std::abs(now.drive.y) + std::abs(now.normal));
  double length_s = std::min(step_s_, left_s);
  if (length_s < left_s && length_s > 0.5 * left_s) length_s = 0.5 * left_s;
  for (;;) {
    const bool to_end = length_s == left_s;
    const SlidingStep trial = sdirk4(
        now_.v, now, to_end ? end : between(now, end, length_s / left_s), length_s, friction_);
    // The first step of all is judged by the speed it would reach.
    const double speed = std::max(peak_speed_, length(trial.end.v));
    const double allowed = tolerance_ * speed + length_s * rounding;
    const double share = trial.error > 0.0 ? allowed / trial.error : 1e4;
    step_s_ = length_s * std::clamp(0.9 * std::sqrt(std::sqrt(share)), 0.2, 5.0);
    if (share >= 1.0 || length_s <= shortest * left_s) {
      peak_speed_ = speed;
      slide_to(trial.end, length_s);
      return length_s;
    }
    length_s = step_s_;
  }
}

Stop TwoAxisBody::find_stop(const Load& now, const Load& end, double left_s) {
  const double speed = length(now_.v);
  const auto grip = [&](const Load& load) {
    return std::abs(load.drive.s) + std::abs(load.drive.y) +
           friction_.largest() * std::max(load.normal, 0.0);
  };
  if (speed > left_s * std::max(grip(now), grip(end))) return {};
  const Vector heading = speed > 0.0 ? now_.v : now_.a;
  const double size = length(heading);
  if (size == 0.0) return {};  // on the threshold: the load leaves it, and cannot stop it soon
  const Vector along = (1.0 / size) * heading;

  // Stops are many, and a wrong one is not mended by what follows: they get a small share.
  const double allowed = 1e-3 * tolerance_ * track_.path_length();
  const Stop straight = stop_on_a_line(speed, along, now, end, left_s, friction_);
  if (straight.time_s == never) return {};
  const Vector sliding = friction_.sliding(along);
  const auto aside = [&](const Load& load) {
    const Vector net = load.drive - std::max(load.normal, 0.0) * sliding;
    return std::abs(cross(along, net));
  };
  const double t = straight.time_s;
  const double sideways = t * std::max(aside(now), aside(end));  // speed it may have at the stop
  // What the load then holds has at most moved aside; what it moves on keeps the error in velocity.
  const auto load = [&](double at_s) { return between(now, end, at_s / left_s); };
  if (sideways <= 0.1 * tolerance_ * peak_speed_ ||
      0.5 * sideways * rests_for_sure(sideways, t, left_s, friction_, load) <= allowed) {
    return straight;
  }

  step_s_ = std::min(step_s_, 0.6 * t);
  return friction_.is_circle() && speed > 0.0 ? find_curved_stop(now, end, left_s, allowed)
                                              : Stop{};
}

Stop TwoAxisBody::find_curved_stop(const Load& now, const Load& end, double left_s,
                                   double allowed) const {
  const double mu = friction_.along();
  const double guess_s = stop_under_constant_load(now_.v, now.drive, mu * now.normal).time_s;
  if (guess_s > left_s) return {};
  // The load a third of the way gives the way of a straight path to the second order of its change.
  const Load third = between(now, end, guess_s / left_s / 3.0);
  const Stop stop = stop_under_constant_load(now_.v, third.drive, mu * third.normal);
  if (stop.time_s > left_s) return {};
  const Load change{end.drive - now.drive, end.normal - now.normal};
  const double jerk = (length(change.drive) + mu * std::abs(change.normal)) / left_s;
  const auto load = [&](double at_s) { return between(now, end, at_s / left_s); };
  const double off = 0.5 * jerk * guess_s * guess_s;  // speed it may have at the stop
  const bool is_exact = off * guess_s / 6.0 <= allowed &&
                        rests_for_sure(off, stop.time_s, left_s, friction_, load) != never;
  return is_exact && (passes_no_peak(third.drive) || stop.path <= allowed) ? stop : Stop{};
}

/// On its way to rest the velocity turns to the drive's direction: between the two, neither an axis
/// nor the displacement's own direction is passed.
bool TwoAxisBody::passes_no_peak(Vector drive) const {
  const Vector v = now_.v, out = scaled(track_.displacement(), to_plan_);
  return v.s * drive.s >= 0.0 && v.y * drive.y >= 0.0 && dot(out, v) * dot(out, drive) >= 0.0;
}

void TwoAxisBody::slide_to(const Sliding& to, double length_s) {
  track_.slide(now_, to, length_s, time_s_);
  now_ = to;
  if (to.v.s == 0.0 && to.v.y == 0.0) sliding_ = false;
}

void TwoAxisBody::rest_after(const Stop& stop) {
  track_.stop(stop, length(now_.v), time_s_);
  sliding_ = false;
}

void TwoAxisBody::coast(const Load& load, double step_s) {
  for (int steps = 0; sliding_; ++steps) {
    if (steps == 100000) throw NotConverged("slide_two_axis: does not come to rest");
    // A quarter of the longest that can be left, straight down the slope.
    const double least_brake = friction_.along() * load.normal - std::abs(load.drive.s);
    const double length_s = std::max(step_s, 0.25 * length(now_.v) / least_brake);
    advance(length_s, time_s_ + length_s, load, load);
  }
}

TwoAxisResult TwoAxisBody::result() const {
  TwoAxisResult r = track_.result();
  r.slip_phases = phases_;
  r.uplift = uplift_;
  return r;
}

}  // namespace glissade::block_detail
