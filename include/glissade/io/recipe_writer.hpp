// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/motion/simulation/synthetic_suite.hpp"

namespace glissade {

/// The recipe as a TOML suite file (suites/synthetic_*.toml), every number exact. `comments` are
/// the lines at its head: first the command that made it.
std::string recipe_toml(const SyntheticRecipe& recipe, const std::vector<std::string>& comments);

}  // namespace glissade
