// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/study/plan/plan.hpp"

namespace glissade {

/// Throws InputError with everything in which study and suites do not fit each other.
void check_fit(const StudyConfig& config, const std::vector<Suite>& suites);

/// Of one record there is no mean, and levels of other measures scale to no spectrum: their charts
/// have no clearance.
bool gives_clearance(const Plan& plan);

/// Of all buildings along their axes. Throws InputError for one that is rigid:
/// no rule of ASCE 7 is of it.
FirstPeriods first_periods(const StudyConfig& config);

/// In what a suite does not meet its target, and what to do.
struct MissedTarget {
  std::string what, remedy;
  bool is_refused = true;  ///< of a clearance
};
/// From 0 to 2 s, and of a clearance up to 1.5 times the longest building period; nothing where the
/// suite, as the study scales it, meets its target.
std::optional<MissedTarget> missed_target(const Plan& plan, std::size_t suite);

/// Sentences on records, of one suite or of all, that are one motion: their Arias intensities are
/// equal to the last bit.
std::vector<std::string> copied_records(const Plan& plan, std::optional<std::size_t> suite = {});

/// Throws InputError where the study gives a clearance ([clearance], [chart]) of a suite that does
/// not meet its target: from 0 to 2 s where the study does not scale it, and up to 1.5 times a
/// building period above 2 s; or of a suite with copies of a record.
void check_clearance(const Plan& plan);

/// Throws InputError where a record would be multiplied by more than the kernels take
/// (largest_acceleration): it is then no ground motion, or the highest level no intensity.
void check_factors(const Plan& plan);

/// Throws InputError where a case's friction, slope and mass ratio have no solution.
void check_cases(const Plan& plan);

}  // namespace glissade
