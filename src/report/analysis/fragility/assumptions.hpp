// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/study/results.hpp"

namespace glissade {

struct Assumption {
  std::string about;  ///< "End of the record"
  std::string text;
};

/// The assumptions of the study, as its samples and records show them.
std::vector<Assumption> assumptions_of(const Results& results);

}  // namespace glissade
