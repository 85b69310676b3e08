// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/results.hpp"

namespace glissade {

/// Fragilities that are not lognormal.
std::vector<std::string> warnings_on(const Results& results, const StudyConfig& config);

/// Remarks on the results: uplift, tipping, histories that did not converge, how
/// the suites meet their target.
std::vector<std::string> notes_on(const Results& results, const StudyConfig& config);

}  // namespace glissade
