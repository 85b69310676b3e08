// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/results.hpp"

namespace glissade {

/// A record that dominates its suite, and what the analyses warn of.
std::vector<std::string> warnings_on(const Results& results, const StudyConfig& config);

/// Remarks on the results: uplift, histories that did not converge, how
/// the suites meet their target, and those of the analyses.
std::vector<std::string> notes_on(const Results& results, const StudyConfig& config);

}  // namespace glissade
