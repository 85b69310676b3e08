// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/study/run/execute.hpp"

namespace glissade {

// Messages between the ranks of one run.
std::vector<char> pack(const std::vector<Suite>& suites);
std::vector<Suite> unpack_suites(const std::vector<char>& bytes);
std::vector<char> pack(const std::vector<UnitResult>& results);
std::vector<UnitResult> unpack_unit_results(const std::vector<char>& bytes);

}  // namespace glissade
