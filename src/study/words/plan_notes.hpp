// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "glissade/study/plan/plan.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// What one_mass_sentence() says of the study's building.
std::string one_mass_text(const StudyConfig& config);

/// Remarks on the results that follow from what is run.
std::vector<std::string> notes_on(const Plan& plan);

/// What a plan and finished results both have of a study.
struct StudyOutline {
  const StudyConfig& config;
  std::size_t cases;
  std::function<Case(std::size_t)> case_of;
  double mce_level;  ///< the intensity that is the MCE of all suites; 0: none is
};
/// @param dbe_level as ModelText::dbe_level
double mce_level(IntensityMeasure measure, double dbe_level, bool has_target);

/// Sentences that stand beside the results.
struct Remarks {
  std::vector<Warning> warnings;
  std::vector<std::string> notes;
};
/// Of the analyses that can be added to finished results, before they find anything.
Remarks remarks_on(const StudyOutline& study);
Remarks remarks_on_analyses(const Plan& plan);

/// What the study does not need.
std::vector<Skip> skips_of(const Plan& plan);
/// Analyses that it does not ask for.
std::vector<Skip> skipped_analyses(const StudyConfig& config);

}  // namespace glissade
