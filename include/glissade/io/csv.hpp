// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "glissade/core/file.hpp"

namespace glissade {

/// The shortest decimal that reads back as the same double; "nan", "inf" and "-inf" where it is
/// none.
std::string shortest_decimal(double value);

/// A table as comma-separated text (RFC 4180 quoting, lines end in \n): the header first, then a
/// row at a time. Column names carry their units.
class CsvTable {
 public:
  explicit CsvTable(const std::vector<std::string>& header);

  CsvTable& cell(std::string_view text);
  CsvTable& cell(double value);
  CsvTable& cell(std::uint64_t value);
  /// Ends the row. A precondition: it has as many cells as the header.
  void end_row();

  const std::string& text() const { return text_; }

 private:
  void append(std::string_view text);
  std::size_t columns_;
  std::size_t filled_ = 0;
  std::string text_;
};

}  // namespace glissade
