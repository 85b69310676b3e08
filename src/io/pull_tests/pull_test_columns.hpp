// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glissade {

enum class PullTestColumn { test, direction, time, displacement, force, normal };
inline constexpr std::size_t pull_test_columns = 6;

/// Where a file of pull tests has what: by PullTestColumn, the column's place and what takes its
/// numbers to SI. Only time may be absent.
struct PullTestHeader {
  struct Column {
    std::size_t index;
    double si_per_unit;
  };
  std::array<std::optional<Column>, pull_test_columns> columns;

  const std::optional<Column>& operator[](PullTestColumn column) const {
    return columns[static_cast<std::size_t>(column)];
  }
};

/// A header line: names in any order and any case. Throws InputError, with one problem for the
/// columns that are unknown or missing, and one for each that is there twice.
PullTestHeader read_pull_test_header(const std::string& where, std::string_view line,
                                     const std::vector<std::string_view>& cells);

}  // namespace glissade
