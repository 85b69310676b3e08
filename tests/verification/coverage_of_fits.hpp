// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "case.hpp"

namespace glissade::verification {

/// Rows of chapter 3.2: how often the intervals of `glissade fit` cover, by the form of the data.
void add_coverage_of_fits(std::vector<Case>& cases);

}  // namespace glissade::verification
