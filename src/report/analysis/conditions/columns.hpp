// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"
#include "plot/view.hpp"

namespace glissade {

/// The column of an axis.
Column condition_column_of(const Results& results, ConditionAxis axis);
/// What stands in it at a place.
Cell condition_cell(const ConditionGrid& grid, ConditionAxis axis, std::size_t place);

/// The columns that name a condition: only those whose axis has several values.
class ConditionColumns {
 public:
  explicit ConditionColumns(const Results& results, std::vector<ConditionAxis> without = {});

  std::size_t count() const { return axes_.size() + (suites().size() > 1 ? 1 : 0); }
  /// Into a table of which something that its rows are of has a `suite` and is `at` a condition.
  void put_in(auto& table) const {
    if (suites().size() > 1)
      table.text("suite", "Suite", "name of the suite",
                 [this](const auto& row) -> decltype(row.at, std::string()) {
                   return suites()[row.suite].name;
                 });
    for (const ConditionAxis axis : axes_)
      table.put(condition_column_of(grid_.results(), axis),
                [this, axis](const auto& row) -> decltype(row.at, Cell()) {
                  return condition_cell(grid_, axis, row.at[axis]);
                });
  }

 private:
  const std::vector<SuiteSummary>& suites() const { return grid_.results().suites; }

  ConditionGrid grid_;
  std::vector<ConditionAxis> axes_;
};

/// The rows of a table at a condition but for its place on an axis.
Where rows_at(const Results& results, const Table& table, const Condition& at, ConditionAxis but);

/// Of a length, or another number.
Column range_column(const char* stem, const char* heading, const std::string& description = "",
                    ColumnKind kind = ColumnKind::length);

template <class T>
void append(std::vector<T>& all, std::vector<T> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace glissade
