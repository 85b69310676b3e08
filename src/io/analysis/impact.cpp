// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {

AnalysisInFiles ImpactAnalysis::in_files() {
  return {.table = "impact",
          .keys = {{"", is_there<&StudyConfig::impact>(),
                    "when and how fast each threshold is first reached"}},
          .needs = {needs_fragility},
          .needs_every_history = true};
}

}  // namespace glissade
