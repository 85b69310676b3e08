// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/study/clearance_reading.hpp"

namespace glissade {

/// What came out where the paper states something: the reading of its topic and, where it states a
/// displacement, where that lies among ours.
std::string answer_to(const ClearanceResults& results, const PaperStatement& statement);

}  // namespace glissade
