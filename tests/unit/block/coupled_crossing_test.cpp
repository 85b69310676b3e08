// SPDX-License-Identifier: GPL-3.0-or-later
// When and how fast a block on a building first gets a given distance.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "unit/block/coupled_reference.hpp"

namespace glissade {
namespace coupled_crossing_test {

using test::CoupledReference;
using test::CoupledScene;
using test::made_up_record;
using test::uniform;

std::vector<CoupledScene> made_up_scenes(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<CoupledScene> scenes(count);
  for (CoupledScene& s : scenes) {
    s.building = {
        {std::exp(uniform(random, std::log(0.1), std::log(2.0))), uniform(random, 0.01, 0.15)},
        uniform(random, 0.0, 0.5),
        {}};
    s.block.friction = uniform(random, 0.05, 0.4);
    s.block.slope_rad = uniform(random, -0.9, 0.9) * std::atan(s.block.friction.along);
    s.factors = {uniform(random, 0.5, 2.0), 0.8};
  }
  return scenes;
}

/// Shares of the peak, which the way out has somewhere.
std::vector<double> shares(double peak_m) { return {0.01 * peak_m, 0.4 * peak_m, 0.93 * peak_m}; }

TEST(coupled_crossing, agrees_with_50_digits) {
  const auto a = made_up_record(120, 1, 8.0), w = made_up_record(120, 2, 3.0);
  const GroundMotion ground{0.02, a, w};
  int crossed = 0;
  for (CoupledScene s : made_up_scenes(6, 3)) {
    s.block.slope_rad = std::abs(s.block.slope_rad);
    if (crossed % 2 == 0) s.building.yielding = {3.0, 0.1};
    const double peak =
        slide_coupled(ground, s.factors, s.building, s.block).slip.peak_displacement_m;
    if (peak < 1e-4) continue;
    const std::vector<double> thresholds = shares(peak);
    std::vector<Crossing> found(thresholds.size());
    slide_coupled(ground, s.factors, s.building, s.block, thresholds, found);
    const double rings_s = std::max(found.back().time_s - 120 * 0.02, 0.0) + 0.04;
    const CoupledReference truth(ground, s.factors, s.building, s.block, rings_s, 10, thresholds);
    ASSERT_EQ(truth.crossed.size(), thresholds.size());
    for (std::size_t i = 0; i < thresholds.size(); ++i) {
      const double speed = static_cast<double>(truth.crossed[i].speed);
      EXPECT_NEAR(found[i].time_s, static_cast<double>(truth.crossed[i].time),
                  1e-12 * (1.0 + thresholds[i] / speed));
      EXPECT_NEAR(found[i].speed_mps, speed, 1e-10 * (1.0 + 1e-2 / speed));
      ++crossed;
    }
  }
  EXPECT_GE(crossed, 12);
}

// From rest on a rigid floor that accelerates at a: the block lags by (a - mu g) t^2 / 2.
TEST(coupled_crossing, is_the_parabola_under_constant_acceleration) {
  const std::vector<double> a(200, 5.0);
  const Block block{.friction = 0.3};
  const double lag = 5.0 - 0.3 * standard_gravity_mps2;
  const std::vector<double> thresholds{1e-6, 0.1, 1.0, 3.0, 1e3};
  std::vector<Crossing> found(thresholds.size());
  slide_coupled({0.01, a}, {}, {{0.0, 0.05}, 0.2, {}}, block, thresholds, found);
  for (std::size_t i = 0; i < 4; ++i) {
    const double time_s = std::sqrt(2.0 * thresholds[i] / lag);
    EXPECT_NEAR(found[i].time_s, time_s, 1e-13);
    EXPECT_NEAR(found[i].speed_mps, lag * time_s, 1e-12);
  }
  EXPECT_FALSE(found[4].happens());
}

TEST(coupled_crossing, at_the_very_peak_has_no_speed_and_beyond_does_not_happen) {
  const auto a = made_up_record(500, 5, 8.0);
  const GroundMotion ground{0.01, a};
  for (const CoupledScene& s : made_up_scenes(30, 6)) {
    std::vector<CoupledPoint> history;
    const double peak =
        slide_coupled(ground, s.factors, s.building, s.block, history).slip.peak_displacement_m;
    if (peak == 0.0) continue;
    const std::vector<double> thresholds{peak, std::nextafter(peak, 1e9)};
    std::vector<Crossing> found(2);
    const CoupledResult r =
        slide_coupled(ground, s.factors, s.building, s.block, thresholds, found);
    EXPECT_EQ(r.slip.peak_displacement_m, peak);
    const auto at_peak = std::ranges::find_if(history, [peak](const CoupledPoint& p) {
      return std::abs(p.displacement_m) == peak && p.velocity_mps == 0.0;
    });
    ASSERT_NE(at_peak, history.end());
    EXPECT_EQ(found[0].speed_mps, 0.0);
    EXPECT_NEAR(found[0].time_s, at_peak->time_s, 1e-12);
    EXPECT_FALSE(found[1].happens());
  }
}

}  // namespace coupled_crossing_test
}  // namespace glissade
