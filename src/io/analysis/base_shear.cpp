// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/in_files.hpp"

namespace glissade {

AnalysisInFiles BaseShearAnalysis::in_files() {
  return {.table = "base_shear",
          .read = [](const TomlTable&, StudyConfig& study) { study.base_shear = true; },
          .keys = {{"", "an empty table", "absent", "peak base shear"}},
          .needs = {{"[model] axes = 2",
                     [](const TomlTable&, const StudyConfig& s) { return s.two_axes(); }}},
          .key_needs = {{"array", "support", "[base_shear], where it is a list",
                         [](const TomlTable& root, const StudyConfig& s) {
                           return s.support.size() == 1 || root.has("base_shear");
                         }}},
          .stands_alone = true,
          .needs_every_history = true,
          .design_friction = FrictionUse::read};
}

}  // namespace glissade
