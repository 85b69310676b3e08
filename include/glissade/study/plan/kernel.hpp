// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/study/config.hpp"

namespace glissade {

/// What computes the histories of a study.
enum class Kernel {
  tables,   ///< peak_slip(): the roof's motion does not depend on the block, one axis
  coupled,  ///< coupled_slip(): array coupled with a linear building, one axis
  events,   ///< slide_coupled(): the building yields, or friction is stronger at rest, one axis
  full      ///< slide_on_building(): two axes, any friction law, and all that the others have
};

/// A kernel and why a study needs no cheaper one.
struct KernelChoice {
  Kernel kernel = Kernel::tables;
  std::string reason;  ///< "building.mass_ratio is above 0"
};

/// The cheapest kernel whose equations are exactly those of the study's model. All that it leaves
/// out is absent from the study, so a dearer one would give the same slip.
KernelChoice cheapest_exact_kernel(const StudyConfig& config);

/// What the kernel is: "one axis, coupled: ..."
std::string describe(Kernel kernel, bool base_shear);

}  // namespace glissade
