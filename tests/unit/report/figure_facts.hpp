// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/tables.hpp"

namespace glissade {

/// Of figures or tables.
template <class Named>
std::vector<std::string> names(const std::vector<Named>& all) {
  std::vector<std::string> list;
  for (const Named& one : all) list.push_back(one.name);
  return list;
}

/// The table of a CSV file, whose title has what stands above all tables.
inline Table table_named(const Results& results, const std::string& name) {
  for (const Table& table : csv_tables(results))
    if (table.name == name) return table;
  ADD_FAILURE() << "no table " << name;
  return {};
}

inline Cell cell_of(const Table& table, std::size_t row, const std::string& stem) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].stem == stem) return table.rows.at(row)[c];
  ADD_FAILURE() << "no column " << stem;
  return 0.0;
}

inline double number(const Table& table, std::size_t row, const std::string& stem) {
  return estimate_of(cell_of(table, row, stem)).value;
}

inline Figure figure_named(const std::vector<Figure>& figures, const std::string& name) {
  for (const Figure& figure : figures) {
    if (figure.name == name) return figure;
  }
  ADD_FAILURE() << "no figure " << name;
  return {};
}

/// The series of that name in any panel; without numbers where there is none.
inline DataSeries series_named(const Figure& figure, const std::string& name) {
  for (const Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series)
      if (series.name == name) return series;
  }
  return {};
}

/// The series that have numbers and an entry in the key.
inline std::vector<DataSeries> curves_of(const Figure& figure) {
  std::vector<DataSeries> curves;
  for (const Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series)
      if (!series.label.empty() && !series.x.empty()) curves.push_back(series);
  }
  return curves;
}

/// The entries of the key, of series and rules.
inline std::vector<std::string> key_of(const Figure& figure) {
  std::vector<std::string> key;
  for (const Panel& panel : figure.panels) {
    for (const DataSeries& series : panel.series)
      if (!series.label.empty()) key.push_back(series.label);
    for (const Rule& rule : panel.rules)
      if (!rule.label.empty()) key.push_back(rule.label);
  }
  return key;
}

/// The series that say which columns of a table they are must have numbers of its rows: "tables/
/// chart.csv: mu, clearance_m". Returns the figures that have such series.
inline std::vector<std::string> figures_of_tables(const std::vector<Figure>& figures,
                                                  const std::vector<Table>& tables) {
  std::vector<std::string> names;
  const auto expect_numbers = [&](const DataSeries& series) {
    const std::size_t slash = series.source.find('/'), end = series.source.find(".csv: ");
    const std::string file = series.source.substr(slash + 1, end - slash - 1);
    const auto table =
        std::ranges::find_if(tables, [&](const Table& one) { return one.name.text() == file; });
    ASSERT_NE(table, tables.end()) << series.source;
    const DataTable data = data_of(*table);
    std::vector<const std::vector<double>*> columns;  // null: of texts, which stand at places
    std::istringstream stems(series.source.substr(end + 6));
    for (std::string stem; std::getline(stems >> std::ws, stem, ',');) {
      const auto column = std::ranges::find(data.columns, stem, &DataColumn::name);
      ASSERT_NE(column, data.columns.end()) << series.source;
      columns.push_back(std::get_if<std::vector<double>>(&column->values));
    }
    const std::vector<const std::vector<double>*> drawn =
        series.low.empty() ? std::vector{&series.x, &series.y}
                           : std::vector{&series.x, &series.low, &series.high};
    ASSERT_EQ(columns.size(), drawn.size());
    for (std::size_t i = 0; i < series.x.size(); ++i) {
      bool found = std::isnan(drawn[1]->at(i));  // a gap
      for (std::size_t row = 0; row < table->rows.size() && !found; ++row) {
        found = true;
        for (std::size_t c = 0; c < columns.size(); ++c)
          found = found && (columns[c] == nullptr || (*columns[c])[row] == drawn[c]->at(i));
      }
      EXPECT_TRUE(found) << series.name << " at " << series.x[i] << " is not of " << series.source;
    }
  };
  for (const Figure& figure : figures) {
    for (const Panel& panel : figure.panels) {
      for (const DataSeries& series : panel.series) {
        if (series.source.empty()) continue;
        expect_numbers(series);
        if (names.empty() || names.back() != figure.name.text())
          names.push_back(figure.name.text());
      }
    }
  }
  return names;
}

inline std::size_t numbers_in(const DataSeries& series) {
  std::size_t count = 0;
  for (const double x : series.x) count += std::isfinite(x) ? 1 : 0;
  return count;
}

}  // namespace glissade
