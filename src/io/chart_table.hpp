// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/config.hpp"
#include "toml_table.hpp"

namespace glissade {

/// The axes of a design chart, where its figures cut through it, and what is asked of it.
/// @param levels the study's intensity levels; may be empty where they were wrong
ChartConfig read_chart(const TomlTable& table, const std::vector<double>& levels);

}  // namespace glissade
