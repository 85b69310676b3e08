// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/motion/design_spectrum.hpp"

namespace glissade {

/// A TOML basic string.
std::string quoted(const std::string& text);

/// "key = value" of each field of a target. Expects one that is not given by points.
std::vector<std::string> target_fields(const DesignTarget& target);

/// The table [target]. Expects one that is not given by points.
std::string target_toml(const DesignTarget& target);

}  // namespace glissade
