// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/slide.hpp"
#include "glissade/motion/motion.hpp"

namespace glissade::verification {

/// What stands in for the paper's one motion: a motion's first horizontal component, scaled to a
/// peak plane acceleration (PPA) of 1.0 g. Refers to the motion's samples.
RoofAcceleration at_one_g(const Motion& motion);

}  // namespace glissade::verification
