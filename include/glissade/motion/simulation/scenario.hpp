// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glissade {

enum class FaultMechanism { strike_slip, reverse };

/// Earthquake and site of a simulated motion. The distance is R_rup in the simulation and R_JB in
/// BSSA14: a vertical fault that reaches the surface.
struct Scenario {
  double magnitude = 0.0;    ///< moment magnitude
  double distance_km = 0.0;  ///< > 0
  double vs30_mps = 0.0;     ///< > 0
  FaultMechanism mechanism = FaultMechanism::strike_slip;
};

}  // namespace glissade
