// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "toml_table.hpp"

namespace glissade {

/// What [suite] of a study file says.
struct SuiteChoice {
  std::filesystem::path file;        ///< resolved against the study file's folder
  std::vector<std::string> records;  ///< ids; empty: all
};
SuiteChoice read_suite_choice(const TomlTable& suite, const std::filesystem::path& study_file);

}  // namespace glissade
