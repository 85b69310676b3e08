// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/formats/tables/table_shape.hpp"

#include <algorithm>

#include "records/formats/reading.hpp"

namespace glissade {
namespace {

/// "-0,0002": digits on both sides of one comma.
bool has_decimal_comma(std::string_view cell) {
  const std::size_t comma = cell.find(',');
  return comma != std::string_view::npos && cell.find('.') == std::string_view::npos &&
         table_number(cell, {' ', true}).has_value() && comma + 1 < cell.size();
}

TableStyle style_of(std::string_view line) {
  const auto any_comma = [&](char separator) {
    return std::ranges::any_of(row_cells(line, {separator}), has_decimal_comma);
  };
  if (line.find(';') != std::string_view::npos) return {';', any_comma(';')};
  if (line.find('\t') != std::string_view::npos && line.find(", ") == std::string_view::npos &&
      row_cells(line, {'\t'}).size() > 1)
    return {'\t', any_comma('\t')};
  if (line.find(',') == std::string_view::npos) return {' ', false};
  const auto words = row_cells(line, {' '});
  const bool is_decimal = words.size() > 1 && line.find('.') == std::string_view::npos &&
                          any_comma(' ') && std::ranges::all_of(words, [](std::string_view word) {
                            return has_decimal_comma(word) || fortran_number(word).has_value();
                          });
  return is_decimal ? TableStyle{' ', true} : TableStyle{',', false};
}

std::vector<bool> numbers_of(std::string_view line, const TableStyle& style) {
  std::vector<bool> is_number;
  for (const std::string_view cell : row_cells(line, style))
    is_number.push_back(table_number(cell, style).has_value());
  return is_number;
}

bool all_of_them(const std::vector<bool>& flags) {
  return std::ranges::find(flags, false) == flags.end();
}

/// One column with decimal commas: the same text might be two columns of whole numbers, but for
/// times that do not increase.
bool is_decimal_comma_column(LineReader lines) {
  std::optional<double> last;
  bool increases = true;
  std::size_t rows = 0;
  do {
    const std::string_view line = trimmed(lines.line());
    if (is_blank_or_comment(line)) continue;
    if (!has_decimal_comma(line)) return false;
    const auto whole = fortran_number(line.substr(0, line.find(',')));
    increases = increases && (!last || (whole && *whole > *last));
    last = whole;
    ++rows;
  } while (lines.next());
  return rows > 1 && !increases;
}

/// Whether the rows that follow a first one have its shape.
bool goes_on(LineReader lines, const TableStyle& style, const std::vector<bool>& shape) {
  const std::size_t looked_at = all_of_them(shape) ? 1 : 2;
  std::size_t rows = 0;
  while (rows < looked_at && lines.next()) {
    if (is_blank_or_comment(lines.line())) continue;
    if (numbers_of(lines.line(), style) != shape) return false;
    ++rows;
  }
  return rows > 0 || all_of_them(shape);
}

}  // namespace

bool TableShape::is_all_numbers() const { return all_of_them(is_number); }

std::vector<std::string_view> row_cells(std::string_view line, const TableStyle& style) {
  return table_cells(line.substr(0, line.find('#')), style.separator);
}

std::optional<double> table_number(std::string_view cell, const TableStyle& style) {
  const std::size_t comma = style.decimal_comma ? cell.find(',') : std::string_view::npos;
  if (comma == std::string_view::npos || cell.size() > 40) return fortran_number(cell);
  std::string with_point(cell);
  with_point[comma] = '.';
  return fortran_number(with_point);
}

std::optional<TableShape> find_table(const RecordText& file) {
  constexpr std::size_t most_lines_above = 200, longest_line = 10000;
  TableShape table;
  for (LineReader lines(file.text); lines.number() < most_lines_above && lines.next();) {
    const std::string_view line = lines.line();
    if (trimmed(line).empty()) continue;
    if (line.size() > longest_line) return std::nullopt;
    if (is_blank_or_comment(line)) {
      table.above.push_back({line, lines.number()});
      continue;
    }
    table.style = is_decimal_comma_column(lines) ? TableStyle{' ', true} : style_of(line);
    table.is_number = numbers_of(line, table.style);
    const auto numbers = std::ranges::count(table.is_number, true);
    const bool is_all = all_of_them(table.is_number);
    if (is_all ? numbers > 0 : numbers > 1) {
      table.first_row = lines.number();
      if (goes_on(lines, table.style, table.is_number)) return table;
      if (is_all) return std::nullopt;  // a header of numbers, or rows of several shapes
    }
    table.has_text_above = true;
    table.above.push_back({line, lines.number()});
  }
  return std::nullopt;
}

}  // namespace glissade
