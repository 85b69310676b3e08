// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>

namespace glissade {

/// What stands first where lengths are written for people; files of numbers are in metres.
enum class UnitSystem { si, us_customary };

// Inside glissade every quantity is SI and every angle is in radians. These constants convert input
// and output only; g is one number for the whole program.
inline constexpr double standard_gravity_mps2 = 9.80665;  ///< exact by definition (CGPM 1901)
inline constexpr double inch_m = 0.0254;
inline constexpr double foot_m = 0.3048;
inline constexpr double pound_force_n = 0.45359237 * standard_gravity_mps2;  ///< exact
inline constexpr double rad_per_deg = std::numbers::pi / 180.0;

}  // namespace glissade
