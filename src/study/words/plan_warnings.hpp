// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/plan/plan.hpp"

namespace glissade {

/// What is possible and not probable, or not for design: a sentence each, which stands beside the
/// results wherever they are shown.
std::vector<std::string> warnings_on(const Plan& plan);

}  // namespace glissade
