// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "analysis/clearance/view.hpp"
#include "glissade/core/file.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/html.hpp"
#include "glissade/study/kernel.hpp"
#include "page/page.hpp"

namespace glissade {
namespace {

/// Tables longer than this are files only.
constexpr std::size_t most_rows_shown = 60;

std::vector<std::string> how_it_was_done(const ClearanceResults& r) {
  return {
      "The model of Walters et al. (2012): the building is one oscillator along each of two axes, "
      "5 % damped unless the study says otherwise, of the same period along both; the array is a "
      "mass on it held by Coulomb friction; it slides along both axes at once and acts back on the "
      "building. Computed by the " +
          describe(Kernel::full) + ".",
      r.displacement == DisplacementMeasure::srss
          ? "The displacement of a history is the SRSS of the separate maxima along the roof's two "
            "axes, as the paper takes it. The vector's own peak, which is never larger, is in "
            "tables/histories.csv."
          : "The displacement of a history is the vector's own peak. The paper takes the SRSS of "
            "the separate maxima, which is never smaller.",
      "Displacements are in plan, relative to the roof. A suite's number is the mean over its "
      "records, each times its factor and the fraction of MCE.",
      "How the records lay to the roof is not told in the paper. Here all records lie alike, each "
      "choice by itself, and the range is told; each record its own way gives the bounds.",
      "At R a building yields where the design spectrum (2/3 of MCE) asks an elastic force R times "
      "as large, along each axis by itself, whatever the level of shaking. R = 1 is a building "
      "that "
      "stays elastic, as the paper's other results assume.",
      fmt::format("Clearance: {:g} times the largest mean over the building periods.",
                  r.clearance_factor)};
}

std::string html_page(const ClearanceResults& results, const std::vector<Table>& tables,
                      const std::vector<DrawnFigure>& figures) {
  Html html = page_head({results.study_name, "clearance study"});
  if (!results.study_description.empty()) html += paragraph(results.study_description);
  html += "<div class=\"answer\">\n";
  for (const std::string& sentence : clearance_sentences(results)) html += paragraph(sentence);
  html += "</div>\n";
  if (!results.statements.empty()) {
    html +=
        heading("The paper beside this study") + wide_table(clearance_statements_table(results));
  }
  html += figures_html(figures);
  for (const Table& table : tables) {
    html += table.rows.size() <= most_rows_shown
                ? wide_table(table)
                : paragraph(fmt::format("{}: {} rows in tables/{}.csv.", table.title,
                                        table.rows.size(), table.name.text()));
  }
  html += heading("How it was done") + list(how_it_was_done(results));
  html += heading("The study") + study_file(results.study_text);
  std::string suites;
  for (const ClearanceSuite& suite : results.suites)
    suites += fmt::format("; suite {}: {}", suite.name, suite.description);
  html += paragraph(
      fmt::format("glissade {}, plan {}{}.", results.program_version, results.plan_hash, suites));
  return (html + page_foot()).str();
}

}  // namespace

void write_clearance_report(const ClearanceResults& results, const std::filesystem::path& out_dir) {
  std::vector<Table> shown{clearance_table(results), clearance_periods_table(results)};
  if (results.orientations.size() > 1) shown.push_back(clearance_orientations_table(results));
  if (can_tell(results, ClearanceTopic::base_shear))
    shown.push_back(clearance_base_shear_table(results));
  std::vector<Table> all = shown;
  all.push_back(clearance_histories_table(results));
  if (!results.statements.empty()) all.push_back(clearance_statements_table(results));
  write_tables(all, out_dir);
  const std::vector<DrawnFigure> figures = draw(clearance_figures(results), out_dir);
  write_text_file(out_dir / "report.html", html_page(results, shown, figures));
}

}  // namespace glissade
