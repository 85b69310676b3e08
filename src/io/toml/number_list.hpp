// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "toml/toml_table.hpp"

namespace glissade {

/// Numbers that increase strictly: a list, or { from, to, count, spacing = "linear" | "log" } with
/// both ends included. Reports what is wrong to the table's document; may then be empty.
std::vector<double> read_increasing(const TomlTable& table, const char* key,
                                    const NumberRule& rule);

}  // namespace glissade
