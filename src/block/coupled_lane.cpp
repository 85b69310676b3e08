// SPDX-License-Identifier: GPL-3.0-or-later
#include "coupled_lane.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade::block_detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<double> vertical_or_zeros(const GroundMotion& motion) {
  if (motion.vertical_mps2.empty()) return {0.0};
  return {motion.vertical_mps2.begin(), motion.vertical_mps2.end()};
}

LaneGround::Largest largest_of(std::span<const double> nodes) {
  LaneGround::Largest largest{std::abs(nodes[0]), 0.0};
  for (std::size_t i = 1; i < nodes.size(); ++i) {
    largest.value = std::max(largest.value, std::abs(nodes[i]));
    largest.change = std::max(largest.change, std::abs(nodes[i] - nodes[i - 1]));
  }
  return largest;
}

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

LaneGround::LaneGround(const GroundMotion& motion, int pieces)
    : a(motion.dt_s, motion.horizontal_mps2, pieces),
      w(motion.dt_s, vertical_or_zeros(motion), pieces),
      vertical(!motion.vertical_mps2.empty()),
      longest_ring_down_nodes(longest_ring_down(motion.dt_s) * static_cast<std::size_t>(pieces)) {
  extend(std::max(quiet_from(), a.last_sample()) + 1);
  largest_a = largest_of(a.acceleration_mps2());
  largest_w = largest_of(w.acceleration_mps2());
}

void LaneGround::extend(std::size_t nodes) {
  a.extend(nodes);
  w.extend(nodes);
}

BankGround LaneGround::nodes() const {
  return {a.acceleration_mps2().data(), vertical ? w.acceleration_mps2().data() : nullptr};
}

bool fits_lane(const CoupledScene& scene, const GroundMotion& ground) {
  const CoupledContact contact(scene.block, std::abs(scene.block.slope_rad),
                               scene.building.mass_ratio);
  double largest_w = 0.0;
  for (const double w : ground.vertical_mps2) largest_w = std::max(largest_w, std::abs(w));
  return !cut(scene.building.horizontal, contact, ground.dt_s).frame.rigid() &&
         scene.block.directions == SlipDirections::both && scene.block.law.is_coulomb() &&
         (contact.slides_at_rest() || contact.stops_at_rest()) && contact.up().a > 0.0 &&
         std::abs(scene.factors.vertical) * largest_w < 0.99 * scene.block.gravity_mps2;
}

CoupledLane::CoupledLane(const CoupledScene& scene, const Cut& cut, const LaneGround& ground,
                         std::span<const double> thresholds_m, std::span<Crossing> crossings)
    : ground_(ground),
      block_(downhill(scene.block)),
      mass_ratio_(scene.building.mass_ratio),
      a_factor_((scene.block.slope_rad < 0.0 ? -1.0 : 1.0) * scene.factors.horizontal),
      w_factor_(scene.factors.vertical),
      step_s_(ground.a.step_s()),
      period_s_(scene.building.horizontal.period_s),
      frame_(cut.frame),
      contact_(block_, block_.slope_rad, mass_ratio_),
      body_(contact_, frame_, block_, CoupledBody::Keeps::peaks) {
  body_.crossings() = {thresholds_m, crossings, contact_.cos_slope()};
  modes_[0].mode = contact_.stuck();
  modes_[1].mode = contact_.sliding_down();
  modes_[2].mode = contact_.sliding_up();
  for (LaneMode& m : modes_) {
    const double root = std::sqrt(m.mode.mass);
    m.step = oscillator_step(frame_.omega_radps * step_s_ / root, frame_.damping_ratio / root);
  }
  elastic_bound_ = y_bound_ = std::abs(a_factor_) * ground.largest_a.value;
  set_limits();
}

Roof CoupledLane::roof_ground(std::size_t node) const {
  return {a_factor_ * ground_.a.acceleration_mps2()[node],
          w_factor_ * ground_.w.acceleration_mps2()[node]};
}

/// mass (u'' + A) = E: the ground and, per mass, what the block's weight does to the roof.
double CoupledLane::forcing(const Mode& mode, std::size_t node) const {
  const Roof ground = roof_ground(node);
  return ground.a + mode.weight / mode.mass * (contact_.gravity() + ground.w);
}

GroundPiece CoupledLane::ground_before(std::size_t node) const {
  return {step_s_, roof_ground(node - 1), roof_ground(node)};
}

void CoupledLane::load(CoupledBank& bank, std::size_t lane) {
  // Node 0 is looked at by the scalar scheme, with the interval after it.
  store_state(bank, lane, 0);
  bank.least_speed[lane] = infinity;
}

void CoupledLane::catch_up(const CoupledBank::State& state, std::size_t lane, std::size_t node) {
  const RoofState roof{state.x[lane], state.y[lane]};
  body_.peaks() = {state.peak[lane], state.peak_x[lane]};
  if (node > base_ && body_.sliding()) {
    const DriveLine& drive = mode().mode.drive;
    const double t = static_cast<double>(node - base_) * step_s_, omega = frame_.omega_radps;
    const double roof_way = (roof.x - base_roof_.x) / (omega * omega) - base_roof_.y / omega * t +
                            a_factor_ * way(ground_.a, base_, node, t);
    const double fall =
        0.5 * contact_.gravity() * t * t + w_factor_ * way(ground_.w, base_, node, t);
    const double gone = base_speed_ * t + drive.a * roof_way + drive.w * fall;
    const double to = body_.slip() + body_.direction() * gone;
    if (body_.crossings().reached(to)) cross(to, node);
    body_.slid(gone, t);
  }
  body_.resume(roof, body_.sliding() ? state.speed[lane] : 0.0,
               static_cast<double>(node) * step_s_);
}

