// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// [hazard]. Reads after the intensity.
void read_hazard(const TomlTable& root, StudyConfig& study);

}  // namespace glissade
