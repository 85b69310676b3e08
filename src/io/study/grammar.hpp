// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

#include "../toml/toml_table.hpp"
#include "glissade/study/config.hpp"

namespace glissade {

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

/// A key of a study file. The rows of grammar() are all keys there are: the error messages,
/// `glissade explain` and studies/GRAMMAR.md are made from them, and no other key can be read
/// (TomlDocument::read_only).
struct GrammarKey {
  std::string table, key;
  std::string value;    ///< what may be given
  std::string usual;    ///< where the key is absent; "required"
  std::string meaning;  ///< with its unit
  std::string name() const { return table + "." + key; }
};
const std::vector<GrammarKey>& grammar();
/// Whether some keys have "building", "building.period_s" or, within the value of a key,
/// "chart.shown.level".
bool has_key(const std::vector<GrammarKey>& keys, const std::string& name);

/// What may be given for several numbers, and for a quantity of a case.
inline constexpr const char
    *list_value = "list or { from, to, count, spacing }",
    *quantity_value = "number, list, { from, to, count, spacing }, { mean, std } or a distribution";

/// A key that has no effect without something else, which `are_met` looks for.
struct KeyNeeds {
  std::string table, key;
  std::string needs;  ///< "[model] axes = 2"
  std::function<bool(const TomlTable& root, const StudyConfig& study)> are_met;
};
std::vector<KeyNeeds> key_needs();
/// Reports every key that is given and has no effect. Reads after all others.
void refuse_idle_keys(const TomlTable& root, const StudyConfig& study);

}  // namespace glissade
