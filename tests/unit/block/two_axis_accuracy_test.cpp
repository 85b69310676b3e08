// SPDX-License-Identifier: GPL-3.0-or-later
// slide_on_building() and peak_slip_two_axes() against the independent solver of
// tests/two_axis_truth.
#include <gtest/gtest.h>

#include "glissade/block/two_axis_lanes.hpp"
#include "unit/block/truth_scenes.hpp"

namespace glissade {
namespace two_axis_accuracy_test {

using test::all_laws;
using test::all_roofs;
using test::Law;
using test::OnBuilding;
using test::Roof;
using test::TwoAxisTruth;

TEST(slide_on_building, at_1e_10_is_the_independent_solver_to_1e_9_above_10_um) {
  std::mt19937 random(5);
  int slid = 0;
  for (const Roof roof : all_roofs)
    for (const Law law : all_laws)
      for (int k = 0; k < 2; ++k) {
        OnBuilding scene = test::truth_scene(random, roof, law, 160);
        scene.tolerance = 1e-10;
        const TwoAxisTruth truth(test::as_truth(scene));
        const SlipResult r = scene.result().slip;
        EXPECT_EQ(r.uplift, truth.uplift);
        if (truth.peak_m < 1e-5L) continue;
        ++slid;
        EXPECT_LE(test::error_of(r, truth), 1e-9)
            << static_cast<int>(roof) << ' ' << static_cast<int>(law) << ' ' << k;
        if (roof != Roof::rigid || !scene.block.law.is_coulomb()) continue;
        const TwoAxisAcceleration motion{
            scene.dt_s, {scene.first, scene.second}, scene.up, scene.factor, scene.factor};
        EXPECT_LE(test::error_of(slide_two_axis(motion, scene.block, 1e-10), truth), 1e-9);
      }
  EXPECT_GE(slid, 30);
}

TEST(slide_on_building, at_1e_10_is_the_independent_solver_where_friction_rises_at_once) {
  std::mt19937 random(6);
  int slid = 0;
  for (const Roof roof : all_roofs)
    for (int k = 0; k < 2; ++k) {
      OnBuilding scene = test::truth_scene(random, roof, Law::rising_at_once, 100);
      scene.tolerance = 1e-10;
      const TwoAxisTruth truth(test::as_truth(scene));
      if (truth.peak_m < 1e-5L) continue;
      ++slid;
      EXPECT_LE(test::error_of(scene.result().slip, truth), 2e-7);
    }
  EXPECT_GE(slid, 4);
}

struct Hard {
  Roof roof;
  Law law;
  unsigned seed;
};

OnBuilding scene_of(const Hard& hard) {
  std::mt19937 random(hard.seed);
  return test::truth_scene(random, hard.roof, hard.law, 160);
}

// A stop on a straight line is none where the load sets the block in motion before it would rest:
// off by 1.3e-5 at 1e-6 when it was taken.
TEST(slide_on_building, does_not_stop_a_block_that_the_load_moves_on) {
  OnBuilding scene = scene_of({Roof::uncoupled, Law::ellipse, 34});
  const TwoAxisTruth truth(test::as_truth(scene));
  for (const double tolerance : {1e-6, 1e-7, 1e-8}) {
    scene.tolerance = tolerance;
    EXPECT_LE(test::error_of(scene.result().slip, truth), 5.0 * tolerance);
  }
}

// Of 900 scenes those that were off by the most: on coupled buildings by 2e-5 to 5e-5 at 1e-6 and
// 3e-6 at 1e-8, as the velocity acted on the building as a straight line in a stiff step; 1e-4
// where the errors of many short steps added up; 4e-6 at every tolerance where a start was missed.
TEST(peak_slip_two_axes, is_the_independent_solver_where_that_is_hard) {
  for (const Hard& hard : {Hard{Roof::coupled, Law::ellipse, 69},
                           {Roof::coupled, Law::ellipse, 119},
                           {Roof::coupled, Law::ellipse, 141},
                           {Roof::coupled, Law::circle, 54},
                           {Roof::uncoupled, Law::ellipse, 12},
                           {Roof::rigid, Law::ellipse, 27}}) {
    const OnBuilding scene = scene_of(hard);
    const TwoAxisTruth truth(test::as_truth(scene));
    const BuildingGround ground = scene.ground();
    const TwoAxisScene batch{scene.building, scene.block, {scene.factor, scene.factor}};
    for (const double tolerance : {1e-6, 1e-8}) {
      BuildingPeak peak;
      peak_slip_two_axes(ground, {&batch, 1}, {&peak, 1}, tolerance);
      EXPECT_LE(test::error_of(peak, truth), 10.0 * tolerance) << hard.seed;
    }
  }
}

}  // namespace two_axis_accuracy_test
}  // namespace glissade
