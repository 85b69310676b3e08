// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/design/design_clearance.hpp"

namespace glissade {

/// For a mean to count (SEAOC PV1-2012, recalled).
inline constexpr std::size_t least_records = 7;

/// Levels of the demand study.
inline constexpr std::size_t at_dbe = 0, at_mce = 1, demand_levels = 2;

/// Under which the array lifts off at a level, in a case at least.
std::vector<std::string> records_with_uplift(const Results& results, std::size_t level);

std::vector<DesignCheck> checks_of(const Project& project, const Results& demand,
                                   const DesignClearance& design);

}  // namespace glissade
