// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/results.hpp"
#include "words/plan_notes.hpp"

namespace glissade {

/// Of the run: a record that dominates its suite; uplift, histories that did not converge, and how
/// the suites meet their target.
Remarks remarks_on_run(const Results& results, const StudyConfig& config);

/// Of the analyses: on the study, then on what they found.
Remarks remarks_on_analyses(const Results& results, const StudyConfig& config);

}  // namespace glissade
