// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/summary.hpp"

#include <fmt/format.h>

#include "analysis/analyses.hpp"
#include "glissade/report/format.hpp"

namespace glissade {

std::vector<std::string> answer_sentences(const Results& results) {
  return collected(results, &AnalysisReport::sentences);
}

std::string summary_text(const Results& results, const std::vector<Skip>& skips) {
  const LengthUnits units(results.units);
  const bool draws = results.cases.samples > 1;
  std::string text = fmt::format(
      "{}: {} records x {} {} x {} levels, displacements in plan\nModel: {}\n", results.study_name,
      results.records.size(), draws ? results.cases.samples : results.cases.size(),
      draws ? "samples" : "cases", results.levels.size(), results.model.kernel);
  for (const std::string& warning : results.warnings) text += "WARNING: " + warning + "\n";
  for (const AnalysisReport& analysis : analyses_in(results)) {
    if (analysis.summary != nullptr) text += "\n" + analysis.summary(results);
  }
  if (!skips.empty()) text += "\nNot computed, because not needed\n";
  for (const Skip& skip : skips) text += "  " + format_skip(skip) + "\n";
  if (!results.notes.empty()) text += "\nNotes\n";
  for (const std::string& note : results.notes) text += "  " + note + "\n";
  return text;
}

}  // namespace glissade