void CoupledLane::cross(double to, std::size_t node) {
  CoupledBody again = body_;
  again.resume(base_roof_, base_speed_, static_cast<double>(base_) * step_s_);
  for (std::size_t i = base_ + 1; i <= node && again.crossings().reached(to); ++i)
    again.advance(ground_before(i), static_cast<double>(i) * step_s_);
  // To rounding, it may be reached only now.
  again.crossings().arrive(to, again.speed(), static_cast<double>(node) * step_s_);
  body_.crossings() = again.crossings();
}

void CoupledLane::resolve(CoupledBank& bank, std::size_t lane, std::size_t node) {
  catch_up(bank.state[1 - bank.now], lane, node - 1);
  const int before = body_.direction();
  body_.advance(ground_before(node), static_cast<double>(node) * step_s_);
  if (before != 0 && !body_.sliding()) at_rest_since_ = node;
  store_state(bank, lane, node);
}

void CoupledLane::store_state(CoupledBank& bank, std::size_t lane, std::size_t node) {
  CoupledBank::State& to = bank.state[bank.now];
  const Mode& now = mode().mode;
  const double twice_zeta = 2.0 * frame_.damping_ratio;
  base_ = node;
  base_roof_ = body_.roof();
  base_speed_ = body_.speed();
  to.x[lane] = base_roof_.x;
  to.y[lane] = base_roof_.y;
  to.elastic[lane] = base_roof_.x + twice_zeta * base_roof_.y;
  to.forcing[lane] = forcing(now, node);
  to.turn[lane] = base_roof_.y - twice_zeta * (to.elastic[lane] / now.mass + to.forcing[lane]);
  to.speed[lane] = base_speed_;
  to.peak[lane] = body_.peaks().elastic_mps2;
  to.peak_x[lane] = body_.peaks().x_mps2;
  if (stored_ != &mode()) store_mode(bank, lane);
  stored_ = &mode();
  store_limits(bank, lane, node);
}

// The effective oscillator's scaled state is x / mass, y / sqrt(mass).
void CoupledLane::store_mode(CoupledBank& bank, std::size_t lane) const {
  const auto& [now, step, limits] = mode();
  const double root = std::sqrt(now.mass), weight = now.weight / now.mass;
  bank.xx[lane] = step.xx;
  bank.xy[lane] = step.xy * root;
  bank.yx[lane] = step.xy / root;
  bank.yy[lane] = step.yy;
  bank.x_start[lane] = step.x_start * now.mass;
  bank.x_end[lane] = step.x_end * now.mass;
  bank.y_start[lane] = step.y_start * root;
  bank.y_end[lane] = step.y_end * root;
  bank.twice_zeta[lane] = 2.0 * frame_.damping_ratio;
  bank.per_mass[lane] = 1.0 / now.mass;
  bank.ground[lane] = a_factor_;
  bank.vertical[lane] = weight * w_factor_;
  bank.constant[lane] = weight * contact_.gravity();
  bank.speed_y[lane] = now.drive.a / frame_.omega_radps;
  bank.speed_a[lane] = 0.5 * step_s_ * now.drive.a * a_factor_;
  bank.speed_w[lane] = 0.5 * step_s_ * now.drive.w * w_factor_;
  bank.speed_g[lane] = step_s_ * now.drive.w * contact_.gravity();
}

bool CoupledLane::is_over(const CoupledBank& bank, std::size_t lane, std::size_t node) {
  const std::size_t since = std::max(ground_.quiet_from(), at_rest_since_);
  const double at_rest_s = static_cast<double>(node - std::min(since, node)) * step_s_;
  if (body_.sliding() || at_rest_s < period_s_ * std::sqrt(1.0 + mass_ratio_)) return false;
  catch_up(bank.state[bank.now], lane, node);
  return cannot_slip(block_, body_.largest_acceleration_to_come_mps2(), 0.0);
}

CoupledPeak CoupledLane::result(const CoupledBank& bank, std::size_t lane, std::size_t node) {
  catch_up(bank.state[bank.now], lane, node);
  look_into(elastic_turn_);
  look_into(x_turn_);
  if (contact_.stops_at_rest()) body_.coast();
  CoupledPeak peak = peak_of(body_.result());
  peak.slip.free_sliding = contact_.slides_at_rest();
  return peak;
}

CoupledPeak peak_of(const CoupledResult& r) {
  return {{.peak_displacement_m = r.slip.peak_displacement_m,
           .residual_displacement_m = r.slip.residual_displacement_m,
           .peak_downslope_m = r.slip.peak_downslope_m,
           .peak_upslope_m = r.slip.peak_upslope_m,
           .slip_duration_s = r.slip.slip_duration_s,
           .slip_phases = r.slip.slip_phases,
           .uplift = r.slip.uplift,
           .free_sliding = r.slip.free_sliding},
          r.peak_base_shear,
          r.peak_roof_displacement_m,
          r.ductility,
          r.residual_roof_displacement_m};
}

}  // namespace glissade::block_detail
