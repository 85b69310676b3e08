// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>

#include "glissade/block/coupled.hpp"

namespace glissade {

/// One history of a batch.
struct CoupledScene {
  CoupledBuilding building;
  Block block;
  MotionFactors factors;
};

struct CoupledPeak {
  PeakSlip slip;
  bool by_events = false;  ///< found by slide_coupled()
};

/// A ground motion and what histories under it share: its integrals, and the tables of the last
/// building, block and ratio of factors, so that the intensities of one building cost one table.
/// Not for two threads at once; a copy shares the integrals, and has no tables yet.
class CoupledGround {
 public:
  /// @param motion whose samples outlive this
  explicit CoupledGround(const GroundMotion& motion);
  ~CoupledGround();
  CoupledGround(const CoupledGround& other);
  CoupledGround& operator=(const CoupledGround&) = delete;

  struct Tables;
  Tables& tables() { return *tables_; }
  const GroundMotion& motion() const { return motion_; }

 private:
  GroundMotion motion_;
  std::unique_ptr<Tables> tables_;
};

/// slide_coupled() for many histories under one ground motion. While its regime of contact lasts,
/// the building is linear: intensity times its response to the motion from rest, which is tabulated
/// once, plus the free vibration that the last event left, in closed form; a spring that yields has
/// a second table, of its stiffness while it yields. So a history goes from
/// event to event; the tables are searched for the next interval in which one is possible, by
/// bounds that miss none. Within 1e-10 of slide_coupled for slips above 1 um
/// (tests/unit/block/coupled_slip_test.cpp). The same bits on every SIMD target, in any company.
///
/// The first crossing of each threshold is as of slide_coupled(): only the phase of sliding in
/// which it is reached is computed again, scalar.
///
/// Left to slide_coupled(): rigid buildings, more than 1 rad or less than 1 mrad of their
/// vibration in a sample interval, damping near or beyond critical;
/// SlipDirections::downslope_only; friction that depends on speed, or static friction where the
/// block slides freely; critical friction; mu tan(slope) >= 1; and where the block lifts off.
/// @param peaks as many as scenes; those of one building, block and ratio of factors best side by
/// side
/// @param thresholds_m > 0, increasing
/// @param crossings as many for each scene, scene after scene
void coupled_slip(CoupledGround& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m = {},
                  std::span<Crossing> crossings = {});
void coupled_slip(const GroundMotion& ground, std::span<const CoupledScene> scenes,
                  std::span<CoupledPeak> peaks, std::span<const double> thresholds_m = {},
                  std::span<Crossing> crossings = {});

}  // namespace glissade
