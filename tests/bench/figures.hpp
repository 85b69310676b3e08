// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

#include "fragility_error.hpp"
#include "work_precision.hpp"

namespace glissade::bench {

// Drawn by gnuplot; std::runtime_error where that fails.

/// Schemes over one set of histories, the floor first: error against mean time.
void draw_trial(const std::vector<SchemeResult>& results, const char* title,
                const std::filesystem::path& svg);
void draw_schemes(const WorkPrecision& measured, const std::filesystem::path& svg);
void draw_fragility(const FragilityError& measured, const std::filesystem::path& svg);

}  // namespace glissade::bench
