// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace glissade::block_detail {

// What of a CoupledTable runs over all nodes, in tiles of 64. Compiled once per SIMD target, every
// operation elementwise and unfused and maxima exact, so all targets give the same bits.

/// Two lines of the ground: a_factor a + w_factor w, of accelerations or velocities.
struct GroundLine {
  const double *a, *w;
  double a_factor, w_factor;
};

/// The response (x, y) of one oscillator, and the size of its amplitude z: with p the forcing,
///   X = x + p - lag dp,  Y = y + dp / (omega dt),  |s^2 z| = sqrt(X^2 + (c_x X + c_y Y)^2) / D
struct AmplitudeFill {
  const double *x, *y;
  GroundLine forcing;
  double lag, per_step, c_x, c_y, per_mass, twice_zeta;
  /// By tile, the largest at its nodes and the one before: |s^2 z|, |x + 2 zeta y|, |x|.
  float *amplitude, *resisting, *x_size;
};
void fill_amplitude(const AmplitudeFill& fill, std::size_t nodes);

/// values[i] = x_factor x[i] + y_factor y[i] + ground line, and its extremes by tile.
struct LineFill {
  const double *x, *y;
  double x_factor, y_factor;
  GroundLine ground;
  float *values, *tile_lowest, *tile_highest;
};
void fill_line(const LineFill& fill, std::size_t nodes);

/// largest[b] = the largest |change| of the ground line over the intervals from each node of tile
/// b and the one before.
void fill_change(const GroundLine& ground, float* largest, std::size_t nodes);

}  // namespace glissade::block_detail
