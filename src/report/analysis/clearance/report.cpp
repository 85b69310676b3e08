// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/analyses.hpp"
#include "glissade/report/clearance_report.hpp"
#include "page/page.hpp"

namespace glissade {
namespace {

/// How a required clearance is found.
std::vector<std::string> explained(const Results& r) {
  const bool two_axes = slides_on_two_axes(r);
  return {
      r.suites.front().of_roof ? "The rule is that of Walters et al. (2012), their model is not: "
                                 "the array slides on the "
                                 "motions of a roof, on which it does not act back."
      : two_axes
          ? "After Walters et al. (2012): the building is one oscillator along each of two "
            "axes, of the same period along both unless the study states otherwise; the array "
            "is a mass on it with Coulomb friction; it slides along both axes at once and "
            "acts back on the building."
          : "The rule is that of Walters et al. (2012), their model is not: the array slides "
            "along one axis, under one horizontal component.",
      !two_axes ? "The displacement of a history is the largest along the slope."
      : r.displacement == DisplacementMeasure::srss
          ? "The displacement of a history is the SRSS of the separate maxima along the roof's two "
            "axes, as the paper takes it. The vector's own peak, which is never larger, is in "
            "tables/histories.csv."
          : "The displacement of a history is the vector's own peak. The paper takes the SRSS of "
            "the separate maxima, which is never smaller.",
      "The range over the orientations is given, and the bounds with the orientation chosen record "
      "by record.",
      "At R a building yields where the design spectrum (2/3 of MCE) requires an elastic force R "
      "times as large, along each axis by itself, whatever the level of shaking; 0 is a building "
      "that stays elastic."};
}

/// Those of a page.
std::vector<Table> page_tables(const Results& results) {
  std::vector<Table> tables{clearance_table(results), clearance_periods_table(results)};
  if (results.cases.orientations > 1) tables.push_back(clearance_orientations_table(results));
  return tables;
}

std::vector<Table> file_tables(const Results& results) {
  std::vector<Table> tables = page_tables(results);
  for (Table& table : clearance_by_orientation_tables(results)) tables.push_back(std::move(table));
  tables.push_back(clearance_yielding_table(results));
  tables.push_back(clearance_histories_table(results));
  return tables;
}

Html section(const Results& results) {
  Html html = heading("Required clearance");
  for (const Table& table : page_tables(results)) html += table_or_file(table);
  return html + list(explained(results));
}

}  // namespace

AnalysisReport ClearanceAnalysis::in_report() {
  return {.is_in = [](const Results& results) { return results.clearance.has_value(); },
          .summary = clearance_summary,
          .sentences = clearance_sentences,
          .figures = clearance_figures,
          .tables = file_tables,
          .section = section};
}

}  // namespace glissade
