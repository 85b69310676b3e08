// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "glissade/building/motion_table.hpp"

namespace glissade {

/// The tables of a roof motion: in plan along the slope and, if given, vertical. Both extend at
/// least to the end of the longer ring-down.
struct RoofTable {
  std::shared_ptr<const MotionTable> horizontal;
  std::shared_ptr<const MotionTable> vertical;  ///< null: none

  RoofTable() = default;
  /// Both of one time step; extend the shorter one first.
  RoofTable(std::shared_ptr<const MotionTable> horizontal,
            std::shared_ptr<const MotionTable> vertical);
  /// A rigid roof under a record (see GroundMotion).
  RoofTable(double dt_s, std::span<const double> horizontal_mps2,
            std::span<const double> vertical_mps2 = {});

  double step_s() const { return horizontal->step_s(); }
};

/// The roof motion of one building under a record (a study tabulates many periods at once). The
/// time step is divided for short periods.
RoofTable tabulate_roof(const GroundMotion& ground, const Building& building,
                        const RoofMotionOptions& follow);

}  // namespace glissade
