// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <span>

#include "glissade/block/on_building.hpp"
#include "glissade/block/peak_slip.hpp"
#include "glissade/block/slide.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/motion/motion.hpp"

namespace glissade {

// Where a block meets a building: the rules of theory.md, "The end of the record", for both.

/// What decides how far the roof under some blocks must be followed.
struct LeastAccelerations {
  double yield_mps2 = std::numeric_limits<double>::infinity();
  double deceleration_mps2 = std::numeric_limits<double>::infinity();  ///< on a roof at rest

  /// One that friction cannot stop counts for nothing: its history ends with the record.
  void include(const Block& block);
};
RoofMotionOptions follow_roof(const LeastAccelerations& least, double largest_factor);

/// How far the roof must be followed for these blocks at any factor on the motion up to
/// `largest_factor`: until none that rests can start, and none that slides is still on its way.
/// Blocks that friction cannot stop (tan(slope) >= mu) end with the record and need none.
RoofMotionOptions follow_roof(std::span<const Block> blocks, double largest_factor);

/// The roof motion that acts on a block: all of it, or for a free slider the part up to the
/// record's last sample, where its displacement is reported.
RoofAcceleration excitation_of(const Block& block, const RoofMotion& roof,
                               const MotionFactors& factors);

/// What moves a building under a motion: both horizontals, and the vertical through its own
/// oscillator (period 0: unchanged), in steps short enough for that.
BuildingGround building_ground(const Motion& motion, const Oscillator& vertical,
                               const RoofMotionOptions& follow);

}  // namespace glissade
