// SPDX-License-Identifier: GPL-3.0-or-later
// The roof of several modes: at the ground's nodes, and between them as power series.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "block/full_model/chord_deviation.hpp"
#include "block/two_axes/roof/tables.hpp"
#include "glissade/core/oscillator.hpp"

namespace glissade::block_detail::two_axes {
namespace {

using Row = std::array<double, row_terms>;

/// The points of a polynomial of row_terms terms on [0, 1], those of Chebyshev with both ends: a
/// mode of phase p over the interval is off by some 2 (p / 4)^10 / 10! of its acceleration.
struct FitPoints {
  std::array<double, row_terms> at;
  /// Powers of the polynomial that is 1 at one point and 0 at the others.
  std::array<std::array<long double, row_terms>, row_terms> one_at{};

  FitPoints() {
    for (std::size_t j = 0; j < row_terms; ++j)
      at[j] = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(j) / (row_terms - 1));
    for (std::size_t j = 0; j < row_terms; ++j) {
      auto& c = one_at[j];
      c[0] = 1.0L;
      for (std::size_t i = 0, degree = 0; i < row_terms; ++i) {
        if (i == j) continue;
        const long double point = at[i], scale = 1.0L / (at[j] - point);
        ++degree;
        for (std::size_t k = degree; k > 0; --k) c[k] = (c[k - 1] - point * c[k]) * scale;
        c[0] *= -point * scale;
      }
    }
  }
  Row through(const Row& values) const {
    Row row;
    for (std::size_t k = 0; k < row_terms; ++k) {
      long double sum = 0.0L;
      for (std::size_t j = 0; j < row_terms; ++j) sum += values[j] * one_at[j][k];
      row[k] = static_cast<double>(sum);
    }
    return row;
  }
};

/// Unrolled, the sum stays in registers.
inline void add(Row& sum, double factor, const Row& row) {
#pragma GCC unroll 10
  for (std::size_t k = 0; k < row_terms; ++k) sum[k] += factor * row[k];
}

/// A mode's part in the roof's acceleration over an interval, by its state at the begin and the
/// ground at both ends.
struct ModeRows {
  Row of_x, of_y, of_begin, of_end;
  OscillatorStep step;

  ModeRows(const Mode& mode, double dt_s) {
    static const FitPoints points;
    const double phase = 2.0 * std::numbers::pi / mode.period_s * dt_s;
    step = oscillator_step(phase, mode.damping_ratio);
    const auto acceleration = [&](double x, double y) {
      return -mode.participation * (2.0 * mode.damping_ratio * y + x);
    };
    Row x, y, begin, end;
    for (std::size_t j = 0; j < row_terms; ++j) {
      const double tau = points.at[j];
      const OscillatorStep s =
          tau > 0.0 ? oscillator_step(phase * tau, mode.damping_ratio) : OscillatorStep{};
      x[j] = acceleration(s.xx, -s.xy);
      y[j] = acceleration(s.xy, s.yy);
      const double left = 1.0 - tau;
      begin[j] = -acceleration(s.x_start + left * s.x_end, s.y_start + left * s.y_end);
      end[j] = -acceleration(tau * s.x_end, tau * s.y_end);
    }
    of_x = points.through(x);
    of_y = points.through(y);
    of_begin = points.through(begin);
    of_end = points.through(end);
  }
};

/// When free vibration has fallen to a twentieth.
double decay_s(const std::array<Modes, 2>& axes) {
  double longest = 0.0;
  for (const Modes& axis : axes)
    for (const Mode& mode : axis)
      longest = std::max(longest, mode.period_s / (2.0 * std::numbers::pi * mode.damping_ratio));
  return std::log(20.0) * longest;
}

}  // namespace

void RestTable::tabulate(const GroundNodes& ground, const std::array<Modes, 2>& modes) {
  end = std::min(ground.quiet + static_cast<std::size_t>(std::ceil(decay_s(modes) / ground.dt_s)),
                 ground.end);
  // A table made again overwrites all but the padding, which is zero.
  rows.resize((end + 1) * 2 * row_terms);
  for (std::size_t n = 0; n < 2; ++n) {
    const std::size_t padded = end + 1 + padding;
    if (own_a[n].size() != padded) own_a[n].assign(padded, 0.0);
    deviation[n].assign(tiles_of(end), 0.0);
    const double after = tabulate_axis(n, ground, modes[n]);
    a[n] = own_a[n].data();
    tile[n] = tile_maxima(a[n], end);
    coming[n] = suffix_maxima(between_nodes(tile[n], deviation[n]), after);
  }
}

double RestTable::tabulate_axis(std::size_t n, const GroundNodes& ground, const Modes& modes) {
  std::vector<ModeRows> by_mode;
  Row of_begin{}, of_end{};
  of_begin[0] = modes.ground_share();
  of_begin[1] = -modes.ground_share();
  of_end[1] = modes.ground_share();
  for (const Mode& mode : modes) {
    by_mode.emplace_back(mode, ground.dt_s);
    add(of_begin, 1.0, by_mode.back().of_begin);
    add(of_end, 1.0, by_mode.back().of_end);
  }
  std::array<OscillatorState, most_modes> now{};  // from rest at the first sample
  for (std::size_t i = 0; i <= end; ++i) {
    const double a0 = ground.ground(n, i), a1 = ground.ground(n, i + 1);
    Row row{};
    add(row, a0, of_begin);
    add(row, a1, of_end);
    for (std::size_t m = 0; m < by_mode.size(); ++m) {
      const ModeRows& mode = by_mode[m];
      OscillatorState& state = now[m];
      add(row, state.x, mode.of_x);
      add(row, state.y, mode.of_y);
      state = mode.step.after(state, a0, a1);
    }
    std::ranges::copy(row, rows.begin() + static_cast<std::ptrdiff_t>((2 * i + n) * row_terms));
    own_a[n][i] = row[0];
    double& largest = deviation[n][i / tile_nodes];
    largest = std::max(largest, chord_deviation(row));
  }
  add_interval_before(deviation[n]);
  double after = 0.0;  // bound of its |acceleration|
  for (std::size_t m = 0; m < by_mode.size(); ++m) {
    const double zeta = modes[m].damping_ratio;
    after += std::abs(modes[m].participation) * (1.0 + 2.0 * zeta) *
             free_vibration_envelope(now[m].x, now[m].y, zeta).amplitude;
  }
  return after;
}

}  // namespace glissade::block_detail::two_axes
