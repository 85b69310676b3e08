// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "cli/child.hpp"

namespace glissade::test {

/// The cells of a row of a table by their columns.
using Row = std::map<std::string, std::string>;

inline double number(const Row& row, const std::string& column) {
  return std::stod(row.at(column));
}

/// The rows of a CSV file below its header.
inline std::vector<Row> rows_of(const std::string& csv) {
  std::vector<Row> rows;
  std::vector<std::string> header;
  for (const std::string& line : lines_of(csv)) {
    const std::vector<std::string> cells = cells_of(line);
    if (header.empty()) {
      header = cells;
      continue;
    }
    EXPECT_EQ(cells.size(), header.size()) << line;
    Row& row = rows.emplace_back();
    for (std::size_t i = 0; i < header.size(); ++i) row[header[i]] = cells.at(i);
  }
  return rows;
}

}  // namespace glissade::test
