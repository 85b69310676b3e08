// SPDX-License-Identifier: GPL-3.0-or-later
// The two-axis kernel in lanes against its readable reference.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "glissade/block/slide.hpp"
#include "unit/block/lane_scenes.hpp"

namespace glissade {
namespace two_axis_lanes_test {

using namespace test::lanes;
using test::OnBuilding;

SlipResult reference(const BuildingGround& ground, const TwoAxisScene& s, double tolerance = 1e-9) {
  return slide_on_building(ground, s.factors, s.building, s.block, tolerance).slip;
}

double error(const BuildingPeak& p, const SlipResult& r) {
  return std::max({std::abs(p.peak_displacement_m - r.peak_displacement_m),
                   std::abs(p.peak_by_axis.along_m - r.peak_by_axis.along_m),
                   std::abs(p.peak_by_axis.across_m - r.peak_by_axis.across_m),
                   std::abs(p.peak_downslope_m - r.peak_downslope_m),
                   std::abs(p.peak_upslope_m - r.peak_upslope_m),
                   std::abs(p.residual.along_m - r.residual.along_m),
                   std::abs(p.residual.across_m - r.residual.across_m)}) /
         r.peak_displacement_m;
}

std::vector<SlipResult> references(const BuildingGround& ground,
                                   std::span<const TwoAxisScene> scenes) {
  std::vector<SlipResult> all;
  for (const TwoAxisScene& s : scenes) all.push_back(reference(ground, s));
  return all;
}

/// Errors of those that slide more than 0.1 mm, in order.
std::vector<double> errors(const BuildingGround& ground, std::span<const TwoAxisScene> scenes,
                           std::span<const SlipResult> truth, double tolerance) {
  const std::vector<BuildingPeak> peaks = solve(ground, scenes, tolerance);
  std::vector<double> found;
  double lanes_s = 0.0, reference_s = 0.0;  // one history may differ where it hardly moves
  for (std::size_t k = 0; k < scenes.size(); ++k) {
    const SlipResult& r = truth[k];
    EXPECT_EQ(peaks[k].uplift, r.uplift) << k;
    EXPECT_EQ(peaks[k].free_sliding, r.free_sliding) << k;
    lanes_s += peaks[k].slip_duration_s;
    reference_s += r.slip_duration_s;
    EXPECT_EQ(peaks[k].peak_displacement_m > 0.0, r.peak_displacement_m > 0.0) << k;
    if (r.peak_displacement_m > 1e-4) found.push_back(error(peaks[k], r));
  }
  EXPECT_NEAR(lanes_s, reference_s, 0.01 * reference_s);
  std::sort(found.begin(), found.end());
  return found;
}
std::vector<double> errors(const BuildingGround& ground, std::span<const TwoAxisScene> scenes,
                           double tolerance) {
  return errors(ground, scenes, references(ground, scenes), tolerance);
}

TEST(peak_slip_two_axes, agrees_with_the_reference) {
  for (const Kind kind : all_kinds) {
    SCOPED_TRACE(static_cast<int>(kind));
    const std::vector<double> found = errors(ground_of(1), made_up_scenes(kind, 60, 2), 1e-6);
    ASSERT_GT(found.size(), 30u);
    EXPECT_LT(found[found.size() / 2], 1e-6);
    EXPECT_LT(found.back(), 3e-5);
  }
}

// The array's part in the modes differs between the axes, which turns the friction that it feels.
TEST(peak_slip_two_axes, modes_coupled_with_the_array_agree_with_the_reference) {
  for (const std::size_t count : {1u, 3u, 5u}) {
    SCOPED_TRACE(count);
    auto scenes = made_up_scenes(Kind::coupled_modes, 60, 2);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      BiaxialBuilding& building = scenes[k].building;
      const double period_s = building.horizontal[0].period_s();
      building.horizontal = {cantilever(period_s, 2.0, count), cantilever(0.9 * period_s, 20.0, 6)};
      if (k % 4 == 0) building.horizontal[1] = building.horizontal[0];
      building.mass_ratio = k % 2 == 0 ? 0.05 : 0.3;
    }
    const std::vector<double> found = errors(ground_of(1), scenes, 1e-6);
    ASSERT_GT(found.size(), 40u);
    EXPECT_LT(found[found.size() / 2], 1e-6);
    EXPECT_LT(found.back(), 3e-5);
  }
}

TEST(peak_slip_two_axes, converges_with_its_tolerance) {
  for (const Kind kind : all_kinds) {
    SCOPED_TRACE(static_cast<int>(kind));
    const BuildingGround ground = ground_of(3);
    std::vector<TwoAxisScene> circles = made_up_scenes(kind, 30, 4), ellipses;
    std::erase_if(circles, [&](const TwoAxisScene& s) {
      if (s.block.friction.along == s.block.friction.across) return false;
      ellipses.push_back(s);
      return true;
    });
    ASSERT_EQ(circles.size(), 10u);
    const auto of_circles = references(ground, circles), of_ellipses = references(ground, ellipses);
    for (const double tolerance : {1e-4, 1e-5, 1e-7}) {
      const std::vector<double> on_circles = errors(ground, circles, of_circles, tolerance);
      EXPECT_LT(on_circles[on_circles.size() / 2], 2.0 * tolerance);
      EXPECT_LT(on_circles.back(), 10.0 * tolerance);
      const std::vector<double> on_ellipses = errors(ground, ellipses, of_ellipses, tolerance);
      EXPECT_LT(on_ellipses[on_ellipses.size() / 2], 2.0 * tolerance);
      const bool one_scene = kind == Kind::coupled && tolerance == 1e-4;  // at 55 tolerances
      EXPECT_LT(on_ellipses.back(), (one_scene ? 60.0 : 10.0) * tolerance);
    }
  }
}

TEST(peak_slip_two_axes, friction_by_speed_is_that_of_the_reference) {
  for (const Kind kind : all_kinds) {
    SCOPED_TRACE(static_cast<int>(kind));
    const BuildingGround ground = ground_of(46);
    const auto scenes = with_friction_by_speed(made_up_scenes(kind, 60, 45));
    const auto truth = references(ground, scenes);
    for (const double tolerance : {1e-5, 1e-6, 1e-8}) {
      const std::vector<double> found = errors(ground, scenes, truth, tolerance);
      ASSERT_GT(found.size(), 30u);
      EXPECT_LT(found[found.size() / 2], 2.0 * tolerance);
      EXPECT_LT(found[found.size() - 2], 30.0 * tolerance);
    }
  }
}

// Slip is discontinuous where the block almost comes to rest: one scene may be another one.
TEST(peak_slip_two_axes, static_friction_holds_as_in_the_reference) {
  for (const Kind kind : all_kinds) {
    SCOPED_TRACE(static_cast<int>(kind));
    const BuildingGround ground = ground_of(44);
    const auto scenes = with_static_friction(made_up_scenes(kind, 60, 43));
    const auto truth = references(ground, scenes);
    for (const double tolerance : {1e-5, 1e-6, 1e-8}) {
      const std::vector<double> found = errors(ground, scenes, truth, tolerance);
      ASSERT_GT(found.size(), 30u);
      EXPECT_LT(found[found.size() / 2], tolerance);
      EXPECT_LT(found[found.size() - 2], 30.0 * tolerance);
    }
  }
}

TEST(peak_slip_two_axes, base_shear_is_that_of_the_reference_and_changes_no_other_bit) {
  OnBuilding made(41, 900, 6.0);
  made.dt_s = 0.01;
  for (const std::size_t samples : {900u, 150u}) {  // the building rings on where the record ends
    for (auto* component : {&made.first, &made.second, &made.up}) component->resize(samples);
    const BuildingGround ground = made.ground();
    for (const Kind kind : {Kind::rigid, Kind::uncoupled, Kind::coupled, Kind::yielding}) {
      SCOPED_TRACE(static_cast<int>(kind));
      auto scenes = made_up_scenes(kind, 60, 42);
      const std::vector<BuildingPeak> peaks = solve(ground, scenes);
      std::vector<double> errors;
      for (std::size_t k = 0; k < scenes.size(); ++k) {
        const TwoAxisScene& s = scenes[k];
        const BuildingSlip r = slide_on_building(ground, s.factors, s.building, s.block, 1e-9);
        for (const std::size_t n : {0u, 1u})
          errors.push_back(std::abs(peaks[k].base_shear[n] / r.peak_base_shear[n] - 1.0));
      }
      std::sort(errors.begin(), errors.end());
      EXPECT_LT(errors[errors.size() / 2], 1e-8);
      EXPECT_LT(errors.back(), 1e-6);
      std::vector<BuildingPeak> others = peaks;
      for (BuildingPeak& peak : others) peak.base_shear = {};
      for (TwoAxisScene& s : scenes) s.base_shear = false;
      EXPECT_EQ(numbers(solve(ground, scenes)), numbers(others));
    }
  }
}

TEST(peak_slip_two_axes, lifts_off_and_lands_as_the_reference) {
  for (const Kind kind : all_kinds) {
    SCOPED_TRACE(static_cast<int>(kind));
    const auto scenes = lifted_scenes(kind, 60, 26);
    const std::vector<BuildingPeak> peaks = solve(ground_of(27), scenes);
    EXPECT_GT(std::ranges::count_if(peaks, &BuildingPeak::uplift), 20);
    const std::vector<double> found = errors(ground_of(27), scenes, 1e-6);
    ASSERT_GT(found.size(), 30u);
    EXPECT_LT(found[found.size() / 2], 1e-6);
    EXPECT_LT(found.back(), 3e-5);
  }
}

TEST(peak_slip_two_axes, lifted_off_without_a_drive_it_stays_where_it_is) {
  OnBuilding made(28, 300, 6.0);
  for (auto* horizontal : {&made.first, &made.second})
    std::fill(horizontal->begin(), horizontal->end(), 0.0);
  TwoAxisScene scene{{}, {{0.3, 0.3}, 0.0, 0.0}, {1.0, 5.0}};
  const BuildingPeak peak = solve(made.ground(), {&scene, 1}).front();
  EXPECT_TRUE(peak.uplift);
  EXPECT_EQ(peak.slip_phases, 0u);
  EXPECT_EQ(peak.peak_displacement_m, 0.0);
}

TEST(peak_slip_two_axes, along_one_axis_is_slide) {
  const auto a = test::made_up_record(900, 5, 8.0);
  const BuildingGround ground{{std::make_shared<GroundTable>(0.01, a), nullptr}, nullptr};
  int slid = 0;
  for (const double slope_deg : {0.0, 3.0}) {
    const Block block{.friction = 0.25, .slope_rad = slope_deg * rad_per_deg};
    const SlipResult r = slide({0.01, a}, block);
    const TwoAxisScene scene{{}, block, {{1.0, 1.0}, 1.0}};
    const BuildingPeak p = solve(ground, {&scene, 1}).front();
    EXPECT_NEAR(p.peak_downslope_m, r.peak_downslope_m, 2e-6 * r.peak_displacement_m);
    EXPECT_NEAR(p.peak_upslope_m, r.peak_upslope_m, 2e-6 * r.peak_displacement_m);
    EXPECT_NEAR(p.residual.along_m, r.residual.along_m, 2e-6 * r.peak_displacement_m);
    EXPECT_EQ(p.peak_by_axis.across_m, 0.0);
    slid += r.peak_displacement_m > 1e-3 ? 1 : 0;
  }
  EXPECT_EQ(slid, 2);
}

TEST(peak_slip_two_axes, what_does_not_fit_the_lanes_is_the_reference) {
  OnBuilding made(9, 400, 7.0);
  made.dt_s = 0.01;
  const BuildingGround plain = made.ground();
  made.vertical = {0.1, 0.02};
  const BuildingGround ringing = made.ground();
  std::vector<TwoAxisScene> scenes = made_up_scenes(Kind::coupled, 9, 10);
  for (TwoAxisScene& s : scenes) s.block.friction = 0.2;
  scenes[0].block.friction.across = 0.09;
  scenes[1].block.law = {1.0, 0.1, 20.0};
  scenes[2].block.law = {1.0, 1.5, 2000.0};
  scenes[3].building.horizontal = {};
  scenes[4].building.horizontal[1][0].period_s = 0.0;
  scenes[5].building.horizontal[0][0].period_s = 0.05;
  scenes[6].block.slope_rad = 0.3;
  scenes[8].building.mass_ratio = 0.0;
  for (const std::size_t wanted : {0u, 1u, 2u, 3u, 4u, 5u, 6u}) scenes[wanted].base_shear = true;
  const Mode too_short[] = {{0.5, 1.3, 0.9, 0.05}, {0.02, -0.3, 0.1, 0.05}};
  scenes[7].building.horizontal[0] = scenes[8].building.horizontal[0] = Modes(too_short);
  const auto expect_reference = [](const BuildingGround& ground,
                                   std::span<const TwoAxisScene> all) {
    const std::vector<BuildingPeak> peaks = solve(ground, all);
    for (std::size_t k = 0; k < all.size(); ++k) {
      const SlipResult r = reference(ground, all[k], 1e-6);
      EXPECT_EQ(error(peaks[k], r), 0.0) << k;
      EXPECT_EQ(peaks[k].slip_phases, r.slip_phases) << k;
      EXPECT_EQ(peaks[k].uplift, r.uplift) << k;
      EXPECT_EQ(peaks[k].free_sliding, r.free_sliding) << k;
      EXPECT_NEAR(peaks[k].slip_duration_s, r.slip_duration_s, 1e-3 * r.slip_duration_s) << k;
    }
  };
  expect_reference(plain, scenes);
  EXPECT_TRUE(solve(plain, scenes)[6].free_sliding);
  expect_reference(ringing, made_up_scenes(Kind::uncoupled, 4, 11));
}

// The building rings on after the record, and the block goes on sliding with it.
TEST(peak_slip_two_axes, follows_the_building_after_the_record) {
  OnBuilding made(1, 900, 6.0);
  made.dt_s = 0.01;
  for (const std::size_t samples : {100u, 150u}) {
    for (auto* component : {&made.first, &made.second, &made.up}) component->resize(samples);
    const BuildingGround ground = made.ground();
    auto scenes = made_up_scenes(Kind::uncoupled, 16, 23);
    for (const Kind kind : {Kind::modes, Kind::coupled_modes})
      for (const TwoAxisScene& s : made_up_scenes(kind, 16, 23)) scenes.push_back(s);
    for (TwoAxisScene& s : scenes) {
      s.factors = {2.0, 2.0};
      s.block.friction = 0.12;
      s.block.slope_rad = 0.03;
    }
    const std::vector<double> found = errors(ground, scenes, 1e-6);
    ASSERT_FALSE(found.empty());
    EXPECT_LT(found.back(), 3e-5);
  }
}

// 2.5 radians of the shortest mode between samples.
TEST(peak_slip_two_axes, a_roof_of_short_modes_is_a_polynomial_between_samples) {
  OnBuilding made(32, 700, 6.0);
  made.dt_s = 0.02;
  for (const Kind kind : {Kind::modes, Kind::coupled_modes}) {
    auto scenes = made_up_scenes(kind, 40, 33);
    for (TwoAxisScene& s : scenes) s.building.horizontal[1] = cantilever(0.7, 20.0);
    ASSERT_LT(scenes[0].building.horizontal[1][5].period_s, 0.053);
    const std::vector<double> found = errors(made.ground(), scenes, 1e-8);
    ASSERT_GT(found.size(), 20u);
    EXPECT_LT(found[found.size() / 2], 1e-8);
    EXPECT_LT(found.back(), 3e-7);
  }
}

// Ten thresholds up to the peak: the same ones are reached, at the same time and speed.
TEST(peak_slip_two_axes, crossings_are_those_of_the_reference) {
  const BuildingGround ground = ground_of(24);
  for (const Kind kind : all_kinds) {
    auto scenes = made_up_scenes(kind, 40, 25);
    for (const TwoAxisScene& lifted : lifted_scenes(kind, 20, 25)) scenes.push_back(lifted);
    const auto plain = solve(ground, scenes);
    for (std::size_t k = 0; k < scenes.size(); ++k) {
      const TwoAxisScene& s = scenes[k];
      std::vector<double> thresholds_m;
      for (int i = 1; i <= 10; ++i)
        thresholds_m.push_back((i < 10 ? 0.0997 * i : 1.01) * plain[k].peak_displacement_m);
      if (plain[k].peak_displacement_m < 1e-4) continue;
      std::vector<Crossing> found(10), expected(10);
      BuildingPeak peak;
      TwoAxisLanes(ground).slide({&s, 1}, {&peak, 1}, thresholds_m, found);
      slide_on_building(ground, s.factors, s.building, s.block, thresholds_m, expected, 1e-9);
      for (std::size_t i = 0; i < 10; ++i) {
        ASSERT_EQ(found[i].happens(), expected[i].happens()) << k << ' ' << i;
        ASSERT_EQ(found[i].happens(), i < 9);
        if (i == 9 || expected[i].speed_mps < 1e-3) continue;
        const double off_m = 2e-5 * peak.peak_displacement_m;
        EXPECT_NEAR(found[i].time_s, expected[i].time_s, 1e-5 + off_m / expected[i].speed_mps);
        EXPECT_NEAR(found[i].speed_mps, expected[i].speed_mps,
                    1e-3 * expected[i].speed_mps + 20.0 * off_m / expected[i].speed_mps);
      }
    }
  }
}

}  // namespace two_axis_lanes_test
}  // namespace glissade
