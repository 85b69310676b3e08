// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/report/format.hpp"

namespace glissade {
namespace {

std::string number_text(ColumnKind kind, double value, int decimals = -1) {
  if (!std::isfinite(value)) return "-";
  switch (kind) {
    case ColumnKind::count:
      return fmt::format("{:.0f}", value);
    case ColumnKind::length: {
      const bool si = LengthUnits::first() == UnitSystem::si;
      return length_number(value, LengthUnits::first()) + " (" +
             length_number(value, si ? UnitSystem::us_customary : UnitSystem::si) + ")";
    }
    case ColumnKind::metric:
      return format_number(in_first_unit(value));
    case ColumnKind::share:
      return format_share(value);
    case ColumnKind::rate:
      return format_rate(value);
    case ColumnKind::text:
    case ColumnKind::number:
      break;
  }
  return decimals < 0 ? format_number(value) : fmt::format("{:.{}f}", value, decimals);
}

std::string estimate_text(ColumnKind kind, const NumberCell& estimate) {
  if (!std::isfinite(estimate.value)) return "-";
  std::string value = estimate.sign + number_text(kind, estimate.value);
  if (std::isnan(estimate.interval.low) || std::isnan(estimate.interval.high)) return value;
  // The interval in the value's first unit only: a range of metres and inches together is hard to
  // read.
  const auto end = [&](double number) {
    return std::isinf(number)           ? std::string("unbounded")
           : kind == ColumnKind::length ? length_number(number, LengthUnits::first())
                                        : number_text(kind, number);
  };
  return value + " [" + end(estimate.interval.low) + ", " + end(estimate.interval.high) + "]";
}

/// "Clearance, m (in)", or "Clearance, in (m)"; "PGV, m/s", or "PGV, in/s".
std::string heading_of(const Column& column) {
  std::string heading = column.heading;
  if (LengthUnits::first() == UnitSystem::si) return heading;
  const auto replace = [&](const char* metric, const char* customary) {
    const std::size_t at = heading.find(metric);
    if (at != std::string::npos) heading.replace(at, std::strlen(metric), customary);
  };
  if (column.kind == ColumnKind::metric) replace(", m", ", in");
  if (column.kind == ColumnKind::length) {
    replace("m (in)", "in (m)");
    replace("%, m]", "%, in]");
  }
  return heading;
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

/// A spreadsheet takes a text that begins with one of these for a formula, but for a sign alone.
bool is_formula(const std::string& text) {
  constexpr std::string_view signs = "=+-@\t\r";
  return text.size() > 1 && signs.find(text.front()) != std::string_view::npos;
}

std::string csv_field(std::string text) {
  if (is_formula(text)) text.insert(0, 1, '\'');
  if (text.find_first_of(",\"\n\r#") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string with_unit(const std::string& stem, const std::string& unit) {
  return unit.empty() ? stem : stem + "_" + unit;
}

std::string csv_header(const Column& column) {
  std::string header;
  for (const std::string& name : file_names(column))
    header += (header.empty() ? "" : ",") + csv_field(name);
  return header;
}

/// As wide as the column's header, whatever the cell.
std::string csv_cell(const Column& column, const Cell& cell) {
  const auto [value, interval] = estimate_of(cell);
  const bool is_text = column.kind == ColumnKind::text || std::holds_alternative<std::string>(cell);
  const std::string csv = is_text ? csv_field(cell_text(column, cell)) : format_exact(value);
  if (!column.with_interval) return csv;
  return csv + "," + format_exact(interval.low) + "," + format_exact(interval.high);
}

/// A text may stand anywhere ("-"); a number without digits of its own only in a column of numbers,
/// and an interval only in one that has them.
[[maybe_unused]] bool belongs_in(const Column& column, const Cell& cell) {
  if (std::holds_alternative<std::string>(cell)) return true;
  const auto* quantity = std::get_if<NumberCell>(&cell);
  if (column.kind == ColumnKind::text) return quantity != nullptr && quantity->digits.count >= 0;
  return column.with_interval || quantity == nullptr ||
         (std::isnan(quantity->interval.low) && std::isnan(quantity->interval.high));
}

std::string padded(const std::string& text, std::size_t width, ColumnKind kind) {
  const std::string space(width - std::min(width, display_width(text)), ' ');
  return kind == ColumnKind::text ? text + space : space + text;
}

}  // namespace

std::string unit_text(const std::string& unit) {
  if (unit == "mps") return "m/s";
  if (unit == "mps2") return "m/s2";
  if (unit == "Jpkg") return "J/kg";
  if (unit == "per_year") return "1/year";
  return unit.empty() ? "-" : unit;
}

std::vector<std::string> file_names(const Column& column) {
  std::vector<std::string> names{with_unit(column.stem, column.unit)};
  if (column.with_interval) {
    names.push_back(with_unit(column.stem + "_low95", column.unit));
    names.push_back(with_unit(column.stem + "_high95", column.unit));
  }
  return names;
}

Estimate estimate_of(const Cell& cell) {
  if (const auto* number = std::get_if<double>(&cell)) return {*number, {}};
  if (const auto* quantity = std::get_if<NumberCell>(&cell)) return *quantity;
  return {std::numeric_limits<double>::quiet_NaN(), {}};
}

NumberCell fixed(double value, int decimals, std::string unit) {
  NumberCell quantity(Estimate{value, {}});
  quantity.digits = {decimals, /*are_significant=*/false};
  quantity.unit = std::move(unit);
  return quantity;
}

NumberCell significant(double value, int digits, std::string unit) {
  NumberCell quantity = fixed(value, digits, std::move(unit));
  quantity.digits.are_significant = true;
  return quantity;
}

std::string text_of(const NumberCell& quantity) {
  if (!std::isfinite(quantity.value)) return "-";
  const auto& [count, are_significant] = quantity.digits;
  return quantity.sign +
         (are_significant ? fmt::format("{:.{}g}", quantity.value, count)
                          : fmt::format("{:.{}f}", quantity.value, count)) +
         (quantity.unit.empty() ? "" : " " + quantity.unit) + quantity.beside;
}

Column text_column(std::string stem, std::string heading, std::string description) {
  return {std::move(stem), "", std::move(heading), ColumnKind::text, std::move(description)};
}

Column detail(Column column) {
  column.detail = true;
  return column;
}

void Table::add(std::vector<Cell> row) {
  GLISSADE_EXPECTS(std::ranges::equal(columns, row, belongs_in));
  rows.push_back(std::move(row));
}

void Table::add_note(std::string text) {
  if (!text.empty()) notes.push_back(std::move(text));
}

namespace {

Table with_columns(const Table& all, const std::vector<std::size_t>& places) {
  Table some{all.name,  all.title,        {},       std::vector<std::vector<Cell>>(all.rows.size()),
             all.notes, all.is_of_inputs, all.suite};
  for (const std::size_t place : places) {
    some.columns.push_back(all.columns[place]);
    for (std::size_t r = 0; r < all.rows.size(); ++r) some.rows[r].push_back(all.rows[r][place]);
  }
  return some;
}

}  // namespace

Table Table::without(const std::string& stem) const {
  std::vector<std::size_t> places;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (columns[c].stem != stem) places.push_back(c);
  return with_columns(*this, places);
}

Table Table::only(const std::vector<std::string>& stems) const {
  std::vector<std::size_t> places;
  for (const std::string& stem : stems) {
    const auto found = std::ranges::find(columns, stem, &Column::stem);
    GLISSADE_EXPECTS(found != columns.end());
    places.push_back(static_cast<std::size_t>(found - columns.begin()));
  }
  return with_columns(*this, places);
}

Table Table::first_rows(std::size_t most, const FileName& file) const {
  Table first = *this;
  if (rows.size() <= most) return first;
  first.rows.resize(most);
  first.notes.push_back(
      fmt::format("{} of {} rows; all are in tables/{}.csv", most, rows.size(), file.text()));
  return first;
}

std::string cell_text(const Column& column, const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* number = std::get_if<double>(&cell))
    return number_text(column.kind, *number, column.decimals);
  const NumberCell& quantity = std::get<NumberCell>(cell);
  return column.kind == ColumnKind::text ? text_of(quantity) : estimate_text(column.kind, quantity);
}

std::string to_csv(const Table& table) {
  std::string csv;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    csv += (c == 0 ? "" : ",") + csv_header(table.columns[c]);
  }
  csv += "\n";
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c)
      csv += (c == 0 ? "" : ",") + csv_cell(table.columns[c], row[c]);
    csv += "\n";
  }
  return csv;
}

