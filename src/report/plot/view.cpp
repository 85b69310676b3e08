// SPDX-License-Identifier: GPL-3.0-or-later
#include "plot/view.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/contract.hpp"
#include "glissade/core/finite.hpp"
#include "text/study_text.hpp"

namespace glissade {
namespace {

/// A column of the table's files: its values, or an end of their intervals.
struct FileColumn {
  std::size_t place = 0, part = 0;

  FileColumn(const Table& table, const std::string& stem) {
    for (const Column& column : table.columns) {
      const std::string stems[] = {column.stem, column.stem + "_low95", column.stem + "_high95"};
      for (part = 0; part < file_names(column).size(); ++part)
        if (stems[part] == stem) return;
      ++place;
    }
    GLISSADE_EXPECTS(place < table.columns.size());
  }
  std::string name(const Table& table) const { return file_names(table.columns[place])[part]; }
  double number(const std::vector<Cell>& row) const {
    const auto [value, interval] = estimate_of(row[place]);
    return part == 0 ? value : part == 1 ? interval.low : interval.high;
  }
};

bool are_same(const Cell& a, const Cell& b) {
  const auto *text = std::get_if<std::string>(&a), *other = std::get_if<std::string>(&b);
  if (text != nullptr || other != nullptr)
    return text != nullptr && other != nullptr && *text == *other;
  const double x = estimate_of(a).value, y = estimate_of(b).value;
  return x == y || (std::isnan(x) && std::isnan(y));
}

using Rows = std::vector<const std::vector<Cell>*>;

Rows rows_where(const Table& table, Rows rows, const Where& where) {
  for (const auto& [stem, cell] : where)
    std::erase_if(rows, [place = FileColumn(table, stem).place, &cell](const auto* row) {
      return !are_same((*row)[place], cell);
    });
  return rows;
}

/// "tables/chart.csv: mu, clearance_m"
std::string source_of(const Table& table, const std::vector<FileColumn>& columns) {
  std::string source;
  for (const FileColumn& column : columns)
    source += (source.empty() ? "" : ", ") + column.name(table);
  return "tables/" + (table.name + ".csv: ") + source;
}

}  // namespace

void keep_rows(Table& table, const std::string& stem, const std::function<bool(double)>& is_kept) {
  const FileColumn column(table, stem);
  std::erase_if(table.rows, [&](const auto& row) { return !is_kept(column.number(row)); });
}

void keep_largest(Table& table, const std::vector<std::string>& same, const std::string& stem) {
  const FileColumn largest(table, stem);
  std::vector<std::size_t> places;
  for (const std::string& column : same) places.push_back(FileColumn(table, column).place);
  std::vector<std::vector<Cell>> kept;
  for (std::vector<Cell>& row : table.rows) {
    const auto found = std::ranges::find_if(kept, [&](const std::vector<Cell>& other) {
      return std::ranges::all_of(
          places, [&](std::size_t place) { return are_same(row[place], other[place]); });
    });
    if (found == kept.end())
      kept.push_back(std::move(row));
    else if (largest.number(row) > largest.number(*found))
      *found = std::move(row);
  }
  table.rows = std::move(kept);
}

void add_lines(Panel& panel, const View& view) {
  const Table& table = view.table;
  const FileColumn x(table, view.x);
  const auto x_of = [&](const std::vector<Cell>& row) {
    const auto place = std::ranges::find_if(
        view.places, [&](const auto& of) { return are_same(of.first, row[x.place]); });
    return place != view.places.end() ? place->second.at : x.number(row);
  };
  Rows shown;
  for (const std::vector<Cell>& row : table.rows) shown.push_back(&row);
  shown = rows_where(table, shown, view.where);
  std::vector<DataSeries> spreads;
  double aside = -0.5 * view.apart * static_cast<double>(view.lines.size() - 1);
  for (const ViewLine& line : view.lines) {
    const Rows rows = rows_where(table, shown, line.where);
    const auto add_to = [&](std::vector<DataSeries>& all, DataSeries series,
                            const std::vector<FileColumn>& y) {
      std::vector<FileColumn> columns{x};
      columns.insert(columns.end(), y.begin(), y.end());
      series.source = source_of(table, columns);
      series.aside = aside;
      for (const std::vector<Cell>* row : rows) {
        if (y.size() == 1)
          series.add(x_of(*row), y[0].number(*row));
        else
          series.add(x_of(*row), Interval{y[0].number(*row), y[1].number(*row)});
      }
      all.push_back(std::move(series));
    };
    const std::string label = line.label.empty() ? line.name : line.label;
    if (!line.y.empty())
      add_to(panel.series, {line.kind, line.look, line.name, view.in_key ? label : ""},
             {FileColumn(table, line.y)});
    if (!line.low.empty())
      add_to(spreads, {view.spread, line.look, line.name + ": " + view.spread_name},
             {FileColumn(table, line.low), FileColumn(table, line.high)});
    aside += view.apart;
  }
  const auto first_line = std::ranges::find_if(
      panel.series, [](const DataSeries& series) { return series.low.empty(); });
  panel.series.insert(first_line, spreads.begin(), spreads.end());
}

Panel panel_of(const View& view, const std::string& x_label) {
  Panel panel{"", {x_label, infinity, -infinity}};
  add_lines(panel, view);
  for (const DataSeries& series : panel.series)
    for (const double x : series.x) {
      panel.x.low = std::min(panel.x.low, x);
      panel.x.high = std::max(panel.x.high, x);
    }
  for (const auto& [cell, tick] : view.places)
    if (!tick.label.empty()) panel.x.ticks.push_back(tick);
  if (!panel.x.ticks.empty()) panel.x.values = Axis::Values::names;
  return panel;
}

double largest_y(const Panel& panel) {
  double found = 0.0;
  for (const DataSeries& series : panel.series)
    found = std::max({found, largest(series.y), largest(series.high)});
  for (const Rule& rule : panel.rules)
    if (rule.kind == Rule::Kind::horizontal) found = std::max(found, rule.at);
  return found;
}

}  // namespace glissade
