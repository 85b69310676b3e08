// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/plan/plan.hpp"

namespace glissade {

/// Remarks on the results that follow from the plan.
std::vector<std::string> notes_on(const Plan& plan);

/// What the study does not need.
std::vector<Skip> skips_of(const Plan& plan);

}  // namespace glissade
