// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/analyses.hpp"
#include "glissade/report/format.hpp"
#include "glissade/report/tables.hpp"
#include "text/study_text.hpp"

namespace glissade {

std::vector<Table> csv_tables(const Results& results) {
  std::vector<Table> tables = collected(results, &AnalysisReport::tables);
  tables.push_back(records_table(results));
  tables.push_back(spectra_table(results));
  std::erase_if(tables, [](const Table& table) { return table.rows.empty(); });
  const std::string one_axis = one_axis_text(results);
  for (Table& table : tables) {
    const std::string target = target_text(results, table.suite);
    if (!table.title.ends_with('.') && !(one_axis + target).empty()) table.title += ".";
    if (!one_axis.empty() && table.title.find(one_axis) == std::string::npos)
      table.title += " Displacements are along " + one_axis + ".";
    if (!target.empty()) table.title += " Design target: " + target + ".";
  }
  return tables;
}

std::vector<DataTable> data_tables(const Results& results) {
  const LengthUnits units(results.units);
  std::vector<DataTable> data;
  for (const Table& table : csv_tables(results)) {
    if (!table.is_of_inputs) data.push_back(data_of(table));
  }
  return data;
}

}  // namespace glissade
