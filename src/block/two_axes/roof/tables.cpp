// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/roof/tables.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "block/full_model/chord_deviation.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail::two_axes {
std::vector<double> tile_maxima(const double* values, std::size_t last_node) {
  std::vector<double> largest(tiles_of(last_node), 0.0);
  for (std::size_t k = 0; k < largest.size(); ++k) {
    double most = 0.0;
    for (std::size_t i = k * tile_nodes; i <= (k + 1) * tile_nodes; ++i)
      most = std::max(most, std::abs(values[i]));
    largest[k] = most;
  }
  return largest;
}

std::vector<double> between_nodes(std::vector<double> at_nodes,
                                  const std::vector<double>& deviation, double factor) {
  for (std::size_t k = 0; k < at_nodes.size(); ++k) at_nodes[k] += factor * deviation[k];
  return at_nodes;
}

std::vector<double> suffix_maxima(std::vector<double> values, double after) {
  for (std::size_t k = values.size(); k-- > 0;) values[k] = after = std::max(values[k], after);
  return values;
}

void add_interval_before(std::vector<double>& by_tile) {
  for (std::size_t k = by_tile.size(); k-- > 1;) by_tile[k] = std::max(by_tile[k], by_tile[k - 1]);
}

GroundNodes::GroundNodes(const BuildingGround& ground) : dt_s(ground.horizontal[0]->step_s()) {
  const GroundTable* up = ground.vertical != nullptr ? ground.vertical->ground.get() : nullptr;
  const GroundTable* tables[] = {ground.horizontal[0].get(), ground.horizontal[1].get(), up};
  for (const GroundTable* table : tables)
    if (table != nullptr) quiet = std::max(quiet, table->quiet_from());
  end = quiet + static_cast<std::size_t>(
                    std::min(RoofMotionOptions{}.longest_ring_down_s / dt_s, most_ring_down_steps));
  nodes.assign(std::max(4 * (quiet + 1), 2 * row_terms), 0.0);  // at least a row for any lane
  std::vector<double>* rows[] = {&a[0], &a[1], &w};
  for (std::size_t n = 0; n < 3; ++n) {
    rows[n]->assign(quiet + 1 + padding, 0.0);
    if (tables[n] == nullptr) continue;
    const auto values = tables[n]->acceleration_mps2();
    const std::size_t count = std::min(values.size(), tables[n]->quiet_from());
    for (std::size_t i = 0; i < count; ++i) nodes[4 * i + n] = (*rows[n])[i] = values[i];
  }
  tile_w = tile_maxima(w.data(), quiet);
  coming_w = suffix_maxima(tile_w, 0.0);
}

FreeVibration::FreeVibration(double omega_radps, double twice_zeta, double per_mass, double dt_s,
                             std::size_t steps)
    : twice_zeta_(twice_zeta), per_mass_(per_mass), root_mass_(1.0 / std::sqrt(per_mass)) {
  const double phase = omega_radps * dt_s / root_mass_, zeta = 0.5 * twice_zeta_ / root_mass_;
  const OscillatorStep s =
      oscillator_step(omega_radps * dt_s, 0.5 * twice_zeta, 1.0 / per_mass, root_mass_);
  repeat({s.xx, s.xy, -s.yx, s.yy}, steps);
  constexpr double margin = 1.2;
  deviation_ = 0.125 * phase * phase * (1.0 + 4.0 * zeta) * (1.0 + 4.0 * zeta) * margin;
}

// The same members say that x is the acceleration: -(0 y + x) (-1).
FreeVibration::FreeVibration(std::complex<double> rate_per_s, double dt_s, std::size_t steps)
    : twice_zeta_(0.0),
      per_mass_(-1.0),
      root_mass_(1.0),
      deviation_(0.125 * std::norm(rate_per_s * dt_s)) {
  const std::complex<double> s = std::exp(rate_per_s * dt_s);
  repeat({s.real(), -s.imag(), s.imag(), s.real()}, steps);
}

