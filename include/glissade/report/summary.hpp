// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/plan/skip.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// What came out, in sentences an engineer can quote: the intensity with a 50 % chance of exceeding
/// each clearance, slip at a level near 1 g, and what the standards prescribe there; of a design
/// chart the clearance at the shown point and what was read off.
std::vector<std::string> answer_sentences(const Results& results);

/// For the terminal, in plain ASCII: the first of these sentences, warnings, fragilities, the
/// comparison with standards at a handful of levels (of a design chart clearances over slope and
/// friction and the sentences above), `skips` (of a run; not in the results file), notes.
std::string summary_text(const Results& results, const std::vector<Skip>& skips = {});

}  // namespace glissade
