// SPDX-License-Identifier: GPL-3.0-or-later
// The block on a building coupled with it, against 50 digits and against what must not change.
#include "glissade/block/coupled.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "glissade/building/roof_motion.hpp"
#include "unit/block/coupled_reference.hpp"

namespace glissade {
namespace coupled_test {

using test::CoupledReference;
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
    block.slope_rad = uniform(random, 0.0, 0.9) * std::min(std::atan(block.friction), 0.3);
  }
  GroundMotion ground() const { return {dt_s, a, w}; }
};

TEST(coupled, agrees_with_50_digits) {
  std::mt19937 random(5);
  int slid = 0, lifted = 0, phases = 0;
  for (unsigned k = 0; k < 20; ++k) {
    const Scene scene(random, 100 + k, 120, k % 4 == 0);
    std::vector<CoupledPoint> history;
    const CoupledResult r =
        slide_coupled(scene.ground(), {1.3, 0.9}, scene.building, scene.block, history);
    const double rings_s = history.back().time_s - static_cast<double>(scene.a.size()) * scene.dt_s;
    const int looks = std::max(
        8, static_cast<int>(std::ceil(60.0 * scene.dt_s / scene.building.horizontal.period_s)));
    const CoupledReference truth(scene.ground(), {1.3, 0.9}, scene.building, scene.block,
                                 std::max(rings_s, 0.0) + 0.5 * scene.dt_s, looks);
    SCOPED_TRACE("scene " + std::to_string(k));
    const auto error = [](double found, const test::Real& true_value, double scale) {
      return std::abs(static_cast<double>(found - true_value)) / (scale > 0.0 ? scale : 1.0);
    };
    const double slip = r.slip.peak_displacement_m;
    for (const double e :
         {error(r.slip.peak_downslope_m, truth.down, slip),
          error(r.slip.peak_upslope_m, truth.up, slip),
          error(r.slip.residual_displacement_m, truth.slip, slip),
          error(r.slip.slip_duration_s, truth.duration, r.slip.slip_duration_s),
          error(history.back().roof_displacement_m, truth.u, r.peak_roof_displacement_m)}) {
      EXPECT_LT(e, 1e-11);
    }
    EXPECT_EQ(r.slip.slip_phases, static_cast<std::size_t>(truth.phases));
    EXPECT_EQ(r.slip.uplift, truth.uplift);
    // The reference sees its peaks at sixty looks a period: within (2 pi / 60)^2 / 8.
    const double seen = 2e-3;
    for (const auto& [found, looked] :
         {std::pair{r.peak_base_shear, truth.base_shear},
          std::pair{r.peak_roof_displacement_m, truth.roof_displacement},
          std::pair{r.peak_roof_acceleration_mps2, truth.roof_acceleration}}) {
      EXPECT_GE(found, static_cast<double>(looked) * (1.0 - 1e-12));
      EXPECT_LE(found, static_cast<double>(looked) * (1.0 + seen));
    }
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
    const CoupledResult r = slide_coupled(scene.ground(), {1.3, 1.0}, scene.building, scene.block);
    const CoupledEnergy& e = r.energy;
    const double largest =
        std::max({std::abs(e.input_m2ps2), e.damped_m2ps2, e.friction_m2ps2, 1e-300});
    const double left = e.input_m2ps2 + e.gravity_m2ps2 -
                        (e.kinetic_m2ps2 + e.strain_m2ps2 + e.damped_m2ps2 + e.friction_m2ps2);
    EXPECT_LT(std::abs(left) / largest, 1e-10) << k;
    EXPECT_GE(e.friction_m2ps2, 0.0);
    friction += e.friction_m2ps2 / largest;
  }
  EXPECT_GT(friction, 200.0);  // a tenth of the energy and more, over all
}

}  // namespace coupled_test
}  // namespace glissade
