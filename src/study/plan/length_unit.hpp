// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/core/units.hpp"

// Lengths in sentences of a study, in the unit of its report.
namespace glissade {

inline const char* length_unit(UnitSystem units) { return units == UnitSystem::si ? "m" : "in"; }
inline double length_value(double length_m, UnitSystem units) {
  return units == UnitSystem::si ? length_m : length_m / inch_m;
}

}  // namespace glissade
