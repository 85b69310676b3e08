// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/building/roof_motion.hpp"

// What modes may be, and the roof that several of them move.
namespace glissade {

/// What a mode may have at most: |participation| and damping ratio.
inline constexpr double most_participation = 100.0, most_mode_damping = 0.999;

/// alpha of cantilever_modes() by structural system, for messages (Miranda & Taghavi 2005,
/// recalled: verify).
inline constexpr auto usual_alpha =
    "0 to 2 walls, 1.5 to 6 walls with frames and braced frames, 5 to 20 moment frames (recalled)";

/// Of its modes; 0: rigid.
double shortest_period_s(const Modes& building);

/// Why a record cannot represent a mode, one whose period is below two of its steps; "" of others.
std::string unresolved_mode(double period_s, double step_s);

/// Roof motion of a building of several modes, as of one of one mass (roof_motion.hpp).
RoofMotion roof_motion(const GroundMotion& ground, const Modes& horizontal,
                       const Oscillator& vertical, const RoofMotionOptions& options);

}  // namespace glissade
