// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/results.hpp"
#include "glissade/study/run/execute.hpp"

namespace glissade {

/// The analyses of the plan's histories.
/// @param motion_parts what motion_part() gave for each part
Results reduce(const Plan& plan, HistoryTable histories,
               const std::vector<std::vector<double>>& motion_parts);
/// The same of units in any order; each unit of the plan must be there once.
Results reduce(const Plan& plan, const std::vector<UnitResult>& units);

/// The study's part of the results: what stands before its histories and motions.
void put_study(const StudyConfig& study, Results& results);
/// Finished results with the analyses of `study`, which names the same histories (or, with a
/// sampling.target_error, those and more): those of a run of it, with its warnings and notes.
void analyse_again(StudyConfig study, Results& results);
/// What that run would have skipped, of what the run of the results did.
std::vector<Skip> skipped_again(const StudyConfig& study, const std::vector<Skip>& skips);

/// What the plan left out, and what the units did not need to do; without what depends on which
/// rank ran which unit (WorkCount::roofs, from_curve).
std::vector<Skip> skipped(const Plan& plan, const WorkCount& count);

}  // namespace glissade
