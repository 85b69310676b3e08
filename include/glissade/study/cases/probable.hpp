// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "glissade/study/cases/case.hpp"

namespace glissade {

/// The values of a parameter that are probable, ends included; beyond them it is possible.
struct ProbableRange {
  const char *table, *key;
  double least, most;
  const char* reason;
};
std::span<const ProbableRange> probable_ranges();

/// What stands beside a result where a value is outside of its probable range: "vertical period 3 s
/// is above 1 s: ..."; "" of others, and of the usual value of a Case.
std::string improbable_value(const Parameter& parameter, double value);

}  // namespace glissade
