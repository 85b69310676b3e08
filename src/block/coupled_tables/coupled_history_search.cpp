// SPDX-License-Identifier: GPL-3.0-or-later
// The next interval of a history in which an event is possible.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "block/coupled_tables/coupled_history.hpp"
#include "block/coupled_tables/coupled_search.hpp"

namespace glissade::block_detail {
namespace {

/// Room for rounding in single precision, relative to the terms of a sum.
constexpr double slack = 1e-6;

template <class Number>
constexpr std::array<Number, CoupledTable::zeros + CoupledTable::tile> zeros{};

}  // namespace

CoupledHistory::Reference CoupledHistory::reference(const CoupledLanes& l, std::size_t lane) const {
  Reference at;
  at.node = static_cast<std::size_t>(l.node[lane]);
  const int k = static_cast<int>(l.regime[lane]) % 3;
  at.direction = k == 2 ? -1 : k;
  at.side = static_cast<int>(l.side[lane]);
  at.ringing_down = at.node > quiet_from_;
  at.elastic = {l.lowest[lane], l.highest[lane]};
  if (at.side != 0 && yielding_table_ == nullptr) return at;
  const RegimeOscillator& r = regime(at);
  at.roof = {l.x_from[lane], l.y_from[lane]};
  at.speed = l.speed_from[lane];
  at.free = r.per_omega2 * Amplitude{l.free_re[lane], l.free_im[lane]};
  at.size = r.per_omega2 * l.free_size[lane];
  const double weight = r.contact.weight * r.gravity_mps2,
               margin = at.ringing_down
                            ? contact_.gravity() * cot_slope_
                            : contact_margin_mps2_[at.side != 0][CoupledTable::index(at.direction)],
               table_x = at.ringing_down
                             ? 0.0
                             : intensity_ * table(at).response(at.direction).largest_x_mps2;
  at.may_lift = !(r.s2_size * at.size < margin);
  at.spring_may_change = body_.yield_mps2() < never &&
                         (at.side != 0 || !(table_x + r.omega2 * at.size + std::abs(weight) <
                                            std::min(-at.elastic.lowest, at.elastic.highest)));
  return at;
}

bool CoupledHistory::finished(const Reference& at) const {
  return at.ringing_down && at.direction == 0 && !at.spring_may_change &&
         cannot_slip(block_, regime(at).s2_size * at.size, 0.0);
}

/// From a lane's reference node to the next interval that it must solve.
CoupledHistory::Next CoupledHistory::search(CoupledLanes& lanes, std::size_t lane) {
  const Reference at = reference(lanes, lane);
  if (finishes_) return finish(lanes, lane);
  std::size_t node = at.node;
  if (at.side != 0 && yielding_table_ == nullptr) {
    if (node >= end_) return finish(lanes, lane);
    lanes.left[lane] = 1.0;
    return by_reference_scheme(lanes, lane);
  }
  for (;;) {
    if (finished(at)) return finish(lanes, lane);
    if (node >= end_) break;
    const std::size_t to = at.ringing_down
                               ? std::min(end_, node + CoupledTable::zeros - CoupledTable::tile)
                               : std::min(end_, quiet_from_);
    const std::size_t found = next_interval(at, node, to);
    const bool goes_on = found == to && (at.ringing_down || found == end_) && node < to;
    node = found;
    if (!goes_on) break;
  }
  finishes_ = node >= end_;
  lanes.begins[lane] = 1.0;
  lanes.left[lane] = lanes.length[lane] = finishes_ ? 0.0 : 1.0;
  lanes.steps[lane] = static_cast<double>(node - at.node);
  const Amplitude power = regime(at).power(node - at.node);
  lanes.power_re[lane] = power.re;
  lanes.power_im[lane] = power.im;
  const CoupledTable::Response& response = table(at).response(at.direction);
  lanes.x_table[lane] = response.x[std::min(node, quiet_from_)];
  lanes.y_table[lane] = response.y[std::min(node, quiet_from_)];
  lanes.node[lane] = static_cast<std::int64_t>(node);
  return Next::interval;
}

/// The first interval before node `to` that must be solved, else `to`.
std::size_t CoupledHistory::next_interval(const Reference& at, std::size_t from,
                                          std::size_t to) const {
  const std::size_t first = at.ringing_down ? 0 : from, last = first + (to - from) + 1;
  std::size_t found = at.direction != 0 ? next_stop_in(at, from, first, last)
                                        : next_start_in(at, from, first, last);
  if (at.may_lift || at.spring_may_change)
    found = next_limit_in(at, from, first, std::min(std::max(found, first + 1) + 1, last), found);
  if (found == last) return to;
  return from + (found == first ? 0 : found - first - 1);
}

std::size_t CoupledHistory::next_start_in(const Reference& at, std::size_t from, std::size_t first,
                                          std::size_t last) const {
  const RegimeOscillator& r = regime(at);
  const CoupledTable::Rest& rest = table(at).rest();
  const auto values = [&](const std::vector<float>& v) {
    return at.ringing_down ? zeros<float>.data() : v.data();
  };
  RestSearch s;
  s.motion = {&r, at.ringing_down ? 0.0f : static_cast<float>(intensity_),
              r.s2 * (at.free * r.power(from - at.node))};
  const double low = table(at).lowest_per_g() * r.gravity_mps2,
               high = table(at).highest_per_g() * r.gravity_mps2,
               room = slack * (intensity_ * rest.largest + s.motion.amplitude.size() +
                               std::abs(low) + std::abs(high));
  s.lowest = low + room;
  s.highest = high - room;
  s.below = values(rest.below);
  s.above = values(rest.above);
  s.tile_below = values(rest.tile_below);
  s.tile_above = values(rest.tile_above);
  s.tile_amplitude = values(table(at).response(0).amplitude);
  return next_start(s, first, last);
}

std::size_t CoupledHistory::next_stop_in(const Reference& at, std::size_t from, std::size_t first,
                                         std::size_t last) const {
  const RegimeOscillator& r = regime(at);
  const CoupledTable::Speed& speed = table(at).speed(at.direction);
  const DriveLine& line = r.contact.drive;
  const Amplitude amplitude = at.free * r.power(from - at.node);
  SpeedSearch s;
  s.motion = {&r, at.ringing_down ? 0.0f : static_cast<float>(intensity_), r.s * amplitude};
  s.gain = at.ringing_down ? zeros<float>.data() : speed.gain.data();
  s.tile_deviation = at.ringing_down ? zeros<float>.data() : speed.tile_deviation.data();
  double constant =
      at.speed - line.a * (at.roof.y * r.per_omega) + line.constant * time_s(from - at.node);
  if (!at.ringing_down) {
    constant -= line.a * intensity_ * (table(at).sign() * nodes().a.velocity_mps()[at.node]);
    if (nodes().vertical) constant -= line.w * w_factor_ * nodes().w.velocity_mps()[at.node];
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
/// or unload; else what was found before.
std::size_t CoupledHistory::next_limit_in(const Reference& at, std::size_t from, std::size_t first,
                                          std::size_t last, std::size_t found) const {
  const CoupledTable::Response& response = table(at).response(at.direction);
  LimitSearch s;
  s.regime = &regime(at);
  s.free = at.free * s.regime->power(from - at.node);
  const auto values = [&](const std::vector<float>& v) {
    return at.ringing_down ? zeros<float>.data() : v.data();
  };
  const auto doubles = [&](const std::vector<double>& v) {
    return at.ringing_down ? zeros<double>.data() : v.data();
  };
  s.intensity = intensity_;
  s.w_factor = w_factor_;
  s.x = doubles(response.x);
  s.y = doubles(response.y);
  if (nodes().vertical)
    s.w = at.ringing_down ? zeros<double>.data() : nodes().w.acceleration_mps2().data();
  s.tile_a = values(response.a_mps2);
  s.tile_x = values(response.x_mps2);
  s.tile_amplitude = values(response.amplitude);
  s.tile_lowest_w = doubles(nodes().tile_lowest_w_mps2);
  s.tile_highest_w = doubles(nodes().tile_highest_w_mps2);
  s.cot_slope = cot_slope_;
  s.lowest = at.side != 0 ? -never : at.elastic.lowest;
  s.highest = at.side != 0 ? never : at.elastic.highest;
  s.side = at.side;
  const std::size_t limit = next_limit(s, first, last);
  return limit < last ? limit : found;
}

}  // namespace glissade::block_detail
