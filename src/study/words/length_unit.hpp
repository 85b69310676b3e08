// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "glissade/core/units.hpp"

// Lengths in sentences of a study, in the unit of its report.
namespace glissade {

inline const char* length_unit(UnitSystem units) { return units == UnitSystem::si ? "m" : "in"; }
inline double length_value(double length_m, UnitSystem units) {
  return units == UnitSystem::si ? length_m : length_m / inch_m;
}

/// Three significant digits.
inline std::string lengths_text(const std::vector<double>& lengths_m, UnitSystem units) {
  std::string text;
  for (const double length_m : lengths_m)
    text += fmt::format("{}{:.3g}", text.empty() ? "" : ", ", length_value(length_m, units));
  return text;
}

}  // namespace glissade
