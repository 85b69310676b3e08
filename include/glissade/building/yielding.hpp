// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "glissade/core/units.hpp"

namespace glissade {

/// Yielding spring of a building: bilinear with kinematic hardening (theory.md, 2.3). The force is
/// elastic, k u, up to the yield force, and then has the stiffness hardening_ratio k; unloading is
/// elastic over twice the yield displacement (Chopra 2017, Dynamics of Structures, section 7.1).
struct Yielding {
  double yield_acceleration_mps2 = std::numeric_limits<double>::infinity();  ///< yield force over
                                                                             ///< the building's
                                                                             ///< mass; > 0
  double hardening_ratio = 0.0;                                              ///< [0, 1)

  bool yields() const { return yield_acceleration_mps2 < std::numeric_limits<double>::infinity(); }
};

/// Strength of a building as yield coefficient: C_y, yield force over weight M g.
struct YieldCoefficient {
  double force_over_weight = 0.0;  ///< > 0
  double gravity_mps2 = standard_gravity_mps2;
};

/// Strength of a building as elastic demand over R (Chopra 2017, eq 7.2.2).
struct ReducedDemand {
  double elastic_mps2 = 0.0;  ///< spectral (pseudo-)acceleration at the building's period, > 0
  double reduction = 1.0;     ///< R >= 1
};

/// Yield acceleration C_y g.
Yielding yielding_for(const YieldCoefficient& strength, double hardening_ratio = 0.0);
/// Yield acceleration S_a / R.
Yielding yielding_for(const ReducedDemand& strength, double hardening_ratio = 0.0);

}  // namespace glissade
