// SPDX-License-Identifier: GPL-3.0-or-later
// Crossings by both solvers on the standard scenes of one component of the built-in suite.
#include <gtest/gtest.h>

#include "glissade/block/peak_slip.hpp"
#include "standard_scenes.hpp"
#include "unit/block/crossings.hpp"

namespace glissade {
namespace crossing_standard_test {

// On the same samples both are exact: what differs is rounding.
TEST(crossing_on_standard_scenes, is_the_same_by_either_solver) {
  const auto all = test::built_in_scenes(GLISSADE_SOURCE_DIR "/suites", 1);
  int compared = 0, beyond = 0;
  test::for_each_roof(
      all.components, all.scenes,
      [&](const test::RoofInput& input, std::span<const test::StandardScene> here) {
        const RoofMotion motion = roof_motion(input.ground, input.building, input.follow);
        for (const test::StandardScene& scene : here) {
          const RoofAcceleration roof = scene.excitation(all.components, motion);
          const double peak_m = slide(roof, scene.block).peak_displacement_m;
          if (peak_m < 1e-6) continue;
          SCOPED_TRACE(scene.describe(all.components));
          const std::vector<double> thresholds = test::thresholds_of(peak_m);
          std::vector<Crossing> scalar(thresholds.size()), kernel = scalar;
          slide(roof, scene.block, thresholds, scalar);
          peak_slip({roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2}, scene.block,
                    {roof.horizontal_factor, roof.vertical_factor}, thresholds, kernel);
          for (std::size_t i = 0; i < thresholds.size(); ++i) {
            if (thresholds[i] == peak_m) continue;  // a matter of the last bit
            if (!scalar[i].happens()) {
              EXPECT_FALSE(kernel[i].happens());
              ++beyond;
              continue;
            }
            test::expect_alike(kernel[i], scalar[i], 1e-11 * peak_m);
            ++compared;
          }
        }
      });
  EXPECT_GT(compared, 2000);
  EXPECT_GT(beyond, 200);
}

}  // namespace crossing_standard_test
}  // namespace glissade
