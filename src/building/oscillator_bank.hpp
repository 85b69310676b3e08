// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "glissade/building/motion_table.hpp"

namespace glissade::building_detail {

/// Oscillators that go through the SIMD lanes side by side. Each has the bits it would have alone,
/// on every target.
constexpr std::size_t bank_size = 16;

/// Vectors may read this far past the end of an array.
constexpr std::size_t padding = 16;

struct OscillatorBank {
  // Coefficients of the exact step (core/oscillator.hpp), and the states, per oscillator.
  alignas(64) double xx[bank_size] = {}, xy[bank_size] = {}, yy[bank_size] = {};
  alignas(64) double x_start[bank_size] = {}, x_end[bank_size] = {};
  alignas(64) double y_start[bank_size] = {}, y_end[bank_size] = {};
  alignas(64) double x[bank_size] = {}, y[bank_size] = {};
};

/// Puts the table's oscillator, at rest, into a lane.
void load(OscillatorBank& bank, std::size_t lane, const MotionTable& table);

/// Takes all oscillators from node `from` to node `to` of the ground, writing the states at nodes
/// from + 1 ... to at x[oscillator][node], y[oscillator][node].
void advance(OscillatorBank& bank, std::span<const double> ground_mps2, std::size_t from,
             std::size_t to, double* const* x, double* const* y);

/// What the bounds of a response are made of.
struct Response {
  const double *x, *y, *ground_mps2, *ground_mps;
  double omega_radps, damping_ratio, step_s, acceleration_scale, velocity_scale;
  std::size_t nodes;
};

struct Extremes {
  double peak_acceleration = 0.0, largest_velocity = 0.0;
};

/// Fills in table.bounds and table.acceleration_bound_mps2 for an oscillator's response from its
/// states.
void bound_response(MotionTable& table);

/// The same for a rigid table.
void bound_ground(MotionTable& table);

/// Largest less smallest velocity of an oscillator's roof up to node `end`, from rest.
double velocity_range_mps(const MotionTable& table, std::size_t end);

}  // namespace glissade::building_detail
