// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "glissade/building/roof_motion.hpp"

namespace glissade::building_detail {

/// Of a sampled roof motion: 1 GB a component.
constexpr std::size_t most_steps = std::size_t{1} << 27;
/// Of a tabulated motion: 3 GB with its ground; readers allow records of 2e7 samples.
constexpr std::size_t most_nodes = std::size_t{1} << 25;

/// @throw InputError if a motion has more than `most` steps
void require_steps(double steps, double step_s, std::size_t most);

/// Length of the ring-down after the ground has come to rest, in time steps.
/// @param x, y its scaled state then (core/oscillator.hpp)
/// @param velocity_range_mps largest minus smallest velocity of the roof until then, from rest: an
/// upper bound of the velocity of a sliding block
/// @throw InputError if they are more than most_steps
std::size_t ring_down_steps(const Oscillator& oscillator, double step_s, double x, double y,
                            double velocity_range_mps, double quiet_mps2,
                            const RoofMotionOptions& options);

}  // namespace glissade::building_detail
