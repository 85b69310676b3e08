// SPDX-License-Identifier: GPL-3.0-or-later
// What happens in an interval, as far as bounds on derivatives prove that nothing else does.
#include "block/coupled_tables/coupled_history.hpp"

namespace glissade::block_detail {
namespace {

/// A drive over what is left of an interval from its fraction tau on, where the amplitude is z.
Curve drive(const LinearGround& ground, const RegimeOscillator& r, const DriveLine& line,
            double tau, Amplitude z) {
  return {line.at(ground.after(tau).at), line.a * ground.change.a + line.w * ground.change.w, 0.0,
          line.a * (r.s2 * z)};
}

/// The speed, the same, where it is v.
Curve speed_curve(const LinearGround& ground, const RegimeOscillator& r, double tau, Amplitude z,
                  double v) {
  const DriveLine& line = r.contact.drive;
  const Amplitude b = line.a * (r.s * z);
  return {v - b.re, r.dt_s * line.at(ground.after(tau).at),
          0.5 * r.dt_s * (line.a * ground.change.a + line.w * ground.change.w), b};
}

/// What is gained in speed up to the fraction t of an interval, and the displacement that this
/// adds.
struct Gain {
  double speed, distance;
};
Gain gain(const Curve& speed, const RegimeOscillator& r, double t, Amplitude z,
          const RegimeOscillator::Growth& growth) {
  return {t * (speed.c1 + t * speed.c2) + real(speed.b, growth.minus_one),
          r.dt_s * t * t * (speed.c1 / 2.0 + t * speed.c2 / 3.0) +
              r.contact.drive.a * real(z, growth.minus_line)};
}

}  // namespace

bool CoupledHistory::solve_interval(std::size_t interval) {
  IntervalState now{interval, ground_after(interval), roof(interval), {}, 0.0};
  now.z = regime().amplitude(now.roof, now.ground);
  if (body_.sliding()) now.speed = speed(interval, now.roof);
  if (watched_) {
    body_before_ = body_;
    if (body_.sliding()) body_before_->slid(travel(interval, now.roof), time_s(interval - from_));
    body_before_->resume(now.roof, now.speed, time_s(interval));
  }
  if (limit_ahead_ || !(body_.sliding() ? slide_in(now) : rest_in(now))) by_reference_scheme(now);
  return !body_.has_lifted();
}

/// False: not proven.
bool CoupledHistory::rest_in(const IntervalState& now) {
  const RegimeOscillator& r = regime();
  int direction = 0;
  BoundedCurve::Root root{};
  for (const int candidate : {+1, -1}) {
    const DriveLine line = candidate > 0 ? contact_.at_rest().down() : contact_.at_rest().up();
    const Curve f = drive(now.ground, r, line, 0.0, now.z);
    const BoundedCurve bounded(f, r, 1.0, r.per_interval());
    const Proof proof = bounded.proof();
    if (proof == Proof::negative) continue;
    if (proof == Proof::unknown || direction != 0) return false;
    direction = candidate;
    root = bounded.root();
    if (!root.found) return false;
  }
  node_ = now.interval + 1;
  if (direction == 0) return true;
  const RoofState at_start = r.state(now.z * root.power, now.ground.after(root.t));
  const std::optional<Begin> phase =
      begin(now, root.t, at_start, direction, block_.law.static_over_sliding > 1.0);
  if (phase) start(now, *phase);
  return phase.has_value();
}

/// Of a phase from the fraction tau on, if it is proven that it does not end in the interval.
/// @param drive_jumps to above zero: after a reversal, or where static friction is exceeded
std::optional<CoupledHistory::Begin> CoupledHistory::begin(const IntervalState& now, double tau,
                                                           const RoofState& roof, int direction,
                                                           bool drive_jumps) const {
  const RegimeOscillator& r = table_->regime(direction);
  const Amplitude z = r.amplitude(roof, now.ground.after(tau));
  const double left = 1.0 - tau;
  const RegimeOscillator::Growth growth = r.after(left);
  const Amplitude to_end = growth.power;
  const Curve f = drive(now.ground, r, r.contact.drive, tau, z), minus = -f;
  if (drive_jumps) {
    if (BoundedCurve(minus, r, left, to_end).proof() != Proof::negative) return {};
  } else {
    const BoundedCurve bounded(f, r, left, to_end);
    if (!bounded.never_falls() || !(bounded.end() > 0.0)) return {};
  }
  const Curve v = speed_curve(now.ground, r, tau, z, 0.0);
  const Gain gained = gain(v, r, left, z, growth);
  const Begin phase{direction, r.state(z * to_end, now.ground.after(1.0)), gained.distance,
                    gained.speed, left * step_s_};
  if (!(phase.speed > 0.0 && phase.distance >= 0.0)) return {};
  if (has_limits_ && !within_limits(r, left, z, now.ground.after(tau), roof, phase.roof)) return {};
  return phase;
}

void CoupledHistory::start(const IntervalState& now, const Begin& phase) {
  if (watched_) {
    body_at_phase_ = body_before_;
    phase_node_ = now.interval;
  }
  body_.start(phase.direction);
  slid(phase.distance, phase.duration, now.interval);
  set_reference(now.interval + 1, phase.roof, phase.speed);
  phase_began_ = true;
}

bool CoupledHistory::slide_in(const IntervalState& now) {
  const RegimeOscillator& r = regime();
  const int direction = body_.direction();
  const Curve v = speed_curve(now.ground, r, 0.0, now.z, now.speed), minus = -v;
  const BoundedCurve bounded(minus, r, 1.0, r.per_interval());
  const Proof proof = bounded.proof();
  if (proof == Proof::negative) {
    node_ = now.interval + 1;
    return true;
  }
  if (proof == Proof::unknown) return false;
  const BoundedCurve::Root stop = bounded.root();
  if (!stop.found) return false;
  const double tau = stop.t;
  const Amplitude z = now.z * stop.power;
  const LinearGround ground = now.ground.after(tau);
  const RoofState at_stop = r.state(z, ground);

  // The other direction's drive decides: never the one it stopped in.
  const RegimeOscillator& stuck = table_->regime(0);
  const Amplitude z_stuck = stuck.amplitude(at_stop, ground);
  const DriveLine other = direction > 0 ? contact_.at_rest().up() : contact_.at_rest().down();
  const Curve back = drive(now.ground, stuck, other, tau, z_stuck);
  const Amplitude to_end = stuck.after(1.0 - tau).power;
  std::optional<Begin> reversal;
  if (back.c0 + back.b.re > 0.0) {
    reversal = begin(now, tau, at_stop, -direction, true);
    if (!reversal) return false;
  } else if (!rests(now, tau, z_stuck, to_end)) {
    return false;
  }
  slid(travel(now.interval, now.roof) +
           (now.speed * tau * step_s_ + gain(v, r, tau, now.z, r.after(tau)).distance),
       time_s(now.interval - from_, tau), now.interval);
  body_.stop();
  if (reversal) {
    start(now, *reversal);
  } else {
    set_reference(now.interval + 1, stuck.state(z_stuck * to_end, now.ground.after(1.0)), 0.0);
  }
  return true;
}

/// The same from here to the end of the interval, between two states.
bool CoupledHistory::within_limits(const RegimeOscillator& r, double length, Amplitude z,
                                   const LinearGround& ground, const RoofState& begin,
                                   const RoofState& end) const {
  const double phase = r.phase * length, bend = 0.125 * phase * phase * r.s2_size * z.size();
  return within_limits(r, bend, begin, ground.at) &&
         within_limits(r, bend, end, ground.after(length).at);
}

/// In contact, and elastic or yielding as now, at a node and beside it where a leaves its chord by
/// no more than `bend`.
bool CoupledHistory::within_limits(const RegimeOscillator& r, double bend, const RoofState& roof,
                                   const Roof& at) const {
  const double g = r.gravity_mps2 + at.w, bend_x = r.contact.mass * bend;
  return g * cot_slope_ + r.acceleration_mps2(roof, at.w) > bend &&
         roof.x - bend_x > elastic_.lowest && roof.x + bend_x < elastic_.highest &&
         (yield_side_ == 0 || yield_side_ * roof.y > std::sqrt(r.contact.mass) * bend);
}

/// It stays at rest from the fraction tau to the interval's end.
bool CoupledHistory::rests(const IntervalState& now, double tau, Amplitude z,
                           Amplitude to_end) const {
  const RegimeOscillator& r = table_->regime(0);
  const LinearGround ground = now.ground.after(tau);
  if (has_limits_ && !within_limits(r, 1.0 - tau, z, ground, r.state(z, ground),
                                    r.state(z * to_end, now.ground.after(1.0))))
    return false;
  for (const DriveLine& line : {contact_.at_rest().down(), contact_.at_rest().up()}) {
    const Curve f = drive(now.ground, r, line, tau, z);
    if (BoundedCurve(f, r, 1.0 - tau, to_end).proof() != Proof::negative) return false;
  }
  return true;
}

}  // namespace glissade::block_detail
