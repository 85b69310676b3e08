// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "trial.hpp"

namespace glissade::bench {

/// Schemes for an array coupled with its building, the floor first, over standard motions: m/M
/// 0.05, 0.1 and 0.3; T 0.2, 0.5 and 1 s (5 %); PGA, friction and slopes of the standard scenes
/// without the free sliders. Then the exact ones with the vertical, and on buildings that yield at
/// C_y 0.2 (hardening 5 %). Truth is slide_coupled().
/// @param histories about so many of each, sixteen to a motion
std::vector<SchemeResult> coupled_precision(const test::StandardScenes& all, std::size_t histories,
                                            bool quick);

}  // namespace glissade::bench
