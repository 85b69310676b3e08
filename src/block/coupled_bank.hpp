// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

namespace glissade::block_detail {

/// Histories that go through the SIMD lanes side by side. What is here decides only where nothing
/// happens; in an interval where something may, a lane is flagged.
struct CoupledBank {
  static constexpr std::size_t lanes = 16;
  using Lanes = double[lanes];

  /// At the last two nodes in turn: `now`, and the one that is being worked out.
  struct alignas(64) State {
    Lanes x = {}, y = {};          ///< scaled (core/oscillator.hpp), of the building alone
    Lanes elastic = {};            ///< P = x + 2 zeta y = -E
    Lanes turn = {};               ///< its rate over omega: P turns where this changes sign
    Lanes forcing = {};            ///< A: mode mass (u'' + A) = -P
    Lanes speed = {};              ///< of the block, in its direction
    Lanes peak = {}, peak_x = {};  ///< of |P| and |x| at nodes, or between where that is known
  } state[2];
  int now = 0;

  // Of the mode a lane is in: the exact step ...
  alignas(64) Lanes xx = {}, xy = {}, yx = {}, yy = {}, x_start = {}, x_end = {}, y_start = {},
                    y_end = {}, twice_zeta = {}, per_mass = {};
  Lanes ground = {}, vertical = {}, constant = {};  ///< A = ground a_g + vertical w + constant
  // ... the block's speed by the change of y, the sums of a_g and w at both ends, and gravity ...
  Lanes speed_y = {}, speed_a = {}, speed_w = {}, speed_g = {};
  // ... and what must hold for nothing to happen. P between its limits, which move with w;
  Lanes lowest = {}, highest = {}, lowest_w = {}, highest_w = {};
  Lanes least_speed = {};  ///< speed at least; infinity flags the lane whatever happens
  Lanes y_bound = {};      ///< |y| at most: the bounds on the motion rest on it
  Lanes sag = {};          ///< a turn this far below the peak cannot exceed it
};

/// The ground at its nodes.
struct BankGround {
  const double *a, *w;  ///< w: null where there is none
};

/// Lanes, as bits.
struct Flags {
  std::uint32_t moves = 0;  ///< an event may be in the interval: the state after it does not count
  std::uint32_t peaks = 0;  ///< |P| or |x| has a turn that may exceed its peak
  bool any() const { return (moves | peaks) != 0; }
};

/// Steps from node `from` on, at most to node `to`. Returns the node reached: `to`, or the first
/// after an interval in which lanes are flagged.
std::size_t walk(CoupledBank& bank, const BankGround& ground, std::size_t from, std::size_t to,
                 Flags& flags);

}  // namespace glissade::block_detail
