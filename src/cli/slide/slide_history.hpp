// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "glissade/block/crossing.hpp"
#include "glissade/block/on_building.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/motion/motion.hpp"
#include "slide/slide_options.hpp"

namespace glissade::cli {

/// What one history did, whichever kernel computed it.
struct SlideHistory {
  SlipResult slip;
  std::optional<double> ppa_g;  ///< where the roof's motion does not depend on the block
  std::vector<double> peak_base_shear, peak_roof_displacement_m;  ///< by axis of a coupled or
                                                                  ///< yielding building
  std::optional<Crossing> crossing;                               ///< of --clearance-m
  std::optional<double> tips_at;  ///< the scale at which the body begins to tip; infinity: never
};

/// What computes it: "one axis, coupled with the building: exact events (slide_coupled)".
std::string model_of(const SlideOptions& options);

/// By the cheapest kernel that is exact for it; writes --history.
/// @param factor on all components
SlideHistory run_history(const SlideOptions& options, const Motion& motion, double factor);

}  // namespace glissade::cli