DataTable data_of(const Table& table) {
  DataTable data{table.name, table.title, {}};
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    const Column& column = table.columns[c];
    const std::vector<std::string> names = file_names(column);
    const std::string unit = unit_text(column.unit),
                      meaning = column.description.empty() ? column.heading : column.description;
    if (column.kind == ColumnKind::text) {
      std::vector<std::string> texts;
      for (const std::vector<Cell>& row : table.rows) texts.push_back(cell_text(column, row[c]));
      data.columns.push_back({names[0], unit, meaning, std::move(texts)});
      continue;
    }
    std::vector<double> values, low, high;
    for (const std::vector<Cell>& row : table.rows) {
      const auto [value, interval] = estimate_of(row[c]);
      values.push_back(value);
      low.push_back(interval.low);
      high.push_back(interval.high);
    }
    data.columns.push_back({names[0], unit, meaning, std::move(values)});
    if (!column.with_interval) continue;
    data.columns.push_back(
        {names[1], unit, "lower end of the 95 % interval of " + names[0], std::move(low)});
    data.columns.push_back(
        {names[2], unit, "upper end of the 95 % interval of " + names[0], std::move(high)});
  }
  return data;
}

Table columns_table(const std::vector<Table>& tables) {
  Table all{"columns",
            "The columns of the other tables, and the title and notes of each",
            {text_column("table", "Table"), text_column("column", "Column"),
             text_column("unit", "Unit"), text_column("meaning", "Meaning"),
             text_column("title", "Title of the table"), text_column("notes", "Its notes")},
            {}};
  for (const Table& table : tables) {
    const Table head{table.name, table.title, table.columns, {}};
    std::string notes;
    for (const std::string& note : table.notes) notes += (notes.empty() ? "" : "; ") + note;
    for (const DataColumn& column : data_of(head).columns)
      all.add({table.name.text(), column.name, column.unit, column.description,
               one_line(table.title), one_line(notes)});
  }
  return all;
}

