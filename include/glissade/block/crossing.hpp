// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace glissade {

/// Time and speed at which a block first reaches a given distance, in plan, from its initial
/// position (theory.md, 4.2). NaN: it does not reach it.
struct Crossing {
  double time_s = std::numeric_limits<double>::quiet_NaN();     ///< from the start of the record
  double speed_mps = std::numeric_limits<double>::quiet_NaN();  ///< in plan, relative to the roof
  bool happens() const { return !std::isnan(time_s); }
};

}  // namespace glissade
