// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

namespace glissade::motion_detail {

constexpr std::size_t block_size = 16;

/// A number of each oscillator of a block.
struct alignas(64) PerOscillator {
  double values[block_size] = {};
  double& operator[](std::size_t k) { return values[k]; }
  double operator[](std::size_t k) const { return values[k]; }
};

struct OscillatorStates {
  PerOscillator x, y, v;
};

/// Oscillators that go through the SIMD lanes side by side, in the scaled state of
/// core/oscillator.hpp, with v = dy/dtau = -(x + 2 zeta y + a). Each has the bits it would have
/// alone, on every target.
struct OscillatorBlock {
  double zeta = 0.0;
  PerOscillator h;      ///< omega dt
  PerOscillator bulge;  ///< how far |x| inside an interval may exceed its ends', over max|v|
  PerOscillator xx, xy, yy, x_start, x_end, y_start, y_end;  ///< the exact step
  OscillatorStates now, next;                                ///< at an interval's start and end
  PerOscillator peak;                                        ///< largest |x| so far
};

/// Looks for a peak inside the interval from `now` to `next`, of oscillators first ... last - 1,
/// while the ground goes from a_start to a_end.
using LookInside = void (*)(OscillatorBlock& block, std::size_t first, std::size_t last,
                            double a_start, double a_end);

/// Takes the first `count` oscillators over the intervals between the samples of the ground, and
/// calls `look_inside` where an oscillator's peak may have risen inside an interval.
void advance(OscillatorBlock& block, std::size_t count, std::span<const double> ground_mps2,
             LookInside look_inside);

}  // namespace glissade::motion_detail
