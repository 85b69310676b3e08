// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "glissade/building/roof_motion.hpp"

namespace glissade::building_detail {

/// How long a building must be followed once the ground is quiet, in steps.
/// @param x, y its scaled state then (core/oscillator.hpp)
/// @param velocity_range_mps largest less smallest velocity of the roof until then, from rest: a
/// block on its way is no faster
std::size_t ring_down_steps(const Oscillator& oscillator, double step_s, double x, double y,
                            double velocity_range_mps, double quiet_mps2,
                            const RoofMotionOptions& options);

}  // namespace glissade::building_detail
