// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>

#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/table.hpp"

// Lengths of the calculation package, to 0.1 in, 0.01 ft or 1 mm, in the unit that stands first: as
// cells of tables and, with the same words, in sentences.
namespace glissade {

inline bool in_inches() { return LengthUnits::first() == UnitSystem::us_customary; }

/// "12.5 in", or "0.318 m"; "0 in" of none at all.
inline NumberCell length_cell(UnitSystem units, double length_m, int more_digits = 0) {
  const bool us = units == UnitSystem::us_customary;
  return fixed(us ? length_m / inch_m : length_m, length_m == 0.0 ? 0 : (us ? 1 : 3) + more_digits,
               us ? "in" : "m");
}
inline NumberCell length_cell(double length_m) {
  return length_cell(LengthUnits::first(), length_m);
}
inline std::string length_in(double length_m) { return text_of(length_cell(length_m)); }

/// "12.5 in (0.318 m)", or "0.318 m (12.5 in)".
inline NumberCell length_cell_in_both(double length_m, int more_digits = 0) {
  const UnitSystem other = in_inches() ? UnitSystem::si : UnitSystem::us_customary;
  NumberCell length = length_cell(LengthUnits::first(), length_m, more_digits);
  length.beside = " (" + text_of(length_cell(other, length_m, more_digits)) + ")";
  return length;
}
inline std::string length_in_both(double length_m, int more_digits = 0) {
  return text_of(length_cell_in_both(length_m, more_digits));
}

}  // namespace glissade
