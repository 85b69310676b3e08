// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "glissade/building/roof_motion.hpp"

namespace glissade::building_detail {

/// Length of the ring-down after the ground has come to rest, in time steps.
/// @param x, y its scaled state then (core/oscillator.hpp)
/// @param velocity_range_mps largest minus smallest velocity of the roof until then, from rest: an
/// upper bound of the velocity of a sliding block
std::size_t ring_down_steps(const Oscillator& oscillator, double step_s, double x, double y,
                            double velocity_range_mps, double quiet_mps2,
                            const RoofMotionOptions& options);

}  // namespace glissade::building_detail
