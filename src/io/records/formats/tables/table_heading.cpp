// SPDX-License-Identifier: GPL-3.0-or-later
#include "records/formats/tables/table_heading.hpp"

#include <algorithm>
#include <array>

#include "text/scan.hpp"

namespace glissade {
namespace {

std::string_view without_quotes(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"')
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

std::string_view without_brackets(std::string_view cell) {
  cell = trimmed(cell);
  if (cell.size() >= 2 &&
      ((cell.front() == '(' && cell.back() == ')') || (cell.front() == '[' && cell.back() == ']')))
    cell = trimmed(cell.substr(1, cell.size() - 2));
  return cell;
}

bool is_unit(std::string_view text) {
  const UnitKind kind = header_unit(without_brackets(text)).kind;
  return kind != UnitKind::unknown && kind != UnitKind::none;
}

TableColumn named_column(std::string_view heading, std::string_view name, std::string_view unit) {
  return {std::string(trimmed(name)), std::string(heading), std::string(unit), header_unit(unit)};
}

/// The unit stands in brackets, or behind the last blank, comma or underscore.
TableColumn column_of(std::string_view cell) {
  const std::size_t open = cell.find_first_of("[(");
  if (open != std::string_view::npos && open > 0) {
    const std::size_t close = cell.find_first_of("])", open);
    const std::string_view unit =
        trimmed(cell.substr(open + 1, close == cell.npos ? cell.npos : close - open - 1));
    return named_column(cell, cell.substr(0, open), unit);
  }
  const std::size_t last = cell.find_last_of(" ,_");
  if (last != std::string_view::npos && last > 0 && is_unit(cell.substr(last + 1))) {
    std::string_view name = trimmed(cell.substr(0, last));
    for (const std::string_view end : {" in", ","})
      if (lower_case(name).ends_with(end)) name.remove_suffix(end.size());
    return named_column(cell, name, trimmed(cell.substr(last + 1)));
  }
  return named_column(cell, cell, "");
}

/// Cells of a heading: a unit, with or without brackets, belongs to the name before it.
std::vector<std::string> heading_cells(std::string_view line, char separator, std::size_t count) {
  std::vector<std::string> cells;
  for (const std::string_view cell : table_cells(line, separator)) {
    if (separator == ' ' && !cells.empty() && (cell.starts_with('(') || cell.starts_with('[')))
      cells.back() += " " + std::string(cell);
    else
      cells.emplace_back(cell);
  }
  if (separator != ' ' || cells.size() != 2 * count) return cells;
  std::vector<std::string> pairs;
  for (std::size_t i = 0; i < cells.size(); i += 2) {
    if (!is_unit(cells[i + 1])) return cells;
    pairs.push_back(cells[i] + " " + cells[i + 1]);
  }
  return pairs;
}

/// As many cells as columns, by the separator of the rows or by another one; empty: no heading.
std::vector<std::string> heading_of(std::string_view line, char separator, std::size_t count) {
  for (const char other : {separator, '\t', ',', ';', ' '}) {
    std::vector<std::string> cells = heading_cells(line, other, count);
    if (cells.size() == count) return cells;
  }
  return {};
}

bool are_units(const std::vector<std::string>& cells) {
  return std::ranges::any_of(cells, [](const auto& cell) { return is_unit(cell); }) &&
         std::ranges::all_of(cells, [](const auto& cell) { return cell.empty() || is_unit(cell); });
}

bool has_any_of(const std::string& lower, std::initializer_list<std::string_view> parts) {
  return std::ranges::any_of(parts, [&](auto part) { return lower.find(part) != lower.npos; });
}

bool is_named(const std::string& lower, std::initializer_list<std::string_view> names) {
  return std::ranges::find(names, lower) != names.end();
}

bool is_period(const TableColumn& column) {
  const std::string lower = lower_case(column.name);
  return column.meaning.kind == UnitKind::frequency || is_named(lower, {"hz", "f", "tn", "t_n"}) ||
         has_any_of(lower, {"period", "freq", "frec", "omega", "schwing"});
}

}  // namespace

std::vector<std::string_view> table_cells(std::string_view line, char separator) {
  line = trimmed(line);
  std::vector<std::string_view> cells;
  while (!line.empty()) {
    if (cells.size() + 1 == most_fields) {
      cells.push_back(line);
      return cells;
    }
    const std::size_t closing = line.front() == '"' ? line.find('"', 1) : line.npos;
    const std::size_t from = closing == line.npos ? 0 : closing;  // a separator in quotes is none
    const std::size_t end =
        separator == ' ' ? line.find_first_of(" \t", from) : line.find(separator, from);
    cells.push_back(without_quotes(line.substr(0, end)));
    line.remove_prefix(end == std::string_view::npos ? line.size() : end + 1);
    if (separator == ' ') line = trimmed(line);
  }
  return cells;
}

std::string_view without_comment_mark(std::string_view line) {
  line = trimmed(line);
  while (!line.empty() && std::string_view("#%!*").find(line.front()) != std::string_view::npos)
    line = trimmed(line.substr(1));
  return line;
}

std::vector<TableColumn> table_columns(const std::vector<std::string>& above, char separator,
                                       std::size_t count) {
  std::vector<TableColumn> columns;
  for (std::size_t i = above.size(); i-- > 0 && columns.empty();) {
    const std::vector<std::string> cells = heading_of(above[i], separator, count);
    if (cells.empty()) continue;
    const std::vector<std::string> names = i > 0 && are_units(cells)
                                               ? heading_of(above[i - 1], separator, count)
                                               : std::vector<std::string>();
    for (std::size_t k = 0; k < count; ++k)
      columns.push_back(names.empty()
                            ? column_of(cells[k])
                            : named_column(names[k], names[k], without_brackets(cells[k])));
    // Above one column any line has as many cells.
    if (count == 1 && !is_acceleration(columns.front())) columns.clear();
  }
  return columns;
}

std::string spectrum_column(const std::vector<TableColumn>& columns) {
  const auto named = [](const TableColumn& column, std::initializer_list<std::string_view> names) {
    return is_named(lower_case(column.name), names);
  };
  const auto is_spectral = [&](const TableColumn& column) {
    return named(column, {"sa", "sv", "sd", "s_a", "se", "s_e", "spa", "sa_g"}) ||
           has_any_of(lower_case(column.name), {"psa", "psv", "pseudo", "spectr", "ps-acc"});
  };
  const auto is_number = [](const TableColumn& column) {
    return !column.heading.empty() &&
           column.heading.find_first_not_of("0123456789.+-") == std::string::npos;
  };
  const auto is_value = [&](const TableColumn& column) {
    const UnitKind kind = column.meaning.kind;
    return kind == UnitKind::velocity || kind == UnitKind::displacement || is_spectral(column) ||
           is_acceleration(column);
  };
  // "Sampling frequency (Hz), 100" and "Frequency content" are no headings.
  if (std::ranges::any_of(columns, is_number) || std::ranges::none_of(columns, is_value)) return "";
  const bool has_spectral = std::ranges::any_of(columns, is_spectral);
  for (const TableColumn& column : columns)
    if (is_time(column) && !is_period(column) && !has_spectral) return "";
  for (const TableColumn& column : columns)
    if (is_period(column) || (has_spectral && is_time(column))) return column.heading;
  return "";
}

bool is_time(const TableColumn& column) {
  if (column.meaning.kind == UnitKind::time) return true;
  if (column.meaning.kind != UnitKind::none) return false;
  return is_named(lower_case(column.name), {"time", "t", "times", "sec", "seconds", "zeit",
                                            "tiempo", "temps", "tempo", "zaman"});
}

bool is_acceleration(const TableColumn& column) {
  if (column.meaning.kind == UnitKind::acceleration) return true;
  if (column.meaning.kind != UnitKind::none && column.meaning.kind != UnitKind::unknown)
    return false;
  const std::string name = lower_case(column.name);
  for (const std::string_view part : {"acc", "acel", "beschl", "acél"})
    if (name.find(part) != std::string::npos) return true;
  return is_named(name,
                  {"a",   "ax",    "ay",   "az",       "a1",  "a2",  "a3",   "u1",  "u2",  "u3",
                   "ux",  "uy",    "uz",   "x",        "y",   "z",   "h1",   "h2",  "v",   "up",
                   "ud",  "ns",    "ew",   "n-s",      "e-w", "u-d", "n",    "e",   "hne", "hnn",
                   "hnz", "north", "east", "vertical", "l",   "t",   "long", "tran"});
}

}  // namespace glissade
