// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/design/project.hpp"
#include "keys/key.hpp"

namespace glissade {

/// The keys of a project file, all that can be read: the example file and the hints for missing
/// keys are made of them. `value` is an example, `usual` is `required`, `in_example` or, of a key
/// that another one replaces or that few need, `alternative`.
const std::vector<KeyTable<Project>>& project_tables();
const std::vector<GrammarKey>& project_grammar();
inline constexpr const char *required = "required", *in_example = "in the example",
                            *alternative = "alternative";

/// "period_s = [0.7, 1.0]": the line of a key.
std::string project_example_of(const char* table, const char* key);

}  // namespace glissade
