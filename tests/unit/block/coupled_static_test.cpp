// SPDX-License-Identifier: GPL-3.0-or-later
// Static friction above that of sliding, on a building coupled with the block.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "unit/block/coupled_reference.hpp"

namespace glissade {
namespace coupled_static_test {

using test::CoupledReference;
using test::CoupledScene;
using test::made_up_record;
using test::uniform;

constexpr double g = standard_gravity_mps2;
const auto a = made_up_record(150, 1, 8.0), w = made_up_record(150, 2, 3.0);
const GroundMotion ground{0.02, a, w};

CoupledScene made_up_scene(std::mt19937& random) {
  CoupledScene s{{{uniform(random, 0.1, 1.5), uniform(random, 0.01, 0.1)},
                  uniform(random, 0.0, 0.5),
                  {uniform(random, 1.0, 20.0), 0.1}},
                 {.friction = uniform(random, 0.1, 0.35)},
                 {1.5, 1.0}};
  s.block.slope_rad = uniform(random, 0.0, 0.8) * std::atan(s.block.friction.along);
  s.block.law.static_over_sliding = uniform(random, 1.01, 1.5);
  return s;
}

// The ground's acceleration grows as c t: the level block starts where that is mu_static g, and
// then gains what is above mu g.
TEST(coupled_static_friction, holds_until_it_breaks_away) {
  std::vector<double> ramp(100);
  for (std::size_t i = 0; i < ramp.size(); ++i) ramp[i] = -0.05 * static_cast<double>(i);
  const double c = 5.0;
  const Block block{.friction = 0.2, .law = {.static_over_sliding = 1.3}};
  std::vector<CoupledPoint> history;
  slide_coupled({0.01, ramp}, {}, {{0.0, 0.05}, 0.2, {}}, block, history);
  const double start_s = 1.3 * 0.2 * g / c;
  int sliding = 0;
  for (const CoupledPoint& p : history) {
    if (p.time_s > 0.985) break;
    const double t = p.time_s, d = std::max(t - start_s, 0.0);
    const double speed = d == 0.0 ? 0.0 : 0.5 * c * (t * t - start_s * start_s) - 0.2 * g * d;
    const double slip = 0.3 * 0.2 * g * d * d / 2.0 + c * d * d * d / 6.0;
    EXPECT_NEAR(p.velocity_mps, speed, 1e-14);
    EXPECT_NEAR(p.displacement_m, slip, 1e-14);
    sliding += d > 0.0 ? 1 : 0;
  }
  EXPECT_GT(sliding, 40);
}

TEST(coupled_static_friction, agrees_with_50_digits) {
  std::mt19937 random(3);
  int phases = 0;
  for (int k = 0; k < 8; ++k) {
    const CoupledScene s = made_up_scene(random);
    SCOPED_TRACE("scene " + std::to_string(k));
    std::vector<CoupledPoint> history;
    const CoupledResult r = slide_coupled(ground, s.factors, s.building, s.block, history);
    const double rings_s = std::max(history.back().time_s - 150 * 0.02, 0.0) + 0.01;
    const CoupledReference truth(ground, s.factors, s.building, s.block, rings_s, 12);
    const double close = 1e-11 * r.slip.peak_displacement_m;
    EXPECT_NEAR(r.slip.peak_downslope_m, static_cast<double>(truth.down), close);
    EXPECT_NEAR(r.slip.peak_upslope_m, static_cast<double>(truth.up), close);
    EXPECT_NEAR(r.slip.residual.along_m, static_cast<double>(truth.slip), close);
    EXPECT_EQ(r.slip.slip_phases, static_cast<std::size_t>(truth.phases));
    phases += truth.phases;
  }
  EXPECT_GT(phases, 30);
}

TEST(coupled_static_friction, keeps_the_balance_of_energy) {
  std::mt19937 random(5);
  for (int k = 0; k < 300; ++k) {
    const CoupledScene s = made_up_scene(random);
    const CoupledResult r = slide_coupled(ground, s.factors, s.building, s.block);
    const CoupledEnergy& e = r.energy;
    EXPECT_NEAR(
        e.input_m2ps2 + e.gravity_m2ps2,
        e.kinetic_m2ps2 + e.strain_m2ps2 + e.damped_m2ps2 + e.friction_m2ps2 + e.hysteretic_m2ps2,
        1e-10 * std::max(std::abs(e.input_m2ps2), e.damped_m2ps2));
  }
}

TEST(coupled_static_friction, enough_of_it_holds_the_block_and_too_steep_a_roof_lets_it_go) {
  const CoupledBuilding building{{0.4, 0.05}, 0.2, {}};
  Block block{.friction = 0.2, .slope_rad = std::atan(0.25), .law = {.static_over_sliding = 50.0}};
  EXPECT_EQ(slide_coupled(ground, {}, building, block).slip.peak_displacement_m, 0.0);
  EXPECT_FALSE(slide_coupled(ground, {}, building, block).slip.free_sliding);
  block.law.static_over_sliding = 1.5;
  const SlipResult loose = slide_coupled(ground, {}, building, block).slip;
  EXPECT_GT(loose.peak_downslope_m, 0.1);
  EXPECT_TRUE(loose.free_sliding);
}

}  // namespace coupled_static_test
}  // namespace glissade
