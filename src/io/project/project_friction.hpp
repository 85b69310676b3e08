// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/design/project.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// Of [friction] of a project: pull tests of a file, or their mean and standard deviation.
/// @param folder of the project file
void read_project_friction(const TomlTable& table, const std::filesystem::path& folder,
                           ProjectFriction& friction);

}  // namespace glissade
