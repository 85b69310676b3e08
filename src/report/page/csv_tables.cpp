// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/analyses.hpp"
#include "glissade/report/tables.hpp"

namespace glissade {

std::vector<Table> csv_tables(const Results& results) {
  std::vector<Table> tables = collected(results, &AnalysisReport::tables);
  tables.push_back(records_table(results));
  tables.push_back(spectra_table(results));
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  return tables;
}

}  // namespace glissade
