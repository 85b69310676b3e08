// SPDX-License-Identifier: GPL-3.0-or-later
// slide_on_building where scenes are at their worst: it comes to an end, with numbers that can be.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "unit/block/on_building_scene.hpp"

namespace glissade {
namespace on_building_stress_test {

using test::OnBuilding;

struct Draw {
  std::mt19937 random;
  bool one_in(unsigned n) { return random() % n == 0; }
  double between(double low, double high) { return test::uniform(random, low, high); }
  double by_size(double low, double high) {
    return std::exp(between(std::log(low), std::log(high)));
  }
};

OnBuilding worst(Draw& draw, unsigned seed) {
  OnBuilding scene(draw.random, seed, 100);
  for (Modes& o : scene.building.horizontal) {
    o = {draw.one_in(5) ? 0.0 : draw.by_size(0.02, 5.0), draw.between(0.02, 0.1)};
    if (draw.one_in(20)) o[0].damping_ratio = 1.5;
  }
  const double mu = draw.by_size(0.05, 2.0);
  scene.block.friction = {mu, draw.one_in(2) ? mu : mu * draw.between(0.5, 1.5)};
  scene.building.mass_ratio = draw.one_in(3) ? 0.0 : draw.between(0.0, 1.0);
  const double critical = std::atan(mu);
  const auto steepness = draw.random() % 6;
  scene.block.slope_rad = steepness == 0   ? 0.0
                          : steepness == 1 ? critical
                          : steepness == 2 ? critical + 0.01
                                           : draw.between(0.0, critical);
  if (draw.one_in(4)) {
    for (Yielding& y : scene.building.yielding)
      y = {draw.between(0.5, 4.0), draw.one_in(2) ? 0.0 : 0.1};
  }
  if (draw.one_in(4)) scene.block.law.static_over_sliding = draw.between(1.0, 2.0);
  if (draw.one_in(4)) {
    scene.block.law.fast_over_slow = draw.between(0.5, 2.0);
    scene.block.law.rate_s_per_m = draw.between(1.0, 200.0);
  }
  if (draw.one_in(3))
    for (double& w : scene.up) w *= 4.0;
  if (draw.one_in(3)) scene.vertical = {draw.between(0.05, 0.5), 0.05};
  scene.tolerance = draw.by_size(1e-9, 1e-2);
  return scene;
}

TEST(slide_on_building, ends_with_numbers_that_can_be_in_any_scene) {
  Draw draw{std::mt19937(11)};
  int slid = 0, lifted = 0, free = 0;
  for (unsigned k = 0; k < 250; ++k) {
    OnBuilding scene = worst(draw, k);
    if (!coupling_is_regular(scene.block, scene.building)) continue;
    SCOPED_TRACE("scene " + std::to_string(k));
    std::vector<double> thresholds_m{1e-6, 1e-3, 1e-2, 0.1, 1.0};
    std::vector<Crossing> crossings(thresholds_m.size());
    const BuildingSlip r = scene.result(thresholds_m, crossings);
    const SlipResult& s = r.slip;
    const double rounding = 1e-9 * s.peak_displacement_m;
    EXPECT_TRUE(std::isfinite(s.path_length_m) && std::isfinite(s.peak_velocity_mps));
    EXPECT_GE(s.peak_displacement_m + rounding,
              std::hypot(s.residual.along_m, s.residual.across_m));
    EXPECT_GE(s.peak_displacement_m + rounding,
              std::max(s.peak_by_axis.along_m, s.peak_by_axis.across_m));
    EXPECT_LE(s.peak_displacement_m, srss_of_maxima_m(s) + rounding);
    // The path is Simpson's rule on each step.
    EXPECT_LE(s.peak_displacement_m, s.path_length_m * (1.0 + 10.0 * scene.tolerance) + 1e-12);
    EXPECT_EQ(s.slip_phases > 0, s.slip_duration_s > 0.0);
    for (std::size_t n = 0; n < 2; ++n) {
      EXPECT_TRUE(std::isfinite(r.peak_base_shear[n]) && r.peak_base_shear[n] >= 0.0);
      EXPECT_TRUE(std::isfinite(r.peak_roof_displacement_m[n]));
    }
    for (std::size_t i = 0; i < thresholds_m.size(); ++i)
      EXPECT_EQ(crossings[i].happens(), thresholds_m[i] <= s.peak_displacement_m);
    slid += s.slip_phases > 0 ? 1 : 0;
    lifted += s.uplift ? 1 : 0;
    free += s.free_sliding ? 1 : 0;
  }
  EXPECT_GT(slid, 120);
  EXPECT_GT(lifted, 12);
  EXPECT_GT(free, 30);
}

}  // namespace on_building_stress_test
}  // namespace glissade
