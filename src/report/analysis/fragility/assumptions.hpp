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

/// What the study takes for granted, told from what its samples and records show.
std::vector<Assumption> assumptions_of(const Results& results);

}  // namespace glissade
