// SPDX-License-Identifier: GPL-3.0-or-later
// What must not change a bit of the two-axis kernel in lanes.
#include <gtest/gtest.h>

#include "simd_targets.hpp"
#include "unit/block/lane_scenes.hpp"

namespace glissade {
namespace two_axis_lanes_bits_test {

using namespace test::lanes;
using test::OnBuilding;

TEST(peak_slip_two_axes, one_mass_among_modes_without_participation_is_one_mass_to_the_bit) {
  for (const Kind kind : {Kind::uncoupled, Kind::coupled}) {
    const auto scenes = made_up_scenes(kind, 20, 31);
    auto among = scenes;
    for (TwoAxisScene& s : among)
      for (Modes& axis : s.building.horizontal) {
        const Mode modes[] = {axis[0], {0.3 * axis.period_s(), 0.0, 0.1, 0.05}};
        axis = Modes(modes);
      }
    EXPECT_EQ(numbers(solve(ground_of(30), among)), numbers(solve(ground_of(30), scenes)));
  }
}

TEST(peak_slip_two_axes, zero_motion_moves_nothing) {
  const auto rest = std::make_shared<GroundTable>(0.01, std::vector<double>(100, 0.0));
  for (const Kind kind : all_kinds)
    for (const double number :
         numbers(solve({{rest, rest}, nullptr}, scenes_of_all_models(kind, 40, 12))))
      EXPECT_EQ(number, 0.0);
}

TEST(peak_slip_two_axes, zeros_after_the_record_change_not_a_bit) {
  OnBuilding made(13, 500, 8.0);
  made.dt_s = 0.01;
  OnBuilding padded = made;
  for (auto* samples : {&padded.first, &padded.second, &padded.up})
    samples->insert(samples->end(), 300, 0.0);
  for (const Kind kind : all_kinds) {
    const auto scenes = scenes_of_all_models(kind, 40, 14);
    EXPECT_EQ(numbers(solve(padded.ground(), scenes)), numbers(solve(made.ground(), scenes)));
  }
}

TEST(peak_slip_two_axes, the_mirror_image_across_the_slope_is_the_same_to_the_bit) {
  for (const Kind kind : all_kinds) {
    const auto scenes = scenes_of_all_models(kind, 40, 15);
    auto mirrored = scenes;
    for (TwoAxisScene& s : mirrored) {
      s.block.azimuth_rad = -s.block.azimuth_rad;
      s.factors.horizontal[1] = -s.factors.horizontal[1];
    }
    const auto peaks = solve(ground_of(16), scenes);
    auto images = solve(ground_of(16), mirrored);
    for (BuildingPeak& p : images) p.residual.across_m = -p.residual.across_m;
    EXPECT_EQ(numbers(images), numbers(peaks));
  }
}

TEST(peak_slip_two_axes, slip_scales_with_the_whole_acceleration_field_to_the_bit) {
  for (const Kind kind : all_kinds) {
    const auto scenes = scenes_of_all_models(kind, 40, 17);
    auto stronger = scenes;
    for (TwoAxisScene& s : stronger) {
      s.block.gravity_mps2 *= 4.0;
      for (double& factor : s.factors.horizontal) factor *= 4.0;
      s.factors.vertical *= 4.0;
      s.block.law.rate_s_per_m *= 0.25;
      for (Yielding& spring : s.building.yielding) spring.yield_acceleration_mps2 *= 4.0;
    }
    const auto peaks = solve(ground_of(18), scenes), more = solve(ground_of(18), stronger);
    for (std::size_t k = 0; k < peaks.size(); ++k) {
      EXPECT_EQ(more[k].peak_displacement_m, 4.0 * peaks[k].peak_displacement_m) << k;
      EXPECT_EQ(more[k].residual.along_m, 4.0 * peaks[k].residual.along_m) << k;
      EXPECT_EQ(more[k].residual.across_m, 4.0 * peaks[k].residual.across_m) << k;
      EXPECT_EQ(more[k].slip_phases, peaks[k].slip_phases) << k;
    }
  }
}

TEST(peak_slip_two_axes, a_history_has_the_same_bits_in_any_company) {
  const BuildingGround ground = ground_of(19);
  for (const Kind kind : all_kinds) {
    auto scenes = scenes_of_all_models(kind, 60, 20);
    for (const TwoAxisScene& s : lifted_scenes(kind, 10, 20)) scenes.push_back(s);
    const auto together = solve(ground, scenes);
    for (std::size_t k = 0; k < scenes.size(); ++k)
      EXPECT_EQ(numbers(solve(ground, {&scenes[k], 1})), numbers({&together[k], 1})) << k;
    std::reverse(scenes.begin(), scenes.end());
    auto reversed = solve(ground, scenes);
    std::reverse(reversed.begin(), reversed.end());
    EXPECT_EQ(numbers(reversed), numbers(together));
  }
}

TEST(peak_slip_two_axes, all_simd_targets_give_the_same_bits) {
  const BuildingGround ground = ground_of(21);
  for (const Kind kind : all_kinds) {
    auto scenes = scenes_of_all_models(kind, 60, 22);
    for (const TwoAxisScene& s : lifted_scenes(kind, 10, 22)) scenes.push_back(s);
    const auto best = numbers(solve(ground, scenes));
    test::on_each_target([&] { EXPECT_EQ(numbers(solve(ground, scenes)), best); });
  }
}

}  // namespace two_axis_lanes_bits_test
}  // namespace glissade
