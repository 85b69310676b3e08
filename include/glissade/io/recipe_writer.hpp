// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/motion/simulation/synthetic_suite.hpp"

namespace glissade {

/// The recipe as a TOML suite file (suites/synthetic_*.toml), every number exact. `origin` is named
/// in the comment at its head: the command that made it, one line.
std::string recipe_toml(const SyntheticRecipe& recipe, const std::string& origin);

}  // namespace glissade
