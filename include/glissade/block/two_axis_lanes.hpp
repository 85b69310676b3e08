// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "glissade/block/on_building.hpp"

namespace glissade {

/// One history of a batch.
struct TwoAxisScene {
  BiaxialBuilding building;
  Block block;
  MotionFactors factors;
  bool base_shear = false;  ///< wanted; the other results have the same bits without it
};

/// The result of one.
struct BuildingPeak : SlipPeak {
  std::array<double, 2> base_shear{};  ///< BuildingSlip::peak_base_shear, where it is wanted
  bool failed = false;                 ///< slide_on_building() did not converge: the rest is zero
};

/// slide_on_building() for many histories under one ground motion, side by side in SIMD lanes: a
/// history that slides is in a lane, each lane at its own time. A step is the Taylor series of the
/// block's velocity, of order 6, over the rest of a sample interval or as much of it as the
/// tolerance allows; the building's modes are series beside it. A roof of several modes, with m/M =
/// 0, is tabulated as one polynomial an interval, so that their number does not matter. Where the
/// block is at rest the next interval in which it may slide is looked for over bounds on the roof's
/// motion, which is tabulated for each building. How a block starts is a series of its own, how it
/// stops is known in closed form (two_axis.hpp); between the two, steps too stiff for the lanes are
/// SDIRK4. Errors at the default tolerance, measured as those of slide_on_building(): 2.2e-7 of the
/// peak in the median, 4.6e-6 at most without uplift, below 1e-4 with it (two_axis_lanes_test,
/// model_test).
///
/// The same bits on every SIMD target, in any order and whatever else is in the batch; but scenes
/// on one building share its table, so give the levels and blocks of a building together.
///
/// Where the normal force falls below 6 % of the weight, and while the block is lifted off, steps
/// are SDIRK4 too; one ends where it lifts off or lands.
///
/// A spring that yields or unloads ends a step, in which its force is a series too; at rest the
/// elastic building is that of the table plus a free vibration. Static friction above sliding
/// friction takes part where the block rests; the factor of friction that depends on speed is one
/// more series (errors of up to 1.2e-5 where it rises within 1 mm/s). Base shear of one mass is a
/// readout: while the block slides of the building's series in each step, at rest of its table
/// where bounds allow more than what was seen.
///
/// Friction that depends on speed at a rate above 1000 s/m, friction (the least at any speed) below
/// 1.02 tan(slope), one rigid axis beside one that is not, damping outside [0.001, 0.5], periods
/// below 7.4 sample intervals (2.4 of a mode), base shear of modes or of a rigid building that
/// carries the block, several modes with m/M = 0 that may move the block once they have decayed to
/// a twentieth after the record, an array that lifts off a building that yields, modes so close
/// that (3.14) of theory.md does not tell them apart, and an oscillating vertical go through
/// slide_on_building().
class TwoAxisLanes {
 public:
  /// @param ground the tables of the last buildings under it are kept, 32 MB or two of them
  /// @param tolerance as slide_on_building()'s, in [1e-9, 1e-2]
  explicit TwoAxisLanes(const BuildingGround& ground, double tolerance = 1e-6);
  ~TwoAxisLanes();
  const BuildingGround& ground() const;

  /// @param peaks as many as scenes
  /// @param crossings for each scene as many as thresholds
  void slide(std::span<const TwoAxisScene> scenes, std::span<BuildingPeak> peaks,
             std::span<const double> thresholds_m = {}, std::span<Crossing> crossings = {});

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All of a motion's at once.
void peak_slip_two_axes(const BuildingGround& ground, std::span<const TwoAxisScene> scenes,
                        std::span<BuildingPeak> peaks, double tolerance = 1e-6);

}  // namespace glissade
