// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "block/events/coupled_motion.hpp"

namespace glissade::block_detail {

/// Motion of the block over a piece.
struct SlipSeries {
  int direction = 0;  ///< +1 down, -1 up
  Series speed;       ///< along the slope, in its direction
  double friction = 0.0;
};

/// The energy balance of building and block, written from forces and velocities and integrated by
/// Gauss's rule, which is exact to rounding on pieces this short.
class EnergyMeter {
 public:
  EnergyMeter(const BuildingOscillator& building, const CoupledContact& contact)
      : building_(building), contact_(contact) {}

  /// The part of a piece up to its fraction `end`.
  void add(const GroundPiece& ground, const RoofMotionSeries& roof, const SlipSeries& slip,
           double end);
  /// With the energy stored in the end state.
  CoupledEnergy total(const RoofState& state, const Spring& spring, double slip_velocity_mps) const;

 private:
  BuildingOscillator building_;
  CoupledContact contact_;
  CoupledEnergy sum_;
};

}  // namespace glissade::block_detail
