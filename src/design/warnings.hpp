// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/design/design_clearance.hpp"

namespace glissade {

/// A displacement of a US project in inches, a longer length in feet.
std::string both_units(double length_m, UnitSystem units);

/// What makes the result smaller, is improbable, is not met or is not sufficient. Expects the
/// checks and separations of `design`.
std::vector<DesignWarning> warnings_on(const Project& project, const Results& demand,
                                       const DesignClearance& design);

}  // namespace glissade
