// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/report/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "glissade/core/contract.hpp"
#include "glissade/core/units.hpp"
#include "glissade/report/format.hpp"

namespace glissade {
namespace {

std::string number_text(ColumnKind kind, double value, int decimals = -1) {
  if (!std::isfinite(value)) return "-";
  switch (kind) {
    case ColumnKind::count:
      return fmt::format("{:.0f}", value);
    case ColumnKind::length:
      return format_number(value) + " (" + format_number(value / inch_m) + ")";
    case ColumnKind::share:
      return format_share(value);
    case ColumnKind::text:
    case ColumnKind::number:
      break;
  }
  return decimals < 0 ? format_number(value) : fmt::format("{:.{}f}", value, decimals);
}

std::string estimate_text(ColumnKind kind, const Estimate& estimate) {
  if (!std::isfinite(estimate.value)) return "-";
  std::string value = estimate.sign + number_text(kind, estimate.value);
  if (std::isnan(estimate.interval.low) || std::isnan(estimate.interval.high)) return value;
  // The interval in the value's first unit only: a range of metres and inches together is hard to
  // read.
  const ColumnKind end_kind = kind == ColumnKind::length ? ColumnKind::number : kind;
  return value + " [" + number_text(end_kind, estimate.interval.low) + ", " +
         number_text(end_kind, estimate.interval.high) + "]";
}

std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c == '\n' || c == '\r'; }, ' ');
  return text;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\n\r#") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

std::string with_unit(const std::string& stem, const std::string& unit) {
  return unit.empty() ? stem : stem + "_" + unit;
}

std::string csv_header(const Column& column) {
  std::string header = csv_field(with_unit(column.stem, column.unit));
  if (column.with_interval) {
    header += "," + csv_field(with_unit(column.stem + "_low95", column.unit));
    header += "," + csv_field(with_unit(column.stem + "_high95", column.unit));
  }
  return header;
}

std::string csv_cell(const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return csv_field(*text);
  if (const auto* number = std::get_if<double>(&cell)) return format_exact(*number);
  const auto& estimate = std::get<Estimate>(cell);
  return format_exact(estimate.value) + "," + format_exact(estimate.interval.low) + "," +
         format_exact(estimate.interval.high);
}

/// Characters on the screen: UTF-8 continuation bytes take none.
std::size_t display_width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0u) != 0x80u;
  }));
}

std::string padded(const std::string& text, std::size_t width, ColumnKind kind) {
  const std::string space(width - std::min(width, display_width(text)), ' ');
  return kind == ColumnKind::text ? text + space : space + text;
}

}  // namespace

Column text_column(std::string stem, std::string heading) {
  return {std::move(stem), "", std::move(heading), ColumnKind::text};
}

void Table::add(std::vector<Cell> row) {
  GLISSADE_EXPECTS(row.size() == columns.size());
  rows.push_back(std::move(row));
}

Table Table::without(const std::string& stem) const {
  Table rest{name, title, {}, std::vector<std::vector<Cell>>(rows.size()), notes};
  for (std::size_t c = 0; c < columns.size(); ++c) {
    if (columns[c].stem == stem) continue;
    rest.columns.push_back(columns[c]);
    for (std::size_t r = 0; r < rows.size(); ++r) rest.rows[r].push_back(rows[r][c]);
  }
  return rest;
}

std::string cell_text(const Column& column, const Cell& cell) {
  if (const auto* text = std::get_if<std::string>(&cell)) return *text;
  if (const auto* number = std::get_if<double>(&cell))
    return number_text(column.kind, *number, column.decimals);
  return estimate_text(column.kind, std::get<Estimate>(cell));
}

std::string to_csv(const Table& table) {
  std::string csv = "# " + one_line(table.title) + "\n";
  for (const std::string& note : table.notes) csv += "# " + one_line(note) + "\n";
  for (std::size_t c = 0; c < table.columns.size(); ++c) {
    csv += (c == 0 ? "" : ",") + csv_header(table.columns[c]);
  }
  csv += "\n";
  for (const std::vector<Cell>& row : table.rows) {
    for (std::size_t c = 0; c < row.size(); ++c) csv += (c == 0 ? "" : ",") + csv_cell(row[c]);
    csv += "\n";
  }
  return csv;
}

std::string to_text(const Table& table) {
  std::vector<std::vector<std::string>> lines(1);
  for (const Column& column : table.columns) lines[0].push_back(column.heading);
  for (const std::vector<Cell>& row : table.rows) {
    std::vector<std::string>& line = lines.emplace_back();
    for (std::size_t c = 0; c < row.size(); ++c)
      line.push_back(cell_text(table.columns[c], row[c]));
  }
  std::vector<std::size_t> widths(table.columns.size(), 0);
  for (const auto& line : lines) {
    for (std::size_t c = 0; c < line.size(); ++c)
      widths[c] = std::max(widths[c], display_width(line[c]));
  }
  std::string text = one_line(table.title) + "\n";
  for (const std::string& note : table.notes) text += one_line(note) + "\n";
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t c = 0; c < line.size(); ++c) {
      row += "  " + padded(line[c], widths[c], table.columns[c].kind);
    }
    text += row.substr(0, row.find_last_not_of(' ') + 1) + "\n";
  }
  return text;
}

Html to_html(const Table& table) {
  const auto cell = [&](Markup text, Markup number, std::size_t c, const std::string& content,
                        Markup end) {
    return enclosed(table.columns[c].kind == ColumnKind::text ? text : number, content, end);
  };
  Html html = enclosed("<table>\n<caption>", table.title, "");
  for (const std::string& note : table.notes) html += enclosed("<br>", note, "");
  html += "</caption>\n<thead><tr>";
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    html += cell("<th scope=\"col\">", "<th scope=\"col\" class=\"number\">", c,
                 table.columns[c].heading, "</th>");
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
