// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "glissade/block/coupled.hpp"

namespace glissade {

/// One history of a batch.
struct CoupledScene {
  CoupledBuilding building;
  Block block;
  MotionFactors factors;
};

/// CoupledResult without what only a walk through every sample can tell.
struct CoupledPeak {
  PeakSlip slip;
  double peak_base_shear = 0.0;               ///< see CoupledResult
  double peak_roof_displacement_m = 0.0;      ///< see CoupledResult
  double ductility = 0.0;                     ///< see CoupledResult
  double residual_roof_displacement_m = 0.0;  ///< see CoupledResult
};

/// slide_coupled() for many histories under one ground motion: sixteen at a time go side by side
/// through its samples in SIMD lanes, each by the exact step of the oscillator it is at the time.
/// An interval in which a lane may have an event, or a new peak between samples, is left to the
/// scalar scheme; what tells is a bound on how far the motion can leave its chord, so nothing is
/// missed. Within 1e-11 of slide_coupled (tests/unit/block/coupled_slip_test.cpp). The same bits
/// on every SIMD target, and whatever else is in the batch.
///
/// Rigid buildings, SlipDirections::downslope_only, static friction, blocks at critical friction or
/// with mu tan(slope) >= 1, and verticals that may take the gravity away go through
/// slide_coupled(). So do buildings that yield, after the lanes have told which do.
/// @param peaks as many as scenes
void coupled_slip(const GroundMotion& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks);

/// The same, and when the displacement first has each of these sizes, as of slide_coupled(): only
/// the phase of sliding in which that is the case is gone through again, scalar.
/// @param thresholds_m > 0, increasing
/// @param crossings as many for each scene, scene after scene
void coupled_slip(const GroundMotion& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m,
                  std::span<Crossing> crossings);

}  // namespace glissade
