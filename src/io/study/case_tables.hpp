// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

// What a study's cases are: every table but those of suite, intensity and analyses.

/// What the rows of the keys do not say of quantities: the slope as a rise in 12, the building's
/// model and strength.
void check_quantities(const TomlTable& root, StudyConfig& study);
/// @param usual the values of drawn friction that the study's analyses need
void read_friction(const TomlTable& table, const std::vector<FrictionValue>& usual,
                   StudyConfig& study);
/// Takes friction from pull tests, `[friction] file`, `direction`, `slip_m` and `sliding_from_m`:
/// normal, not below 0, with the mean and standard deviation of sliding friction over the tests.
/// `folder` is the study file's. Leaves `friction` as it is where something is wrong, which is
/// reported.
void read_tested_friction(const TomlTable& table, StudyConfig& study);
void check_support(const TomlTable& table, StudyConfig& study);
void check_sampling(const TomlTable& table, SamplingConfig& sampling);

}  // namespace glissade
