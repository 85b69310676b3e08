// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/html.hpp"

#include <fmt/format.h>

#include "analysis/analyses.hpp"
#include "analysis/chart/view.hpp"
#include "analysis/fragility/assumptions.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "page/page.hpp"
#include "page/symbols.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// What the analyses say in sentences.
struct Answers {
  std::vector<std::string> first;  ///< of the first analysis some, of each other one: above all
  std::vector<std::vector<std::string>> rest;  ///< of each analysis, in its section
};

Answers answers_of(const Results& results) {
  constexpr std::size_t most = 6, of_first = 4;
  Answers answers;
  for (const AnalysisReport& analysis : analyses_in(results)) {
    std::vector<std::string>& rest = answers.rest.emplace_back();
    if (analysis.sentences == nullptr) continue;
    const std::size_t here = answers.first.empty() ? of_first : 1;
    std::size_t taken = 0;
    for (std::string& sentence : analysis.sentences(results)) {
      const bool is_first = taken++ < here && answers.first.size() < most;
      (is_first ? answers.first : rest).push_back(std::move(sentence));
    }
  }
  return answers;
}

Html answer_html(const Answers& answers) {
  return "<div class=\"answer\">\n" + list(answers.first) + "</div>\n";
}

Html analyses_html(const Results& results, const Answers& answers) {
  Html html;
  std::size_t i = 0;
  for (const AnalysisReport& analysis : analyses_in(results)) {
    html += analysis.section(results);
    if (const auto& sentences = answers.rest[i++]; !sentences.empty()) html += list(sentences);
  }
  return html;
}

Html warnings_html(const Results& results) {
  return results.warnings.empty() ? Html()
                                  : "<div class=\"warning\">\n" + heading("Warnings") +
                                        list(texts_of(results.warnings)) + "</div>\n";
}

std::string what_was_run(const Results& results) {
  const CaseSet& set = results.cases;
  std::string text = fmt::format(
      "{} x {} x {} x {} x {} of {}. Every displacement is in plan.", counted_records(results),
      counted(set.combinations(), "combination"), counted(set.samples, "sample"),
      counted(set.orientations, "orientation"), levels_of_each(results), results.intensity_label);
  text += " Intensity measure: " + results.measure.meaning() + ".";
  if (const std::string target = target_text(results); !target.empty())
    text += " Design target: " +
            (differs_by_suite(results) ? "that of each suite, under Inputs" : target) + ".";
  if (const double dbe = results.model.dbe_level; dbe > 0.0)
    text += fmt::format(" Of the design target, DBE is S_DS = {} and MCE {}.",
                        with_unit(results, level_number(dbe)),
                        with_unit(results, level_number(mce_over_dbe * dbe)));
  if (results.chart) text += " Chart: " + chart_size(results) + ". " + how_counted(results);
  return text;
}

Html assumptions_html(const Results& results) {
  Html html = heading("What is assumed") + "<dl>\n";
  for (const Assumption& assumption : assumptions_of(results)) {
    html +=
        enclosed("<dt>", assumption.about, "</dt>") + enclosed("<dd>", assumption.text, "</dd>\n");
  }
  return html + "</dl>\n";
}

Html skips_and_notes_html(const Results& results, const std::vector<Skip>& skips) {
  std::vector<std::string> skipped;
  for (const Skip& skip : skips) skipped.push_back(format_skip(skip));
  Html html = heading("What was skipped, and why");
  html += skipped.empty() ? paragraph("See run.json beside the results file.") : list(skipped);
  if (!results.notes.empty()) html += heading("Notes") + list(results.notes);
  return html;
}

Html suites_html(const Results& results) {
  Html html;
  for (const SuiteSummary& suite : results.suites)
    html += enclosed("<p>", "Suite: " + suite.name + ". ", "") + given_text(suite.description) +
            enclosed("", suite.target.empty() ? "" : ". Its design target: " + suite.target + ".",
                     "</p>\n");
  return html;
}

Html inputs_html(const Results& results) {
  std::string runs;
  for (const RunResults& run : results.runs)
    runs += (runs.empty() ? "" : " | ") + friction_and_listed(results, run);
  return heading("Inputs") + suites_html(results) +
         (results.runs.empty() ? Html() : paragraph("Friction: " + runs)) +
         wide_table(records_table(results)) + "<h3>Study file</h3>\n" +
         study_file(results.study_text);
}

}  // namespace

std::string html_report(const Results& results, const std::vector<DrawnFigure>& figures,
                        const std::vector<Skip>& skips) {
  const Answers answers = answers_of(results);
  const Html page =
      page_head({results.study_name, "sliding of an unanchored solar array"}) +
      (results.study_description.empty()
           ? Html()
           : Html("<p>") + given_text(results.study_description) + "</p>\n") +
      answer_html(answers) + warnings_html(results) + paragraph(what_was_run(results)) +
      figures_html(figures) + analyses_html(results, answers) + assumptions_html(results) +
      skips_and_notes_html(results, skips) + inputs_html(results) +
      paragraph(fmt::format(
          "Made by glissade {}; plan {}, seed {}. The same study, suite and seed give the same "
          "numbers. Tables with all digits are in tables/, figures as PDF and SVG in figures/.",
          results.program_version, results.plan_hash, results.seed)) +
      page_foot();
  return with_symbols(page.str());
}

}  // namespace glissade
