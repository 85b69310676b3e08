// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/plan.hpp"

namespace glissade {

/// Throws InputError with everything in which study and suite do not fit each other.
void check_fit(const StudyConfig& config, const Suite& suite);

/// Throws InputError where a sample's friction, slope and mass ratio have no solution.
void check_samples(const Plan& plan);

}  // namespace glissade
