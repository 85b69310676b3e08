// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>

#include "glissade/core/units.hpp"
#include "glissade/design/project.hpp"

namespace glissade {

/// "12.5 in", or "0.318 m".
inline std::string length_in(UnitSystem units, double length_m) {
  return units == UnitSystem::us_customary ? fmt::format("{:.1f} in", length_m / inch_m)
                                           : fmt::format("{:.3f} m", length_m);
}

/// "12.5 in (0.318 m)", or "0.318 m (12.5 in)".
inline std::string length_in_both(UnitSystem units, double length_m) {
  const bool us = units == UnitSystem::us_customary;
  return fmt::format("{} ({})", length_in(units, length_m),
                     length_in(us ? UnitSystem::si : UnitSystem::us_customary, length_m));
}

/// "1.06 ft", or "0.323 m": of a separation.
inline std::string separation_in(UnitSystem units, double length_m) {
  return units == UnitSystem::us_customary ? fmt::format("{:.2f} ft", length_m / foot_m)
                                           : fmt::format("{:.3f} m", length_m);
}

}  // namespace glissade
