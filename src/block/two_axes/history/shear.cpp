// SPDX-License-Identifier: GPL-3.0-or-later
// The base shear of the building under a history.
#include <algorithm>

#include "block/polynomial/power_series.hpp"
#include "block/two_axes/history/history.hpp"
#include "block/two_axes/roof/roof_at_rest.hpp"

namespace glissade::block_detail::two_axes {

void LaneHistory::raise_shear(const RoofAtRest& roof, std::size_t from, std::size_t to) {
  if (!follows_shear()) return;
  for (std::size_t begin = from, end = begin; begin < to; begin = end) {
    end = std::min(roof.tile_end(begin), to);
    const std::array<double, 2> most = roof.bound_in_tile(begin);
    if (most[0] <= largest_a_[0] && most[1] <= largest_a_[1]) continue;
    const std::array<RoofAtRest::TileNodes, 2> a = roof.accelerations(begin);
    const auto largest_at = [&](std::size_t n, std::size_t i) {
      return std::max(std::abs(a[n][i]), std::abs(a[n][i + 1]));
    };
    for (std::size_t n = 0; n < 2; ++n)
      for (std::size_t i = 0; i < end - begin; ++i)
        largest_a_[n] = std::max(largest_a_[n], largest_at(n, i));
    for (std::size_t i = 0; i < end - begin; ++i) {
      const auto may_exceed = [&](std::size_t n) {
        return largest_at(n, i) + roof.deviation(n, begin) > largest_a_[n];
      };
      if (may_exceed(0) || may_exceed(1))
        piece(resting_at(begin + i, roof.state(begin + i))).raise(largest_a_, 1.0);
    }
  }
}

void LaneHistory::raise_shear_to_end(RoofAtRest& roof, std::size_t from) {
  if (!follows_shear()) return;
  for (std::size_t i = from; i < ground_.end;) {
    if (!roof.after_record() && i >= table_->end) roof.end_record();
    const std::array<double, 2> bound = roof.bound_in_tile(i);  // after the record of all to come
    if (roof.after_record() && bound[0] <= largest_a_[0] && bound[1] <= largest_a_[1]) return;
    const std::size_t end = roof.tile_end(i);
    raise_shear(roof, i, end);
    roof.renew(i = end);
  }
}

void LaneHistory::raise_shear(const HistoryState& state, const RoofPiece& piece, const Stop& stop) {
  if (!follows_shear() || !has_mass(roof_)) return;
  const SceneConstants& c = constants_;
  const std::array<double, 2> b = plan_velocity(velocity(state)).begin;
  const double fraction = stop.time_s / piece.length_s();
  const auto may_exceed = [&](std::size_t n, double omega, double omega_rho, double twice_zeta) {
    const double of_velocity =
        2.0 * omega_rho * std::abs(b[n]) * (twice_zeta + omega * stop.time_s);
    return piece.bound(n, fraction) + of_velocity > largest_a_[n];
  };
  if (may_exceed(0, c.omega_1, c.omega_rho_1, c.twice_zeta_1) ||
      may_exceed(1, c.omega_2, c.omega_rho_2, c.twice_zeta_2))
    stopping_piece(state, stop).raise(largest_a_, fraction);
}

void LaneHistory::raise_shear(const LaneStates& lanes, std::size_t lane) {
  const LaneStates::Shear& shear = lanes.shear;
  for (std::size_t n = 0; n < 2; ++n) {
    Series a;
    a.terms = row_terms;
    for (std::size_t k = 0; k < row_terms; ++k) a.c[k] = shear.a[n][k][lane];
    raise_largest(largest_a_[n], a, shear.fraction[lane]);
  }
}

}  // namespace glissade::block_detail::two_axes
