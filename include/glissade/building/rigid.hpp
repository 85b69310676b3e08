// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/building/motion_table.hpp"
#include "glissade/building/yielding.hpp"

namespace glissade {

/// The roof moves with the ground: a period of zero, or one below a sixteenth of the time step
/// (above critical damping of the time that its faster rate has), which the record cannot excite.
/// One rule for all models.
inline bool is_rigid(const Modes& building, double dt_s) {
  return parts_needed(building, dt_s) == 0;
}

/// @throw InputError if the building yields but is_rigid()
void require_no_rigid_spring(const Oscillator& oscillator, const Yielding& yielding, double dt_s);

}  // namespace glissade
