// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "glissade/block/on_building.hpp"
#include "glissade/building/building_model.hpp"
#include "glissade/motion/design_spectrum.hpp"
#include "glissade/study/cases/case.hpp"

namespace glissade {

// From a case to what the kernels take: here and nowhere else.

/// The building's strength along an axis of this period; none where the case stays elastic.
/// @param target the design spectrum; not null where R is above 0
Yielding strength_of(const Case& c, double period_s, const DesignTarget* target);

/// The building along its two axes, without the array.
std::array<Modes, 2> building_axes(const Case& c, const BuildingModel& model);

Block block_of(const Case& c);
/// Of an array that has a neighbour.
Block neighbour_block(const Case& c);
BiaxialBuilding biaxial_building(const Case& c, const BuildingModel& model,
                                 const DesignTarget* target);

/// Of an array that does not slide: what friction nothing overcomes does on a flat roof that does
/// not move vertically.
Block anchored_block();

}  // namespace glissade
