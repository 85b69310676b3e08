// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "core/oscillator_lanes.hpp"

namespace glissade::motion_detail {

using oscillator_lanes::PerOscillator;

struct OscillatorStates {
  PerOscillator x, y, v;
};

/// Oscillators side by side, in the scaled state of core/oscillator.hpp, with
/// v = dy/dtau = -(x + 2 zeta y + a).
struct OscillatorBlock {
  static constexpr std::size_t size = oscillator_lanes::count;
  double zeta = 0.0;
  PerOscillator h;      ///< omega dt
  PerOscillator bulge;  ///< bound of the excess of |x| inside an interval over its ends, per max|v|
  oscillator_lanes::Steps steps;
  OscillatorStates now, next;  ///< at start and end of an interval
  PerOscillator peak;          ///< largest |x| so far
};

/// Searches a peak inside the interval from `now` to `next`, of oscillators first ... last - 1,
/// with ground acceleration from a_start to a_end.
using LookInside = void (*)(OscillatorBlock& block, std::size_t first, std::size_t last,
                            double a_start, double a_end);

/// Steps the first `count` oscillators over the intervals between the samples of the ground, and
/// calls `look_inside` if the peak of an oscillator may have increased inside an interval.
void advance(OscillatorBlock& block, std::size_t count, std::span<const double> ground_mps2,
             LookInside look_inside);

}  // namespace glissade::motion_detail
