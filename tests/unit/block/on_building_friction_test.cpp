// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of friction and crossings of slide_on_building, in closed form.
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "unit/block/on_building_scene.hpp"

namespace glissade {
namespace on_building_friction_test {

using test::OnBuilding;
constexpr double g = standard_gravity_mps2;

/// A flat roof that is jerked from under the block, which is left with this speed. The jerk takes
/// 0.1 ms and is so large that friction does nothing meanwhile.
struct Thrown {
  double dt_s = 1e-7, speed_mps = 1.0;
  Block block{{0.3, 0.3}};
  BiaxialBuilding building{{Oscillator{0.0}, Oscillator{0.0}}, {}, 0.0};
  double angle = 0.4;
  std::vector<double> thresholds_m;
  std::vector<Crossing> crossings;

  BuildingSlip result(double tolerance = 1e-8) {
    std::vector<double> x(8, 0.0), y(8, 0.0);
    x[1] = -std::cos(angle) * speed_mps / dt_s;  // a triangle of area v0
    y[1] = -std::sin(angle) * speed_mps / dt_s;
    const BuildingGround ground{
        {std::make_shared<GroundTable>(dt_s, x), std::make_shared<GroundTable>(dt_s, y)}, nullptr};
    crossings.resize(thresholds_m.size());
    return slide_on_building(ground, {}, building, block, thresholds_m, crossings, tolerance);
  }
};

// s = v0 t - mu g t^2 / 2 until v0 / (mu g). The jerk ends at 2e-7 s.
TEST(slide_on_building, tells_when_and_how_fast_a_thrown_block_passes_each_length) {
  Thrown thrown;
  const double deceleration = 0.3 * g, way_m = 0.5 / deceleration;
  thrown.thresholds_m = {0.001, 0.05, 0.1, 0.999 * way_m, 1.001 * way_m, 1.0};
  const BuildingSlip r = thrown.result();
  EXPECT_NEAR(r.slip.peak_displacement_m, way_m, 1e-6 * way_m);
  for (std::size_t i = 0; i < 4; ++i) {
    const double speed = std::sqrt(1.0 - 2.0 * deceleration * thrown.thresholds_m[i]);
    ASSERT_TRUE(thrown.crossings[i].happens());
    EXPECT_NEAR(thrown.crossings[i].speed_mps, speed, 1e-4);
    EXPECT_NEAR(thrown.crossings[i].time_s, (1.0 - speed) / deceleration, 1e-5);
  }
  EXPECT_FALSE(thrown.crossings[4].happens());
  EXPECT_FALSE(thrown.crossings[5].happens());
}

TEST(slide_on_building, crossings_do_not_change_the_history) {
  const OnBuilding scene;
  const BuildingSlip without = scene.result();
  std::vector<double> thresholds_m;
  for (int i = 1; i <= 20; ++i) thresholds_m.push_back(0.06 * i * without.slip.peak_displacement_m);
  std::vector<Crossing> crossings(thresholds_m.size());
  const BuildingSlip with = scene.result(thresholds_m, crossings);
  EXPECT_NEAR(with.slip.peak_displacement_m, without.slip.peak_displacement_m,
              1e-6 * without.slip.peak_displacement_m);
  for (std::size_t i = 0; i < 20; ++i) {
    EXPECT_EQ(crossings[i].happens(), thresholds_m[i] <= with.slip.peak_displacement_m);
    if (!crossings[i].happens()) continue;
    EXPECT_GE(crossings[i].time_s, i > 0 ? crossings[i - 1].time_s : 0.0);
    EXPECT_GT(crossings[i].speed_mps, 0.0);
    EXPECT_LE(crossings[i].speed_mps, with.slip.peak_velocity_mps * (1.0 + 1e-9));
  }
}

// v' = -mu g k(v), k = F - (F - 1) exp(-a v): it rests after the integral of 1 / (mu g k) over v,
// ln(F exp(a v0) - F + 1) / (a F mu g), on a way that is the integral of v / (mu g k).
TEST(slide_on_building, friction_that_depends_on_speed_stops_a_thrown_block_as_its_integral_tells) {
  for (const double fast : {0.5, 0.8, 1.5, 3.0}) {
    for (const double rate : {2.0, 20.0, 100.0}) {
      Thrown thrown;
      thrown.block.law = {1.0, fast, rate};
      const BuildingSlip r = thrown.result();
      const double n = 0.3 * g;
      const double time_s = std::log(fast * std::exp(rate) - fast + 1.0) / (rate * fast * n);
      const auto way = [&](double v) {
        return v / (n * (fast - (fast - 1.0) * std::exp(-rate * v)));
      };
      const double way_m =
          boost::math::quadrature::gauss_kronrod<double, 31>::integrate(way, 0.0, 1.0, 12, 1e-12);
      EXPECT_NEAR(r.slip.slip_duration_s, time_s, 1e-5 * time_s) << fast << " " << rate;
      EXPECT_NEAR(r.slip.peak_displacement_m, way_m, 1e-5 * way_m) << fast << " " << rate;
      EXPECT_NEAR(r.slip.path_length_m, way_m, 1e-5 * way_m);
    }
  }
}

// The roof's acceleration rises as j t along a line and stays at A: the block lets go where it
// passes mu_static g, at once slides with mu g, and loses its speed again once the roof is at rest.
//   v = (j t^2 / 2 - mu g t) from t_s = mu_static g / j on
TEST(slide_on_building, static_friction_holds_until_it_is_passed_and_is_gone_then) {
  const double dt_s = 0.1, peak_mps2 = 0.5 * g, mu = 0.2;
  std::vector<double> a{0.0, peak_mps2};
  for (const double ratio : {1.0, 1.5, 2.0}) {
    OnBuilding scene;
    scene.dt_s = dt_s;
    scene.first = a;  // up to A in one interval, and down to zero in the next
    scene.second.clear();
    scene.up.clear();
    scene.building.horizontal = {Oscillator{0.0}, Oscillator{0.0}};
    scene.block = {{mu, mu}};
    scene.block.law.static_over_sliding = ratio;
    scene.tolerance = 1e-9;
    const double jerk = peak_mps2 / dt_s, start_s = ratio * mu * g / jerk;
    // Backward: speed and way at A, at zero, and to rest.
    const double n = mu * g;
    double v = 0.0, s = 0.0;
    const auto pass = [&](double length_s, double from, double to) {
      s += v * length_s + (from - n) * length_s * length_s / 2.0 +
           (to - from) * length_s * length_s / 6.0;
      v += 0.5 * (from + to) * length_s - n * length_s;
    };
    pass(dt_s - start_s, ratio * n, peak_mps2);
    pass(dt_s, peak_mps2, 0.0);
    ASSERT_GT(v, 0.0);
    s += v * v / (2.0 * n);
    const BuildingSlip r = scene.result();
    EXPECT_NEAR(r.slip.residual.along_m, -s, 1e-8 * s) << ratio;
    EXPECT_NEAR(r.slip.slip_duration_s, 2.0 * dt_s - start_s + v / n, 1e-8);
    scene.block.law.static_over_sliding = 2.51;
    EXPECT_EQ(scene.result().slip.slip_phases, 0u);
  }
}

// A block on a slope between sliding and static friction rests until it is moved, and then never
// stops.
TEST(slide_on_building, what_only_static_friction_holds_never_stops_again) {
  OnBuilding scene;
  scene.block = {{0.1, 0.1}, std::atan(0.15), 0.0};
  scene.block.law.static_over_sliding = 2.0;
  scene.factor = 1e-3;
  const BuildingSlip still = scene.result();
  EXPECT_EQ(still.slip.slip_phases, 0u);
  EXPECT_FALSE(still.slip.free_sliding);
  scene.factor = 1.0;
  const BuildingSlip moved = scene.result();
  EXPECT_TRUE(moved.slip.free_sliding);
  // It loses only what friction's growth with speed gives back.
  scene.block.law = {2.0, 3.0, 5.0};
  EXPECT_TRUE(scene.result().slip.free_sliding);
}

}  // namespace on_building_friction_test
}  // namespace glissade
