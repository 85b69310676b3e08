// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/events/coupled_body.hpp"

#include <algorithm>

#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail {

namespace {

constexpr int most_events = 64;  // in a piece of 1/16 period: some ten occur

}  // namespace

CoupledBody::CoupledBody(const CoupledContact& contact, const BuildingOscillator& building,
                         const Block& block, const Yielding& yielding)
    : contact_(contact),
      building_(building),
      block_(block),
      has_static_friction_(block.law.static_over_sliding > 1.0 && block.friction.along > 0.0),
      energy_(building, contact),
      spring_(yielding) {}

ContactRegime CoupledBody::regime() const {
  if (direction_ == 0) return contact_.stuck();
  if (lifted_) return contact_.lifted(direction_);
  return direction_ > 0 ? contact_.sliding_down() : contact_.sliding_up();
}

/// A phase that begins at its threshold has its drive exactly zero there, and rising.
SlipSeries CoupledBody::slip_series(const ContactRegime& regime, const RoofMotionSeries& roof,
                                    double length_s) const {
  SlipSeries slip;
  slip.direction = direction_;
  if (direction_ == 0) return slip;
  Series drive = roof.line(regime.drive);
  if (after_.drive_is_zero) {
    drive.c[0] = 0.0;
    drive.c[1] = std::max(drive.c[1], 0.0);
  }
  slip.speed = drive.integral(length_s, speed_);
  slip.friction = lifted_ ? 0.0 : block_.friction.along;
  return slip;
}

/// When the block starts from rest. Its drive is zero or less in the direction in which it has just
/// stopped.
double CoupledBody::start_fraction(const RoofMotionSeries& roof, double a_change,
                                   int direction) const {
  const DriveLine line = lifted_         ? contact_.frictionless(direction)
                         : direction > 0 ? contact_.at_rest().down()
                                         : contact_.at_rest().up();
  if (roof.is_negative(line, a_change)) return never;
  Series drive = roof.line(line);
  if (after_.stopped_direction == direction) {
    drive.c[0] = std::min(drive.c[0], 0.0);
    if (after_.no_restart) drive.c[1] = std::min(drive.c[1], 0.0);
  }
  return first_rise(drive);
}

/// When contact is lost, or regained.
double CoupledBody::contact_fraction(const RoofMotionSeries& roof, double a_change) const {
  if (contact_frozen_ || (!lifted_ && roof.is_negative(contact_.lift(), a_change))) return never;
  Series lift = roof.line(contact_.lift());
  if (after_.normal_force_is_zero) lift.c[0] = 0.0;
  return lifted_ ? first_fall(lift) : first_rise(lift);
}

CoupledBody::NextEvent CoupledBody::first_event(const RoofMotionSeries& roof,
                                                const SlipSeries& slip) const {
  NextEvent next;
  const double a_change = roof.largest_change();
  if (direction_ == 0) {
    next.sooner(Event::starts_down, start_fraction(roof, a_change, +1));
    if (block_.directions == SlipDirections::both)
      next.sooner(Event::starts_up, start_fraction(roof, a_change, -1));
  } else {
    next.sooner(Event::stops, first_fall(slip.speed));
  }
  next.sooner(Event::lifts_or_lands, contact_fraction(roof, a_change));
  if (spring_.yielding()) {
    next.sooner(Event::unloads, spring_.unload_fraction(roof.y));
  } else if (spring_.yields()) {
    next.sooner(Event::yields_up, spring_.yield_fraction(roof.x, +1));
    next.sooner(Event::yields_down, spring_.yield_fraction(roof.x, -1));
  }
  return next;
}

void CoupledBody::advance(GroundPiece ground, double end_time_s) {
  piece_end_ = end_time_s;
  for (int events = 0; events < most_events; ++events) {
    const ContactRegime now = regime();
    const RoofMotionSeries roof = roof_motion_series(building_, now, contact_.gravity(), roof_,
                                                     spring_.line(roof_.x), ground);
    const SlipSeries slip = slip_series(now, roof, ground.length_s);
    // With no normal force a block may lift and land without end.
    contact_frozen_ = events > most_events / 2;
    const NextEvent next = first_event(roof, slip);
    pass(ground, roof, slip, next);
    ground.keep_after(next.fraction);
    if (next.event == Event::none) time_ = piece_end_;
    apply(next);
    record(ground);
    if (next.event == Event::none || !(ground.length_s > 0.0)) {
      after_ = {};
      return;
    }
  }
  throw NotConverged("slide_coupled: too many events inside one piece of time");
}

void CoupledBody::pass(const GroundPiece& ground, const RoofMotionSeries& roof,
                       const SlipSeries& slip, const NextEvent& next) {
  const double fraction = next.fraction;
  const auto raise = [fraction](double& peak, const Series& of) {
    if (of.bound() > peak) peak = std::max(peak, largest(of, fraction));
  };
  raise(peak_resisting_mps2_, roof.resisting);
  raise(peak_x_mps2_, roof.x);
  raise(result_.peak_roof_acceleration_mps2, roof.a);
  energy_.add(ground, roof, slip, fraction);
  result_.slip.uplift |= lifted_;
  if (direction_ != 0) {
    double& peak = result_.slip.peak_velocity_mps;
    if (slip.speed.bound() > peak) peak = std::max(peak, highest(slip.speed, fraction));
    const double begin = slip_;
    slip_ += direction_ * std::max(slip.speed.integral(ground.length_s, 0.0).at(fraction), 0.0);
    result_.slip.path_length_m += std::abs(slip_ - begin);
    if (crossings_.reached(slip_))
      crossings_.follow({direction_, begin, slip_, time_}, slip.speed, ground.length_s, fraction,
                        next.event == Event::stops);
    speed_ = std::max(slip.speed.at(fraction), 0.0);
    result_.slip.slip_duration_s += fraction * ground.length_s;
  }
  if (spring_.yields()) spring_.pass(roof.x, fraction);
  roof_ = {roof.x.at(fraction), roof.y.at(fraction)};
  time_ = std::min(time_ + fraction * ground.length_s, piece_end_);
}

