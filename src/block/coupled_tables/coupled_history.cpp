// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/coupled_tables/coupled_history.hpp"

#include <algorithm>
#include <cmath>

namespace glissade::block_detail {
namespace {

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
      contact_(contact),
      subdivision_(subdivision),
      block_(downhill(scene.block)),
      intensity_(intensity),
      w_factor_(scene.factors.vertical),
      step_s_(table.nodes().a.step_s()),
      body_(contact, subdivision.building, block_, CoupledBody::Keeps::peaks,
            scene.building.yielding),
      watched_(!thresholds_m.empty()),
      quiet_from_(table.nodes().quiet),
      end_(contact.slides_at_rest() ? table.nodes().a.last_sample()
                                    : quiet_from_ + longest_ring_down(step_s_)) {
  body_.crossings() = {thresholds_m, crossings, contact_.cos_slope()};
  for (std::size_t k = 0; k < 6; ++k) {
    if (k < 3)
      set_searches(k, table);
    else if (yielding_table != nullptr)
      set_searches(k, *yielding_table);
  }
}

LinearGround CoupledHistory::ground_after(std::size_t node) const {
  const auto at = [&](std::size_t i) {
    if (i > quiet_from_) return Roof{};
    return Roof{intensity_ * (elastic_table_.sign() * nodes().a.acceleration_mps2()[i]),
                nodes().vertical ? w_factor_ * nodes().w.acceleration_mps2()[i] : 0.0};
  };
  const Roof begin = at(node), end = at(node + 1);
  return {begin, {end.a - begin.a, end.w - begin.w}};
}

/// A state at the end of the lane's interval, as a piece of no length.
void CoupledHistory::put(CoupledLanes& l, std::size_t lane, const CoupledBody::State& s) {
  l.left[lane] = l.length[lane] = l.begins[lane] = 0.0;
  l.x[lane] = s.roof.x;
  l.y[lane] = s.roof.y;
  l.speed[lane] = s.speed;
  l.regime[lane] =
      static_cast<double>(CoupledTable::index(s.direction)) + (s.spring.side != 0 ? 3.0 : 0.0);
  l.side[lane] = s.spring.side;
  l.highest[lane] = s.spring.hardened + l.yield_mps2[lane];
  l.lowest[lane] = s.spring.hardened - l.yield_mps2[lane];
  l.starts[lane] = l.stopped[lane] = l.unloads[lane] = 0.0;
  l.slip[lane] = s.slip;
  l.farthest_down[lane] = s.farthest_down;
  l.farthest_up[lane] = s.farthest_up;
  l.duration_s[lane] = s.slip_duration_s;
  l.phases[lane] = static_cast<double>(s.slip_phases);
}

/// The lane's history where it is, to go on with by the scalar scheme.
CoupledBody CoupledHistory::body(const CoupledLanes& l, std::size_t lane, double now_s) const {
  CoupledBody body = body_;
  const double starts = l.starts[lane];
  const int k = static_cast<int>(l.regime[lane]) % 3;
  body.set_state({.roof = {l.x[lane], l.y[lane]},
                  .spring = {.hardened = 0.5 * (l.highest[lane] + l.lowest[lane]),
                             .side = static_cast<int>(l.side[lane]),
                             .unloaded = static_cast<int>(l.unloads[lane])},
                  .direction = k == 2 ? -1 : k,
                  .speed = l.speed[lane],
                  .slip = l.slip[lane],
                  .farthest_down = l.farthest_down[lane],
                  .farthest_up = l.farthest_up[lane],
                  .slip_duration_s = l.duration_s[lane],
                  .slip_phases = static_cast<std::size_t>(l.phases[lane]),
                  .time_s = now_s,
                  .drive_is_zero = starts == 1.0,
                  .stopped_direction = static_cast<int>(l.stopped[lane])});
  return body;
}

CoupledHistory::Next CoupledHistory::begin(CoupledLanes& l, std::size_t lane) {
  for (CoupledLanes::Row* row :
       {&l.x_from, &l.y_from, &l.speed_from, &l.free_re, &l.free_im, &l.free_size, &l.velocity_from,
        &l.displacement_from, &l.displacement_low_from, &l.w_velocity_from, &l.w_displacement_from,
        &l.w_displacement_low_from})
    (*row)[lane] = 0.0;
  l.intensity[lane] = intensity_;
  l.w_factor[lane] = nodes().vertical ? w_factor_ : 0.0;
  l.yield_mps2[lane] = body_.yield_mps2();
  put(l, lane, {});
  l.node[lane] = 0;
  return search(l, lane);
}

/// Through what is left of an interval from a fraction of it.
void CoupledHistory::advance(CoupledBody& body, std::size_t interval, double from) const {
  const LinearGround ground = ground_after(interval);
  const double part = (1.0 - from) / subdivision_.pieces;
  for (int k = 0; k < subdivision_.pieces; ++k) {
    const double y0 = from + k * part,
                 y1 = k + 1 == subdivision_.pieces ? 1.0 : from + (k + 1) * part;
    body.advance({part * step_s_, ground.after(y0).at, ground.after(y1).at}, time_s(interval, y1));
  }
}

/// The rest of the interval by the scalar scheme.
CoupledHistory::Next CoupledHistory::by_reference_scheme(CoupledLanes& lanes, std::size_t lane) {
  const auto node = static_cast<std::size_t>(lanes.node[lane]);
  const double tau = 1.0 - lanes.left[lane];
  CoupledBody now = body(lanes, lane, time_s(node, tau));
  advance(now, node, tau);
  if (now.has_lifted()) return Next::lifts;
  put(lanes, lane, now.state());
  if (watched_) {
    body_.crossings() = now.crossings();
    watch(now, node, 1.0);
  }
  return Next::interval;
}

/// Makes this where the phase began, or is known to have no threshold behind.
void CoupledHistory::watch(const CoupledBody& now, std::size_t interval, double tau) {
  body_at_phase_ = now;
  phase_node_ = interval;
  phase_tau_ = tau;
}

CoupledHistory::Next CoupledHistory::go_on(CoupledLanes& lanes, std::size_t lane,
                                           const LanesDone& done) {
  const auto is = [lane](std::uint64_t bits) { return ((bits >> lane) & 1) != 0; };
  if (watched_) {
    const auto node = static_cast<std::size_t>(lanes.node[lane]);
    const std::size_t interval = is(done.searching) ? node - 1 : node;
    const double tau = 1.0 - lanes.left[lane];
    if (body_.crossings().reached(lanes.slip[lane]))
      cross(lanes.slip[lane], tau > 0.0 ? interval : interval - 1);
    if (is(done.started)) watch(body(lanes, lane, time_s(interval, tau)), interval, tau);
  }
  if (is(done.searching)) return search(lanes, lane);
  if (is(done.undecided)) return by_reference_scheme(lanes, lane);
  return Next::interval;
}

/// The slip has reached a threshold by the end of this interval, in its present phase.
void CoupledHistory::cross(double slip_m, std::size_t end_interval) {
  CoupledBody again = *body_at_phase_;
  again.crossings() = body_.crossings();
  for (std::size_t i = phase_node_; i <= end_interval && again.crossings().reached(slip_m); ++i)
    advance(again, i, i == phase_node_ ? phase_tau_ : 0.0);
  // To rounding, it may be reached only now.
  again.crossings().arrive(slip_m, again.speed(), time_s(end_interval + 1));
  body_.crossings() = again.crossings();
}

CoupledHistory::Next CoupledHistory::finish(const CoupledLanes& lanes, std::size_t lane) {
  body_ = body(lanes, lane, time_s(end_));
  if (contact_.stops_at_rest()) body_.coast();
  return Next::finished;
}

SlipResult CoupledHistory::result() const {
  SlipResult slip = body_.result().slip;
  slip.free_sliding = contact_.slides_at_rest();
  return slip;
}

}  // namespace glissade::block_detail
