// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace glissade {

/// A building's spring that yields: bilinear with kinematic hardening. Its force is elastic, k u,
/// up to the yield force, and from there has the stiffness hardening_ratio k; unloading is elastic
/// over twice the yield displacement (Chopra 2017, Dynamics of Structures, section 7.1).
struct Yielding {
  double yield_acceleration_mps2 = std::numeric_limits<double>::infinity();  ///< yield force over
                                                                             ///< the building's
                                                                             ///< mass; > 0
  double hardening_ratio = 0.0;                                              ///< [0, 1)

  bool yields() const { return yield_acceleration_mps2 < std::numeric_limits<double>::infinity(); }
};

}  // namespace glissade
