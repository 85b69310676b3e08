// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/chart/report.hpp"
#include "glissade/report/tables.hpp"

namespace glissade {

std::vector<Table> csv_tables(const Results& results) {
  if (results.chart) return chart_csv_tables(results);
  std::vector<Table> tables = {fragility_table(results), slip_table(results),
                               stripes_table(results),   records_table(results),
                               spectra_table(results),   samples_table(results)};
  Table standards = standards_table(results);
  if (!standards.rows.empty()) tables.insert(tables.begin() + 2, std::move(standards));
  Table impact = impact_table(results);
  if (!impact.rows.empty()) tables.push_back(std::move(impact));
  return tables;
}

}  // namespace glissade
