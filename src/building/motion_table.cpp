// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/building/motion_table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "glissade/core/contract.hpp"
#include "oscillator_bank.hpp"
#include "ring_down.hpp"

namespace glissade {
namespace {

using building_detail::bank_size;
using building_detail::load;
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

void resize_states(MotionTable& table, std::size_t nodes) {
  table.nodes = nodes;
  table.x.resize(nodes + padding);
  table.y.resize(nodes + padding);
}

/// Up to bank_size tables with ground and oscillator set.
void respond(GroundTable& ground, std::span<const RoofMotionOptions> follow,
             std::span<MotionTable> tables) {
  OscillatorBank bank;
  std::array<double*, bank_size> x{}, y{};
  const auto run = [&](std::size_t from, std::size_t to) {
    for (std::size_t k = 0; k < tables.size(); ++k) {
      x[k] = tables[k].x.data();
      y[k] = tables[k].y.data();
    }
    building_detail::advance(bank, ground.acceleration_mps2(), from, to, x.data(), y.data());
  };
  const std::size_t quiet = ground.quiet_from();
  ground.extend(quiet + 1);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    load(bank, k, tables[k]);
    resize_states(tables[k], quiet + 1);
    tables[k].x[0] = tables[k].y[0] = 0.0;  // at rest
  }
  run(0, quiet);

  std::size_t most_nodes = 0;
  for (std::size_t k = 0; k < tables.size(); ++k) {
    MotionTable& t = tables[k];
    t.end =
        quiet + building_detail::ring_down_steps(t.oscillator, t.step_s(), t.x[quiet], t.y[quiet],
                                                 building_detail::velocity_range_mps(t, quiet),
                                                 follow[k].quiet_horizontal_mps2, follow[k]);
    most_nodes = std::max(most_nodes, nodes_to(t.end, ground));
  }
  ground.extend(most_nodes + padding);
  for (MotionTable& table : tables) resize_states(table, most_nodes);
  if (most_nodes > quiet + 1) run(quiet, most_nodes - 1);
  for (MotionTable& table : tables) {
    table.nodes = nodes_to(table.end, ground);
    building_detail::bound_response(table);
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
  n.twice_zeta_ = 2.0 * oscillator.damping_ratio;
  n.quarter_step_s_ = 0.25 * step_s();
  n.five_per_step_ = 5.0 / step_s();
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

int parts_needed(const Oscillator& oscillator, double dt_s) {
  if (oscillator.period_s == 0.0) return 0;
  // Above critical damping the faster of the two rates governs.
  const double zeta = oscillator.damping_ratio;
  const double rate = zeta > 1.0 ? zeta + std::sqrt(zeta * zeta - 1.0) : 1.0;
  const double wanted = nodes_per_period * rate * dt_s / oscillator.period_s;
  if (wanted > most_parts) return 0;
  int parts = 1;
  while (parts < wanted) parts *= 2;
  return parts;
}

void tabulate_responses(const std::shared_ptr<GroundTable>& ground,
                        std::span<const Oscillator> oscillators,
                        std::span<const RoofMotionOptions> follow, std::span<MotionTable> tables) {
  GLISSADE_EXPECTS(follow.size() == oscillators.size() && tables.size() == oscillators.size());
  for (std::size_t k = 0; k < tables.size(); ++k) {
    GLISSADE_EXPECTS(oscillators[k].period_s > 0.0);
    tables[k].ground = ground;
    tables[k].oscillator = oscillators[k];
    tables[k].omega_radps = 2.0 * std::numbers::pi / oscillators[k].period_s;
  }
  for (std::size_t first = 0; first < tables.size(); first += bank_size) {
    const std::size_t count = std::min(bank_size, tables.size() - first);
    respond(*ground, follow.subspan(first, count), tables.subspan(first, count));
  }
}

namespace {

/// Raises `peak` to the largest size(quartic), refining only where the hull allows a larger value.
template <class Size>
void raise_to_peak(const Quartic& q, double& peak, Size size) {
  peak = std::max({peak, size(q.b[0]), size(q.b[4])});
  double hull = 0.0;
  for (const double b : q.b) hull = std::max(hull, size(b));
  if (hull <= peak * (1.0 + 1e-12)) return;
  Quartic left, right = q;
  for (int level = 0; level < 5; ++level) {  // de Casteljau, in the middle
    left.b[level] = right.b[0];
    for (int k = 0; k < 4 - level; ++k) right.b[k] = 0.5 * (right.b[k] + right.b[k + 1]);
  }
  raise_to_peak(left, peak, size);
  raise_to_peak(right, peak, size);
}

}  // namespace

void raise_to_largest(const Quartic& q, double& largest) {
  raise_to_peak(q, largest, [](double value) { return value; });
}

double peak_acceleration_mps2(const MotionTable& table) {
  const MotionNodes at = table.at_nodes();
  double peak = 0.0;
  for (std::size_t i = 0; i <= table.end; ++i)
    peak = std::max(peak, std::abs(at.acceleration_mps2(i)));
  if (table.rigid()) return peak;
  for (std::size_t i = 0; i < table.end; ++i)
    raise_to_peak(at.acceleration_after(i), peak, [](double a) { return std::abs(a); });
  return peak;
}

void extend(MotionTable& table, std::size_t nodes) {
  if (nodes <= table.nodes) return;
  table.ground->extend(nodes + padding);
  if (table.rigid()) {
    table.nodes = nodes;
    return building_detail::bound_ground(table);
  }
  OscillatorBank bank;
  load(bank, 0, table);
  const std::size_t last = table.nodes - 1;
  bank.x[0] = table.x[last];
  bank.y[0] = table.y[last];
  resize_states(table, nodes);
  std::array<double*, bank_size> x{table.x.data()}, y{table.y.data()};
  building_detail::advance(bank, table.ground->acceleration_mps2(), last, nodes - 1, x.data(),
                           y.data());
  building_detail::bound_response(table);
}

}  // namespace glissade
