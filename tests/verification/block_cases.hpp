// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "case.hpp"
#include "glissade/motion/motion.hpp"

namespace glissade::verification {

/// The four of Rodriguez-Nikl et al. (2019), in their order and with their numbers.
std::vector<Case> physical_checks(const Suite& suite);

/// Laws that hold to the last bit: mirror, similitude, zeros appended; and to rounding: samples
/// inserted.
std::vector<Case> invariants(const Suite& suite);

}  // namespace glissade::verification
