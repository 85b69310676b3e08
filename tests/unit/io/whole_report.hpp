// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "glissade/report/figures.hpp"
#include "glissade/report/html.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"

namespace glissade {

/// All of a report but the drawing of its figures.
struct WholeReport {
  std::vector<std::string> tables;
  std::string page, summary;
};

inline WholeReport report_of(const Results& results) {
  WholeReport report;
  const std::vector<Table> tables = csv_tables(results);
  for (const Table& table : tables) report.tables.push_back(to_csv(table));
  report.tables.push_back(to_csv(columns_table(tables)));  // with titles and notes
  std::vector<DrawnFigure> figures;
  for (Figure& figure : make_figures(results)) figures.push_back({std::move(figure), "<svg/>"});
  report.page = html_report(results, figures);
  report.summary = summary_text(results);
  return report;
}

}  // namespace glissade
