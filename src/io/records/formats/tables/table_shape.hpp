// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "records/formats/record_format.hpp"
#include "records/formats/tables/table_heading.hpp"

namespace glissade {

struct TableLine {
  std::string_view text;
  std::size_t number;
};

/// A table, before its rows are read.
struct TableShape {
  TableStyle style;
  std::vector<bool> is_number;   ///< of the cells of the first row
  std::size_t first_row = 0;     ///< line
  std::vector<TableLine> above;  ///< its first row
  bool has_text_above = false;   ///< lines that are no comments

  bool is_all_numbers() const;
};

/// Where rows of one shape begin, below what may be a heading; nothing where no rows do.
std::optional<TableShape> find_table(const RecordText& file);

/// The cells of a row, without a comment behind them.
std::vector<std::string_view> row_cells(std::string_view line, const TableStyle& style);
std::optional<double> table_number(std::string_view cell, const TableStyle& style);

}  // namespace glissade
