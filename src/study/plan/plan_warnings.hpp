// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/plan/plan.hpp"

namespace glissade {

/// What is possible and not probable, or not for design: a sentence each, which stands beside the
/// results wherever they are shown.
std::vector<std::string> warnings_on(const Plan& plan);

/// Of an analysis that gives probabilities: they need the scatter between records, which is less
/// in a suite of those nearest to a target.
std::vector<std::string> warnings_on_nearest_records(const Plan& plan);

}  // namespace glissade
