// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "block/contact/coupled_regime.hpp"

namespace glissade::block_detail {

// Searching a table for the next node where an event is possible. In single precision, with bounds
// on the safe side: what is found is looked at exactly, and what is passed over cannot matter.
// Compiled once per SIMD target, chosen at run time; nodes and tiles as in CoupledTable.

/// intensity table + Re(amplitude exp(s t)), the free vibration from node `from` on.
struct Vibration {
  const RegimeOscillator* regime = nullptr;
  float intensity = 0.0f;
  Amplitude amplitude;
  double size = 0.0;  ///< of it
};

/// A block at rest begins to slide where this leaves [lowest, highest].
struct RestSearch {
  Vibration motion;
  const float *below = nullptr, *above = nullptr;            ///< by node
  const float *tile_below = nullptr, *tile_above = nullptr;  ///< by tile, and between nodes
  const float* tile_amplitude = nullptr;
  double lowest = 0.0, highest = 0.0;
  double room = 0.0;  ///< for rounding
};
/// The first node in [from, to) at or beside which the block may start, else to.
std::size_t next_start(const RestSearch& search, std::size_t from, std::size_t to);

/// speed = drive_a (motion) + constant + per_step n, n nodes from `from` on.
struct SpeedSearch {
  Vibration motion;
  const float* gain = nullptr;            ///< by node
  const float* tile_deviation = nullptr;  ///< by tile
  float drive_a = 0.0f, constant = 0.0f, per_step = 0.0f;
  float deviation = 0.0f;  ///< of the free vibration
};
/// The first node in [from, to) at or beside which the block may stop, else to.
std::size_t next_stop(const SpeedSearch& search, std::size_t from, std::size_t to);

/// Between a node and the next nothing but the motion's own events happens where
///   (g + w) cot + a > 0,   lowest < x < highest,   side y > 0 unless side is 0
struct LimitSearch {
  const RegimeOscillator* regime = nullptr;
  double intensity = 0.0, w_factor = 0.0;
  Amplitude free;                                         ///< of the free vibration at node `from`
  const double *x = nullptr, *y = nullptr, *w = nullptr;  ///< by node; w: or none
  // By tile, and between nodes.
  const float *tile_a = nullptr, *tile_x = nullptr, *tile_amplitude = nullptr;
  const double *tile_lowest_w = nullptr, *tile_highest_w = nullptr;
  double cot_slope = 0.0, lowest = 0.0, highest = 0.0;
  int side = 0;
};
/// The first node in [from, to) at or beside which one of them may fail, else to.
std::size_t next_limit(const LimitSearch& search, std::size_t from, std::size_t to);

}  // namespace glissade::block_detail
