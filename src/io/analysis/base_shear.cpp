// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {

AnalysisInFiles BaseShearAnalysis::in_files() {
  return {.table = "base_shear",
          .keys = {{"", is_there<&StudyConfig::base_shear>(), "peak base shear"}},
          .needs = {{"[model] axes = 2", [](auto&, auto& s) { return s.two_axes(); }}},
          .stands_alone = true,
          .needs_every_history = true,
          .design_friction = FrictionUse::read};
}

}  // namespace glissade
