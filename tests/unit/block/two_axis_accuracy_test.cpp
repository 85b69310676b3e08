// SPDX-License-Identifier: GPL-3.0-or-later
// slide_on_building() and slide_two_axes() against the independent solver of tests/two_axis_truth.
#include <gtest/gtest.h>

#include "unit/block/truth_scenes.hpp"

namespace glissade {
namespace {

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
        const TwoAxisResult r = scene.result().slip;
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

}  // namespace
}  // namespace glissade
