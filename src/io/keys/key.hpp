// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "enum_names.hpp"
#include "keys/grammar.hpp"
#include "toml/number_list.hpp"
#include "toml/toml_table.hpp"

// A key of a file in one row: what may be given, what holds where it is absent, what it means, what
// it needs and where it goes.
namespace glissade {

/// What may be given for several numbers, and for a quantity of a case.
inline constexpr const char
    *list_value = "list or { from, to, count, spacing }",
    *quantity_value = "number, list, { from, to, count, spacing }, { mean, std } or a distribution";

/// The names of choices as they stand in a study file: "a", "b".
template <class E>
std::string one_of(EnumNames<E> names) {
  std::string text;
  for (const auto& [name, value] : names)
    text += (text.empty() ? "\"" : ", \"") + std::string(name) + "\"";
  return text;
}

template <class E>
std::string quoted(EnumNames<E> names, E value) {
  const auto found = std::ranges::find(names, value, &std::pair<const char*, E>::second);
  return std::string("\"") + found->first + "\"";
}

/// Something without which a table or a key of a study or project C has no effect.
template <class C>
struct Need {
  std::string what;  ///< "[model] axes = 2"
  std::function<bool(const TomlTable& root, const C& config)> is_met;
};

/// How a value is read into its place.
template <class Read>
struct Reading {
  std::string value, usual;
  Read read;
};

/// A key of a C. One without `read` is read together with others, by the reader of its table.
template <class C>
struct Key : GrammarKey {
  std::vector<Need<C>> needs;
  std::function<void(const TomlTable& table, C& config)> read;

  Key(const char* name, std::string given, std::string otherwise, std::string what,
      std::vector<Need<C>> what_for = {})
      : GrammarKey{"", name, std::move(given), std::move(otherwise), std::move(what), ""},
        needs(std::move(what_for)) {}
  Key(const char* name, auto how, std::string what, std::vector<Need<C>> what_for = {})
      : Key(name, how.value, how.usual, std::move(what), std::move(what_for)) {
    read = [name, how](const TomlTable& table, C& config) { how.read(table, name, config); };
  }
  /// Of a project or product: with an example.
  Key(const char* name, std::string example, std::string standing, std::string what, auto how)
      : Key(name, Reading{std::move(example), std::move(standing), how.read}, std::move(what)) {}
};

template <class C>
struct KeyTable {
  std::string name;
  std::vector<Key<C>> keys;
  std::vector<std::string> needs = {};  ///< of the whole table
};

template <class C>
void read_keys(const std::vector<Key<C>>& keys, const TomlTable& table, C& config) {
  for (const Key<C>& key : keys)
    if (key.read) key.read(table, config);
}

/// Those of some tables.
template <class C>
void read_keys(const std::vector<KeyTable<C>>& tables, std::initializer_list<const char*> names,
               const TomlTable& root, C& config) {
  for (const char* name : names)
    read_keys(std::ranges::find(tables, name, &KeyTable<C>::name)->keys, root.table(name), config);
}

/// The rows, with "A; B" of what they need.
template <class C>
std::vector<GrammarKey> in_words(const std::vector<KeyTable<C>>& tables) {
  std::vector<GrammarKey> all;
  for (const KeyTable<C>& table : tables) {
    std::vector<std::string> needs = table.needs;
    for (const Key<C>& row : table.keys) {
      for (const Need<C>& need : row.needs) needs.push_back(need.what);
      all.push_back(row);
      all.back().table = table.name;
      all.back().needs = fmt::format("{}", fmt::join(needs, "; "));
      needs.clear();
    }
  }
  return all;
}

/// The value at a path of members, of which an optional one is made.
template <auto First, auto... Rest>
auto& at(auto& config) {
  auto& part = config.*First;
  if constexpr (sizeof...(Rest) == 0) {
    return part;
  } else if constexpr (requires { part.has_value(); }) {
    return at<Rest...>(part ? *part : part.emplace());
  } else {
    return at<Rest...>(part);
  }
}

template <class Member, class C>
C class_of(Member C::*);

/// What is there where the file says nothing.
template <auto First, auto... Rest>
auto usual_at() {
  decltype(class_of(First)) usual;
  return at<First, Rest...>(usual);
}

// Kinds of values: what may be given, what holds where nothing is, and how it is found.

inline auto kind(bool usual) {
  return Reading{"true or false", usual ? "true" : "false",
                 [](auto& table, auto key) { return table.flag(key); }};
}
inline auto kind(const std::string&) {
  return Reading{"text", "\"\"", [](auto& table, auto key) { return table.text(key); }};
}
inline auto kind(double usual, NumberRule rule) {
  return Reading{"number", fmt::format("{:g}", usual),
                 [=](auto& table, auto key) { return table.number(key, rule); }};
}
inline auto kind(std::optional<double>, NumberRule rule) {
  return Reading{"number", "none", [=](auto& table, auto key) { return table.number(key, rule); }};
}
inline auto kind(const std::vector<double>&, NumberRule rule) {
  return Reading{list_value, "required", [=](auto& table, auto key) {
                   return std::optional(read_increasing(table, key, rule));
                 }};
}
inline auto kind(std::integral auto usual, std::uint64_t least, std::uint64_t most) {
  return Reading{"whole number", fmt::format("{}", usual),
                 [=](auto& table, auto key) { return table.whole(key, least, most); }};
}
template <class E>
auto kind(E usual, EnumNames<E> names) {
  return Reading{one_of(names), quoted(names, usual),
                 [=](auto& table, auto key) { return table.template choice<E>(key, names); }};
}
template <class E>
auto kind(const std::vector<E>& usual, EnumNames<E> names) {  // one or several
  return Reading{one_of(names) + ", or a list",
                 usual.empty() ? "required" : quoted(names, usual.front()),
                 [=](auto& table, auto key) { return read_choices<E>(table, key, names); }};
}

/// @param how the rule of a number, the ends of a whole number, the names of choices
template <auto... Path>
auto reads(auto... how) {
  const auto of = kind(usual_at<Path...>(), how...);
  return Reading{of.value, of.usual, [of](const TomlTable& table, const char* key, auto& config) {
                   auto& place = at<Path...>(config);
                   if (auto given = of.read(table, key))
                     place = static_cast<std::remove_reference_t<decltype(place)>>(*given);
                 }};
}

/// A number that must be there.
template <auto... Path>
auto requires_number(NumberRule rule) {
  return Reading{"number", "required", [=](auto& table, auto key, auto& config) {
                   at<Path...>(config) = table.required_number(key, rule);
                 }};
}

/// A text that must be there.
template <auto... Path>
auto requires_text() {
  return Reading{"text", "required", [](auto& table, auto key, auto& config) {
                   at<Path...>(config) = table.required_text(key);
                 }};
}

/// A table without keys.
template <auto Flag>
auto is_there() {
  return Reading{"an empty table", "absent",
                 [](auto&, auto, auto& config) { config.*Flag = true; }};
}

}  // namespace glissade
