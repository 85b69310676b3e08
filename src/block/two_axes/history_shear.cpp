// SPDX-License-Identifier: GPL-3.0-or-later
// The base shear of the building under a history.
#include <algorithm>

#include "block/polynomial/power_series.hpp"
#include "block/two_axes/roof/roof_at_rest.hpp"
#include "history.hpp"

namespace glissade::block_detail::two_axes {

void LaneHistory::raise_shear(const RoofAtRest& roof, std::size_t from, std::size_t to) {
  if (!follows_shear()) return;
  const auto may_exceed = [&](const std::array<double, 2>& a) {
    return a[0] > largest_a_[0] || a[1] > largest_a_[1];
  };
  for (std::size_t i = from; i < to;) {
    const std::size_t end = std::min(roof.tile_end(i), to);
    if (!may_exceed(roof.bound_in_tile(i))) {
      i = end;
      continue;
    }
    for (std::array<double, 2> begin = roof.acceleration(i); i < end; ++i) {
      const std::array<double, 2> next = roof.acceleration(i + 1);
      const auto bound = [&](std::size_t n) {
        return std::max(std::abs(begin[n]), std::abs(next[n])) + roof.deviation(n, i);
      };
      if (may_exceed({bound(0), bound(1)}))
        piece(resting_at(static_cast<std::int64_t>(i), roof.state(i))).raise(largest_a_, 1.0);
      begin = next;
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

void LaneHistory::raise_shear(const HistoryState& state, const Stop& stop) {
  if (follows_shear() && has_mass(roof_))
    stopping_piece(state, stop).raise(largest_a_, stop.time_s / (ground_.dt_s * state.motion.left));
}

void LaneHistory::raise_shear(const LaneStates& lanes, std::size_t lane) {
  const LaneStates::Shear& shear = lanes.shear;
  for (std::size_t n = 0; n < 2; ++n) {
    Series a;
    a.terms = row_terms;
    for (std::size_t k = 0; k < row_terms; ++k) a.c[k] = shear.a[n][k][lane];
    largest_a_[n] = std::max(largest_a_[n], largest(a, shear.fraction[lane]));
  }
}

}  // namespace glissade::block_detail::two_axes
