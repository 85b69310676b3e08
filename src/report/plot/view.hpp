// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"

// A figure as a view of a table: lines of y over x. Columns are named by their stems, the ends of
// their 95 % intervals as in files: stem_low95, stem_high95.
namespace glissade {

/// Leaves the rows whose number in a column is one of these.
void keep_rows(Table& table, const std::string& stem, const std::function<bool(double)>& is_kept);
/// Of rows that have the same cells in some columns leaves the one with the largest number in
/// another.
void keep_largest(Table& table, const std::vector<std::string>& same, const std::string& stem);

/// Rows with these cells.
using Where = std::vector<std::pair<std::string, Cell>>;

inline constexpr auto as_line = DataSeries::Kind::line, as_points = DataSeries::Kind::points,
                      as_line_and_points = DataSeries::Kind::line_and_points;

struct ViewLine {
  std::string name;  ///< and in the key
  Look look;
  DataSeries::Kind kind;
  std::string y;                    ///< column; empty: no line but a spread
  Where where = {};                 ///< of the rows of the view
  std::string low = {}, high = {};  ///< columns of a band or bars; empty: it has none
  std::string label = {};           ///< in the key, in place of the name
};

struct View {
  Table table;
  std::string x;  ///< column
  std::vector<ViewLine> lines;
  Where where = {};
  std::vector<std::pair<Cell, Tick>> places = {};    ///< on the x axis, of texts or named numbers
  DataSeries::Kind spread = DataSeries::Kind::band;  ///< or bars
  std::string spread_name = "95 % interval";
  bool in_key = true;  ///< the names of the lines
  double apart = 0.0;  ///< from line to line along x, so that bars do not hide each other
};

/// Adds the lines above what is in the panel, and their spreads below all lines.
void add_lines(Panel& panel, const View& view);
/// A panel of them, with an x axis from the first to the last and the names of the places.
Panel panel_of(const View& view, const std::string& x_label);
/// Of lines, spreads and level rules the largest finite number, at least 0.
double largest_y(const Panel& panel);

}  // namespace glissade
