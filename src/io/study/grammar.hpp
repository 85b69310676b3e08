// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "../toml_table.hpp"

namespace glissade {

/// A key of a study file. The rows of grammar() are all keys there are: the error messages,
/// `glissade explain` and studies/GRAMMAR.md are made from them, and a test holds the reader to
/// them.
struct GrammarKey {
  std::string table, key;
  std::string value;    ///< what may be given
  std::string usual;    ///< where the key is absent; "required"
  std::string meaning;  ///< with its unit
  std::string name() const { return table + "." + key; }
};
std::vector<GrammarKey> grammar();

/// Keys of earlier grammars, and what to write now.
std::vector<RenamedKey> renamed_keys();

}  // namespace glissade
