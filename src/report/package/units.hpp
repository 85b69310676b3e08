// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>

#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"

// Lengths of the calculation package, to 0.1 in, 0.01 ft or 1 mm, in the unit that stands first.
namespace glissade {

inline bool in_inches() { return LengthUnits::first() == UnitSystem::us_customary; }

/// "12.5 in", or "0.318 m"; "0 in" of none at all.
inline std::string length_in(UnitSystem units, double length_m, int more_digits = 0) {
  const bool us = units == UnitSystem::us_customary;
  if (length_m == 0.0) return us ? "0 in" : "0 m";
  return us ? fmt::format("{:.{}f} in", length_m / inch_m, 1 + more_digits)
            : fmt::format("{:.{}f} m", length_m, 3 + more_digits);
}
inline std::string length_in(double length_m) { return length_in(LengthUnits::first(), length_m); }

/// "12.5 in (0.318 m)", or "0.318 m (12.5 in)".
inline std::string length_in_both(double length_m, int more_digits = 0) {
  const UnitSystem first = LengthUnits::first(),
                   other = in_inches() ? UnitSystem::si : UnitSystem::us_customary;
  return fmt::format("{} ({})", length_in(first, length_m, more_digits),
                     length_in(other, length_m, more_digits));
}

/// "1.06 ft", or "0.323 m": of a separation.
inline std::string separation_in(double length_m) {
  return in_inches() ? fmt::format("{:.2f} ft", length_m / foot_m) : length_in(length_m);
}

}  // namespace glissade
