// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/run/scene.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "glissade/study/run/execute.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::made_up_record;

SlipResult slide_on(const Building& building, const GroundMotion& ground, const Block& block,
                    double factor, RoofMotionOptions options) {
  const RoofMotion roof = roof_motion(ground, building, options);
  return slide(excitation_of(block, roof, {factor, factor}), block);
}

TEST(scene, follows_the_ring_down_far_enough_for_a_block_still_on_its_way) {
  // The record stops at its peak, so building and block are in full motion at its end.
  double worst = 0;
  int moved_after = 0;
  for (unsigned seed = 1; seed <= 12; ++seed) {
    auto a = made_up_record(400, seed, 4.0);
    a.resize(static_cast<std::size_t>(std::max_element(a.begin(), a.end()) - a.begin()) + 1);
    const GroundMotion ground{0.01, a};
    for (const double period : {0.3, 1.0}) {
      for (const double slope_deg : {0.0, 4.0}) {
        const Building building{.horizontal = {period, 0.05}};
        const Block block{.friction = 0.2, .slope_rad = slope_deg * rad_per_deg};
        RoofMotionOptions longer = follow_roof({&block, 1}, 1.5);
        const double residual = slide_on(building, ground, block, 1.5, longer).residual.along_m;
        const double cut = slide_on(building, ground, block, 1.5, {}).residual.along_m;
        longer.quiet_horizontal_mps2 *= 1e-3;  // follow it a hundred times deeper
        const SlipResult all = slide_on(building, ground, block, 1.5, longer);
        if (all.peak_displacement_m < 1e-3) continue;
        worst =
            std::max(worst, std::abs(residual - all.residual.along_m) / all.peak_displacement_m);
        moved_after += std::abs(cut - residual) > 1e-3 * all.peak_displacement_m ? 1 : 0;
      }
    }
  }
  EXPECT_GT(moved_after, 10);  // the ring-down matters here
  EXPECT_LT(worst, 1e-4);
}

TEST(scene, ends_a_free_slider_with_the_record) {
  const auto a = made_up_record(300, 3, 2.0);
  const GroundMotion ground{0.01, a};
  const Building building{.horizontal = {0.5, 0.05}};
  const std::vector<Block> blocks{{.friction = 0.1, .slope_rad = 10 * rad_per_deg},
                                  {.friction = 0.5}};
  const RoofMotion roof = roof_motion(ground, building, follow_roof(blocks, 1.0));
  ASSERT_GT(roof.horizontal_mps2.size(), roof.record_samples);  // the other block needs a ring-down
  EXPECT_EQ(excitation_of(blocks[0], roof, {}).horizontal_mps2.size(), roof.record_samples);
  EXPECT_EQ(excitation_of(blocks[1], roof, {}).horizontal_mps2.size(), roof.horizontal_mps2.size());
  EXPECT_NEAR(static_cast<double>(roof.record_samples - 1) * roof.dt_s, 2.99, 1e-9);
}

// What the straight line between roof samples leaves: against a roof sampled twelve times as
// finely.
TEST(scene, samples_a_building_s_roof_finely_enough_for_three_parts_in_a_thousand_of_slip) {
  double worst = 0, sum = 0;
  int count = 0;
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const auto a = made_up_record(800, seed, 6.0);
    const GroundMotion ground{0.01, a};
    for (const double period : {0.2, 0.5, 1.0}) {
      const Building building{.horizontal = {period, 0.05}};
      const Block block{.friction = 0.4, .slope_rad = 1.19 * rad_per_deg};
      RoofMotionOptions options = follow_roof({&block, 1}, 1.0);
      const double standard = slide_on(building, ground, block, 1.0, options).peak_displacement_m;
      options.steps_per_period *= 12;
      const double fine = slide_on(building, ground, block, 1.0, options).peak_displacement_m;
      if (fine < 0.01) continue;
      worst = std::max(worst, std::abs(standard / fine - 1));
      sum += std::abs(standard / fine - 1);
      ++count;
    }
  }
  EXPECT_GT(count, 10);
  EXPECT_LT(worst, 3e-3);
  RecordProperty("largest", std::to_string(worst));
  RecordProperty("mean", std::to_string(sum / count));
}

TEST(scene, leaves_the_samples_untouched_by_the_design_friction_beside_them) {
  StudyConfig config = test::small_config();
  // Design friction 0.02: slides freely on 4 degrees.
  config.quantities.at("friction", "mu") = test::drawn(TruncatedNormal{0.2, 0.09, 0.0, INFINITY});
  const Results both = test::run(test::small_plan(config));
  config.friction.values = {FrictionValue::as_drawn};
  const Results one = test::run(test::small_plan(config));
  ASSERT_EQ(both.cases.size(), 2 * one.cases.size());
  double worst = 0;
  test::for_each_history(one.histories, [&](std::size_t record, std::size_t c, std::size_t level) {
    const double with = both.histories.displacement_m(record, c, level),
                 without = one.histories.displacement_m(record, c, level);
    worst = std::max(worst, std::abs(with - without) / std::max(without, 1e-3));
  });
  EXPECT_LT(worst, 1e-4);  // the weaker friction only needs a longer ring-down
}

}  // namespace
}  // namespace glissade
