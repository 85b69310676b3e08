// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/report/table.hpp"
#include "glissade/study/results.hpp"
#include "plot/view.hpp"

namespace glissade {

/// The columns that name a condition: only those whose axis has several values.
class ConditionColumns {
 public:
  explicit ConditionColumns(const Results& results, std::vector<ConditionAxis> without = {});

  std::vector<Column> columns() const;
  std::vector<Cell> cells(std::size_t suite, const Condition& at) const;

 private:
  ConditionGrid grid_;
  std::vector<ConditionAxis> axes_;
};

/// The column of an axis.
Column condition_column_of(const Results& results, ConditionAxis axis);
/// What stands in it at a place.
Cell condition_cell(const ConditionGrid& grid, ConditionAxis axis, std::size_t place);
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
