// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace glissade {

/// A linear single-degree-of-freedom oscillator. period_s = 0 means rigid: the motion goes through unchanged.
struct Oscillator {
  double period_s = 0.0;      ///< >= 0
  double damping_ratio = 0.05;///< in [0, 1)
};

}  // namespace glissade
