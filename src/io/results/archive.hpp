// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "glissade/study/results.hpp"
#include "results/hdf5_file.hpp"
#include "toml_table.hpp"

namespace glissade {

// Pieces that write or read, as the archive (Hdf5Writer, Hdf5Reader) does: each field is named
// once, for both ways.

template <class Archive, class Values>
void list(const Archive& archive, const std::string& name, const Label& label, Values& values) {
  Dims dims{values.size()};
  archive.array(name, label, dims, values);
}

template <class Archive, class Cube>
void cube(const Archive& archive, const std::string& name, const Label& label, Cube& values) {
  Dims dims{values.rows, values.columns, values.depth};
  archive.array(name, label, dims, values.data);
  if constexpr (Archive::reads) {
    values.rows = dims[0];
    values.columns = dims[1];
    values.depth = dims[2];
  }
}

/// What one field is in the file: flags are bytes, the rest is as it is.
template <class T>
using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;

/// Reading makes as many rows as the dataset has, which is one of theirs; all must then fit.
template <class Archive, class Rows>
void make_rows(const Archive& archive, const std::string& name, Rows& rows, std::size_t rank = 1) {
  if constexpr (Archive::reads) rows.resize(archive.row_count(name, rank));
}

/// One field of every row, as a 1-D dataset; `field(row)` is a reference to it.
template <class Archive, class Rows, class Field>
void column(const Archive& archive, const std::string& name, const Label& label, Rows& rows,
            Field field) {
  using T = std::remove_cvref_t<decltype(field(rows.front()))>;
  std::vector<Stored<T>> values;
  if constexpr (!Archive::reads) {
    for (auto& row : rows) values.push_back(static_cast<Stored<T>>(field(row)));
  }
  list(archive, name, label, values);
  if constexpr (Archive::reads) {
    if (rows.size() != values.size()) throw Hdf5Error("fit " + name + " to the other columns");
    for (std::size_t i = 0; i < rows.size(); ++i) field(rows[i]) = static_cast<T>(values[i]);
  }
}

template <class E>
std::string name_of(EnumNames<E> names, E value) {
  for (const auto& [name, candidate] : names) {
    if (candidate == value) return name;
  }
  throw Hdf5Error("name a value");
}

template <class E>
E value_of(EnumNames<E> names, const std::string& text) {
  for (const auto& [name, value] : names) {
    if (text == name) return value;
  }
  throw Hdf5Error("understand " + text);
}

/// A column of enumeration names.
template <class E, class Archive, class Rows, class Field>
void name_column(const Archive& archive, const std::string& name, const Label& label, Rows& rows,
                 EnumNames<E> names, Field field) {
  std::vector<std::string> values;
  if constexpr (!Archive::reads) {
    for (auto& row : rows) values.push_back(name_of<E>(names, field(row)));
  }
  list(archive, name, label, values);
  if constexpr (Archive::reads) {
    if (rows.size() != values.size()) throw Hdf5Error("fit " + name + " to the other columns");
    for (std::size_t i = 0; i < rows.size(); ++i) field(rows[i]) = value_of<E>(names, values[i]);
  }
}

template <class Archive, class Rows, class Field>
void interval_column(const Archive& archive, const std::string& name, const Label& label,
                     Rows& rows, Field field) {
  column(
      archive, name + "_low", label, rows, [&](auto& row) -> auto& { return field(row).low; });
  column(
      archive, name + "_high", label, rows, [&](auto& row) -> auto& { return field(row).high; });
}

/// A list in every row, as a (row, position) dataset. Where lists differ in length they are filled
/// up with nan, and
/// `<name>_count` is the length of each.
template <class Archive, class Rows, class Field>
void matrix(const Archive& archive, const std::string& name, const Label& label, Rows& rows,
            Field field) {
  std::vector<std::uint64_t> counts;
  for (auto& row : rows) counts.push_back(field(row).size());
  hsize_t width = counts.empty() ? 0 : *std::max_element(counts.begin(), counts.end());
  std::vector<double> values;
  if constexpr (!Archive::reads) {
    for (auto& row : rows) {
      const auto& list_of_row = field(row);
      values.insert(values.end(), list_of_row.begin(), list_of_row.end());
      values.resize(values.size() + width - list_of_row.size(),
                    std::numeric_limits<double>::quiet_NaN());
    }
  }
  Dims dims{counts.size(), width};
  archive.array(name, label, dims, values);
  const Label count_label{"-", "how many values each row of the dataset of this name has"};
  if constexpr (!Archive::reads) {
    const bool is_ragged =
        std::any_of(counts.begin(), counts.end(), [&](std::uint64_t n) { return n != width; });
    if (is_ragged) list(archive, name + "_count", count_label, counts);
  } else {
    counts.assign(dims[0], dims[1]);
    if (archive.has(name + "_count")) list(archive, name + "_count", count_label, counts);
    if (rows.size() != dims[0] || counts.size() != dims[0])
      throw Hdf5Error("fit " + name + " to the other columns");
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (counts[i] > dims[1]) throw Hdf5Error("fit " + name + " to its counts");
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * dims[1]);
      field(rows[i]).assign(begin, begin + static_cast<std::ptrdiff_t>(counts[i]));
    }
  }
}

/// A list of intervals in every row, as two such datasets.
template <class Archive, class Rows, class Field>
void interval_matrix(const Archive& archive, const std::string& name, const Label& label,
                     Rows& rows, Field field) {
  std::vector<std::vector<double>> low, high;
  if constexpr (!Archive::reads) {
    for (auto& row : rows) {
      auto& low_of_row = low.emplace_back();
      auto& high_of_row = high.emplace_back();
      for (const Interval& interval : field(row)) {
        low_of_row.push_back(interval.low);
        high_of_row.push_back(interval.high);
      }
    }
  }
  if constexpr (Archive::reads) {
    low.resize(rows.size());
    high.resize(rows.size());
  }
  const auto whole = [](auto& row) -> auto& { return row; };
  matrix(archive, name + "_low", label, low, whole);
  matrix(archive, name + "_high", label, high, whole);
  if constexpr (Archive::reads) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (low[i].size() != high[i].size()) throw Hdf5Error("fit " + name + " to itself");
      field(rows[i]).clear();
      for (std::size_t j = 0; j < low[i].size(); ++j)
        field(rows[i]).push_back({low[i][j], high[i][j]});
    }
  }
}

}  // namespace glissade
