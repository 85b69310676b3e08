// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "glissade/study/results.hpp"
#include "results/hdf5_file.hpp"
#include "toml/toml_table.hpp"

namespace glissade {

// Pieces that write or read, as the archive (Hdf5Writer, Hdf5Reader) does: each field is named
// once, for both ways.

template <class Archive, class Values>
void list(const Archive& archive, const std::string& name, const Label& label, Values& values) {
  Dims dims{values.size()};
  archive.array(name, label, dims, values);
}

/// What one field is in the file: flags are bytes, the rest is as it is.
template <class T>
using Stored = std::conditional_t<std::is_same_v<T, bool>, std::uint8_t, T>;

/// Reading makes as many rows as the dataset has, which is one of theirs; all must then fit.
template <class Archive, class Rows>
void make_rows(const Archive& archive, const std::string& name, Rows& rows, std::size_t rank = 1) {
  if constexpr (Archive::reads)
    rows.resize(archive.row_count(name, rank, sizeof(typename Rows::value_type)));
}

/// Whether `values` are as many as the rows.
template <class Rows, class Values>
void expect_one_per_row(const std::string& name, const Rows& rows, const Values& values) {
  if (rows.size() != values.size()) throw Hdf5Error("fit " + name + " to the other columns");
}

template <class T>
constexpr bool is_list = false;
template <class T>
constexpr bool is_list<std::vector<T>> = true;

/// A group for a part that results may have: one that is optional, or rows.
template <class Archive, class Part, class Fields>
void if_there(const Archive& archive, const std::string& group, Part& part, Fields fields) {
  if constexpr (is_list<std::remove_const_t<Part>>) {
    bool is_there = !part.empty();
    if constexpr (Archive::reads) is_there = archive.has(group);
    if (is_there) fields(archive.group(group), part);
  } else {
    if constexpr (Archive::reads) {
      if (archive.has(group)) part.emplace();
    }
    if (part) fields(archive.group(group), *part);
  }
}

/// A 1-D dataset with a value of every row: `to_file(row)`, and `from_file(row, value)`.
template <class Archive, class Rows, class ToFile, class FromFile>
void converted(const Archive& archive, const std::string& name, const Label& label, Rows& rows,
               ToFile to_file, FromFile from_file) {
  std::vector<std::remove_cvref_t<decltype(to_file(rows.front()))>> values;
  if constexpr (!Archive::reads) {
    for (auto& row : rows) values.push_back(to_file(row));
  }
  list(archive, name, label, values);
  if constexpr (Archive::reads) {
    expect_one_per_row(name, rows, values);
    for (std::size_t i = 0; i < rows.size(); ++i) from_file(rows[i], values[i]);
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

/// A field of a field: member(&Outer::inner, &Inner::value).
template <class Outer, class Inner>
auto member(Outer outer, Inner inner) {
  return [=](auto& row) -> auto& { return std::invoke(inner, std::invoke(outer, row)); };
}

/// The columns of a group: each is named once with its unit, its description and the field of a row
/// that it is, a member or what member() makes of two. A list in a row makes a matrix; an interval
/// makes two datasets, NAME_low and NAME_high; an estimate makes these and its value; an absent
/// number is nan.
template <class Archive, class Rows>
class Columns {
 public:
  Columns(const Archive& archive, Rows& rows) : archive_(archive), rows_(rows) {}
  /// Reading makes as many rows as the dataset `key` has.
  Columns(const Archive& archive, Rows& rows, const std::string& key) : Columns(archive, rows) {
    make_rows(archive, key, rows);
  }

  template <class Field>
  void operator()(const std::string& name, const Label& label, Field field) const {
    const auto of = [&](auto& row) -> auto& { return std::invoke(field, row); };
    using T = std::remove_cvref_t<decltype(of(rows_.front()))>;
    if constexpr (std::is_same_v<T, Estimate>) {
      (*this)(name, label, member(field, &Estimate::value));
      const std::string of_it = "95 % interval of " + name;
      (*this)(name, {label.unit, of_it.c_str()}, member(field, &Estimate::interval));
    } else if constexpr (std::is_same_v<T, Interval>) {
      (*this)(name + "_low", label, member(field, &Interval::low));
      (*this)(name + "_high", label, member(field, &Interval::high));
    } else if constexpr (std::is_same_v<T, std::vector<Interval>>) {
      interval_matrix(archive_, name, label, rows_, of);
    } else if constexpr (is_list<T>) {
      matrix(archive_, name, label, rows_, of);
    } else if constexpr (std::is_same_v<T, std::optional<double>>) {
      converted(
          archive_, name, label, rows_,
          [&](auto& row) { return of(row).value_or(std::numeric_limits<double>::quiet_NaN()); },
          [&](auto& row, double value) {
            of(row) = std::isnan(value) ? std::nullopt : std::optional(value);
          });
    } else {
      converted(
          archive_, name, label, rows_, [&](auto& row) { return static_cast<Stored<T>>(of(row)); },
          [&](auto& row, const Stored<T>& value) { of(row) = static_cast<T>(value); });
    }
  }

  /// A column of an enumeration's names.
  template <class Field, class E>
  void operator()(const std::string& name, const Label& label, Field field,
                  EnumNames<E> names) const {
    converted(
        archive_, name, label, rows_,
        [&](auto& row) { return name_of(names, std::invoke(field, row)); },
        [&](auto& row, const std::string& text) {
          std::invoke(field, row) = value_of(names, text);
        });
  }

 private:
  const Archive& archive_;
  Rows& rows_;
};

}  // namespace glissade
