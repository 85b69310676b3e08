// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace glissade {

/// The power of two that scales a positive number into [1, 2), within the range of a double; 1 for
/// zero. Multiplication by it has no rounding error.
inline double scale_to_one(double value) {
  if (!(value > 0.0)) return 1.0;
  return std::ldexp(1.0, std::clamp(-std::ilogb(value), -1000, 1000));
}

}  // namespace glissade
