// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/full_model/body.hpp"

#include "block/events/coupled_motion.hpp"
#include "glissade/core/not_converged.hpp"

namespace glissade::block_detail {
FullModelBody::FullModelBody(const BuildingContact& contact,
                             const std::array<BuildingAxis, 2>& axes, double mass_ratio, int pieces,
                             double piece_s, double tolerance, TwoAxisTrack track)
    : contact_(contact),
      axes_(axes),
      mass_ratio_(mass_ratio),
      accelerance_(contact.accelerance({axes[0].accelerance(), axes[1].accelerance()})),
      pieces_(pieces),
      tolerance_(tolerance),
      friction_bound_(contact.friction_bound(accelerance_)),
      track_(track) {
  const FrictionEllipse& friction = contact_.friction_at_rest();
  const TwoAxisLoading& loading = contact_.loading();
  per_friction_ = {1.0 / friction.along(), 1.0 / friction.across()};
  margin_per_a_ = loading.tan_slope() +
                  std::max(1.0 / friction.along(), 1.0 / (friction.across() * loading.cos_slope()));
  margin_per_w_ = 1.0 + loading.tan_slope() / friction.along();
  if (!axes[0].one_mass() || !axes[1].one_mass())
    rest_maps_ = {axes[0].rest_map(piece_s), axes[1].rest_map(piece_s)};
  slides_at_rest_ = beyond_friction(loading.tan_slope(), friction.along()) > 0.0;
}

void FullModelBody::follow(const Excitation& excitation, double longest_period_s) {
  const double dt = excitation.dt_s();
  // Padding changes nothing, to the last bit; free sliders end with the record.
  const std::size_t n = slides_at_rest_ ? excitation.last_sample() : excitation.quiet_from();
  for (std::size_t i = 0; i < n;) {
    if (at_rest() && pieces_ == 1) i = rest_through(excitation, i, n);
    if (i == n) break;
    interval(excitation.after(i), static_cast<double>(i + 1) * dt);
    ++i;
  }
  if (!slides_at_rest_ && will_stop()) ring_down(dt, longest_period_s);
}

void FullModelBody::ring_down(double dt_s, double longest_period_s) {
  const double last = std::ceil(RoofMotionOptions{}.longest_ring_down_s / dt_s);
  const double from_s = time_s_;
  double at_rest_s = 0.0;
  ExcitationPiece quiet;
  quiet.length_s = dt_s;
  for (std::size_t i = 1;; ++i) {
    if (at_rest() && at_rest_s >= longest_period_s && is_settled()) return;
    if (longest_period_s == 0.0 || static_cast<double>(i) > last) break;
    if (i == 1u << 20) longest_ring_down(dt_s);  // refuses a step that is too short
    interval(quiet, from_s + static_cast<double>(i) * dt_s);
    at_rest_s = at_rest() ? at_rest_s + dt_s : 0.0;
  }
  if (will_stop()) coast(dt_s);
}

void FullModelBody::interval(const ExcitationPiece& excitation, double end_s) {
  if (pieces_ == 1) return advance(excitation, end_s);
  const double begin_s = time_s_;
  for (int i = 0; i < pieces_; ++i) {
    ExcitationPiece piece = excitation;
    const double to = static_cast<double>(i + 1) / pieces_;
    piece.restrict_to(static_cast<double>(i) / pieces_, to);
    advance(piece, i + 1 == pieces_ ? end_s : begin_s + to * (end_s - begin_s));
  }
}

void FullModelBody::advance(ExcitationPiece piece, double end_s) {
  if (!sliding_ && rest_quickly(piece)) {
    time_s_ = end_s;
    return;
  }
  const double whole_s = piece.length_s;
  // Steps shrink geometrically toward a stop, so some dozens suffice in a piece. The bound ends a
  // history whose friction no step can follow: a law that is nearly a jump in speed.
  constexpr std::int64_t steps_of_piece = 50;
  constexpr double nothing_left = 1e-14;  // of the piece: rounding of its length
  for (steps_left_ += steps_of_piece; steps_left_ > 0; --steps_left_) {
    const double fraction = sliding_ ? slide(piece) : rest(piece);
    if (!((1.0 - fraction) * piece.length_s > nothing_left * whole_s)) {
      time_s_ = end_s;
      return;
    }
    time_s_ = std::min(time_s_ + fraction * piece.length_s, end_s);
    piece.keep_after(fraction);
  }
  throw NotConverged("slide_on_building: too many steps");
}

void FullModelBody::raise_peaks(std::size_t axis, const AxisSeries& motion, double fraction) {
  const auto raise = [fraction](double& peak, const Series& of) {
    if (of.bound() > peak) peak = std::max(peak, largest(of, fraction));
  };
  const bool one_mass = axes_[axis].one_mass();
  if ((one_mass ? motion.resisting_bound : motion.shear_bound) > peaks_.shear[axis])
    raise(peaks_.shear[axis], one_mass ? motion.resisting : motion.shear);
  if (motion.x_bound > peaks_.x[axis])
    raise(peaks_.x[axis], one_mass ? motion.x[0] : motion.roof_x);
}

void FullModelBody::start(Vector acceleration, const ExcitationPiece& piece) {
  const double gravity = contact_.loading().gravity() + piece.w(0.0);
  peak_speed_ = std::max(peak_speed_, rounding_speed * piece.length_s * std::abs(gravity));
  sliding_ = true;
  now_ = {{}, acceleration};
  friction_now_ = {};
  step_s_ = never;
  ++phases_;
}

void FullModelBody::coast(double step_s) {
  axes_ = {BuildingAxis({}, {}, 0.0, step_s), BuildingAxis({}, {}, 0.0, step_s)};
  rest_maps_.clear();
  mass_ratio_ = 0.0;
  accelerance_ = {};
  friction_bound_ = contact_.friction_bound(accelerance_);
  const Load load = contact_.loading().at(0.0, 0.0, 0.0);
  const double least_brake =
      contact_.least_factor(now_.v) * contact_.friction().along() * load.normal -
      std::abs(load.drive.s);
  for (int steps = 0; sliding_; ++steps) {
    if (steps == 100000) throw NotConverged("slide_on_building: does not come to rest");
    ExcitationPiece still;
    // A quarter of the longest that can be left, straight down the slope.
    still.length_s = std::max(step_s, 0.25 * length(now_.v) / least_brake);
    advance(still, time_s_ + still.length_s);
  }
}

bool FullModelBody::will_stop() const {
  if (!sliding_) return true;
  const double mu = contact_.least_factor(now_.v) * contact_.friction().along();
  return beyond_friction(contact_.loading().tan_slope(), mu) < 0.0;
}

bool FullModelBody::is_settled() const {
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

SlipResult FullModelBody::result() const {
  SlipResult r = track_.result();
  r.slip_phases = phases_;
  r.uplift = uplift_;
  r.free_sliding = slides_at_rest_ || sliding_;
  return r;
}

}  // namespace glissade::block_detail
