// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace glissade {

/// A key of a project file. The example file, the page of keys and the hints for missing keys are
/// made of these rows.
struct ProjectKey {
  const char* table;
  const char* key;
  const char* example;  ///< as written in a file
  enum class Use { required, usual, alternative } use;
  const char* meaning;
};
std::span<const ProjectKey> project_keys();
/// "period_s = [0.7, 1.0]": the line of a key.
const char* project_example_of(const char* table, const char* key);

}  // namespace glissade
