// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <functional>
#include <string>

#include "glissade/core/error.hpp"

// Results that are read from files may be of any study: what a project looks for in them is checked
// in every build.
namespace glissade {

/// Throws InputError unless it holds.
inline void expect_of_project(bool holds, const std::string& part) {
  if (holds) return;
  throw InputError({"the results of the project's studies", "do not hold " + part,
                    "they are of another project or were changed: begin again with --overwrite",
                    ""});
}

/// The first of `list` with this value; throws where there is none.
template <class List, class Value, class Projection = std::identity>
const auto& found_in(const List& list, const Value& value, const std::string& part,
                     Projection projection = {}) {
  const auto found = std::ranges::find(list, value, projection);
  expect_of_project(found != list.end(), part);
  return *found;
}

}  // namespace glissade
