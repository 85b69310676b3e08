// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/motion/motion.hpp"
#include "glissade/report/table.hpp"

namespace glissade::cli {

/// The motions of a suite as recorded, without its scales.
Table motions_table(const Suite& suite);

}  // namespace glissade::cli
