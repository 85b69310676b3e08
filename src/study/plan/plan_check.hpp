// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/plan/plan.hpp"

namespace glissade {

/// Throws InputError with everything in which study and suites do not fit each other.
void check_fit(const StudyConfig& config, const std::vector<Suite>& suites);

/// Throws InputError where the study gives a clearance ([clearance], [chart]) of a suite that does
/// not meet its target: from 0 to 2 s where the study does not scale it, and up to 1.5 times a
/// building period above 2 s.
void check_clearance(const Plan& plan);

/// Throws InputError where a case's friction, slope and mass ratio have no solution.
void check_cases(const Plan& plan);

}  // namespace glissade
