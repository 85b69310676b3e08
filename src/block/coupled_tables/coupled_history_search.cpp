// SPDX-License-Identifier: GPL-3.0-or-later
// The next interval of a history in which an event is possible.
#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "block/coupled_tables/coupled_history.hpp"
#include "block/coupled_tables/coupled_search.hpp"

namespace glissade::block_detail {
namespace {

/// Room for rounding in single precision, relative to the terms of a sum.
constexpr double slack = 1e-6;

constexpr std::array<float, CoupledTable::zeros + CoupledTable::tile> zeros{};

}  // namespace

/// The first interval before node `to` that must be solved, else `to`.
std::size_t CoupledHistory::next_interval(std::size_t to) {
  const std::size_t first = ringing_down_ ? 0 : node_, last = first + (to - node_) + 1;
  limit_ahead_ = by_scalar_scheme_;
  const bool at_once = std::exchange(phase_began_, false) || limit_ahead_;
  std::size_t found = at_once           ? first
                      : body_.sliding() ? next_stop_in(first, last)
                                        : next_start_in(first, last);
  if (!limit_ahead_ && (may_lift_ || spring_may_change_)) {
    const std::size_t searched = std::min(std::max(found, first + 1) + 1, last),
                      limit = next_limit_in(first, searched);
    limit_ahead_ = limit < searched;
    if (limit_ahead_) found = limit;
  }
  if (found == last) return to;
  return node_ + (found == first ? 0 : found - first - 1);
}

std::size_t CoupledHistory::next_start_in(std::size_t first, std::size_t last) const {
  const RegimeOscillator& r = regime();
  const CoupledTable::Rest& rest = table_->rest();
  const auto values = [&](const std::vector<float>& v) {
    return ringing_down_ ? zeros.data() : v.data();
  };
  RestSearch s;
  s.motion = {&r, ringing_down_ ? 0.0f : static_cast<float>(intensity_),
              r.s2 * (free_ * r.power(node_ - from_))};
  const double low = table_->lowest_per_g() * r.gravity_mps2,
               high = table_->highest_per_g() * r.gravity_mps2,
               room = slack * (intensity_ * rest.largest + s.motion.amplitude.size() +
                               std::abs(low) + std::abs(high));
  s.lowest = low + room;
  s.highest = high - room;
  s.below = values(rest.below);
  s.above = values(rest.above);
  s.tile_below = values(rest.tile_below);
  s.tile_above = values(rest.tile_above);
  s.tile_amplitude = values(table_->response(0).amplitude);
  return next_start(s, first, last);
}

std::size_t CoupledHistory::next_stop_in(std::size_t first, std::size_t last) const {
  const RegimeOscillator& r = regime();
  const CoupledTable::Speed& speed = table_->speed(body_.direction());
  const DriveLine& line = r.contact.drive;
  const Amplitude amplitude = free_ * r.power(node_ - from_);
  SpeedSearch s;
  s.motion = {&r, ringing_down_ ? 0.0f : static_cast<float>(intensity_), r.s * amplitude};
  s.gain = ringing_down_ ? zeros.data() : speed.gain.data();
  s.tile_deviation = ringing_down_ ? zeros.data() : speed.tile_deviation.data();
  double constant =
      speed_from_ - line.a * (roof_from_.y * r.per_omega) + line.constant * time_s(node_ - from_);
  if (!ringing_down_) {
    constant -= line.a * intensity_ * (table_->sign() * nodes().a.velocity_mps()[from_]);
    if (nodes().vertical) constant -= line.w * w_factor_ * nodes().w.velocity_mps()[from_];
  }
  const double per_step = line.constant * step_s_,
               size = std::abs(line.a) * (intensity_ * speed.largest + s.motion.amplitude.size()) +
                      std::abs(constant);
  s.drive_a = static_cast<float>(line.a);
  s.constant = static_cast<float>(constant - slack * size);
  s.per_step = static_cast<float>(per_step - slack * std::abs(per_step));
  s.deviation = static_cast<float>(0.125 * step_s_ * std::abs(line.a) * r.phase * r.s2_size *
                                   amplitude.size() * (1.0 + slack));
  return next_stop(s, first, last);
}

/// The first node in [first, last) at or beside which the block may lift, or the spring yield
/// or unload.
std::size_t CoupledHistory::next_limit_in(std::size_t first, std::size_t last) const {
  const RegimeOscillator& r = regime();
  const CoupledTable::Response& response = table_->response(body_.direction());
  const double intensity = ringing_down_ ? 0.0 : intensity_, weight = r.contact.weight,
               stiffness = r.omega2, bend = 0.125 * r.phase * r.phase,
               x_at_rest = -weight * r.gravity_mps2,
               least_x = std::min(x_at_rest - elastic_.lowest, elastic_.highest - x_at_rest);
  Amplitude free = free_ * r.power(node_ - from_);
  for (std::size_t i = first; i < last;) {
    const std::size_t b = ringing_down_ ? 0 : i / CoupledTable::tile,
                      end = std::min(last, (i / CoupledTable::tile + 1) * CoupledTable::tile);
    const double w = ringing_down_ ? 0.0 : nodes().lowest_w(w_factor_, b), size = free.size(),
                 size_a = intensity * response.a_mps2[b] + r.s2_size * size,
                 size_x = intensity * response.x_mps2[b] + stiffness * size;
    if (yield_side_ != 0 || size_a >= (r.gravity_mps2 + w) * cot_slope_ || size_x >= least_x) {
      const double bend_a =
          bend * (intensity * response.amplitude[b] + r.s2_size * size) * (1.0 + slack);
      for (std::size_t k = i; k < end; ++k) {
        RoofState roof = r.free_state(free * r.powers[k - i]);
        Roof at;
        if (!ringing_down_) {
          roof = roof + RoofState{intensity * response.x[k], intensity * response.y[k]};
          if (nodes().vertical) at.w = w_factor_ * nodes().w.acceleration_mps2()[k];
        }
        roof.x += x_at_rest;
        if (!within_limits(r, bend_a, roof, at)) return k;
      }
    }
    free = free * r.power(end - i);
    i = end;
  }
  return last;
}

}  // namespace glissade::block_detail
