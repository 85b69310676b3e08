// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

/// Peak acceleration of a floor at `height` (z/h, 0 to 1) for components, in g, without
/// amplification of the component: 0.4 S_DS (1 + 2 z/h), ASCE 7-16, 13.3.1 with a_p = R_p = I_p = 1
/// (recalled: verify against the standard).
double asce7_16_floor_acceleration_g(double sds_g, double height = 1.0);

/// The same by ASCE 7-22, 13.3.1: 0.4 S_DS H_f with H_f = 1 + a_1 z/h + a_2 (z/h)^10, a_1 = 1/T_a
/// at most 2.5, a_2 = 1 - (0.4/T_a)^2 at least 0 (recalled: verify against the standard).
/// @param period_s T_a, > 0
double asce7_22_floor_acceleration_g(double sds_g, double period_s, double height = 1.0);

}  // namespace glissade
