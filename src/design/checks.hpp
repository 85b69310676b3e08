// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/design/design_clearance.hpp"

namespace glissade {

/// A displacement of a US project in inches, a longer length in feet.
std::string both_units(double length_m, UnitSystem units);

/// For a mean to count (SEAOC PV1-2012, recalled).
inline constexpr std::size_t least_records = 7;

/// What the project's conditions require with this friction.
double required_m(const Project& project, const Results& demand, double friction);

/// Under which the array lifts off at a level, in a case at least.
std::vector<std::string> records_with_uplift(const Results& results, std::size_t level);

std::vector<DesignCheck> checks_of(const Project& project, const Results& demand,
                                   const DesignClearance& design);

/// What makes the result smaller, is improbable, is not met or is not sufficient. Expects the
/// checks and separations of `design`.
std::vector<DesignWarning> warnings_on(const Project& project, const Results& demand,
                                       const DesignClearance& design);

}  // namespace glissade
