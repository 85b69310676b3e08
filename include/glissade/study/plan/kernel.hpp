// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "glissade/study/config.hpp"

namespace glissade {

/// What computes the histories of a study.
enum class Kernel {
  tables,   ///< peak_slip(): the roof's motion does not depend on the block, one axis
  coupled,  ///< one axis, coupled building and array: peak_slip_two_axes() with one axis moved
  full      ///< peak_slip_two_axes(), or slide_on_building() where it gives more: two axes, any
            ///< friction law, and all that the others have
};

/// A kernel and why a study needs no cheaper one.
struct KernelChoice {
  Kernel kernel = Kernel::tables;
  std::string reason;  ///< "building.mass_ratio is above 0"
};

/// The cheapest kernel whose equations are exactly those of the study's model. All that it leaves
/// out is absent from the study, so a dearer one would give the same slip.
KernelChoice cheapest_exact_kernel(const StudyConfig& config);

/// Microseconds of a history of 8,000 samples, from `bench`: what units of work are cut by.
double history_us(Kernel kernel, const StudyConfig& config);

/// What the kernel is, with the functions that compute the histories: "one axis, coupled: ..."
std::string describe(Kernel kernel, const StudyConfig& config);

}  // namespace glissade
