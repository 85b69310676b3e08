// SPDX-License-Identifier: GPL-3.0-or-later
// The two-axis kernel on the standard motions, recorded where they are found, against its reference
// at a thousandth of its tolerance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glissade/block/two_axis_lanes.hpp"
#include "standard_scenes.hpp"

namespace glissade {
namespace two_axis_lanes_standard_test {

using test::Component;

BuildingGround ground_of(const Component& x, const Component& y) {
  return {{std::make_shared<GroundTable>(x.dt_s, x.horizontal_mps2),
           std::make_shared<GroundTable>(y.dt_s, y.horizontal_mps2)},
          nullptr};
}

TwoAxisScene scene_of(const Component& x, std::size_t k, double period_s, double mass_ratio) {
  constexpr double pga_g[] = {0.5, 1.0, 1.5}, mu[] = {0.1, 0.3, 0.5},
                   slope_deg[] = {0.0, 1.19, 4.0};
  constexpr double azimuth_deg[] = {0.0, 90.0, 215.0};
  const double factor = pga_g[k % 3] * standard_gravity_mps2 / x.pga_mps2;
  TwoAxisScene s;
  s.building.horizontal = {Oscillator{period_s, 0.05}, Oscillator{0.8 * period_s, 0.05}};
  s.building.mass_ratio = mass_ratio;
  s.block.friction = {mu[k / 3 % 3], mu[k / 3 % 3]};
  s.block.slope_rad = slope_deg[k / 2 % 3] * rad_per_deg;
  s.block.azimuth_rad = azimuth_deg[k / 5 % 3] * rad_per_deg;
  s.factors = {factor, 0.0};
  return s;
}

// Peaks above 1 mm, with the recorded motions more than 1,000: half of them within 2e-7, all within
// 1e-5.
TEST(two_axis_lanes_on_standard_motions, keeps_the_tolerance) {
  const auto all = test::standard_scenes(GLISSADE_SOURCE_DIR "/suites",
                                         GLISSADE_SOURCE_DIR "/../shared/records");
  std::vector<double> errors;
  for (std::size_t i = 0; i + 1 < all.components.size(); i += 2) {
    const Component &x = all.components[i], &y = all.components[i + 1];
    if (x.dt_s != y.dt_s) continue;
    const BuildingGround ground = ground_of(x, y);
    std::vector<TwoAxisScene> scenes;
    for (std::size_t k = 0; k < 20; ++k) {
      scenes.push_back(scene_of(x, i / 2 + k, 0.0, 0.0));
      scenes.push_back(scene_of(x, i / 2 + k, 0.5, 0.0));
      scenes.push_back(scene_of(x, i / 2 + k, 0.5, 0.05));
    }
    std::vector<BuildingPeak> peaks(scenes.size());
    peak_slip_two_axes(ground, scenes, peaks, 1e-6);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      const TwoAxisScene& s = scenes[k];
      const double truth_m =
          slide_on_building(ground, s.factors, s.building, s.block, 1e-9).slip.peak_displacement_m;
      if (truth_m > 1e-3) errors.push_back(std::abs(peaks[k].peak_displacement_m / truth_m - 1.0));
    }
  }
  std::sort(errors.begin(), errors.end());
  RecordProperty("scenes", static_cast<int>(errors.size()));
  ASSERT_GT(errors.size(), 100u);
  EXPECT_LT(errors[errors.size() / 2], 2e-7);
  EXPECT_LT(errors.back(), 1e-5);
}

}  // namespace two_axis_lanes_standard_test
}  // namespace glissade
