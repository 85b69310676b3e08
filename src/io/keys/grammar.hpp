// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace glissade {

/// A key of a file in words. Those of grammar() are all that a study file can have:
/// `glissade explain` and studies/GRAMMAR.md are made of them, and no other key can be read
/// (TomlDocument::read_only).
struct GrammarKey {
  std::string table, key;
  std::string value;    ///< what may be given
  std::string usual;    ///< where the key is absent; "required"
  std::string meaning;  ///< with its unit
  std::string needs;    ///< without which it has no effect: "[model] axes = 2"
  std::string name() const { return table + "." + key; }
  /// Meaning and needs.
  std::string in_full() const { return needs.empty() ? meaning : meaning + "; needs " + needs; }
};
const std::vector<GrammarKey>& grammar();
/// Whether some keys have "building", "building.period_s" or, within the value of a key,
/// "chart.shown.level".
bool has_key(const std::vector<GrammarKey>& keys, const std::string& name);

}  // namespace glissade
