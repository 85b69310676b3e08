// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "unit/block/coupled_reference.hpp"

namespace glissade::test {

/// A history of slide_coupled() and the same in 50 digits.
struct CoupledPair {
  CoupledResult found;
  CoupledReference truth;
};

inline double error(double found, const Real& truth, double scale) {
  return std::abs(static_cast<double>(found - truth)) / (scale > 0.0 ? scale : 1.0);
}

/// The reference sees its peaks at sixty looks a period: within (2 pi / 60)^2 / 8.
inline void expect_peak(double found, const Real& looked) {
  EXPECT_GE(found, static_cast<double>(looked) * (1.0 - 1e-12));
  EXPECT_LE(found, static_cast<double>(looked) * (1.0 + 2e-3));
}

/// Expects what every building has: slip, the roof at the end, phases, peaks.
inline CoupledPair expect_near_truth(const GroundMotion& ground, const MotionFactors& factors,
                                     const CoupledBuilding& building, const Block& block) {
  std::vector<CoupledPoint> history;
  const CoupledResult r = slide_coupled(ground, factors, building, block, history);
  const double rings_s =
      history.back().time_s - static_cast<double>(ground.horizontal_mps2.size()) * ground.dt_s;
  const int looks =
      std::max(8, static_cast<int>(std::ceil(60.0 * ground.dt_s / building.horizontal.period_s)));
  const CoupledReference truth(ground, factors, building, block,
                               std::max(rings_s, 0.0) + 0.5 * ground.dt_s, looks);
  const double slip = r.slip.peak_displacement_m;
  for (const double e :
       {error(r.slip.peak_downslope_m, truth.down, slip),
        error(r.slip.peak_upslope_m, truth.up, slip),
        error(r.slip.residual.along_m, truth.slip, slip),
        error(r.slip.slip_duration_s, truth.duration, r.slip.slip_duration_s),
        error(history.back().roof_displacement_m, truth.u, r.peak_roof_displacement_m)})
    EXPECT_LT(e, 1e-11);
  EXPECT_EQ(r.slip.slip_phases, static_cast<std::size_t>(truth.phases));
  EXPECT_EQ(r.slip.uplift, truth.uplift);
  expect_peak(r.peak_base_shear, truth.base_shear);
  expect_peak(r.peak_roof_displacement_m, truth.roof_displacement);
  return {r, truth};
}

/// Expects what went in to be stored, damped, rubbed away or taken by yielding.
/// @return the largest of these
inline double expect_balance(const CoupledEnergy& e) {
  const double largest = std::max(
      {std::abs(e.input_m2ps2), e.damped_m2ps2, e.friction_m2ps2, e.hysteretic_m2ps2, 1e-300});
  const double left =
      e.input_m2ps2 + e.gravity_m2ps2 -
      (e.kinetic_m2ps2 + e.strain_m2ps2 + e.damped_m2ps2 + e.friction_m2ps2 + e.hysteretic_m2ps2);
  EXPECT_LT(std::abs(left) / largest, 1e-10);
  EXPECT_GE(e.friction_m2ps2, 0.0);
  EXPECT_GE(e.hysteretic_m2ps2, 0.0);
  return largest;
}

}  // namespace glissade::test
