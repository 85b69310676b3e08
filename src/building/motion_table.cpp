// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/motion_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "glissade/core/hull_maximum.hpp"
#include "oscillator_bank.hpp"
#include "ring_down.hpp"

namespace glissade {
namespace {

using building_detail::OscillatorBank;
using building_detail::padding;

/// With this many nodes a period the quintic between nodes has an error below 1e-6 of slip
/// (tests/unit/block/peak_slip_building_test.cpp).
constexpr double nodes_per_period = 16.0;
constexpr int most_parts = 256;
constexpr std::size_t least_nodes = 16;  // whole SIMD vectors for records of any length

/// Number of nodes of a table whose motion ends at node `end`.
std::size_t nodes_to(std::size_t end, const GroundTable& ground) {
  return std::max({end + 1, ground.last_sample() + 1, least_nodes});
}

double omega_of(const Mode& mode) { return 2.0 * std::numbers::pi / mode.period_s; }

/// An oscillator of some table, and where its states go.
struct Responding {
  Oscillator oscillator;
  std::vector<double>*x, *y;
};

/// Takes oscillators from node `from`, where they have states, to node `to`.
void advance(std::span<const Responding> all, const GroundTable& ground, std::size_t from,
             std::size_t to) {
  constexpr std::size_t at_once = OscillatorBank::size;
  for (std::size_t first = 0; first < all.size(); first += at_once) {
    OscillatorBank bank;
    std::array<double*, at_once> x{}, y{};
    for (std::size_t k = 0; k < std::min(at_once, all.size() - first); ++k) {
      const Responding& one = all[first + k];
      bank.set(k, one.oscillator, ground.step_s());
      bank.x[k] = (*one.x)[from];
      bank.y[k] = (*one.y)[from];
      x[k] = one.x->data();
      y[k] = one.y->data();
    }
    building_detail::advance(bank, ground.acceleration_mps2(), from, to, x.data(), y.data());
  }
}

/// The modes' states, while they are computed.
struct ModeStates {
  std::vector<double> x, y;
};

/// The sum of modes at nodes `from` to `to`.
void add_up(MotionTable& table, std::span<const ModeStates> states, std::size_t from,
            std::size_t to) {
  ModeSum& sum = table.modes;
  for (std::vector<double>* of : {&table.x, &table.y, &sum.a, &sum.jerk}) {
    of->resize(to + 1 + padding);
    std::fill(of->begin() + static_cast<std::ptrdiff_t>(from), of->end(), 0.0);
  }
  const double* ground = table.ground->acceleration_mps2().data();
  double *u = table.x.data(), *v = table.y.data(), *a = sum.a.data(), *jerk = sum.jerk.data();
  for (std::size_t n = 0; n < table.building.size(); ++n) {
    const Mode& mode = table.building[n];
    const double omega = omega_of(mode), gamma = mode.participation,
                 twice_zeta = 2.0 * mode.damping_ratio;
    const double per_u = gamma / (omega * omega), per_v = gamma / omega, per_jerk = gamma * omega;
    const double *x = states[n].x.data(), *y = states[n].y.data();
    for (std::size_t i = from; i <= to; ++i) {
      const double resisting = x[i] + twice_zeta * y[i];
      u[i] += per_u * x[i];
      v[i] += per_v * y[i];
      a[i] -= gamma * resisting;
      jerk[i] += per_jerk * (twice_zeta * (resisting + ground[i]) - y[i]);
    }
    sum.last[n] = {x[to], y[to]};
  }
}

}  // namespace

MotionNodes MotionTable::at_nodes() const {
  MotionNodes n;
  n.ground_ = ground->nodes().data();
  if (rigid()) return n;
  n.x_ = x.data();
  n.y_ = y.data();
  n.omega_radps_ = omega_radps;
  n.per_omega_s_ = 1.0 / omega_radps;
  n.twice_zeta_ = 2.0 * building[0].damping_ratio;
  n.quarter_step_s_ = 0.25 * step_s();
  n.five_per_step_ = 5.0 / step_s();
  if (is_one_mass()) return n;
  n.modes_ = &modes;
  n.ground_share_ = building.ground_share();
  return n;
}

MotionTable tabulate_rigid(std::shared_ptr<GroundTable> ground) {
  MotionTable table;
  table.end = ground->quiet_from();
  table.nodes = nodes_to(table.end, *ground);
  ground->extend(table.nodes + padding);
  table.ground = std::move(ground);
  building_detail::bound_ground(table);
  return table;
}

int parts_needed(const Modes& building, double dt_s) {
  if (building.rigid()) return 0;
  double wanted = 0.0;
  for (const Mode& mode : building) {
    // Above critical damping the faster of the two rates governs.
    const double zeta = mode.damping_ratio;
    const double rate = zeta > 1.0 ? zeta + std::sqrt(zeta * zeta - 1.0) : 1.0;
    wanted = std::max(wanted, nodes_per_period * rate * dt_s / mode.period_s);
  }
  if (wanted > most_parts) return 0;
  int parts = 1;
  while (parts < wanted) parts *= 2;
  return parts;
}

void tabulate_responses(const std::shared_ptr<GroundTable>& ground,
                        std::span<const Modes> buildings, std::span<const RoofMotionOptions> follow,
                        std::span<MotionTable> tables) {
  GLISSADE_EXPECTS(follow.size() == buildings.size() && tables.size() == buildings.size());
  const std::size_t quiet = ground->quiet_from();
  ground->extend(quiet + 1);
  std::vector<std::vector<ModeStates>> states(tables.size());
  std::vector<Responding> all;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    MotionTable& table = tables[k];
    GLISSADE_EXPECTS(!buildings[k].rigid());
    table.ground = ground;
    table.building = buildings[k];
    if (table.is_one_mass()) {
      table.modes = {};
      table.omega_radps = omega_of(table.building[0]);
      all.push_back({table.building[0].oscillator(), &table.x, &table.y});
      continue;
    }
    table.omega_radps = 1.0;
    table.modes.last.resize(table.building.size());
    states[k].resize(table.building.size());
    for (std::size_t n = 0; n < table.building.size(); ++n)
      all.push_back({table.building[n].oscillator(), &states[k][n].x, &states[k][n].y});
  }
  const auto resize = [&](std::size_t nodes) {
    for (const Responding& one : all) {
      one.x->resize(nodes + padding);
      one.y->resize(nodes + padding);
    }
  };
  resize(quiet + 1);
  for (const Responding& one : all) (*one.x)[0] = (*one.y)[0] = 0.0;  // at rest
  advance(all, *ground, 0, quiet);

