// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "glissade/building/ground_table.hpp"

namespace glissade::block_detail {

/// The equations of a regime as the lanes take them, with the scaled amplitude Z = omega^2 z of
/// RegimeOscillator and sigma = s / omega:
///   x = -[H - lag dH] + Re(Z p),   y = -dH / angle + Re(sigma Z p),   a = a_g + Re(sigma^2 Z p)
///   p = exp((-decay + i turn) t), t in fractions of an interval
struct LaneRegime {
  double mass, weight;                       ///< H = mass a_g + weight (g + w)
  double lag, angle, per_angle;              ///< angle = omega dt
  double decay, turn;                        ///< s dt
  double sigma_re, sigma_im, sigma, per_im;  ///< sigma, |sigma|, 1 / sigma_im
  double phase, per_omega, per_omega2;       ///< phase = |s| dt
  /// Lines of a and g + w: at rest the drives down and up; sliding, minus the drive, and none.
  double a_1, w_1, a_2, w_2;
  const double *x = nullptr, *y = nullptr;  ///< response by node (CoupledTable::Response)
};

/// What the lanes have in common.
struct LaneTables {
  std::array<const LaneRegime*, 6> regimes{};  ///< at rest, down, up; the same while it yields
  const GroundNode *ground = nullptr, *vertical = nullptr;  ///< vertical: or none
  std::int64_t quiet = 0;  ///< the ground is at rest from this node on; tables end there
  double sign = 1.0;       ///< of the ground, which the responses have
  double step_s = 0.0, gravity_mps2 = 0.0, cot_slope = 0.0;
  double yielding_to_elastic = 0.0;  ///< omega
  bool yields = false;               ///< the spring may; else only the first three regimes are used
  bool has_yielding = true;          ///< the last three are of the yielding spring
  bool static_friction = false;      ///< above that of sliding
  std::int64_t end = 0;              ///< no interval is begun without a search from here on
  /// Terms of the series of p that count.
  static constexpr std::size_t most_terms = 10;
  std::size_t decay_terms = 1, turn_terms = 1;
};

/// Histories side by side, each at a piece of an interval between two events, or before one.
/// Between intervals with events a history is what it was at its reference node plus its tables and
/// a free vibration.
struct CoupledLanes {
  static constexpr std::size_t count = 8;
  using Row = double[count];

  // Of the history.
  alignas(64) Row intensity;
  Row w_factor;
  Row yield_mps2;
  // The present piece.
  Row left, length;     ///< of the interval; of that, the piece
  Row x, y, speed;      ///< RoofState; in the direction of sliding
  Row regime;           ///< index in LaneTables::regimes
  Row side;             ///< on which the spring yields: 1, -1 or 0
  Row highest, lowest;  ///< spring forces between which it is elastic
  // What has just happened where the piece begins.
  Row starts;   ///< sliding: 1, and the drive is zero there; 2: it has jumped above
  Row stopped;  ///< the direction in which it slid, or 0
  Row unloads;  ///< the side on which the spring yielded, or 0
  // The record so far.
  Row slip, farthest_down, farthest_up, duration_s, phases;
  // The reference node: state, amplitude Z of the free vibration, its size.
  Row x_from, y_from, speed_from, free_re, free_im, free_size;
  Row velocity_from, displacement_from, displacement_low_from;  ///< of the ground
  Row w_velocity_from, w_displacement_from, w_displacement_low_from;
  // Of a lane whose interval is new: where it is from the reference node.
  Row begins;  ///< 1, or 0
  Row steps, power_re, power_im;
  Row x_table, y_table;      ///< there, at unit intensity
  std::int64_t node[count];  ///< of the interval's begin; after its end, the reference node
};

/// Lanes as bits, after a step.
struct LanesDone {
  std::uint64_t searching = 0;  ///< the interval is over
  std::uint64_t undecided = 0;  ///< the bounds do not decide, however short the piece
  std::uint64_t started = 0;    ///< a phase of sliding has begun
};

/// Every active lane through its piece, to the first event or to the end. An event is solved where
/// bounds on derivatives prove that it is the only one; where they do not, the piece is halved.
/// Elementwise and unfused: the same bits on every SIMD target, in any company.
LanesDone step(CoupledLanes& lanes, const LaneTables& tables, std::uint64_t active);

/// How many terms of sinh(x) / x - 1 and cosh(x) - 1 count.
std::size_t terms_for(double x);

}  // namespace glissade::block_detail
