// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "glissade/core/data_table.hpp"
#include "glissade/core/file_name.hpp"
#include "glissade/fragility/fit.hpp"
#include "glissade/report/html_text.hpp"

namespace glissade {

/// How a column is written for people. CSV always has the bare SI number with all its digits.
enum class ColumnKind {
  text,
  count,   ///< whole numbers
  number,  ///< three significant digits
  length,  ///< metres, with inches in brackets
  metric,  ///< m or m/s, as inches where those stand first
  share,   ///< percent
  rate,    ///< a year: "1.6e-4"
};

struct Column {
  std::string stem;     ///< "mean_slip": the name in files without its unit
  std::string unit;     ///< "m", "g", "s" ...; empty for text, counts and dimensionless numbers
  std::string heading;  ///< for people, unit included: "Mean slip, m (in)"
  ColumnKind kind = ColumnKind::number;
  std::string description;  ///< in results.h5 and columns.csv; empty: the heading
  bool with_interval =
      false;            ///< cells are Estimates; files get three columns: value, _low95, _high95
  int decimals = -1;    ///< of numbers for people; below 0: three significant digits
  bool detail = false;  ///< in CSV and HTML, not on a terminal
};

/// A column of text.
Column text_column(std::string stem, std::string heading, std::string description = "");
/// The same, but not on a terminal.
Column detail(Column column);

/// How many digits people read.
struct Digits {
  int count = -1;                ///< below 0: as the column states
  bool are_significant = false;  ///< or decimals
};

/// A number with what belongs to it. Unit and digits are of those in a column of text; in another
/// the column has them.
struct NumberCell : Estimate {
  NumberCell(const Estimate& estimate, std::string sign_text = "")
      : Estimate(estimate), sign(std::move(sign_text)) {}
  std::string sign;  ///< before the value: "> " of a lower bound, "< " of an upper one
  Digits digits;
  std::string unit;    ///< "in"
  std::string beside;  ///< after the unit: " (0.318 m)"
};
/// "12.50 in": with so many decimals.
NumberCell fixed(double value, int decimals, std::string unit = "");
/// "12.5 in": with so many significant digits at most.
NumberCell significant(double value, int digits, std::string unit = "");
/// Of one with its own digits; "-" for what is not finite.
std::string text_of(const NumberCell& quantity);

using Cell = std::variant<double, std::string, NumberCell>;

/// A small table: made once, shown as CSV, on a terminal, in HTML and in results.h5.
struct Table {
  FileName name = "table";  ///< of its file, without .csv
  std::string title;        ///< one line: what it is
  std::vector<Column> columns;
  std::vector<std::vector<Cell>> rows;
  std::vector<std::string> notes;  ///< how to read it: a line each, below the title
  bool is_of_inputs = false;       ///< or of histories, which results.h5 has in groups of their own
  std::optional<std::size_t> suite = {};  ///< where it is of one of the study's suites alone

  /// Adds a row. Expects one cell per column: in a column of text a number with its own digits
  /// only, no interval in a column without.
  void add(std::vector<Cell> row);
  void add_note(std::string text);  ///< unless it is empty
  /// The same table without a column.
  Table without(const std::string& stem) const;
  /// The same table with some columns alone, in this order.
  Table only(const std::vector<std::string>& stems) const;
  /// Its first rows; where it has more, a note says that all are in tables/`file`.csv.
  Table first_rows(std::size_t most, const FileName& file) const;
};

/// "m/s" of what is "mps" in names.
std::string unit_text(const std::string& unit);

/// A value with its interval, of two members.
template <class Thing>
auto with_interval(double Thing::*value, Interval Thing::*interval) {
  return [=](const Thing& of) { return Estimate{of.*value, of.*interval}; };
}

/// A column of tables of several things, and what stands in it.
template <class Value>
struct ColumnOf {
  Column column;
  Value value;

  operator const Column&() const { return column; }
};

/// A table of which each row is of some things: of a run and one of its fragilities. The value of a
/// column is a member of one of them, or a function of one or of all. Numbers of any type are
/// numbers, yes and no words; an Estimate has its interval. Headings get their unit and " [95 %]".
template <class... Things>
struct TableOf : Table {
  TableOf(FileName file, std::string what) : Table{std::move(file), std::move(what), {}, {}, {}} {}

