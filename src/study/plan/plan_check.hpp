// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/plan/plan.hpp"

namespace glissade {

/// Throws InputError with everything in which study and suites do not fit each other.
void check_fit(const StudyConfig& config, const std::vector<Suite>& suites);

/// Throws InputError where the study has [clearance] and a suite that does not meet its target, 0
/// to 2 s within 2 %, and that the study does not scale.
void check_clearance(const Plan& plan);

/// Throws InputError where a case's friction, slope and mass ratio have no solution.
void check_cases(const Plan& plan);

}  // namespace glissade
