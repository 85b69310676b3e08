// SPDX-License-Identifier: GPL-3.0-or-later
// The block on a building coupled with it, against 50 digits and against what must not change.
#include "glissade/block/coupled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>

#include "unit/block/coupled_truth.hpp"

namespace glissade {
namespace coupled_test {

using test::made_up_record;
using test::uniform;

/// A scene of any size, drawn from the generator: buildings from much stiffer than a sample
/// interval to much slower than the record.
struct Scene {
  double dt_s;
  std::vector<double> a, w;
  CoupledBuilding building;
  Block block;

  Scene(std::mt19937& random, unsigned seed, std::size_t samples, bool may_lift)
      : dt_s(uniform(random, 0.005, 0.03)),
        a(made_up_record(samples, seed, uniform(random, 3.0, 14.0))),
        w(made_up_record(samples, seed + 1000, uniform(random, 0.0, may_lift ? 25.0 : 5.0))),
        building{
            {std::exp(uniform(random, std::log(0.03), std::log(3.0))), uniform(random, 0.005, 0.2)},
            uniform(random, 0.0, 0.5)},
        block{.friction = uniform(random, 0.05, 0.5)} {
    block.slope_rad = uniform(random, 0.0, 0.9) * std::min(std::atan(block.friction.along), 0.3);
  }
  GroundMotion ground() const { return {dt_s, a, w}; }
};

TEST(coupled, agrees_with_50_digits) {
  std::mt19937 random(5);
  int slid = 0, lifted = 0, phases = 0;
  for (unsigned k = 0; k < 20; ++k) {
    const Scene scene(random, 100 + k, 120, k % 4 == 0);
    SCOPED_TRACE("scene " + std::to_string(k));
    const auto [r, truth] =
        test::expect_near_truth(scene.ground(), {1.3, 0.9}, scene.building, scene.block);
    test::expect_peak(r.peak_roof_acceleration_mps2, truth.roof_acceleration);
    slid += r.slip.slip_phases > 0 ? 1 : 0;
    lifted += r.slip.uplift ? 1 : 0;
    phases += truth.phases;
  }
  EXPECT_GT(slid, 12);
  EXPECT_GT(lifted, 2);
  EXPECT_GT(phases, 150);
}

TEST(coupled, input_and_gravity_are_stored_damped_and_rubbed_away) {
  std::mt19937 random(8);
  double friction = 0.0;
  for (unsigned k = 0; k < 2000; ++k) {
    const Scene scene(random, k, 200, k % 7 == 0);
    const CoupledEnergy e =
        slide_coupled(scene.ground(), {1.3, 1.0}, scene.building, scene.block).energy;
    SCOPED_TRACE(k);
    const double largest = test::expect_balance(e);
    friction += e.friction_m2ps2 / largest;
  }
  EXPECT_GT(friction, 200.0);  // a tenth of the energy and more, over all
}

}  // namespace coupled_test
}  // namespace glissade