void FreeVibration::repeat(const Matrix& one, std::size_t steps) {
  const auto times = [](const Matrix& a, const Matrix& b) {
    return Matrix{a.xx * b.xx + a.xy * b.yx, a.xx * b.xy + a.xy * b.yy, a.yx * b.xx + a.yy * b.yx,
                  a.yx * b.xy + a.yy * b.yy};
  };
  for (std::size_t k = 1; k < tile_nodes; ++k) near_[k] = times(one, near_[k - 1]);
  const Matrix per_tile = times(one, near_[tile_nodes - 1]);
  far_.resize(steps / tile_nodes + 2);
  for (std::size_t k = 1; k < far_.size(); ++k) far_[k] = times(per_tile, far_[k - 1]);
  for (std::size_t k = 0; k < 8; ++k) {
    own_x_part_[k] = near_[k].xx;
    own_y_part_[k] = near_[k].xy;
    x_part_[k] = -(twice_zeta_ * near_[k].yx + near_[k].xx) * per_mass_;
    y_part_[k] = -(twice_zeta_ * near_[k].yy + near_[k].xy) * per_mass_;
  }
}

OscillatorState FreeVibration::after(std::size_t steps, const OscillatorState& from) const {
  const Matrix &f = far_[steps / tile_nodes], &n = near_[steps % tile_nodes];
  const double x = f.xx * from.x + f.xy * from.y, y = f.yx * from.x + f.yy * from.y;
  return {n.xx * x + n.xy * y, n.yx * x + n.yy * y};
}

double FreeVibration::bound(const OscillatorState& s) const {
  const double zeta = 0.5 * twice_zeta_ / root_mass_;
  const Envelope envelope = free_vibration_envelope(s.x * per_mass_, s.y / root_mass_, zeta);
  return (1.0 + 2.0 * zeta) * envelope.amplitude;
}

void RestTable::tabulate(const GroundNodes& ground, const SceneConstants& c, RoofKind roof) {
  free = {};
  end = ground.quiet;
  for (std::size_t n = 0; n < 2; ++n) {
    a[n] = ground.a[n].data();
    deviation[n].assign(tiles_of(ground.quiet), 0.0);
    const double after = roof == RoofKind::rigid           ? 0.0
                         : roof == RoofKind::coupled_modes ? tabulate_modes_at_rest(n, ground, c)
                                                           : tabulate_axis(n, ground, c);
    tile[n] = tile_maxima(a[n], ground.quiet);
    coming[n] = suffix_maxima(between_nodes(tile[n], deviation[n]), after);
  }
}

double RestTable::tabulate_axis(std::size_t n, const GroundNodes& ground,
                                const Constants<double>& c) {
  const std::size_t quiet = ground.quiet;
  const double omega = n == 0 ? c.omega_1 : c.omega_2;
  const double twice_zeta = n == 0 ? c.twice_zeta_1 : c.twice_zeta_2;
  free[n].emplace_back(omega, twice_zeta, c.per_mass, ground.dt_s, quiet);
  const double phase = omega * ground.dt_s;
  const OscillatorStep step =
      oscillator_step(phase, 0.5 * twice_zeta, 1.0 / c.per_mass, 1.0 / std::sqrt(c.per_mass));
  const double per_left = 1.0 / (1.0 - (phase + twice_zeta) * phase * c.per_mass);
  // A table made again overwrites all but the first node and the padding, which are zero.
  x[n].resize(quiet + 1 + padding);
  y[n].resize(quiet + 1);
  own_a[n].resize(quiet + 1 + padding);
  OscillatorState now;  // from rest at the first sample, whatever its acceleration
  const double* g = ground.a[n].data();
  double largest = 0.0;  // departure in a tile
  for (std::size_t i = 0; i < quiet; ++i) {
    const ChordDeviation departs(phase, twice_zeta, c.per_mass, per_left,
                                 std::abs(own_a[n][i] - g[i]), std::abs(now.y),
                                 std::abs(g[i + 1] - g[i]));
    largest = std::max(largest, departs.e * c.per_mass);
    if (i % tile_nodes == tile_nodes - 1 || i + 1 == quiet)
      deviation[n][i / tile_nodes] = std::exchange(largest, 0.0);
    now = step.after(now, g[i], g[i + 1]);
    x[n][i + 1] = now.x;
    y[n][i + 1] = now.y;
    own_a[n][i + 1] = free[n][0].acceleration(now);
  }
  add_interval_before(deviation[n]);
  a[n] = own_a[n].data();
  const double after = free[n][0].bound(now);
  spring_tile[n] = tile_maxima(x[n].data(), quiet);
  spring_coming[n] = suffix_maxima(between_nodes(spring_tile[n], deviation[n], 1.0 / c.per_mass),
                                   after / c.per_mass);
  return after;
}

}  // namespace glissade::block_detail::two_axes
