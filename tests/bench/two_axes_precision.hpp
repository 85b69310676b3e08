// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "trial.hpp"

namespace glissade::bench {

/// Schemes for both horizontal directions at once, the floor first, over the standard motions with
/// two components; the PGA is the larger one's. PGA and friction of the standard scenes; slopes 0,
/// 1.19, 4 and 7 degrees toward azimuths 0, 90, 215 degrees, without the free sliders; without and
/// with the vertical. On a rigid roof; on buildings of 0.2, 0.5 and 1 s (5 %; the second axis 0.8
/// times that) with m/M 0 and 0.05; and those with friction across the slope 0.8 times that along
/// it. Truth is slide_on_building() at tolerance 1e-9.
/// @param histories about so many of each kind, sixteen to a motion
std::vector<SchemeResult> two_axes_precision(const test::StandardScenes& all, std::size_t histories,
                                             bool quick);

}  // namespace glissade::bench
