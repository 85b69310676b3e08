// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/results.hpp"
#include "glissade/study/run/execute.hpp"

namespace glissade {

/// Puts the units' results together in plan order, fits the fragilities, compares with the
/// standards. `units` may come in any order; each unit of the plan must be there once.
Results reduce(const Plan& plan, const std::vector<UnitResult>& units);
/// The same with what motion_part() gave for each part. Each unit is freed when it is added.
Results reduce(const Plan& plan, std::vector<UnitResult>&& units,
               const std::vector<std::vector<double>>& motion_parts);

/// Finished results with the analyses of `study`, which names the same histories (or, with a
/// sampling.target_error, those and more). Warnings and notes
/// stay, and new ones are added.
void analyse_again(StudyConfig study, Results& results);

WorkCount total_count(const std::vector<UnitResult>& units);

/// What the plan left out, and what the units did not need to do.
std::vector<Skip> skipped(const Plan& plan, const WorkCount& count);

}  // namespace glissade
