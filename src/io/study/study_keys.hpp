// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/config.hpp"
#include "keys/key.hpp"

namespace glissade {

using StudyKey = Key<StudyConfig>;
using StudyNeed = Need<StudyConfig>;
using StudyTable = KeyTable<StudyConfig>;
/// All tables of a study file, those of analyses last.
const std::vector<StudyTable>& study_tables();

/// "building.damping: 0.05": what holds for each key that is left out and would have an effect.
std::vector<StudyConfig::NotStated> keys_not_stated(const TomlTable& root,
                                                    const StudyConfig& study);

/// Reports every key that is given and has no effect. Reads after all others.
void refuse_idle_keys(const TomlTable& root, const StudyConfig& study);

}  // namespace glissade
