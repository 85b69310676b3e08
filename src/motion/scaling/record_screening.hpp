// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/motion/record_selection.hpp"

namespace glissade {

struct Screening {
  std::vector<std::size_t> candidates;  ///< indices in the library, by id
  std::vector<LeftOutRecord> left_out;
};

/// The records of the library that meet the criteria. InputError if the criteria contradict each
/// other or leave fewer records than required.
Screening screen(const Suite& library, const SelectionCriteria& criteria);

}  // namespace glissade
