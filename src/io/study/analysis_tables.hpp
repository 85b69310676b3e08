// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// The tables of the analyses, and what they need of each other. Reads after all others.
void read_analyses(const TomlTable& root, StudyConfig& study);

/// Of analyses that need nothing of a run but what every run keeps.
std::vector<std::string> tables_of_same_histories();

}  // namespace glissade
