// SPDX-License-Identifier: GPL-3.0-or-later
// What happens in an interval, as far as bounds on derivatives prove that nothing else does.
#include "block/coupled_tables/coupled_history.hpp"

namespace glissade::block_detail {
namespace {

/// A drive over what is left of an interval from its share y on, where the amplitude is z.
Curve drive(const LinearGround& ground, const Regime& r, const DriveLine& line, double y,
            Amplitude z) {
  return {line.at(ground.after(y).at), line.a * ground.change.a + line.w * ground.change.w, 0.0,
          line.a * (r.s2 * z)};
}

/// The speed, the same, where it is v.
Curve speed_curve(const LinearGround& ground, const Regime& r, double y, Amplitude z, double v) {
  const DriveLine& line = r.mode.drive;
  const Amplitude b = line.a * (r.s * z);
  return {v - b.re, r.dt_s * line.at(ground.after(y).at),
          0.5 * r.dt_s * (line.a * ground.change.a + line.w * ground.change.w), b};
}

/// What is gained in speed up to the share t of an interval, and the way that this adds.
struct Gain {
  double speed, distance;
};
Gain gain(const Curve& speed, const Regime& r, double t, Amplitude z,
          const Regime::Growth& growth) {
  return {t * (speed.c1 + t * speed.c2) + real(speed.b, growth.minus_one),
          r.dt_s * t * t * (speed.c1 / 2.0 + t * speed.c2 / 3.0) +
              r.mode.drive.a * real(z, growth.minus_line)};
}

}  // namespace

bool CoupledHistory::look_into(std::size_t interval) {
  Visit visit{interval, ground_after(interval), roof(interval), {}, 0.0};
  visit.z = regime().amplitude(visit.roof, visit.ground);
  if (body_.sliding()) visit.speed = speed(interval, visit.roof);
  if (watched_) {
    opening_ = body_;
    if (body_.sliding()) opening_->slid(travel(interval, visit.roof), time_s(interval - from_));
    opening_->resume(visit.roof, visit.speed, time_s(interval));
  }
  if (!(body_.sliding() ? slide_in(visit) : rest_in(visit))) by_body(visit);
  return !body_.has_lifted();
}

/// False: not proven.
bool CoupledHistory::rest_in(const Visit& visit) {
  const Regime& r = regime();
  int direction = 0;
  BoundedCurve::Root root{};
  for (const int candidate : {+1, -1}) {
    const Curve f =
        drive(visit.ground, r, candidate > 0 ? contact_.down() : contact_.up(), 0.0, visit.z);
    const BoundedCurve bounded(f, r, 1.0, r.per_interval());
    const Proof proof = bounded.proof();
    if (proof == Proof::negative) continue;
    if (proof == Proof::unknown || direction != 0) return false;
    direction = candidate;
    root = bounded.root();
    if (!root.found) return false;
  }
  node_ = visit.interval + 1;
  if (direction == 0) return true;
  const RoofState at_start = r.state(visit.z * root.power, visit.ground.after(root.t));
  const std::optional<Begin> phase = begin(visit, root.t, at_start, direction, false);
  if (phase) start(visit, *phase);
  return phase.has_value();
}

/// Of a phase from the share y on, if it is proven that it does not end in the interval.
std::optional<CoupledHistory::Begin> CoupledHistory::begin(const Visit& visit, double y,
                                                           const RoofState& roof, int direction,
                                                           bool reverses) const {
  const Regime& r = table_.regime(direction);
  const Amplitude z = r.amplitude(roof, visit.ground.after(y));
  const double left = 1.0 - y;
  const Regime::Growth growth = r.after(left);
  const Amplitude to_end = growth.power;
  const Curve f = drive(visit.ground, r, r.mode.drive, y, z), minus = -f;
  if (reverses) {
    if (BoundedCurve(minus, r, left, to_end).proof() != Proof::negative) return {};
  } else {
    const BoundedCurve bounded(f, r, left, to_end);
    if (!bounded.never_falls() || !(bounded.end() > 0.0)) return {};
  }
  const Curve v = speed_curve(visit.ground, r, y, z, 0.0);
  const Gain gained = gain(v, r, left, z, growth);
  const Begin phase{direction, r.state(z * to_end, visit.ground.after(1.0)), gained.distance,
                    gained.speed, left * step_s_};
  if (!(phase.speed > 0.0 && phase.distance >= 0.0)) return {};
  return phase;
}

void CoupledHistory::start(const Visit& visit, const Begin& phase) {
  if (watched_) {
    before_ = opening_;
    before_node_ = visit.interval;
  }
  body_.start(phase.direction);
  slid(phase.distance, phase.duration, visit.interval);
  be_at(visit.interval + 1, phase.roof, phase.speed);
  young_ = true;
}

bool CoupledHistory::slide_in(const Visit& visit) {
  const Regime& r = regime();
  const int direction = body_.direction();
  const Curve v = speed_curve(visit.ground, r, 0.0, visit.z, visit.speed), minus = -v;
  const BoundedCurve bounded(minus, r, 1.0, r.per_interval());
  const Proof proof = bounded.proof();
  if (proof == Proof::negative) {
    node_ = visit.interval + 1;
    return true;
  }
  if (proof == Proof::unknown) return false;
  const BoundedCurve::Root stop = bounded.root();
  if (!stop.found) return false;
  const double y = stop.t;
  const Amplitude z = visit.z * stop.power;
  const LinearGround ground = visit.ground.after(y);
  const RoofState at_stop = r.state(z, ground);

  // The other direction's drive decides: never the one it stopped in.
  const Regime& stuck = table_.regime(0);
  const Amplitude z_stuck = stuck.amplitude(at_stop, ground);
  const DriveLine other = direction > 0 ? contact_.up() : contact_.down();
  const Curve back = drive(visit.ground, stuck, other, y, z_stuck);
  std::optional<Begin> reversal;
  if (back.c0 + back.b.re > 0.0) {
    reversal = begin(visit, y, at_stop, -direction, true);
    if (!reversal) return false;
  } else if (!rests(visit, y, z_stuck)) {
    return false;
  }
  slid(travel(visit.interval, visit.roof) +
           (visit.speed * y * step_s_ + gain(v, r, y, visit.z, r.after(y)).distance),
       time_s(visit.interval - from_, y), visit.interval);
  body_.stop();
  if (reversal) {
    start(visit, *reversal);
  } else {
    be_at(visit.interval + 1,
          stuck.state(z_stuck * stuck.after(1.0 - y).power, visit.ground.after(1.0)), 0.0);
  }
  return true;
}

/// It stays at rest from the share y to the interval's end.
bool CoupledHistory::rests(const Visit& visit, double y, Amplitude z) const {
  const Regime& r = table_.regime(0);
  const Amplitude to_end = r.after(1.0 - y).power;
  for (const DriveLine& line : {contact_.down(), contact_.up()}) {
    const Curve f = drive(visit.ground, r, line, y, z);
    if (BoundedCurve(f, r, 1.0 - y, to_end).proof() != Proof::negative) return false;
  }
  return true;
}

}  // namespace glissade::block_detail
