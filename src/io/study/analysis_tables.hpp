// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// The tables of the analyses, and what they need of each other. Reads after all others.
void read_analyses(const TomlTable& root, StudyConfig& study);

/// The values of drawn friction that the analyses of a study need.
std::vector<FrictionValue> usual_friction_values(const TomlTable& root);

}  // namespace glissade