/// The transitions: what each event changes, and what it leaves exactly at zero (AfterEvent).
void CoupledBody::apply(const NextEvent& next) {
  const bool at_once = next.fraction == 0.0;  // where the last event was
  AfterEvent after;
  after.stopped_direction = has_static_friction_ && !at_once ? 0 : after_.stopped_direction;
  switch (next.event) {
    case Event::starts_down:
    case Event::starts_up: {
      const int direction = next.event == Event::starts_down ? +1 : -1;
      after.drive_is_zero =
          at_once ? after_.stopped_direction == direction : lifted_ || !has_static_friction_;
      after.stopped_direction = 0;
      start(direction);
      break;
    }
    case Event::stops:
      after.no_restart = at_once && (after_.drive_is_zero || has_static_friction_);
      after.stopped_direction = direction_;
      stop();
      break;
    case Event::lifts_or_lands:
      after.normal_force_is_zero = true;
      after.no_restart = after_.no_restart;
      lifted_ = !lifted_;
      break;
    case Event::yields_up:  // of the spring: forces do not jump, only their rates
    case Event::yields_down:
    case Event::unloads:
      after.drive_is_zero = at_once && after_.drive_is_zero;
      after.normal_force_is_zero = at_once && after_.normal_force_is_zero;
      if (next.event == Event::unloads)
        roof_.y = spring_.unload(roof_.y);
      else
        spring_.yield(next.event == Event::yields_up ? +1 : -1);
      break;
    case Event::none:
      return;
  }
  after_ = after;
}

void CoupledBody::start(int direction) {
  direction_ = direction;
  ++result_.slip.slip_phases;
}

/// Slip is monotone inside a phase, so its peaks are at phase ends.
void CoupledBody::stop() {
  direction_ = 0;
  speed_ = 0.0;
  farthest_down_ = std::max(farthest_down_, slip_);
  farthest_up_ = std::min(farthest_up_, slip_);
}

void CoupledBody::record(const GroundPiece& ground) const {
  if (!history_) return;
  const ContactRegime now = regime();
  const double resisting = -(spring_.force(roof_.x) + 2.0 * building_.damping_ratio * roof_.y);
  const double a =
      building_.rigid()
          ? ground.begin.a
          : (resisting - now.weight * (contact_.gravity() + ground.begin.w)) / now.mass;
  const double per_omega = building_.rigid() ? 0.0 : 1.0 / building_.omega_radps;
  history_({time_, slip_ * contact_.cos_slope(), direction_ * speed_ * contact_.cos_slope(),
            roof_.x * per_omega * per_omega, a, spring_.force(roof_.x)});
}

void CoupledBody::coast() {
  const Drive at_rest = contact_.sliding({});
  const double deceleration = direction_ > 0 ? -at_rest.down : -at_rest.up;
  if (direction_ == 0 || !(deceleration > 0.0)) return;
  const double begin = slip_;
  slip_ += direction_ * 0.5 * speed_ * speed_ / deceleration;
  result_.slip.path_length_m += std::abs(slip_ - begin);
  crossings_.follow_to_rest({direction_, begin, slip_, time_}, speed_, deceleration);
  result_.slip.slip_duration_s += speed_ / deceleration;
  time_ += speed_ / deceleration;
  velocity_before_coast_ = direction_ * speed_;
  direction_ = 0;
  speed_ = 0.0;
}

/// Of the block's mass and the building's, elastic about the position of zero spring force.
Envelope CoupledBody::free_vibration() const {
  const double mass = contact_.stuck().mass, root = std::sqrt(mass);
  return free_vibration_envelope(spring_.force(roof_.x) / mass, roof_.y / root,
                                 building_.damping_ratio / root);
}

bool CoupledBody::may_yield() const {
  return spring_.yields() &&
         spring_.may_yield(roof_.x, contact_.stuck().mass * free_vibration().amplitude);
}

double CoupledBody::largest_acceleration_to_come_mps2() const {
  if (building_.rigid()) return 0.0;
  const double zeta = building_.damping_ratio / std::sqrt(contact_.stuck().mass);
  return (1.0 + 2.0 * zeta) * free_vibration().amplitude;
}

CoupledResult CoupledBody::result() const {
  CoupledResult r = result_;
  const double cosine = contact_.cos_slope();
  set_peaks(std::max(farthest_down_, slip_) * cosine, std::min(farthest_up_, slip_) * cosine,
            slip_ * cosine, r.slip);
  r.slip.path_length_m *= cosine;
  r.slip.peak_velocity_mps *= cosine;
  r.peak_base_shear = peak_resisting_mps2_ / contact_.gravity();
  r.ductility = peak_x_mps2_ / spring_.limit();
  if (!building_.rigid()) {
    const double square = building_.omega_radps * building_.omega_radps;
    r.peak_roof_displacement_m = peak_x_mps2_ / square;
    r.residual_roof_displacement_m = spring_.offset(roof_.x) / square;
  }
  r.energy = energy_.total(roof_, spring_, direction_ * speed_ + velocity_before_coast_);
  return r;
}

}  // namespace glissade::block_detail
