// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "enum_names.hpp"
#include "glissade/core/contract.hpp"
#include "results/hdf5_file.hpp"

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

/// Numbers of cases and motions: finite, and no larger than arithmetic with them stands.
inline void expect_usable(const std::string& name, const std::vector<double>& values) {
  constexpr double most = 1e100;
  const auto is = [](double x) { return std::abs(x) <= most; };
  if (!std::ranges::all_of(values, is)) throw Hdf5Error("take the numbers of " + name);
}
template <class T>
void expect_usable(const std::string&, const std::vector<T>&) {}

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
    if (rows.size() != values.size()) throw Hdf5Error("fit " + name + " to the other columns");
    expect_usable(name, values);
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

/// A list in every row, all of one length, as a (row, position) dataset.
template <class Archive, class Rows, class Field>
void matrix(const Archive& archive, const std::string& name, const Label& label, Rows& rows,
            Field field) {
  std::vector<double> values;
  Dims dims{rows.size(), rows.empty() ? 0 : field(rows.front()).size()};
  if constexpr (!Archive::reads) {
    for (auto& row : rows) {
      GLISSADE_EXPECTS(field(row).size() == dims[1]);
      values.insert(values.end(), field(row).begin(), field(row).end());
    }
  }
  archive.array(name, label, dims, values);
  if constexpr (Archive::reads) {
    if (dims[0] != rows.size()) throw Hdf5Error("fit " + name + " to the other columns");
    expect_usable(name, values);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const auto begin = values.begin() + static_cast<std::ptrdiff_t>(i * dims[1]);
      field(rows[i]).assign(begin, begin + static_cast<std::ptrdiff_t>(dims[1]));
    }
  }
}

/// A field of a field: member(&Outer::inner, &Inner::value).
template <class Outer, class Inner>
auto member(Outer outer, Inner inner) {
  return [=](auto& row) -> auto& { return std::invoke(inner, std::invoke(outer, row)); };
}

/// The columns of a group: each is named once with its unit, its description and the field of a row
/// that it is, a member or what member() makes of two.
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
    converted(
        archive_, name, label, rows_, [&](auto& row) { return static_cast<Stored<T>>(of(row)); },
        [&](auto& row, const Stored<T>& value) { of(row) = static_cast<T>(value); });
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
