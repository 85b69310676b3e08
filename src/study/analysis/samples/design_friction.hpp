// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/analysis/sensitivity.hpp"

namespace glissade {

/// Of every combination that is run with drawn friction and with its design value.
std::vector<DesignFrictionRow> design_friction_rows(const StudyConfig& config,
                                                    const Results& results);

}  // namespace glissade
