// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "case.hpp"
#include "glissade/motion/motion.hpp"

namespace glissade::verification {

/// Laws that hold to the last bit: mirror, similitude, zeros appended; and to rounding: samples
/// inserted.
std::vector<Case> invariants(const Suite& suite);

}  // namespace glissade::verification
