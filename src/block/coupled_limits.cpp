// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bounds that let a lane pass an interval without looking into it.
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupled_lane.hpp"

namespace glissade::block_detail {
namespace {

/// By values and slopes at 0 and 1.
struct HermiteCubic {
  double begin, end, begin_slope, end_slope;

  /// The largest |value|; zero where the slope keeps its sign from end to end.
  double largest_at_turn() const {
    if (begin_slope * end_slope > 0.0) return 0.0;
    const double rise = end - begin;
    // slope = begin_slope + 2 b y + 3 c y^2
    const double b = 3.0 * rise - 2.0 * begin_slope - end_slope,
                 c = begin_slope + end_slope - 2.0 * rise;
    const double root = std::sqrt(std::max(b * b - 3.0 * c * begin_slope, 0.0));
    const double q = -(b + std::copysign(root, b));
    double most = std::max(std::abs(begin), std::abs(end));
    for (const double y : {begin_slope / q, q / (3.0 * c)})
      if (y > 0.0 && y < 1.0)
        most = std::max(most, std::abs(begin + y * (begin_slope + y * (b + y * c))));
    return most;
  }
};

}  // namespace

/// What keeps an interval without events. A function leaves its chord by at most 1/8 of its largest
/// second derivative over the interval. With phase = omega step, z = u'', and ' over the interval:
///   y' = phase z,  z' = -phase (y + 2 zeta z) / mass - dA,  P' = phase (y + 2 zeta z),
/// so with |P| and |y| bounded at the begin, |z| <= (|z_0| + phase |y_0| / mass + |dA|) /
/// (1 - (phase^2 + 2 zeta phase) / mass), and so on. It leaves the cubic with its values and slopes
/// at both ends by at most 1/384 of its largest fourth derivative.
CoupledLane::Limits CoupledLane::limits(const Mode& now, int direction) const {
  const double g = contact_.gravity(), weight = std::abs(now.weight / now.mass);
  const LaneGround::Largest &a = ground_.largest_a, &w = ground_.largest_w;
  const double a_size = std::abs(a_factor_), w_size = std::abs(w_factor_);

  Limits l{.lowest = -elastic_bound_, .highest = elastic_bound_, .bound = elastic_bound_};
  enum class Of { bound, block } lower = Of::bound, upper = Of::bound;
  if (direction == 0) {  // until the drives are positive
    const DriveLine down = contact_.down(), up = contact_.up();
    const double high = now.mass * down.w / down.a, low = now.mass * up.w / up.a;
    l = {low * g, high * g, low * w_factor_, high * w_factor_};
    l.bound = std::max(-low, high) * (g + w_size * w.value);
    lower = upper = Of::block;
  } else if (contact_.sin_slope() > 0.0) {  // until the normal force vanishes
    const double per_g = contact_.cos_slope() / contact_.sin_slope();
    if (per_g * (g - w_size * w.value) < elastic_bound_) {
      l.highest = per_g * g;
      l.highest_w = per_g * w_factor_;
      l.bound = std::max(elastic_bound_, per_g * (g + w_size * w.value));
      upper = Of::block;
    }
  }
  const double phase = frame_.omega_radps * step_s_, twice_zeta = 2.0 * frame_.damping_ratio,
               per_mass = 1.0 / now.mass;
  const double forcing = a_size * a.value + weight * (g + w_size * w.value),
               forcing_change = a_size * a.change + weight * w_size * w.change;
  const double most_z = ((l.bound + phase * y_bound_) * per_mass + forcing + forcing_change) /
                        (1.0 - (phase * phase + twice_zeta * phase) * per_mass);
  const double elastic_rate = phase * (y_bound_ + (phase + twice_zeta) * most_z);
  const double rounding = 1e-12 * (l.bound + forcing);
  const double z_rate = elastic_rate * per_mass + forcing_change;
  l.sag = 0.125 * phase * (phase * most_z + twice_zeta * z_rate) + rounding;
  const double z_curvature = phase * per_mass * (phase * most_z + twice_zeta * z_rate),
               z_third = phase * per_mass * (phase * z_rate + twice_zeta * z_curvature);
  l.elastic_cubic = phase * (phase * z_curvature + twice_zeta * z_third) / 384.0 + rounding;
  l.x_cubic = phase * phase * z_curvature / 384.0 + rounding;
  if (lower == Of::block) l.lowest += l.sag;
  if (upper == Of::block) l.highest -= l.sag;
  const double a_rate = elastic_rate * per_mass + weight * w_size * w.change;
  const double drive_rate =
      std::abs(now.drive.a) * a_rate + std::abs(now.drive.w) * w_size * w.change;
  l.least_speed = direction == 0 ? -1.0 : step_s_ * (0.125 * drive_rate + rounding);
  return l;
}

void CoupledLane::set_limits() {
  for (std::size_t k = 0; k < modes_.size(); ++k)
    modes_[k].limits = limits(modes_[k].mode, k == 0 ? 0 : k == 1 ? 1 : -1);
}

void CoupledLane::store_limits(CoupledBank& bank, std::size_t lane, std::size_t node) {
  const CoupledBank::State& state = bank.state[bank.now];
  const double y = std::abs(state.y[lane]), elastic = state.elastic[lane];
  if (y > y_bound_ || std::abs(elastic) > elastic_bound_) {
    if (y > y_bound_) y_bound_ = 1.5 * y;
    if (std::abs(elastic) > elastic_bound_) elastic_bound_ = 1.5 * std::abs(elastic);
    set_limits();
  }
  const Limits& l = mode().limits;
  bank.lowest[lane] = l.lowest;
  bank.lowest_w[lane] = l.lowest_w;
  bank.highest[lane] = l.highest;
  bank.highest_w[lane] = l.highest_w;
  bank.least_speed[lane] = l.least_speed;
  bank.y_bound[lane] = y_bound_;
  // A turn of f that exceeds the peak lies within a sag of one end, and within 4 of the other.
  bank.sag[lane] = 4.0 * l.sag;
  const double w = ground_.w.acceleration_mps2()[node];
  const bool clear = elastic >= l.lowest + l.lowest_w * w &&
                     elastic <= l.highest + l.highest_w * w && !body_.lifted() &&
                     (state.speed[lane] >= l.least_speed || gathers_speed(state, lane, node));
  // Too near to a limit now: the next interval is looked into as well.
  if (!clear) bank.least_speed[lane] = std::numeric_limits<double>::infinity();
}

/// Sliding, and faster all through the next interval: by the drive and its rate now, and a bound on
/// its second derivative.
bool CoupledLane::gathers_speed(const CoupledBank::State& state, std::size_t lane,
                                std::size_t node) const {
  const auto& [now, step, l] = mode();
  const std::size_t next = std::min(node + 1, ground_.w.acceleration_mps2().size() - 1);
  const Roof ground = roof_ground(node);
  const double w_rise = roof_ground(next).w - ground.w;
  const double a = -(state.elastic[lane] + now.weight * (contact_.gravity() + ground.w)) / now.mass;
  const double a_rate =
      -(frame_.omega_radps * step_s_ * state.turn[lane] + now.weight * w_rise) / now.mass;
  const double drive = now.drive.at({a, ground.w}),
               drive_rate = now.drive.a * a_rate + now.drive.w * w_rise,
               most_curvature = 8.0 * l.sag * std::abs(now.drive.a) / now.mass;
  return state.speed[lane] > 0.0 && drive + 0.5 * std::min(drive_rate, 0.0) > most_curvature / 6.0;
}

void CoupledLane::note_turn(CoupledBank& bank, std::size_t lane, std::size_t node) {
  const CoupledBank::State &from = bank.state[1 - bank.now], &to = bank.state[bank.now];
  const Limits& l = mode().limits;
  const double phase = frame_.omega_radps * step_s_;
  const auto note = [&](Turn& turn, double& peak, const HermiteCubic& cubic, double error) {
    const double about = cubic.largest_at_turn();
    if (about + error <= peak) return;
    // Of two turns the higher is kept. Where that cannot be told, the one before is looked into.
    if (about - error <= turn.most) look_into(turn);
    turn = {about + error, &mode().mode, {from.x[lane], from.y[lane]}, node};
    peak = std::max(peak, about - error);
  };
  CoupledBody::Peaks& peaks = body_.peaks();
  peaks = {to.peak[lane], to.peak_x[lane]};
  note(elastic_turn_, peaks.elastic_mps2,
       {from.elastic[lane], to.elastic[lane], phase * from.turn[lane], phase * to.turn[lane]},
       l.elastic_cubic);
  note(x_turn_, peaks.x_mps2, {from.x[lane], to.x[lane], phase * from.y[lane], phase * to.y[lane]},
       l.x_cubic);
  bank.state[bank.now].peak[lane] = peaks.elastic_mps2;
  bank.state[bank.now].peak_x[lane] = peaks.x_mps2;
}

void CoupledLane::look_into(const Turn& turn) {
  if (turn.mode == nullptr) return;
  const RoofMotionSeries roof = roof_motion_series(frame_, *turn.mode, contact_.gravity(),
                                                   turn.roof, ground_before(turn.node));
  CoupledBody::Peaks& peaks = body_.peaks();
  peaks.elastic_mps2 = std::max(peaks.elastic_mps2, largest(roof.elastic, 1.0));
  peaks.x_mps2 = std::max(peaks.x_mps2, largest(roof.x, 1.0));
}

}  // namespace glissade::block_detail
