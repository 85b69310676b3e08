// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupled_history.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "coupled_search.hpp"

namespace glissade::block_detail {
namespace {

/// Room for rounding in single precision, relative to the terms of a sum.
constexpr double slack = 1e-6;

constexpr std::array<float, CoupledTable::zeros + CoupledTable::block> zeros{};

/// U(i) - U(from) - V(from) t: the way gone beyond that of the velocity at `from`.
double way(const GroundTable& ground, std::size_t from, std::size_t i, double t) {
  const GroundNode &a = ground.nodes()[from], &b = ground.nodes()[i];
  return (b.displacement_m - a.displacement_m) + (b.displacement_low_m - a.displacement_low_m) -
         a.velocity_mps * t;
}

Block downhill(Block block) {
  block.slope_rad = std::abs(block.slope_rad);
  return block;
}

}  // namespace

CoupledHistory::CoupledHistory(const CoupledTable& table, const CoupledContact& contact,
                               const Cut& cut, const CoupledScene& scene, double intensity,
                               std::span<const double> thresholds_m, std::span<Crossing> crossings)
    : table_(table),
      contact_(contact),
      cut_(cut),
      block_(downhill(scene.block)),
      intensity_(intensity),
      w_factor_(scene.factors.vertical),
      step_s_(table.nodes().a.step_s()),
      most_a_mps2_(std::numeric_limits<double>::infinity()),
      most_x_mps2_(scene.building.yielding.yield_acceleration_mps2),
      body_(contact, cut.frame, block_, CoupledBody::Keeps::peaks),
      watched_(!thresholds_m.empty()),
      quiet_from_(table.nodes().quiet),
      end_(contact.slides_at_rest() ? table.nodes().a.last_sample()
                                    : quiet_from_ + longest_ring_down(step_s_)) {
  body_.crossings() = {thresholds_m, crossings, contact_.cos_slope()};
  const double g = contact_.gravity() - std::abs(w_factor_) * nodes().largest_w_mps2;
  if (contact_.sin_slope() > 0.0) most_a_mps2_ = g * contact_.cos_slope() / contact_.sin_slope();
}

// ---- state

Roof CoupledHistory::ground(std::size_t node) const {
  if (quiet_) return {};
  return {intensity_ * (table_.sign() * nodes().a.acceleration_mps2()[node]),
          nodes().vertical ? w_factor_ * nodes().w.acceleration_mps2()[node] : 0.0};
}

LinearGround CoupledHistory::ground_after(std::size_t node) const {
  const Roof begin = ground(node), end = ground(node + 1);
  return {begin, {end.a - begin.a, end.w - begin.w}};
}

RoofState CoupledHistory::roof(std::size_t node) const {
  const Regime& r = regime();
  RoofState state = r.free_state(free_ * r.power(node - from_));
  state.x -= r.mode.weight * r.gravity_mps2;
  if (quiet_) return state;
  const CoupledTable::Response& response = table_.response(body_.direction());
  return state + RoofState{intensity_ * response.x[node], intensity_ * response.y[node]};
}

/// What follows is reckoned from here.
void CoupledHistory::be_at(std::size_t node, const RoofState& roof, double speed_mps) {
  const Regime& r = regime();
  const CoupledTable::Response& response = table_.response(body_.direction());
  const double weight = r.mode.weight * r.gravity_mps2, table = quiet_ ? 0.0 : intensity_;
  node_ = from_ = node;
  RoofState free{roof.x + weight, roof.y};
  if (!quiet_)
    free = free - RoofState{intensity_ * response.x[node], intensity_ * response.y[node]};
  free_ = r.free_amplitude(free);
  roof_from_ = roof;
  speed_from_ = speed_mps;
  const double size = free_.size();
  fits_ =
      table * response.largest_a_mps2 + r.s2.size() * size < most_a_mps2_ &&
      table * response.largest_x_mps2 + r.omega_radps * r.omega_radps * size + std::abs(weight) <
          most_x_mps2_;
}

/// From the reference to a node.
double CoupledHistory::speed(std::size_t node, const RoofState& now) const {
  const DriveLine& line = regime().mode.drive;
  double roof_gain = (now.y - roof_from_.y) / cut_.frame.omega_radps, fall = 0.0;
  if (!quiet_) {
    const auto gain = [&](const GroundTable& of) {
      return of.velocity_mps()[node] - of.velocity_mps()[from_];
    };
    roof_gain += intensity_ * (table_.sign() * gain(nodes().a));
    if (nodes().vertical) fall = w_factor_ * gain(nodes().w);
  }
  return speed_from_ + line.a * roof_gain + line.w * fall + line.constant * time_s(node - from_);
}

double CoupledHistory::travel(std::size_t node, const RoofState& now) const {
  const DriveLine& line = regime().mode.drive;
  const double t = time_s(node - from_), omega = cut_.frame.omega_radps;
  double roof_way = (now.x - roof_from_.x) / (omega * omega) - roof_from_.y / omega * t, fall = 0.0;
  if (!quiet_) {
    roof_way += intensity_ * (table_.sign() * way(nodes().a, from_, node, t));
    if (nodes().vertical) fall = w_factor_ * way(nodes().w, from_, node, t);
  }
  return speed_from_ * t + line.a * roof_way + line.w * fall + 0.5 * line.constant * t * t;
}

/// Reckons from the node it is at.
void CoupledHistory::catch_up() {
  const RoofState now = roof(node_);
  double speed_now = 0.0;
  if (body_.sliding()) {
    speed_now = speed(node_, now);
    slid(travel(node_, now), time_s(node_ - from_), node_ - 1);
  }
  body_.resume(now, speed_now, time_s(node_));
  if (watched_) {
    before_ = body_;
    before_node_ = node_;
  }
  be_at(node_, now, speed_now);
}

/// From here on the tables are zero, and the free vibration is all there is.
void CoupledHistory::enter_quiet() {
  catch_up();
  quiet_ = true;
  be_at(node_, roof_from_, speed_from_);
}

bool CoupledHistory::over() const {
  return quiet_ && !body_.sliding() && cannot_slip(block_, regime().s2.size() * free_.size(), 0.0);
}

bool CoupledHistory::run() {
  be_at(0, {}, 0.0);
  while (node_ < end_ && fits_) {
    if (!quiet_ && node_ == quiet_from_) enter_quiet();
    if (over()) break;
    const std::size_t to =
        std::min(end_, quiet_ ? node_ + CoupledTable::zeros - CoupledTable::block : quiet_from_);
    node_ = young_ ? node_ : next_interval(to);
    young_ = false;
    if (node_ < to && !look_into(node_)) return false;
  }
  if (!fits_) return false;
  catch_up();
  if (contact_.stops_at_rest()) body_.coast();
  return true;
}

SlipResult CoupledHistory::result() const {
  SlipResult slip = body_.result().slip;
  slip.free_sliding = contact_.slides_at_rest();
  return slip;
}

// ---- search

/// The first interval before node `to` that must be looked into, else `to`.
std::size_t CoupledHistory::next_interval(std::size_t to) const {
  const std::size_t first = quiet_ ? 0 : node_, last = first + (to - node_) + 1;
  const std::size_t found =
      body_.sliding() ? next_stop_in(first, last) : next_start_in(first, last);
  if (found == last) return to;
  return node_ + (found == first ? 0 : found - first - 1);
}

std::size_t CoupledHistory::next_start_in(std::size_t first, std::size_t last) const {
  const Regime& r = regime();
  const CoupledTable::Rest& rest = table_.rest();
  const auto values = [&](const std::vector<float>& v) { return quiet_ ? zeros.data() : v.data(); };
  RestSearch s;
  s.motion = {&r, quiet_ ? 0.0f : static_cast<float>(intensity_),
              r.s2 * (free_ * r.power(node_ - from_))};
  const double low = table_.lowest_per_g() * r.gravity_mps2,
               high = table_.highest_per_g() * r.gravity_mps2,
               room = slack * (intensity_ * rest.largest + s.motion.swing.size() + std::abs(low) +
                               std::abs(high));
  s.lowest = low + room;
  s.highest = high - room;
  s.below = values(rest.below);
  s.above = values(rest.above);
  s.block_below = values(rest.block_below);
  s.block_above = values(rest.block_above);
  s.block_swing = values(table_.response(0).swing);
  return next_start(s, first, last);
}

std::size_t CoupledHistory::next_stop_in(std::size_t first, std::size_t last) const {
  const Regime& r = regime();
  const CoupledTable::Speed& speed = table_.speed(body_.direction());
  const DriveLine& line = r.mode.drive;
  const Amplitude swing = free_ * r.power(node_ - from_);
  SpeedSearch s;
  s.motion = {&r, quiet_ ? 0.0f : static_cast<float>(intensity_), r.s * swing};
  s.gain = quiet_ ? zeros.data() : speed.gain.data();
  s.block_sag = quiet_ ? zeros.data() : speed.block_sag.data();
  double constant =
      speed_from_ - line.a * (roof_from_.y / r.omega_radps) + line.constant * time_s(node_ - from_);
  if (!quiet_) {
    constant -= line.a * intensity_ * (table_.sign() * nodes().a.velocity_mps()[from_]);
    if (nodes().vertical) constant -= line.w * w_factor_ * nodes().w.velocity_mps()[from_];
  }
  const double per_step = line.constant * step_s_,
               size = std::abs(line.a) * (intensity_ * speed.largest + s.motion.swing.size()) +
                      std::abs(constant);
  s.drive_a = static_cast<float>(line.a);
  s.constant = static_cast<float>(constant - slack * size);
  s.per_step = static_cast<float>(per_step - slack * std::abs(per_step));
  s.sag = static_cast<float>(0.125 * step_s_ * std::abs(line.a) * r.phase * (r.s2 * swing).size() *
                             (1.0 + slack));
  return next_stop(s, first, last);
}

// ---- events

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

/// The block slid so far since the reference; thresholds are looked for phase by phase.
void CoupledHistory::slid(double distance_m, double duration_s, std::size_t end_interval) {
  const double to = body_.slip() + body_.direction() * distance_m;
  if (watched_ && body_.crossings().reached(to)) {
    CoupledBody again = *before_;
    again.crossings() = body_.crossings();
    for (std::size_t i = before_node_; i <= end_interval && again.crossings().reached(to); ++i)
      advance(again, i, ground_after(i));
    // To rounding, it may be reached only now.
    again.crossings().arrive(to, again.speed(), time_s(end_interval + 1));
    body_.crossings() = again.crossings();
  }
  body_.slid(distance_m, duration_s);
}

void CoupledHistory::advance(CoupledBody& body, std::size_t interval,
                             const LinearGround& ground) const {
  for (int part = 0; part < cut_.pieces; ++part) {
    const double y0 = static_cast<double>(part) / cut_.pieces,
                 y1 = static_cast<double>(part + 1) / cut_.pieces;
    body.advance({step_s_ / cut_.pieces, ground.after(y0).at, ground.after(y1).at},
                 time_s(interval, y1));
  }
}

/// The interval by the scalar scheme.
void CoupledHistory::by_body(const Visit& visit) {
  node_ = visit.interval;
  catch_up();
  advance(body_, visit.interval, visit.ground);
  if (watched_) {
    before_ = body_;
    before_node_ = visit.interval + 1;
  }
  be_at(visit.interval + 1, body_.roof(), body_.speed());
}

}  // namespace glissade::block_detail
