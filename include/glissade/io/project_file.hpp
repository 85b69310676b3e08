// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "glissade/design/project.hpp"

namespace glissade {

/// A project file (TOML; keys: project_example()). Throws InputError with everything that is wrong
/// or missing, each with an example line.
Project read_project(const std::filesystem::path& file);

/// A project file with every key, commented: what `glissade clearance --example` prints.
std::string project_example();

}  // namespace glissade
