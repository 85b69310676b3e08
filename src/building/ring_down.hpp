// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "glissade/building/motion_table.hpp"

namespace glissade::building_detail {

/// Of a roof motion: 270 MB a component that is sampled, 3 GB tabulated with its ground. Readers
/// allow records of 2e7 samples.
constexpr std::size_t most_steps = std::size_t{1} << 25;

/// @throw InputError if a motion has more than most_steps
void require_steps(double steps, double step_s);

/// Length of the ring-down after the ground has come to rest, in time steps. Of several modes: by
/// the sum of their bounds.
/// @param states of each mode then
/// @param velocity_range_mps largest minus smallest velocity of the roof until then, from rest: an
/// upper bound of the velocity of a sliding block
/// @throw InputError if they are more than most_steps
std::size_t ring_down_steps(const Modes& building, double step_s,
                            std::span<const OscillatorState> states, double velocity_range_mps,
                            double quiet_mps2, const RoofMotionOptions& options);

}  // namespace glissade::building_detail
