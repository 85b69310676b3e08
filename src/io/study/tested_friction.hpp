// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/study/config.hpp"
#include "toml_table.hpp"

namespace glissade {

/// Takes a study's friction from pull tests, `[friction] file`, `direction`, `slip_m` and
/// `sliding_from_m`: normal, not below 0, with the mean and standard deviation of sliding friction
/// over the tests. `folder` is the study file's. Leaves `friction` as it is where something is
/// wrong, which is reported.
void read_tested_friction(const TomlTable& table, const std::filesystem::path& folder,
                          StudyConfig& study);

}  // namespace glissade
