// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "glissade/study/config.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

/// [hazard] of a study, project or product. @param measure the column of the curve's file beside
/// annual_rate. Nothing where a problem is reported.
std::optional<HazardConfig> read_hazard(const TomlTable& table, const std::string& measure,
                                        double sds_g);
/// With more earthquakes in a life the lowest level is far below any that matters, or the curve is
/// in another unit: a problem.
void check_events(const TomlTable& table, const HazardConfig& hazard, double lowest,
                  const std::string& remedy);

}  // namespace glissade