  Column& text(std::string stem, std::string heading, std::string description, auto value) {
    return put(text_column(stem, heading, description), value);
  }
  Column& number(std::string stem, std::string heading, std::string description, auto value,
                 const std::string& unit = "") {
    if (!unit.empty()) heading += ", " + unit_text(unit);
    return put({stem, unit, heading, ColumnKind::number, description}, value);
  }
  Column& count(std::string stem, std::string heading, std::string description, auto value) {
    return put({stem, "", heading, ColumnKind::count, description}, value);
  }
  Column& share(std::string stem, std::string heading, std::string description, auto value) {
    return put({stem, "", heading, ColumnKind::share, description}, value);
  }
  Column& length(std::string stem, std::string heading, std::string description, auto value) {
    return put({stem, "m", heading + ", m (in)", ColumnKind::length, description}, value);
  }
  Column& rate(std::string stem, std::string heading, std::string description, auto value) {
    return put({stem, "per_year", heading, ColumnKind::rate, description}, value);
  }
  Column& put(Column column, auto value) {
    using Found = std::decay_t<decltype(found(value, std::declval<const Things&>()...))>;
    if (std::is_base_of_v<Estimate, Found> && column.kind != ColumnKind::text) {
      column.with_interval = true;
      column.heading += column.kind == ColumnKind::length ? " [95 %, m]" : " [95 %]";
    }
    cells_.push_back(
        [=](const Things&... things) { return cell_of<Found>(found(value, things...)); });
    return columns.emplace_back(std::move(column));
  }
  void put_all(const auto&... shared) { (put(shared.column, shared.value), ...); }

  void add(const Things&... things) {
    std::vector<Cell> row;
    for (const auto& cell : cells_) row.push_back(cell(things...));
    Table::add(std::move(row));
  }
  /// A row of each thing; or of each owner with each thing that it has.
  void add_each(const auto& things) {
    for (const auto& thing : things) add(thing);
  }
  void add_each(const auto& owners, auto member) {
    for (const auto& owner : owners)
      for (const auto& thing : std::invoke(member, owner)) add(owner, thing);
  }

 private:
  std::vector<std::function<Cell(const Things&...)>> cells_;

  static decltype(auto) found(const auto& value, const auto& first, const auto&... others) {
    if constexpr (std::is_invocable_v<decltype(value), decltype(first), decltype(others)...>)
      return std::invoke(value, first, others...);
    else if constexpr (std::is_invocable_v<decltype(value), decltype(first)>)
      return std::invoke(value, first);
    else
      return found(value, others...);
  }
  template <class T>
  static Cell cell_of(const T& value) {
    if constexpr (std::is_same_v<T, bool>)
      return value ? "yes" : "no";
    else if constexpr (std::is_arithmetic_v<T>)
      return static_cast<double>(value);
    else if constexpr (std::is_enum_v<T>)
      return to_string(value);
    else
      return value;
  }
};

/// The names of a column in files, unit included: one, or with its interval three.
std::vector<std::string> file_names(const Column& column);
/// The numbers of a cell, NaN where it has none: value, and ends of the interval.
Estimate estimate_of(const Cell& cell);
/// The cell as people read it: "0.300 (11.8)", "12 %", "0.84 [0.76, 0.93]"; "-" for what is not
/// finite.
std::string cell_text(const Column& column, const Cell& cell);

/// A header with the unit in every name, then the rows (RFC 4180 quoting). NaN is an empty field.
std::string to_csv(const Table& table);
/// A row for each column of their CSV files: its unit and meaning, with the table's title and
/// notes.
Table columns_table(const std::vector<Table>& tables);
/// The same for results.h5: an interval is two columns more; in a column of numbers a text is NaN.
DataTable data_of(const Table& table);
/// Title and aligned columns, numbers to the right, no wider than a terminal: texts and headings
/// are broken, and where that is not enough the last columns are left out, and named.
std::string to_text(const Table& table);
/// With no line break between a number and its unit, "0.605 s", or its interval, "0.84 [0.76,
/// 0.93]", nor after a sign, "-second", "1e-5".
std::string unbroken(const std::string& text);
/// A <table> with a caption, everything escaped.
Html to_html(const Table& table);

}  // namespace glissade
