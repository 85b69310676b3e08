// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "records/record_units.hpp"

namespace glissade {

/// What separates the cells of a table, and how its numbers are written.
struct TableStyle {
  char separator = ' ';  ///< ' ': blanks and tabs
  bool decimal_comma = false;
};

/// The cells of a line, without quotes; what is empty behind the last separator is none.
std::vector<std::string_view> table_cells(std::string_view line, char separator);

/// "# time_s a_g" without what marks it as a comment.
std::string_view without_comment_mark(std::string_view line);

/// A column by its heading: "Time (s)", "U1 m/sec2", "a [m/s^2]", "acc_g".
struct TableColumn {
  std::string name;     ///< without the unit
  std::string heading;  ///< as written
  std::string unit;     ///< as written; may be empty
  HeaderUnit meaning;   ///< of the unit
};

/// The columns that the lines above the rows name, if as many; a line of units may follow the
/// names.
/// @param above comment marks removed
std::vector<TableColumn> table_columns(const std::vector<std::string>& above, char separator,
                                       std::size_t count);

bool is_time(const TableColumn& column);
/// Why the columns are those of a spectrum or of modes: one is a period or a frequency and none
/// surely a time; "" where they may be a record.
std::string spectrum_column(const std::vector<TableColumn>& columns);
/// By its unit, or by its name where it has no unit.
bool is_acceleration(const TableColumn& column);

}  // namespace glissade
