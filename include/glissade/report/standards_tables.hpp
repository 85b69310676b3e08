// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>
#include <vector>

#include "glissade/report/table.hpp"
#include "glissade/standards/conditions.hpp"

namespace glissade {

inline constexpr const char* verify_note =
    "recalled: from memory of the standard. Verify against the standard, which may have conditions "
    "that are not listed here.";

/// The conditions of both standards, with what is found of an array.
Table conditions_table(const ArrayFacts& array);

using StandardSeparations = std::pair<Standard, std::vector<Separation>>;
Table separations_table(const std::vector<StandardSeparations>& standards);

}  // namespace glissade
