// SPDX-License-Identifier: GPL-3.0-or-later
// The building whose spring yields, with the block on it, against 50 digits and against what must
// hold.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "glissade/block/coupled.hpp"
#include "unit/block/coupled_truth.hpp"

namespace glissade {
namespace coupled_yielding_test {

using test::made_up_record;
using test::uniform;

/// With a yield level below the force of the elastic building, and blocks that slide below it.
struct Scene {
  double dt_s;
  std::vector<double> a, w;
  CoupledBuilding building;
  Block block;

  Scene(std::mt19937& random, unsigned seed, std::size_t samples)
      : dt_s(uniform(random, 0.005, 0.03)),
        a(made_up_record(samples, seed, uniform(random, 3.0, 14.0))),
        w(made_up_record(samples, seed + 1000, uniform(random, 0.0, 5.0))),
        building{
            {std::exp(uniform(random, std::log(0.1), std::log(2.0))), uniform(random, 0.01, 0.2)},
            uniform(random, 0.0, 1.0),
            {}},
        block{.friction = uniform(random, 0.05, 0.3)} {
    block.slope_rad = uniform(random, -0.9, 0.9) * std::min(std::atan(block.friction.along), 0.3);
    building.yielding = {1.0, seed % 3 == 0 ? 0.0 : uniform(random, 0.0, 0.3)};
    const CoupledBuilding elastic{building.horizontal, building.mass_ratio, {}};
    const double omega = 2.0 * std::numbers::pi / building.horizontal.period_s;
    building.yielding.yield_acceleration_mps2 =
        slide_coupled(ground(), {}, elastic, block).peak_roof_displacement_m * omega * omega /
        uniform(random, 1.2, 6.0);
  }
  GroundMotion ground() const { return {dt_s, a, w}; }
};

TEST(coupled_yielding, agrees_with_50_digits) {
  std::mt19937 random(6);
  int slid = 0, yields = 0;
  for (unsigned k = 0; k < 14; ++k) {
    Scene scene(random, 100 + k, 120);
    scene.block.slope_rad = std::abs(scene.block.slope_rad);
    SCOPED_TRACE("scene " + std::to_string(k));
    const auto [r, truth] =
        test::expect_near_truth(scene.ground(), {}, scene.building, scene.block);
    EXPECT_LT(test::error(r.residual_roof_displacement_m, truth.residual_roof,
                          r.peak_roof_displacement_m),
              1e-11);
    test::expect_peak(r.ductility, truth.ductility);
    slid += r.slip.slip_phases > 0 ? 1 : 0;
    yields += truth.yields;
  }
  EXPECT_GT(slid, 9);
  EXPECT_GT(yields, 60);
}

TEST(coupled_yielding, energy_is_balanced_with_what_yielding_took) {
  std::mt19937 random(9);
  double hysteretic = 0.0;
  for (unsigned k = 0; k < 1500; ++k) {
    const Scene scene(random, k, 150);
    const CoupledEnergy e =
        slide_coupled(scene.ground(), {1.3, k % 7 == 0 ? 4.0 : 1.0}, scene.building, scene.block)
            .energy;
    SCOPED_TRACE(k);
    const double largest = test::expect_balance(e);
    hysteretic += e.hysteretic_m2ps2 / largest;
  }
  EXPECT_GT(hysteretic, 150.0);  // a tenth of the energy and more, over all
}

}  // namespace coupled_yielding_test
}  // namespace glissade
