// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/csv.hpp"

#include <charconv>

#include "glissade/core/contract.hpp"

namespace glissade {

std::string shortest_decimal(double value) {
  char buffer[32];
  const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
  return {buffer, end};
}

CsvTable::CsvTable(const std::vector<std::string>& header) : columns_(header.size()) {
  for (const std::string& name : header) cell(name);
  end_row();
}

void CsvTable::append(std::string_view text) {
  if (filled_++ > 0) text_ += ',';
  text_ += text;
}

CsvTable& CsvTable::cell(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) {
    append(text);
    return *this;
  }
  std::string quoted = "\"";
  for (const char c : text) {
    quoted += c;
    if (c == '"') quoted += c;
  }
  append(quoted + "\"");
  return *this;
}

CsvTable& CsvTable::cell(double value) {
  append(shortest_decimal(value));
  return *this;
}

CsvTable& CsvTable::cell(std::uint64_t value) {
  append(std::to_string(value));
  return *this;
}

void CsvTable::end_row() {
  GLISSADE_EXPECTS(filled_ == columns_);
  filled_ = 0;
  text_ += '\n';
}

}  // namespace glissade
