// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "analysis/chart/report.hpp"
#include "glissade/report/clearance_report.hpp"
#include "glissade/report/tables.hpp"

namespace glissade {
namespace {

/// Tables without rows, and those that another analysis gives too, are left out.
void append(std::vector<Table>& all, std::vector<Table> more) {
  for (Table& table : more) {
    const auto same = [&](const Table& t) { return t.name == table.name; };
    if (!table.rows.empty() && !std::any_of(all.begin(), all.end(), same))
      all.push_back(std::move(table));
  }
}

}  // namespace

std::vector<Table> csv_tables(const Results& results) {
  std::vector<Table> tables;
  if (!results.runs.empty()) {
    append(tables, {fragility_table(results), slip_table(results), standards_table(results),
                    stripes_table(results), samples_table(results), impact_table(results)});
  }
  if (results.chart) append(tables, chart_csv_tables(results));
  if (results.clearance) append(tables, clearance_file_tables(clearance_results(results)));
  append(tables, {records_table(results), spectra_table(results)});
  return tables;
}

}  // namespace glissade
