// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/motion/record_selection.hpp"

namespace glissade {

struct Screening {
  std::vector<std::size_t> candidates;  ///< places in the library, by id
  std::vector<LeftOutRecord> left_out;
};

/// Which records of the library keep the criteria. InputError where the criteria contradict
/// themselves or leave fewer than they ask for.
Screening screen(const Suite& library, const SelectionCriteria& criteria);

}  // namespace glissade
