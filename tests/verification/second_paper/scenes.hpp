// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "unit/block/reference.hpp"
#include "verification/case.hpp"

namespace glissade::verification {

using test::CoupledScene;
using test::uniform;

/// A made-up horizontal motion with its vertical, 1,000 samples of 0.01 s.
struct MadeUpGround {
  std::vector<double> a = test::made_up_record(1000, 1, 7.0),
                      w = test::made_up_record(1000, 2, 3.0);
  GroundMotion motion() const { return {0.01, a, w}; }
};

/// Linear buildings from a few samples a period to a third of the record, m/M up to 0.5, slopes to
/// either side of which the block does not slide, motions from weak to strong.
inline std::vector<CoupledScene> coupled_scenes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<CoupledScene> scenes(count);
  for (CoupledScene& s : scenes) {
    s.building = {
        {std::exp(uniform(random, std::log(0.04), std::log(3.0))), uniform(random, 0.005, 0.15)},
        uniform(random, 0.0, 0.5),
        {}};
    s.block.friction = uniform(random, 0.05, 0.5);
    s.block.slope_rad = uniform(random, -0.95, 0.95) * std::atan(s.block.friction.along);
    const double factor = std::exp(uniform(random, std::log(0.2), std::log(3.0)));
    s.factors = {factor, 0.8 * factor};
  }
  return scenes;
}

/// The same with springs that yield at 1/1.2 to 1/6 of what they would need to stay elastic.
inline std::vector<CoupledScene> yielding_scenes(std::size_t count, unsigned seed) {
  const MadeUpGround ground;
  std::mt19937 random(seed);
  std::vector<CoupledScene> scenes = coupled_scenes(count, seed + 1);
  for (CoupledScene& s : scenes) {
    s.building.horizontal.period_s = uniform(random, 0.1, 2.0);
    const double omega = 2.0 * std::numbers::pi / s.building.horizontal.period_s;
    const double demand_mps2 =
        omega * omega *
        slide_coupled(ground.motion(), s.factors, s.building, s.block).peak_roof_displacement_m;
    s.building.yielding = {demand_mps2 / uniform(random, 1.2, 6.0), uniform(random, 0.0, 0.2)};
  }
  return scenes;
}

/// Of two results with the displacements of a SlipResult: the largest difference in one of them,
/// relative to the slip and 0.1 mm.
template <class Found, class Expected>
double slip_difference(const Found& found, const Expected& expected) {
  const double size = expected.peak_displacement_m + 1e-4;
  double worst = 0.0;
  for (const double d : {found.peak_displacement_m - expected.peak_displacement_m,
                         found.peak_downslope_m - expected.peak_downslope_m,
                         found.peak_upslope_m - expected.peak_upslope_m,
                         found.residual.along_m - expected.residual.along_m})
    worst = worse(worst, std::abs(d) / size);
  return worst;
}

inline double relative(double found, double expected) { return std::abs(found / expected - 1.0); }

/// What is missing in input + gravity = kinetic + strain + damped + friction + hysteretic, relative
/// to the largest of them.
inline double energy_gap(const CoupledEnergy& e) {
  const double spent =
      e.kinetic_m2ps2 + e.strain_m2ps2 + e.damped_m2ps2 + e.friction_m2ps2 + e.hysteretic_m2ps2;
  double largest = 1e-12;
  for (const double part : {e.input_m2ps2, e.gravity_m2ps2, e.damped_m2ps2, e.friction_m2ps2,
                            e.hysteretic_m2ps2, e.kinetic_m2ps2, e.strain_m2ps2})
    largest = worse(largest, std::abs(part));
  return std::abs(e.input_m2ps2 + e.gravity_m2ps2 - spent) / largest;
}

}  // namespace glissade::verification
