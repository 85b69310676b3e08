// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/peak_slip.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/building/roof_table.hpp"

namespace glissade {

/// The base of a rigid body that could tip instead of sliding.
struct RigidBase {
  double centre_of_mass_height_m = 0.0;  ///< above the roof, > 0; midway between the edges
  double width_m = 0.0;                  ///< of the base along the slope, > 0
};

}  // namespace glissade
