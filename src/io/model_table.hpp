// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "glissade/study/config.hpp"
#include "toml_table.hpp"

namespace glissade {

// What moves and what resists: the tables of a study file that tell the model.

ModelConfig read_model(const TomlTable& table);
/// @param axes keys that only two axes have are reported where there is one
BuildingConfig read_building(const TomlTable& table, SlidingAxes axes);
RoofConfig read_roof(const TomlTable& table, SlidingAxes axes);
FrictionConfig read_friction(const TomlTable& table, SlidingAxes axes,
                             const std::filesystem::path& study_file);
/// `static_ratio`, `fast_ratio` and `rate_spm` of [friction].
FrictionLaw read_friction_law(const TomlTable& table);

/// `key` belongs to studies on two axes: elsewhere it is reported.
void needs_two_axes(const TomlTable& table, const char* key, SlidingAxes axes);

inline constexpr NumberRule damping_ratio{"0 or more and below 1",
                                          [](double x) { return x >= 0.0 && x < 1.0; }};

}  // namespace glissade
