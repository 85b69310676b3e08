// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/html.hpp"

#include <fmt/format.h>

#include <set>

#include "analysis/chart/report.hpp"
#include "analysis/chart/view.hpp"
#include "analysis/fragility/assumptions.hpp"
#include "analysis/impact/impact.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "page/page.hpp"

namespace glissade {
namespace {

/// The provisions of one provenance, each once.
std::vector<std::string> provisions(const Results& results, Provenance provenance) {
  std::set<std::string> found;
  const auto add = [&](const Prescription& prescribed) {
    if (prescribed.provenance == provenance) found.insert(prescribed.basis);
  };
  for (const RunResults& run : results.runs) {
    for (const StandardComparison& c : run.standards) add(c.prescribed);
  }
  if (results.chart) {
    for (const ChartPrescription& p : results.chart->standards) add(p.prescribed);
  }
  return {found.begin(), found.end()};
}

/// What is prescribed and on what basis; what is recalled must be verified before anyone relies on
/// it.
Html provisions_html(const Results& results) {
  Html html;
  const std::vector<std::string> checked = provisions(results, Provenance::checked);
  const std::vector<std::string> recalled = provisions(results, Provenance::recalled);
  if (!checked.empty()) html += paragraph("Checked against a source:") + list(checked);
  if (!recalled.empty()) {
    html +=
        "<div class=\"warning\"><p><strong>Verify against the standard.</strong> These provisions "
        "are recalled from "
        "memory of the standard, not reproduced from it:</p>\n" +
        list(recalled) + "</div>\n";
  }
  return html;
}

Html answer_html(const Results& results) {
  return "<div class=\"answer\">\n" + list(answer_sentences(results)) + "</div>\n";
}

/// Nothing without standards.
Html standards_html(const Results& results, const Table& standards) {
  if (standards.rows.empty()) return {};
  return heading("Standards beside the results") + provisions_html(results) +
         wide_table(standards.without("basis"));
}

/// Nothing where the study has no [impact].
Html impact_html(const Results& results) {
  if (!has_impact(results)) return {};
  const Table table = brief_impact_table(results);
  return heading("Speed on reaching a parapet, given that it is reached") +
         paragraph(impact_explained()) +
         (table.rows.empty() ? paragraph("The array reached no clearance at these levels.")
                             : wide_table(table)) +
         paragraph("Every run, clearance and level: tables/impact.csv.");
}

Html fragility_html(const Results& results) {
  return heading("Fragility") + wide_table(fragility_summary_table(results)) +
         standards_html(results, standards_table(results)) + impact_html(results) +
         heading("Slip by level") + wide_table(slip_table(results)) + heading("Fits in full") +
         wide_table(fragility_table(results).without("interval_method"));
}

Html chart_html(const Results& results) {
  constexpr std::size_t most = 16;
  Html html = heading("Design chart");
  if (!results.chart->readings.empty()) html += wide_table(chart_answers_table(results));
  return html + standards_html(results, chart_standards_table(results)) +
         heading("The chart in numbers") + wide_table(chart_matrix_table(results, most)) +
         paragraph(
             "Every level, slope and coefficient of friction, to interpolate in: "
             "tables/chart.csv.");
}

/// Longer tables are files only.
Html clearance_html(const ClearanceResults& results) {
  constexpr std::size_t most_rows = 60;
  Html html = heading("Required clearance");
  for (const Table& table : clearance_tables(results)) {
    html += table.rows.size() <= most_rows
                ? wide_table(table)
                : paragraph(fmt::format("{}: {} rows in tables/{}.csv.", table.title,
                                        table.rows.size(), table.name.text()));
  }
  return html + list(clearance_explained(results));
}

std::string what_was_run(const Results& results) {
  const CaseSet& set = results.cases;
  std::string text = fmt::format(
      "{} records x {} combinations x {} samples x {} orientations x {} levels of {}. Every "
      "displacement is in plan.",
      results.records.size(), set.combinations(), set.samples, set.orientations,
      results.levels.size(), results.intensity_label);
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
    html += paragraph("Suite: " + suite.name + ". " + suite.description);
  return html;
}

Html inputs_html(const Results& results) {
  std::string runs;
  for (const RunResults& run : results.runs)
    runs += run.label + " (" + run.friction_description + ") ";
  return heading("Inputs") + suites_html(results) +
         (results.runs.empty() ? Html() : paragraph("Friction: " + runs)) +
         wide_table(records_table(results)) + "<h3>Study file</h3>\n" +
         study_file(results.study_text);
}

}  // namespace

std::string html_report(const Results& results, const std::vector<DrawnFigure>& figures,
                        const std::vector<Skip>& skips) {
  const Html page =
      page_head({results.study_name, "sliding of an unanchored solar array"}) +
      (results.study_description.empty() ? Html() : paragraph(results.study_description)) +
      paragraph(what_was_run(results)) + answer_html(results) + figures_html(figures) +
      (results.clearance ? clearance_html(clearance_results(results)) : Html()) +
      (results.runs.empty() ? Html() : fragility_html(results)) +
      (results.chart ? chart_html(results) : Html()) + assumptions_html(results) +
      skips_and_notes_html(results, skips) + inputs_html(results) +
      paragraph(fmt::format("Made by glissade {}; plan {}, seed {}. The same study, suite and seed "
                            "give the same numbers. Tables "
                            "with all digits are in tables/, figures as PDF and SVG in figures/.",
                            results.program_version, results.plan_hash, results.seed)) +
      page_foot();
  return page.str();
}

}  // namespace glissade
