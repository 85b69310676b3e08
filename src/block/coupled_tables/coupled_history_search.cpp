// SPDX-License-Identifier: GPL-3.0-or-later
// The next interval of a history in which an event is possible.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "block/coupled_tables/coupled_history.hpp"

namespace glissade::block_detail {
namespace {

/// Room for rounding in single precision, relative to the terms of a sum.
constexpr double slack = 1e-6;

template <class Number>
constexpr std::array<Number, CoupledTable::zeros + CoupledTable::tile> zeros{};

}  // namespace

void CoupledHistory::set_searches(std::size_t index, const CoupledTable& table) {
  const int direction = index % 3 == 2 ? -1 : static_cast<int>(index % 3);
  Searches& s = searches_[index];
  const RegimeOscillator& r = *(s.regime = &table.regime(direction));
  const CoupledTable::Response& response = *(s.response = &table.response(direction));
  const float intensity = static_cast<float>(intensity_);
  const CoupledTable::Rest& rest = table.rest();
  s.rest = {{&r, intensity, {}, 0.0},
            table.rest_below(),
            rest.above.data(),
            rest.tile_below.data(),
            rest.tile_above.data(),
            response.amplitude.data(),
            table.lowest_per_g() * r.gravity_mps2,
            table.highest_per_g() * r.gravity_mps2};
  s.table_a_mps2 = intensity_ * rest.largest;
  if (direction != 0) {
    const CoupledTable::Speed& speed = table.speed(direction);
    const DriveLine& line = r.contact.drive;
    s.speed = {{&r, intensity, {}, 0.0},
               speed.gain.data(),
               speed.tile_deviation.data(),
               static_cast<float>(line.a),
               0.0f,
               static_cast<float>(step_s_ * (line.constant - slack * std::abs(line.constant)))};
    const double size = std::abs(line.a), rate = r.phase / step_s_;
    s.table_speed_mps = size * intensity_ * speed.largest;
    s.speed_per_free = size * rate;
    s.deviation_per_free = 0.125 * step_s_ * size * r.phase * r.s2_size * (1.0 + slack);
  }
  s.limit = {&r,
             intensity_,
             w_factor_,
             {},
             response.x.data(),
             response.y.data(),
             nodes().vertical ? nodes().w.acceleration_mps2().data() : nullptr,
             response.a_mps2.data(),
             response.x_mps2.data(),
             response.amplitude.data(),
             nodes().tile_lowest_w_mps2.data(),
             nodes().tile_highest_w_mps2.data(),
             contact_.cot_slope(),
             0.0,
             0.0,
             0};
  s.table_x_mps2 = intensity_ * response.largest_x_mps2;
  s.contact_margin_mps2 = table.contact_margin_mps2(direction, intensity_, w_factor_);
}

/// From here on the tables are zero, and the free vibration is all there is.
void CoupledHistory::begin_ring_down() {
  ringing_down_ = true;
  for (Searches& s : searches_) {
    s.rest.motion.intensity = s.speed.motion.intensity = 0.0f;
    s.limit.intensity = s.limit.w_factor = 0.0;
    s.table_a_mps2 = s.table_speed_mps = s.table_x_mps2 = 0.0;
    s.rest.below = s.rest.above = s.rest.tile_below = s.rest.tile_above = s.rest.tile_amplitude =
        s.speed.gain = s.speed.tile_deviation = s.limit.tile_a = s.limit.tile_x =
            s.limit.tile_amplitude = zeros<float>.data();
    s.limit.x = s.limit.y = s.limit.tile_lowest_w = s.limit.tile_highest_w = zeros<double>.data();
    s.limit.w = nullptr;
    s.contact_margin_mps2 = contact_.gravity() * contact_.cot_slope();
  }
}

/// From a lane's reference node to the next interval that it must solve.
CoupledHistory::Next CoupledHistory::search(CoupledLanes& lanes, std::size_t lane) {
  const auto k = static_cast<std::size_t>(lanes.regime[lane]);
  const auto reference = static_cast<std::size_t>(lanes.node[lane]);
  if (finishes_ || (k >= 3 && yielding_table_ == nullptr && reference >= end_))
    return finish(lanes, lane);
  if (k >= 3 && yielding_table_ == nullptr) {
    lanes.left[lane] = 1.0;
    return by_reference_scheme(lanes, lane);
  }
  if (!ringing_down_ && reference > quiet_from_) begin_ring_down();
  const Searches& s = searches_[k];
  const RegimeOscillator& r = *s.regime;
  FreeVibration at{r.per_omega2 * Amplitude{lanes.free_re[lane], lanes.free_im[lane]},
                   r.per_omega2 * lanes.free_size[lane], false};
  std::size_t node = reference;
  for (;;) {
    at.reaches_limits = may_reach_limits(lanes, lane, s, at.size);
    if (ringing_down_ && k == 0 && !at.reaches_limits &&
        cannot_slip(block_, r.s2_size * at.size, 0.0))
      return finish(lanes, lane);
    std::size_t to = std::min(
        end_, ringing_down_ ? node + CoupledTable::zeros - CoupledTable::tile : quiet_from_);
    if (at.reaches_limits) to = std::min(to, node + CoupledTable::tile);  // near as a rule
    const std::size_t from = node;
    node = next_interval(lanes, lane, at, from, to);
    if (node < to || node >= end_ || (!ringing_down_ && node >= quiet_from_)) break;
    at.amplitude = at.amplitude * r.power(node - from);
    at.size = at.amplitude.size();
  }
  finishes_ = node >= end_;
  lanes.begins[lane] = 1.0;
  lanes.left[lane] = lanes.length[lane] = finishes_ ? 0.0 : 1.0;
  lanes.steps[lane] = static_cast<double>(node - reference);
  const Amplitude power = r.power(node - reference);
  lanes.power_re[lane] = power.re;
  lanes.power_im[lane] = power.im;
  const std::size_t in_table = std::min(node, quiet_from_);
  lanes.x_table[lane] = s.response->x[in_table];
  lanes.y_table[lane] = s.response->y[in_table];
  lanes.node[lane] = static_cast<std::int64_t>(node);
  return Next::interval;
}

/// With a free vibration of this size it may lift, yield or unload.
bool CoupledHistory::may_reach_limits(const CoupledLanes& lanes, std::size_t lane,
                                      const Searches& s, double size) const {
  const RegimeOscillator& r = *s.regime;
  if (!(r.s2_size * size < s.contact_margin_mps2) || lanes.side[lane] != 0.0) return true;
  return !(s.table_x_mps2 + r.omega2 * size + std::abs(r.contact.weight * r.gravity_mps2) <
           std::min(-lanes.lowest[lane], lanes.highest[lane]));
}

/// The first interval before node `to` that must be solved, else `to`.
std::size_t CoupledHistory::next_interval(const CoupledLanes& lanes, std::size_t lane,
                                          const FreeVibration& at, std::size_t from,
                                          std::size_t to) {
  Searches& s = searches_[static_cast<std::size_t>(lanes.regime[lane])];
  const std::size_t first = ringing_down_ ? 0 : from, last = first + (to - from) + 1;
  std::size_t found = s.regime->contact.drive.a == 0.0
                          ? next_start(s, at, first, last)
                          : next_stop(s, lanes, lane, at, from, first, last);
  if (at.reaches_limits) {
    s.limit.free = at.amplitude;
    s.limit.side = static_cast<int>(lanes.side[lane]);
    s.limit.lowest = s.limit.side != 0 ? -never : lanes.lowest[lane];
    s.limit.highest = s.limit.side != 0 ? never : lanes.highest[lane];
    const std::size_t searched = std::min(std::max(found, first + 1) + 1, last),
                      limit = next_limit(s.limit, first, searched);
    if (limit < searched) found = limit;
  }
  if (found == last) return to;
  return from + (found == first ? 0 : found - first - 1);
}

std::size_t CoupledHistory::next_start(Searches& of, const FreeVibration& at, std::size_t first,
                                       std::size_t last) const {
  const RegimeOscillator& r = *of.regime;
  RestSearch& s = of.rest;
  s.motion.amplitude = r.s2 * at.amplitude;
  s.motion.size = r.s2_size * at.size;
  s.room = slack * (of.table_a_mps2 + s.motion.size + (s.highest - s.lowest));
  return block_detail::next_start(s, first, last);
}

std::size_t CoupledHistory::next_stop(Searches& of, const CoupledLanes& l, std::size_t lane,
                                      const FreeVibration& at, std::size_t from, std::size_t first,
                                      std::size_t last) const {
  const RegimeOscillator& r = *of.regime;
  const DriveLine& line = r.contact.drive;
  const auto reference = static_cast<std::size_t>(l.node[lane]);
  SpeedSearch& s = of.speed;
  s.motion.amplitude = r.s * at.amplitude;
  double constant = l.speed_from[lane] - line.a * (l.y_from[lane] * r.per_omega) +
                    line.constant * time_s(from - reference);
  if (!ringing_down_)
    constant -= line.a * (intensity_ * elastic_table_.sign()) * l.velocity_from[lane] +
                line.w * w_factor_ * l.w_velocity_from[lane];
  s.constant = static_cast<float>(
      constant - slack * (of.table_speed_mps + of.speed_per_free * at.size + std::abs(constant)));
  s.deviation = static_cast<float>(of.deviation_per_free * at.size);
  return block_detail::next_stop(s, first, last);
}

}  // namespace glissade::block_detail
