// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "glissade/core/oscillator.hpp"

namespace glissade::oscillator_lanes {

/// Oscillators computed side by side in SIMD lanes. Each has the same bits as alone, on every
/// target.
constexpr std::size_t count = 16;

/// One number for each of them.
struct alignas(64) PerOscillator {
  double values[count] = {};
  double& operator[](std::size_t k) { return values[k]; }
  double operator[](std::size_t k) const { return values[k]; }
};

/// Their exact steps over one interval.
struct Steps {
  PerOscillator xx, xy, yy, x_start, x_end, y_start, y_end;

  /// @pre step.xy = step.yx
  void set(std::size_t k, const OscillatorStep& step) {
    xx[k] = step.xx;
    xy[k] = step.xy;
    yy[k] = step.yy;
    x_start[k] = step.x_start;
    x_end[k] = step.x_end;
    y_start[k] = step.y_start;
    y_end[k] = step.y_end;
  }
};

}  // namespace glissade::oscillator_lanes
