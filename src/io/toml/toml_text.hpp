// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/motion/design_spectrum.hpp"

namespace glissade {

/// A TOML basic string.
std::string quoted(const std::string& text);

/// A number, or a list where there are several.
std::string list_of(const std::vector<double>& values);

/// A file as a path from a folder; an empty one is the current folder.
std::string relative_path(const std::filesystem::path& file, const std::filesystem::path& folder);
/// The same, quoted.
std::string path_from(const std::filesystem::path& file, const std::filesystem::path& folder);

/// "key = value" of each field of a target. Expects one that is not given by points.
std::vector<std::string> target_fields(const DesignTarget& target);

/// The table [target]. Expects one that is not given by points.
std::string target_toml(const DesignTarget& target);

}  // namespace glissade
