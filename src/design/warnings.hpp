// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/design/design_clearance.hpp"

namespace glissade {

/// A displacement of a US project in inches, a longer length in feet.
std::string both_units(double length_m, UnitSystem units);

/// The same, and those of the analysis and its checks. Expects the checks of `design`.
std::vector<DesignWarning> warnings_on(const Project& project, const Results& demand,
                                       const DesignClearance& design);

}  // namespace glissade