namespace {

/// A column as a terminal shows it.
struct TextColumn {
  const Column& column;
  std::vector<std::string> cells;  ///< the heading first
  std::size_t widest = 0;          ///< of its cells
  std::size_t whole = 0;           ///< of its cells, with a broken heading
  std::size_t least = 0;           ///< of its parts, with broken texts too
  std::size_t width = 0;           ///< as shown

  TextColumn(const Table& table, std::size_t c) : column(table.columns[c]) {
    cells.push_back(heading_of(column));
    for (const std::vector<Cell>& row : table.rows) cells.push_back(cell_text(column, row[c]));
    constexpr std::size_t narrowest_text = 8;
    for (std::size_t r = 0; r < cells.size(); ++r) {
      widest = std::max(widest, display_width(cells[r]));
      const bool breaks = r == 0 || column.kind == ColumnKind::text;
      for (const std::string& part : wrapped(cells[r], breaks ? narrowest_text : terminal_width))
        least = std::max(least, display_width(part));
      whole = std::max(r == 0 ? least : display_width(cells[r]), whole);
    }
    width = widest;
  }
};

std::size_t total_width(const std::vector<TextColumn>& columns) {
  std::size_t total = 0;
  for (const TextColumn& column : columns) total += 2 + column.width;
  return total;
}

/// Breaks headings first, then texts; then the last columns go.
void fit_terminal(std::vector<TextColumn>& columns, std::string& left_out) {
  const auto heading = [](const TextColumn& column) {
    return column.width - std::min(column.width, column.whole);
  };
  const auto text = [](const TextColumn& column) { return column.width - column.least; };
  while (total_width(columns) > terminal_width) {
    TextColumn& longest_heading = *std::ranges::max_element(columns, {}, heading);
    TextColumn& longest_text = *std::ranges::max_element(columns, {}, text);
    if (heading(longest_heading) > 0) {
      --longest_heading.width;
    } else if (text(longest_text) > 0) {
      --longest_text.width;
    } else if (columns.size() == 1) {
      return;
    } else {
      left_out = heading_of(columns.back().column) + (left_out.empty() ? "" : "; ") + left_out;
      columns.pop_back();
      for (TextColumn& column : columns) column.width = column.widest;
    }
  }
}

/// A row of the table, as many lines as its highest cell.
std::string row_text(const std::vector<TextColumn>& columns, std::size_t r) {
  std::vector<std::string> lines;
  for (std::size_t c = 0, left = 0; c < columns.size(); left += 2 + columns[c].width, ++c) {
    const std::vector<std::string> parts = wrapped(columns[c].cells[r], columns[c].width);
    lines.resize(std::max(lines.size(), parts.size()));
    for (std::size_t i = 0; i < parts.size(); ++i) {
      lines[i] += std::string(left + 2 - std::min(left + 2, display_width(lines[i])), ' ') +
                  padded(parts[i], columns[c].width, columns[c].column.kind);
    }
  }
  std::string text;
  for (const std::string& line : lines)
    text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
  return text;
}

}  // namespace

