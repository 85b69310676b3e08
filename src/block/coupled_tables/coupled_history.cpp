// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/coupled_tables/coupled_history.hpp"

#include <algorithm>
#include <cmath>

namespace glissade::block_detail {
namespace {

/// U(i) - U(from) - V(from) t: the displacement beyond that of the velocity at `from`.
double displacement_beyond(const GroundTable& ground, std::size_t from, std::size_t i, double t) {
  const GroundNode &a = ground.nodes()[from], &b = ground.nodes()[i];
  return (b.displacement_m - a.displacement_m) + (b.displacement_low_m - a.displacement_low_m) -
         a.velocity_mps * t;
}

Block downhill(Block block) {
  block.slope_rad = std::abs(block.slope_rad);
  return block;
}

}  // namespace

CoupledHistory::CoupledHistory(const CoupledTable& table, const CoupledTable* yielding_table,
                               const CoupledContact& contact, const Subdivision& subdivision,
                               const CoupledScene& scene, double intensity,
                               std::span<const double> thresholds_m, std::span<Crossing> crossings)
    : elastic_table_(table),
      yielding_table_(yielding_table),
      table_(&table),
      contact_(contact),
      subdivision_(subdivision),
      block_(downhill(scene.block)),
      intensity_(intensity),
      w_factor_(scene.factors.vertical),
      step_s_(table.nodes().a.step_s()),
      cot_slope_(contact.cot_slope()),
      has_limits_(contact.sin_slope() > 0.0 || scene.building.yielding.yields()),
      body_(contact, subdivision.building, block_, CoupledBody::Keeps::peaks,
            scene.building.yielding),
      watched_(!thresholds_m.empty()),
      quiet_from_(table.nodes().quiet),
      end_(contact.slides_at_rest() ? table.nodes().a.last_sample()
                                    : quiet_from_ + longest_ring_down(step_s_)) {
  body_.crossings() = {thresholds_m, crossings, contact_.cos_slope()};
  for (const int direction : {-1, 0, 1}) {
    const auto margin = [&](const CoupledTable& of) {
      return of.contact_margin_mps2(direction, intensity, w_factor_);
    };
    const std::size_t k = CoupledTable::index(direction);
    contact_margin_mps2_[0][k] = margin(table);
    if (yielding_table != nullptr) contact_margin_mps2_[1][k] = margin(*yielding_table);
  }
}

Roof CoupledHistory::ground(std::size_t node) const {
  if (ringing_down_) return {};
  return {intensity_ * (table_->sign() * nodes().a.acceleration_mps2()[node]),
          nodes().vertical ? w_factor_ * nodes().w.acceleration_mps2()[node] : 0.0};
}

LinearGround CoupledHistory::ground_after(std::size_t node) const {
  const Roof begin = ground(node), end = ground(node + 1);
  return {begin, {end.a - begin.a, end.w - begin.w}};
}

RoofState CoupledHistory::roof(std::size_t node) const {
  const RegimeOscillator& r = regime();
  RoofState state = r.free_state(free_ * r.power(node - from_));
  state.x -= r.contact.weight * r.gravity_mps2;
  if (ringing_down_) return state;
  const CoupledTable::Response& response = table_->response(body_.direction());
  return state + RoofState{intensity_ * response.x[node], intensity_ * response.y[node]};
}

/// Makes this node the reference of what follows.
void CoupledHistory::set_reference(std::size_t node, const RoofState& roof, double speed_mps) {
  yield_side_ = body_.yield_side();
  table_ = yield_side_ != 0 && yielding_table_ != nullptr ? yielding_table_ : &elastic_table_;
  by_scalar_scheme_ = yield_side_ != 0 && yielding_table_ == nullptr;
  const RegimeOscillator& r = regime();
  const CoupledTable::Response& response = table_->response(body_.direction());
  const double weight = r.contact.weight * r.gravity_mps2, table = ringing_down_ ? 0.0 : intensity_;
  node_ = from_ = node;
  RoofState free{roof.x + weight, roof.y};
  if (!ringing_down_)
    free = free - RoofState{intensity_ * response.x[node], intensity_ * response.y[node]};
  free_ = r.free_amplitude(free);
  roof_from_ = roof;
  speed_from_ = speed_mps;
  elastic_ = body_.spring_forces();
  const std::size_t k = CoupledTable::index(body_.direction());
  const double size = free_.size(), margin = ringing_down_
                                                 ? contact_.gravity() * cot_slope_
                                                 : contact_margin_mps2_[yield_side_ != 0][k];
  may_lift_ = !(r.s2_size * size < margin);
  spring_may_change_ =
      yield_side_ != 0 || !(table * response.largest_x_mps2 + r.omega2 * size + std::abs(weight) <
                            std::min(-elastic_.lowest, elastic_.highest));
}

/// From the reference to a node.
double CoupledHistory::speed(std::size_t node, const RoofState& now) const {
  const DriveLine& line = regime().contact.drive;
  double roof_gain = (now.y - roof_from_.y) * regime().per_omega, fall = 0.0;
  if (!ringing_down_) {
    const auto gain = [&](const GroundTable& of) {
      return of.velocity_mps()[node] - of.velocity_mps()[from_];
    };
    roof_gain += intensity_ * (table_->sign() * gain(nodes().a));
    if (nodes().vertical) fall = w_factor_ * gain(nodes().w);
  }
  return speed_from_ + line.a * roof_gain + line.w * fall + line.constant * time_s(node - from_);
}

double CoupledHistory::travel(std::size_t node, const RoofState& now) const {
  const DriveLine& line = regime().contact.drive;
  const double t = time_s(node - from_);
  double roof_displacement =
             (now.x - roof_from_.x) * regime().per_omega2 - roof_from_.y * regime().per_omega * t,
         fall = 0.0;
  if (!ringing_down_) {
    roof_displacement +=
        intensity_ * (table_->sign() * displacement_beyond(nodes().a, from_, node, t));
    if (nodes().vertical) fall = w_factor_ * displacement_beyond(nodes().w, from_, node, t);
  }
  return speed_from_ * t + line.a * roof_displacement + line.w * fall + 0.5 * line.constant * t * t;
}

/// Makes its present node the reference.
void CoupledHistory::set_reference_here() {
  const RoofState now = roof(node_);
  double speed_now = 0.0;
  if (body_.sliding()) {
    speed_now = speed(node_, now);
    slid(travel(node_, now), time_s(node_ - from_), node_ - 1);
  }
  body_.resume(now, speed_now, time_s(node_));
  if (watched_) {
    body_at_phase_ = body_;
    phase_node_ = node_;
  }
  set_reference(node_, now, speed_now);
}

/// From here on the tables are zero, and the free vibration is all there is.
void CoupledHistory::begin_ring_down() {
  set_reference_here();
  ringing_down_ = true;
  set_reference(node_, roof_from_, speed_from_);
}

bool CoupledHistory::finished() const {
  return ringing_down_ && !body_.sliding() && !spring_may_change_ &&
         cannot_slip(block_, regime().s2_size * free_.size(), 0.0);
}

bool CoupledHistory::run() {
  set_reference(0, {}, 0.0);
  while (node_ < end_) {
    if (!ringing_down_ && node_ == quiet_from_) begin_ring_down();
    if (finished()) break;
    const std::size_t to = std::min(
        end_, ringing_down_ ? node_ + CoupledTable::zeros - CoupledTable::tile : quiet_from_);
    node_ = next_interval(to);
    if (node_ < to && !solve_interval(node_)) return false;
  }
  set_reference_here();
  if (contact_.stops_at_rest()) body_.coast();
  return true;
}

SlipResult CoupledHistory::result() const {
  SlipResult slip = body_.result().slip;
  slip.free_sliding = contact_.slides_at_rest();
  return slip;
}

/// The block slid so far since the reference; thresholds are looked for phase by phase.
void CoupledHistory::slid(double distance_m, double duration_s, std::size_t end_interval) {
  const double to = body_.slip() + body_.direction() * distance_m;
  if (watched_ && body_.crossings().reached(to)) {
    CoupledBody again = *body_at_phase_;
    again.crossings() = body_.crossings();
    for (std::size_t i = phase_node_; i <= end_interval && again.crossings().reached(to); ++i)
      advance(again, i, ground_after(i));
    // To rounding, it may be reached only now.
    again.crossings().arrive(to, again.speed(), time_s(end_interval + 1));
    body_.crossings() = again.crossings();
  }
  body_.slid(distance_m, duration_s);
}

void CoupledHistory::advance(CoupledBody& body, std::size_t interval,
                             const LinearGround& ground) const {
  for (int part = 0; part < subdivision_.pieces; ++part) {
    const double y0 = static_cast<double>(part) / subdivision_.pieces,
                 y1 = static_cast<double>(part + 1) / subdivision_.pieces;
    body.advance({step_s_ / subdivision_.pieces, ground.after(y0).at, ground.after(y1).at},
                 time_s(interval, y1));
  }
}

/// The interval by the scalar scheme.
void CoupledHistory::by_reference_scheme(const IntervalState& now) {
  node_ = now.interval;
  if (!by_scalar_scheme_) set_reference_here();
  advance(body_, now.interval, now.ground);
  if (watched_) {
    body_at_phase_ = body_;
    phase_node_ = now.interval + 1;
  }
  set_reference(now.interval + 1, body_.spring_roof(), body_.speed());
}

}  // namespace glissade::block_detail
