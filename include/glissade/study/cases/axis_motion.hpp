// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>

#include "glissade/study/cases/orientation.hpp"

namespace glissade {

/// What acts along one of the building's axes: a component of the ground with its sign, or a mix of
/// both.
struct AxisMotion {
  int component = 0;          ///< 0 or 1; of a mix the axis
  double azimuth_deg = -1.0;  ///< of a mix, else -1
  int sign = 1;               ///< a factor on it
  auto operator<=>(const AxisMotion&) const = default;
};
AxisMotion axis_motion(const Orientation& orientation, int axis);

}  // namespace glissade
