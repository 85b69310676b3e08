// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>

namespace glissade {

/// When and how fast a block first gets a given distance, in plan, from where it lay: what a
/// parapet there would be hit by. NaN: it does not get there.
struct Crossing {
  double time_s = std::numeric_limits<double>::quiet_NaN();     ///< from the record's begin
  double speed_mps = std::numeric_limits<double>::quiet_NaN();  ///< in plan, relative to the roof
  bool happens() const { return !std::isnan(time_s); }
};

}  // namespace glissade
