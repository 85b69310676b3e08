// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/block/on_building.hpp"
#include "glissade/study/plan.hpp"

namespace glissade {

// From a sample of a plan to what the kernels take.

/// The building's own strength along an axis of this period; none where the study gives none.
Yielding strength_of(const Plan& plan, double period_s);

TwoAxisBlock two_axis_block(const Plan& plan, std::size_t run, std::size_t sample);
BiaxialBuilding biaxial_building(const Plan& plan, std::size_t sample);

}  // namespace glissade
