// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// Fragilities, slip, comparison with standards and impact, for each combination of what the study
/// lists.
std::vector<RunResults> fragility_runs(const StudyConfig& config, const Results& results);

}  // namespace glissade
