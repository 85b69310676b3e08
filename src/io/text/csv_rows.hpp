// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "glissade/io/text_files.hpp"

namespace glissade {

/// Why a row is refused; nothing (no `what`) where it is taken. Rows of one kind of trouble are
/// counted, and the first few are shown.
struct RowTrouble {
  std::string what, suggestion;
  std::string kind = what;
};

using Cells = std::vector<std::string_view>;

/// The cells of a line, without the quotes in which a separator may stand, and the blanks around
/// them.
Cells quoted_cells(std::string_view line, char separator);

/// A file with a header that names its columns, and a row of as many cells in each line below.
struct CsvReader {
  Cells (*split)(std::string_view line);  ///< cells of a line
  std::size_t shown_of_a_kind = 3;
  std::string begin_with;  ///< of a file without rows: "a header (...) and ..."
  /// Throws InputError where it is none; false: the file is another one, and no more is read.
  std::function<bool(const std::string& where, std::string_view line, const Cells& names)>
      take_header;
  std::function<RowTrouble(const Cells& cells, std::size_t line)> take_row;
};
/// Throws InputError with what is wrong with the rows, or where there are none. Lines that begin
/// with # are comments; empty columns at the end and rows of commas are left out.
void read_csv(const TextFile& file, const CsvReader& reader);

/// Columns of numbers beside which a file may have `record` and `event`, any text, and `weight`, 0
/// or more.
struct NumberRow {
  std::vector<double> values;  ///< by NumberRows::header
  std::size_t line = 0;
  bool has_record = false, has_event = false, has_weight = false;
  double weight = 1.0;
  std::size_t record = 0, event = 0;  ///< rows with the same text have the same number
  /// What is independent: the event where it is named, else the record.
  std::size_t unit() const { return has_event ? event : record; }
};

/// A header that a CSV file of numbers may have, in any order, and what takes its rows.
struct NumberRows {
  Cells header;
  std::function<RowTrouble(const NumberRow& row)> take_row;
  std::string_view may_be_infinite = {};  ///< a column with inf
  bool may_be_empty = false;              ///< in it nothing stands for inf
};

/// Reads the finite numbers below one of the headers. The names of the records, by number.
enum class BesideNumbers { nothing, record_and_weight };
std::vector<std::string> read_number_rows(const TextFile& file,
                                          const std::vector<NumberRows>& known,
                                          BesideNumbers beside = BesideNumbers::nothing);

}  // namespace glissade