std::string to_text(const Table& table) {
  std::vector<TextColumn> columns;
  std::string left_out;
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    if (!table.columns[c].detail) columns.emplace_back(table, c);
  }
  fit_terminal(columns, left_out);
  std::string text = wrapped(one_line(table.title), terminal_width, 0) + "\n";
  for (const std::string& note : table.notes)
    text += wrapped(one_line(note), terminal_width, 0) + "\n";
  for (std::size_t r = 0; r <= table.rows.size(); ++r) text += row_text(columns, r);
  if (!left_out.empty())
    text += wrapped("(in the CSV files only: " + left_out + ")", terminal_width, 2) + "\n";
  return text;
}

std::string unbroken(const std::string& text) {
  static constexpr std::string_view no_break_space = "\u00a0", word_joiner = "\u2060";
  const auto is = [&](std::size_t i, int (*of_class)(int)) {
    return i < text.size() && of_class(static_cast<unsigned char>(text[i])) != 0;
  };
  std::string kept;
  bool in_interval = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '[' || text[i] == ']')
      in_interval = text[i] == '[' && (is(i + 1, std::isdigit) || text.substr(i + 1, 1) == "<");
    const bool of_number = is(i - 1, std::isdigit) && is(i + 1, std::isalpha),
               of_interval =
                   i + 1 < text.size() && (text[i + 1] == '[' || text[i + 1] == '%' ||
                                           (text[i + 1] == '(' && is(i - 1, std::isdigit)));
    const bool unit = text[i] == ' ' && i > 0 && (of_number || of_interval || in_interval);
    const bool sign = text[i] == '-' && i > 0 &&
                      ((text[i - 1] == ' ' && is(i + 1, std::isalpha)) ||
                       (text[i - 1] == 'e' && is(i + 1, std::isdigit)));
    unit ? kept += no_break_space : kept += text[i];
    if (sign) kept += word_joiner;
  }
  return kept;
}

Html to_html(const Table& table) {
  const auto cell = [&](Markup text, Markup number, std::size_t c, const std::string& content,
                        Markup end) {
    return enclosed(table.columns[c].kind == ColumnKind::text ? text : number, unbroken(content),
                    end);
  };
  Html html = enclosed("<table>\n<caption><div>", table.title, "");
  for (const std::string& note : table.notes)
    html += enclosed("<br><span class=\"note\">", note, "</span>");
  html += "</div></caption>\n<thead><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    html += cell("<th scope=\"col\">", "<th scope=\"col\" class=\"number\">", c,
                 heading_of(table.columns[c]), "</th>");
  html += "</tr></thead>\n<tbody>\n";
  for (const std::vector<Cell>& row : table.rows) {
    html += "<tr>";
    for (std::size_t c = 0; c < row.size(); ++c)
      html +=
          cell("<td>", "<td class=\"number\">", c, cell_text(table.columns[c], row[c]), "</td>");
    html += "</tr>\n";
  }
  return html + "</tbody>\n</table>\n";
}

}  // namespace glissade
