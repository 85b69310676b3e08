// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numbers>
#include <span>

#include "core/oscillator_lanes.hpp"
#include "glissade/building/motion_table.hpp"

namespace glissade::building_detail {

/// Number of elements that vectors may read past the end of an array.
constexpr std::size_t padding = 16;

using oscillator_lanes::PerOscillator;

struct OscillatorBank {
  static constexpr std::size_t size = oscillator_lanes::count;
  oscillator_lanes::Steps steps;
  PerOscillator x, y;

  void set(std::size_t lane, const Oscillator& oscillator, double step_s) {
    const double omega_radps = 2.0 * std::numbers::pi / oscillator.period_s;
    steps.set(lane, oscillator_step(omega_radps * step_s, oscillator.damping_ratio));
  }
};

/// Steps all oscillators from node `from` to node `to` of the ground, and writes the states at
/// nodes from + 1 ... to at x[oscillator][node], y[oscillator][node].
void advance(OscillatorBank& bank, std::span<const double> ground_mps2, std::size_t from,
             std::size_t to, double* const* x, double* const* y);

/// Input for the bounds of a response.
struct Response {
  const double *x, *y, *ground_mps2, *ground_mps;
  double omega_radps, damping_ratio, step_s, acceleration_scale, velocity_scale;
  std::size_t nodes;
  const double *a = nullptr, *jerk = nullptr;  ///< of several modes (ModeSum)
  double ground_share = 0.0;
};

struct ResponsePeaks {
  double peak_acceleration = 0.0, largest_velocity = 0.0;
};

/// Computes table.bounds and table.acceleration_bound_mps2 of a response from its states.
void bound_response(MotionTable& table);

/// The same for a rigid table.
void bound_ground(MotionTable& table);

/// Largest minus smallest velocity of the roof of an oscillator up to node `end`, from rest.
double velocity_range_mps(const MotionTable& table, std::size_t end);

}  // namespace glissade::building_detail
