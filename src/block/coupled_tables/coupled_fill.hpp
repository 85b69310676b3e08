// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "glissade/building/ground_table.hpp"

namespace glissade::block_detail {

// What of a CoupledTable runs over all nodes: one pass, in tiles of 64 nodes. Compiled once per
// SIMD target, every operation elementwise and unfused and maxima exact, so all targets give the
// same bits.

/// One oscillator, and what is tabulated of it. Where x is null nothing is.
struct ResponseFill {
  /// Exact step of its scaled state (x, y) under the forcing p = per_a a + per_w w.
  struct Step {
    double xx, xy, yx, yy, x_start, x_end, y_start, y_end, per_a, per_w;
  } step;
  double *x = nullptr, *y = nullptr;  ///< by node
  /// Of the amplitude z, with X = x + p - lag dp, Y = y + dp / (omega dt):
  ///   |s^2 z| = sqrt(X^2 + (c_x X + c_y Y)^2) / D
  double lag, per_step, c_x, c_y, per_mass;
  /// By tile, the largest at its nodes and the one before: |s^2 z|, |x + 2 zeta y|, |x|.
  float *amplitude, *resisting, *x_size;
};

/// x_factor x + y_factor y + a_factor A + w_factor W of an oscillator and two lines of the ground.
/// Where values is null nothing is made.
struct LineFill {
  double x_factor = 0.0, y_factor = 0.0, a_factor = 0.0, w_factor = 0.0;
  float *values = nullptr, *tile_lowest = nullptr,
        *tile_highest = nullptr;  ///< by node, and extremes by tile
  float* tile_change =
      nullptr;  ///< largest change of the line of a and w from the node before to the next
};

struct TableFill {
  // By node. The lanes read the same nodes, which this loop brings into the cache.
  const GroundNode *ground, *vertical;  ///< vertical: or none
  double twice_zeta;
  std::array<ResponseFill, 3> responses{};
  std::array<LineFill, 2> rest{};    ///< of the first, with w
  std::array<LineFill, 2> speeds{};  ///< of the second and the third, with the velocities
  std::size_t nodes;
};
void fill_tables(const TableFill& fill);

}  // namespace glissade::block_detail
