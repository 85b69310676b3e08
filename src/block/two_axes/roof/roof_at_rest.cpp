// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/two_axes/roof/roof_at_rest.hpp"

#include <algorithm>
#include <cmath>

namespace glissade::block_detail::two_axes {
namespace {

constexpr double zeros[8] = {};

}  // namespace

RoofAtRest::RoofAtRest(const SceneConstants& constants, RoofKind roof, const GroundNodes& ground,
                       const RestTable& table, const HistoryState& state)
    : constants_(constants),
      roof_(roof),
      ground_(ground),
      table_(table),
      after_record_(roof != RoofKind::modes &&
                    static_cast<std::size_t>(state.node) >= ground.quiet),
      springs_(state.springs),
      base_(static_cast<std::size_t>(state.node)) {
  if (!vibrates()) return;
  RoofState beside = state.roof(roof_);
  for (std::size_t n = 0; n < 2; ++n) {
    if (roof_ == RoofKind::coupled_modes) beside[n] = table_.rest[n].vibrations(beside[n]);
    for (std::size_t k = 0; k < table_.free[n].size() && !after_record_; ++k) {
      const OscillatorState own = table_.state(n, base_, k);
      beside[n][k].x -= factor(n) * own.x;
      beside[n][k].y -= factor(n) * own.y;
    }
  }
  if (roof_ == RoofKind::building && !after_record_) beside = {};  // rounding
  set_free(base_, beside);
}

void RoofAtRest::set_free(std::size_t node, const RoofState& state) {
  base_ = node;
  free_ = state;
  set_bounds(free_);
}

void RoofAtRest::set_bounds(const RoofState& free) {
  free_bound_ = free_deviation_ = {};
  for (std::size_t n = 0; n < 2; ++n)
    for (std::size_t k = 0; k < table_.free[n].size(); ++k) {
      const double bound = table_.free[n][k].bound(free[n][k]);
      free_bound_[n] += bound;
      free_deviation_[n] += bound * table_.free[n][k].deviation();
    }
}

RoofState RoofAtRest::free_at(std::size_t node) const {
  RoofState free{};
  for (std::size_t n = 0; n < 2; ++n)
    for (std::size_t k = 0; k < table_.free[n].size(); ++k)
      free[n][k] = table_.free[n][k].after(node - base_, free_[n][k]);
  return free;
}

RoofState RoofAtRest::in_table(std::size_t node) const {
  RoofState state = free_at(node);
  for (std::size_t n = 0; n < 2 && !after_record_; ++n)
    for (std::size_t k = 0; k < table_.free[n].size(); ++k) {
      const OscillatorState own = table_.state(n, node, k);
      state[n][k].x += factor(n) * own.x;
      state[n][k].y += factor(n) * own.y;
    }
  return state;
}

RoofState RoofAtRest::state(std::size_t node) const {
  RoofState state = in_table(node);
  if (roof_ == RoofKind::coupled_modes)
    for (std::size_t n = 0; n < 2; ++n) state[n] = table_.rest[n].modes(state[n]);
  return state;
}

void RoofAtRest::end_record() {
  const RoofState all = in_table(ground_.quiet);
  after_record_ = true;
  if (vibrates()) set_free(ground_.quiet, all);
}

void RoofAtRest::renew(std::size_t node) {
  if (!vibrates()) return;
  if (after_record_) return set_free(node, in_table(node));
  set_bounds(free_at(node));
}

bool RoofAtRest::sticks(const std::array<double, 2>& a, double w) const {
  const Constants<double>& c = constants_;
  const double most = std::sqrt(a[0] * a[0] + a[1] * a[1]) * (1.0 + 1e-12);
  return (c.gravity + w) * c.tangent + most * std::max(1.0, c.per_aspect) / c.cosine <=
         c.mu_at_rest * (c.gravity - w - c.tangent * most) * (1.0 - 1e-12);
}

bool RoofAtRest::sticks_from(std::size_t node) const {
  const std::size_t k = node / tile_nodes;
  if (after_record_)
    return sticks(free_bound_, 0.0) && stays_elastic([](std::size_t) { return 0.0; });
  std::array<double, 2> a = free_bound_;
  for (std::size_t n = 0; n < 2; ++n) a[n] += std::abs(factor(n)) * table_.coming[n][k];
  return sticks(a, std::abs(constants_.factor_w) * ground_.w_to_come(k)) &&
         stays_elastic(
             [&](std::size_t n) { return std::abs(factor(n)) * table_.spring_coming[n][k]; });
}

double RoofAtRest::deviation(std::size_t axis, std::size_t node) const {
  const double free = free_deviation_[axis];
  return after_record_ ? free
                       : free + std::abs(factor(axis)) * table_.deviation[axis][node / tile_nodes];
}

std::array<RoofAtRest::TileNodes, 2> RoofAtRest::accelerations(std::size_t node) const {
  std::array<TileNodes, 2> a{};
  for (std::size_t n = 0; n < 2; ++n) {
    for (std::size_t i = 0; i < a[n].size() && !after_record_; ++i)
      a[n][i] = factor(n) * table_.a[n][node + i];
    for (const FreeVibration& free : table_.free[n]) {
      const OscillatorState& from =
          free_[n][static_cast<std::size_t>(&free - table_.free[n].data())];
      for (std::size_t i = 0; i < a[n].size(); i += 8) {
        const OscillatorState state = free.after(node + i - base_, from);
        for (std::size_t k = 0; k < 8; ++k)
          a[n][i + k] += free.x_part()[k] * state.x + free.y_part()[k] * state.y;
      }
    }
  }
  return a;
}

std::array<double, 2> RoofAtRest::bound_in_tile(std::size_t node) const {
  std::array<double, 2> a = free_bound_;
  for (std::size_t n = 0; n < 2 && !after_record_; ++n)
    a[n] += std::abs(factor(n)) * table_.tile[n][node / tile_nodes] + deviation(n, node);
  return a;
}

bool RoofAtRest::sticks_in_tile(std::size_t node) const {
  const std::size_t k = node / tile_nodes;
  return !after_record_ &&
         sticks(bound_in_tile(node), std::abs(constants_.factor_w) * ground_.largest_w(k)) &&
         stays_elastic([&](std::size_t n) {
           const double left = table_.deviation[n][k] / constants_.per_mass;
           return std::abs(factor(n)) * (table_.spring_tile[n][k] + left);
         });
}

/// No spring leaves its limits where the table's part of its force is within largest(axis).
bool RoofAtRest::stays_elastic(const auto& largest) const {
  if (roof_ != RoofKind::yielding) return true;
  for (std::size_t n = 0; n < 2; ++n) {
    const double most = largest(n) + free_bound_[n] / constants_.per_mass;
    if (!(most < springs_.high[n] && -most > springs_.low[n])) return false;
  }
  return true;
}

std::size_t RoofAtRest::tile_end(std::size_t node) const {
  return after_record_ ? std::min(node + tile_nodes - 1, ground_.end)
                       : std::min((node / tile_nodes + 1) * tile_nodes, table_.end);
}

std::size_t RoofAtRest::first_release(std::size_t from, std::size_t end) const {
  const Constants<double>& c = constants_;
  const double rounding = 1e-12 * c.gravity;
  const double needed =
      (deviation(0, from) + deviation(1, from)) * reserve_per_acceleration(c) + rounding;
  RestMotion motion;
  motion.springs = roof_ == RoofKind::yielding;
  for (std::size_t i = from; i <= end; i += 8) {
    for (std::size_t n = 0; n < 2; ++n) {
      RestMotion::Axis& axis = motion.axis[n];
      axis.a = after_record_ ? zeros : table_.a[n] + i;
      axis.factor = factor(n);
      axis.count = table_.free[n].size();
      for (std::size_t k = 0; k < axis.count; ++k) {
        const FreeVibration& free = table_.free[n][k];
        axis.free[k] = {free.x_part().data(), free.y_part().data(),
                        free.after(i - base_, free_[n][k])};
      }
      if (!motion.springs) continue;
      const FreeVibration& free = table_.free[n][0];
      const double left = deviation(n, from) / c.per_mass;  // of E, and more than the spring's
      axis.spring = {after_record_ ? zeros : table_.x[n].data() + i, free.own_x_part().data(),
                     free.own_y_part().data(), springs_.low[n] + left, springs_.high[n] - left};
    }
    motion.w = i > ground_.quiet ? zeros : ground_.w.data() + i;
    const std::size_t released = two_axes::first_release(motion, c, needed);
    if (released < 8) return std::min(i + released, end + 1);
  }
  return end + 1;
}

}  // namespace glissade::block_detail::two_axes
