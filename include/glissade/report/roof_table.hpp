// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/report/table.hpp"

namespace glissade {

/// The same table in words of a roof's motions: PGA is the peak roof acceleration.
Table in_words_of_roof(Table table);

}  // namespace glissade
