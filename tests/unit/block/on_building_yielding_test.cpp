// SPDX-License-Identifier: GPL-3.0-or-later
// Yielding buildings below a block, in closed form and by limits.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "unit/block/on_building_scene.hpp"

namespace glissade {
namespace on_building_yielding_test {

using test::OnBuilding;

constexpr double infinity = std::numeric_limits<double>::infinity();

/// A building without damping on ground that is thrown sideways by a jerk of no duration, so that
/// it starts with this velocity; the block does not slide.
struct Kicked {
  double velocity_mps = 0.5, period_s = 0.8, mass_ratio = 0.0;
  Yielding yielding{2.0, 0.0};

  BuildingSlip result() const {
    const double dt_s = 1e-6;
    std::vector<double> a(4, 0.0);
    a[1] = -velocity_mps / dt_s;  // relative to the ground it moves on
    OnBuilding scene;
    scene.dt_s = dt_s;
    scene.first = a;
    scene.second.clear();
    scene.up.clear();
    scene.building = {{Oscillator{period_s, 0.05}, Oscillator{0.0}}, {}, mass_ratio};
    scene.building.horizontal[0][0].damping_ratio = 0.0;
    scene.building.yielding[0] = yielding;
    scene.block = {{1e9, 1e9}};
    return scene.result();
  }
};

// Kinetic energy of building and block is taken by the spring: elastic up to u_y = f / omega^2, and
// then f (u - u_y) + h omega^2 (u - u_y)^2 / 2, h the hardening ratio.
//   (1 + r) v^2 / 2 = f u_y / 2 + f p + h omega^2 p^2 / 2,  p = u_max - u_y
// and the largest force is f + h omega^2 p. Undamped, it then swings for ever, and no farther.
TEST(slide_on_building, a_kicked_building_yields_as_far_as_its_energy_takes_it) {
  for (const double ratio : {0.0, 0.3}) {
    for (const double hardening : {0.0, 0.1}) {
      Kicked kicked;
      kicked.mass_ratio = ratio;
      kicked.yielding = {2.0, hardening};
      const double omega = 2.0 * std::numbers::pi / kicked.period_s, k = omega * omega, f = 2.0;
      const double left = 0.5 * (1.0 + ratio) * 0.25 - 0.5 * f * f / k;
      ASSERT_GT(left, 0.0);
      const double p = hardening == 0.0
                           ? left / f
                           : (std::sqrt(f * f + 2.0 * hardening * k * left) - f) / (hardening * k);
      const BuildingSlip r = kicked.result();
      EXPECT_EQ(r.slip.slip_phases, 0u);
      EXPECT_NEAR(r.peak_roof_displacement_m[0], f / k + p, 2e-5 * (f / k + p));
      EXPECT_NEAR(r.peak_base_shear[0] * standard_gravity_mps2, f + hardening * k * p, 1e-5 * f);
    }
  }
}

TEST(slide_on_building, a_spring_that_is_strong_enough_is_elastic) {
  for (const double ratio : {0.0, 0.2}) {
    OnBuilding scene;
    scene.building.mass_ratio = ratio;
    const BuildingSlip elastic = scene.result();
    // Without damping forces in the base shear, a spring takes at most the roof's largest way.
    for (std::size_t n = 0; n < 2; ++n) {
      const double omega = 2.0 * std::numbers::pi / scene.building.horizontal[n][0].period_s;
      scene.building.yielding[n] = {1.0001 * omega * omega * elastic.peak_roof_displacement_m[n],
                                    0.0};
    }
    const BuildingSlip strong = scene.result();
    EXPECT_NEAR(strong.slip.peak_displacement_m, elastic.slip.peak_displacement_m,
                1e-9 * elastic.slip.peak_displacement_m);
    EXPECT_NEAR(strong.peak_base_shear[0], elastic.peak_base_shear[0], 1e-10);
    for (Yielding& y : scene.building.yielding) y.yield_acceleration_mps2 *= 0.9;
    const BuildingSlip weak = scene.result();
    EXPECT_GT(std::abs(weak.slip.residual.along_m / elastic.slip.residual.along_m - 1.0), 1e-3);
    scene.building.yielding = {Yielding{infinity, 0.5}, Yielding{infinity, 0.0}};
    EXPECT_EQ(scene.result().slip.residual.along_m, elastic.slip.residual.along_m);
    EXPECT_EQ(scene.result().peak_base_shear, elastic.peak_base_shear);
  }
}

// Without hardening or damping the roof passes on no more than the yield force: a block with more
// friction rests, whatever the ground does.
TEST(slide_on_building, a_plastic_building_isolates_its_roof) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    OnBuilding scene(seed, 800, 15.0);
    scene.up.clear();
    scene.building.mass_ratio = 0.25;
    for (Modes& o : scene.building.horizontal) o[0].damping_ratio = 0.0;
    scene.building.yielding = {Yielding{3.0, 0.0}, Yielding{3.0, 0.0}};
    const double a = 3.0 / 1.25, mu = std::numbers::sqrt2 * a / standard_gravity_mps2;
    scene.block = {{1.001 * mu, 1.001 * mu}};
    const BuildingSlip r = scene.result();
    EXPECT_EQ(r.slip.slip_phases, 0u);
    EXPECT_NEAR(r.peak_base_shear[0] * standard_gravity_mps2, 3.0, 1e-12);
    scene.block = {{0.5 * mu, 0.5 * mu}};
    EXPECT_GT(scene.result().slip.slip_phases, 0u);
  }
}

// A spring almost as stiff beyond its yield force as before is almost elastic.
TEST(slide_on_building, full_hardening_is_elastic) {
  OnBuilding scene;
  scene.tolerance = 1e-9;
  const BuildingSlip elastic = scene.result();
  scene.building.yielding = {Yielding{1.0, 1.0 - 1e-8}, Yielding{1.0, 1.0 - 1e-8}};
  const BuildingSlip r = scene.result();
  EXPECT_NEAR(r.slip.peak_displacement_m, elastic.slip.peak_displacement_m,
              1e-6 * elastic.slip.peak_displacement_m);
  EXPECT_NEAR(r.peak_roof_displacement_m[1], elastic.peak_roof_displacement_m[1],
              1e-6 * elastic.peak_roof_displacement_m[1]);
}

}  // namespace on_building_yielding_test
}  // namespace glissade
