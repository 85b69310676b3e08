// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "assumptions.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"

namespace glissade {
namespace {

constexpr auto style = R"(
body { font: 16px/1.5 Arial, Helvetica, sans-serif; color: #222; max-width: 68em; margin: 2em auto; padding: 0 1em; }
h1 { margin-bottom: 0; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }
.answer { background: #eef4fa; border-left: 4px solid #0072b2; padding: .6em 1em; }
.answer p { margin: .4em 0; }
.warning { background: #fff4e0; border-left: 4px solid #e69f00; padding: .4em 1em; }
figure { margin: 1.5em auto; max-width: 60em; } figure svg { width: 100%; height: auto; }
figcaption, caption { color: #444; font-size: .9em; text-align: left; padding: .3em 0; }
.wide { overflow-x: auto; }
table { border-collapse: collapse; font-size: .85em; margin: 1em 0; }
th, td { border-bottom: 1px solid #ddd; padding: .2em .6em; text-align: left; vertical-align: top; }
th { background: #f4f4f4; vertical-align: bottom; } .number { text-align: right; white-space: nowrap; }
td:not(.number) { min-width: 7em; }
dt { font-weight: bold; } dd { margin: 0 0 .5em 1.5em; }
pre { background: #f7f7f7; border: 1px solid #ddd; padding: .8em; white-space: pre-wrap; overflow-wrap: anywhere; font-size: .85em; }
@media print {
  body { max-width: none; margin: 0; font-size: 10pt; } h2, figcaption { break-after: avoid; }
  figure { max-width: 14cm; } figure, tr { break-inside: avoid; } .wide { overflow: visible; } table { font-size: 7pt; }
}
)";

std::string paragraph(const std::string& text) { return "<p>" + escape_html(text) + "</p>\n"; }

std::string heading(const std::string& text) { return "<h2>" + escape_html(text) + "</h2>\n"; }

std::string wide_table(const Table& table) {
  return "<div class=\"wide\">" + to_html(table) + "</div>\n";
}

std::string list(const std::vector<std::string>& items) {
  std::string html = "<ul>\n";
  for (const std::string& item : items) html += "<li>" + escape_html(item) + "</li>\n";
  return html + "</ul>\n";
}

/// The drawing without what belongs to a file of its own (XML declaration, gnuplot's title, which
/// browsers show as a tooltip).
std::string inline_svg(const DrawnFigure& drawn) {
  std::string svg = drawn.svg.substr(std::min(drawn.svg.find("<svg"), drawn.svg.size()));
  const std::size_t title = svg.find("<title>Gnuplot</title>");
  if (title != std::string::npos) svg.erase(title, std::string("<title>Gnuplot</title>").size());
  if (svg.starts_with("<svg")) {
    svg.insert(4, " role=\"img\" aria-label=\"" + escape_html(drawn.figure.title) + "\"");
  }
  return svg;
}

std::string figure_html(const DrawnFigure& drawn, std::size_t number) {
  return fmt::format(
      "<figure id=\"figure_{0}\">\n{1}\n<figcaption><strong>Figure {2}. {3}.</strong> "
      "{4}</figcaption>\n</figure>\n",
      drawn.figure.name, inline_svg(drawn), number, escape_html(drawn.figure.title),
      escape_html(drawn.figure.caption));
}

/// The provisions of one provenance, each once.
std::vector<std::string> provisions(const Results& results, Provenance provenance) {
  std::set<std::string> found;
  for (const RunResults& run : results.runs) {
    for (const StandardComparison& c : run.standards) {
      if (c.prescribed.provenance == provenance) found.insert(c.prescribed.basis);
    }
  }
  return {found.begin(), found.end()};
}

/// What is prescribed and on what basis; what is recalled must be verified before anyone relies on
/// it.
std::string provisions_html(const Results& results) {
  std::string html;
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

std::string answer_html(const Results& results) {
  return "<div class=\"answer\">\n" + list(answer_sentences(results)) + "</div>\n";
}

std::string results_html(const Results& results, const std::vector<DrawnFigure>& figures) {
  std::string html = heading("Results") + wide_table(fragility_summary_table(results));
  for (std::size_t i = 0; i < figures.size(); ++i) html += figure_html(figures[i], i + 1);
  const Table standards = standards_table(results);
  if (!standards.rows.empty()) {
    html += heading("Standards beside the results") + provisions_html(results) +
            wide_table(standards.without("basis"));
  }
  return html + heading("Slip by level") + wide_table(slip_table(results)) +
         heading("Fits in full") + wide_table(fragility_table(results).without("interval_method"));
}

std::string assumptions_html(const Results& results) {
  std::string html = heading("What is assumed") + "<dl>\n";
  for (const Assumption& assumption : assumptions_of(results)) {
    html += "<dt>" + escape_html(assumption.about) + "</dt><dd>" + escape_html(assumption.text) +
            "</dd>\n";
  }
  return html + "</dl>\n";
}

std::string skips_and_notes_html(const Results& results, const std::vector<Skip>& skips) {
  std::vector<std::string> skipped;
  for (const Skip& skip : skips) skipped.push_back(format_skip(skip));
  std::string html = heading("What was skipped, and why");
  html += skipped.empty() ? paragraph("See run.json beside the results file.") : list(skipped);
  if (!results.notes.empty()) html += heading("Notes") + list(results.notes);
  return html;
}

std::string inputs_html(const Results& results) {
  std::string runs;
  for (const RunResults& run : results.runs)
    runs += run.label + " (" + run.friction_description + ") ";
  return heading("Inputs") +
         paragraph("Suite: " + results.suite_name + ". " + results.suite_description) +
         paragraph("Friction runs: " + runs) + wide_table(records_table(results)) +
         "<h3>Study file</h3>\n<pre>" + escape_html(results.study_text) + "</pre>\n";
}

}  // namespace

std::string html_report(const Results& results, const std::vector<DrawnFigure>& figures,
                        const std::vector<Skip>& skips) {
  const std::string name = escape_html(results.study_name);
  return "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>" +
         name + " - slip fragility</title>\n<style>" + style + "</style>\n</head>\n<body>\n<h1>" +
         name + "</h1>\n" +
         paragraph(fmt::format("Slip fragility of an unattached rooftop solar array: {} records x "
                               "{} samples x {} levels of {}. "
                               "Every displacement is in plan.",
                               results.records.size(), results.samples.size(),
                               results.levels.size(), results.intensity_label)) +
         answer_html(results) + results_html(results, figures) + assumptions_html(results) +
         skips_and_notes_html(results, skips) + inputs_html(results) +
         paragraph(
             fmt::format("Made by glissade {}; plan {}, seed {}. The same study, suite and seed "
                         "give the same numbers. Tables "
                         "with all digits are in tables/, figures as PDF and SVG in figures/.",
                         results.program_version, results.plan_hash, results.seed)) +
         "</body>\n</html>\n";
}

}  // namespace glissade
