// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

namespace glissade {

/// The power of two that brings a positive number into [1, 2), as far as a double can hold it; 1
/// for zero. Multiplying by it rounds nothing.
inline double scale_to_one(double value) {
  if (!(value > 0.0)) return 1.0;
  return std::ldexp(1.0, std::clamp(-std::ilogb(value), -1000, 1000));
}

}  // namespace glissade
