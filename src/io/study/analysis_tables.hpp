// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// The tables of the analyses, and what they need of each other. Reads after all others.
void read_analyses(const TomlTable& root, StudyConfig& study);

/// The values of drawn friction that the analyses of a study need.
std::vector<FrictionValue> usual_friction_values(const TomlTable& root);

/// [hazard] of a study or project. @param measure the column of the curve's file beside annual_rate
/// @param folder that of the file. Nothing where a problem is reported.
std::optional<HazardConfig> read_hazard(const TomlTable& table, const std::string& measure,
                                        double sds_g);
/// With more earthquakes in a life the lowest level is far below any that matters, or the curve is
/// in another unit: a problem.
void check_events(const TomlTable& table, const HazardConfig& hazard, double lowest,
                  const std::string& remedy);

}  // namespace glissade
