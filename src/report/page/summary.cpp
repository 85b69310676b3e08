// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/summary.hpp"

#include <fmt/format.h>

#include "analysis/analyses.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/report/format.hpp"
#include "text/study_text.hpp"

namespace glissade {

std::vector<std::string> answer_sentences(const Results& results) {
  return collected(results, &AnalysisReport::sentences);
}

std::string summary_text(const Results& results, const std::vector<Skip>& skips) {
  const LengthUnits units(results.units);
  const bool draws = results.cases.samples > 1;
  const auto line = [](const std::string& whole) {
    return wrapped(whole, terminal_width, 2) + "\n";
  };
  std::string text = line(fmt::format(
      "{}: {} x {} x {}, displacements in plan", results.study_name, counted_records(results),
      draws ? counted(results.cases.samples, "sample") : counted(results.cases.size(), "case"),
      levels_of_each(results)));
  if (const std::vector<std::string> answers = answer_sentences(results); !answers.empty())
    text += line(answers.front());
  for (const Warning& warning : results.warnings) text += line("WARNING: " + warning.text);
  text += "\n" + line("Model: " + results.model.kernel) +
          line("Orientation: " + describe(orientation_choice(results.cases)));
  if (const std::string target = target_text(results); !target.empty())
    text += line("Design target: " + target);
  for (const AnalysisReport& analysis : analyses_in(results)) {
    if (analysis.summary != nullptr) text += "\n" + analysis.summary(results);
  }
  if (!skips.empty()) text += "\nNot computed, because not needed\n";
  for (const Skip& skip : skips) text += wrapped(format_skip(skip));
  if (!results.notes.empty()) text += "\nNotes\n";
  return text + paragraphs(results.notes);
}

}  // namespace glissade
