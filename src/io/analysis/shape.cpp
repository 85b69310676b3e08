// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {

AnalysisInFiles ShapeAnalysis::in_files() {
  return {.table = "shape",
          .keys = {{"", is_there<&StudyConfig::shape>(),
                    "whether the fragilities are lognormal and what else they could be"}},
          .needs = {needs_fragility},
          .of_any_run = true};
}

}  // namespace glissade