  std::size_t most_nodes = 0;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    MotionTable& t = tables[k];
    if (!t.is_one_mass()) add_up(t, states[k], 0, quiet);
    const std::vector<OscillatorState> now =
        t.is_one_mass() ? std::vector{OscillatorState{t.x[quiet], t.y[quiet]}} : t.modes.last;
    t.end = quiet + building_detail::ring_down_steps(t.building, t.step_s(), now,
                                                     building_detail::velocity_range_mps(t, quiet),
                                                     follow[k].quiet_horizontal_mps2, follow[k]);
    most_nodes = std::max(most_nodes, nodes_to(t.end, *ground));
  }
  ground->extend(most_nodes + padding);
  resize(most_nodes);
  if (most_nodes > quiet + 1) advance(all, *ground, quiet, most_nodes - 1);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    MotionTable& table = tables[k];
    table.nodes = nodes_to(table.end, *ground);
    if (!table.is_one_mass()) add_up(table, states[k], quiet, table.nodes - 1);
    building_detail::bound_response(table);
  }
}

MotionTable tabulate_response(const std::shared_ptr<GroundTable>& ground, const Modes& building,
                              const RoofMotionOptions& follow) {
  MotionTable table;
  tabulate_responses(ground, {&building, 1}, {&follow, 1}, {&table, 1});
  return table;
}

void raise_to_largest(const Quartic& q, double& largest) {
  raise_to_largest(std::to_array(q.b), largest, [](double value) { return value; });
}

double peak_acceleration_mps2(const MotionTable& table) {
  const MotionNodes at = table.at_nodes();
  double peak = 0.0;
  for (std::size_t i = 0; i <= table.end; ++i)
    peak = std::max(peak, std::abs(at.acceleration_mps2(i)));
  if (table.rigid()) return peak;
  for (std::size_t i = 0; i < table.end; ++i)
    raise_to_largest(std::to_array(at.acceleration_after(i).b), peak,
                     [](double a) { return std::abs(a); });
  return peak;
}

void extend(MotionTable& table, std::size_t nodes) {
  if (nodes <= table.nodes) return;
  table.ground->extend(nodes + padding);
  if (table.rigid()) {
    table.nodes = nodes;
    return building_detail::bound_ground(table);
  }
  const std::size_t last = table.nodes - 1;
  std::vector<ModeStates> states(table.is_one_mass() ? 0 : table.building.size());
  std::vector<Responding> all;
  if (table.is_one_mass()) all.push_back({table.building[0].oscillator(), &table.x, &table.y});
  for (std::size_t n = 0; n < states.size(); ++n) {
    states[n].x.resize(last + 1, table.modes.last[n].x);
    states[n].y.resize(last + 1, table.modes.last[n].y);
    all.push_back({table.building[n].oscillator(), &states[n].x, &states[n].y});
  }
  for (const Responding& one : all) {
    one.x->resize(nodes + padding);
    one.y->resize(nodes + padding);
  }
  advance(all, *table.ground, last, nodes - 1);
  if (!table.is_one_mass()) add_up(table, states, last, nodes - 1);
  table.nodes = nodes;
  building_detail::bound_response(table);
}

}  // namespace glissade
