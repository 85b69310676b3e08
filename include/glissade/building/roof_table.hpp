// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "glissade/building/motion_table.hpp"

namespace glissade {

/// The tables of a roof's motion: along the slope's plan direction and, where there is one, up.
/// Each goes at least as far as the longer of them is followed.
struct RoofTable {
  std::shared_ptr<const MotionTable> horizontal;
  std::shared_ptr<const MotionTable> vertical;  ///< null: none

  RoofTable() = default;
  /// Of one step; a shorter one is to be extended first.
  RoofTable(std::shared_ptr<const MotionTable> horizontal,
            std::shared_ptr<const MotionTable> vertical);
  /// A rigid roof under a record (see GroundMotion).
  RoofTable(double dt_s, std::span<const double> horizontal_mps2,
            std::span<const double> vertical_mps2 = {});

  double step_s() const { return horizontal->step_s(); }
};

/// The roof of one building under a record, by itself (a study tabulates many periods at once). The
/// step is cut where the periods ask for it.
RoofTable tabulate_roof(const GroundMotion& ground, const Building& building,
                        const RoofMotionOptions& follow);

}  // namespace glissade
