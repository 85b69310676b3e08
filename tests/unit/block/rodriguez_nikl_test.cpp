// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/block/rodriguez_nikl.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/block/reference.hpp"

namespace glissade {
namespace rodriguez_nikl_test {

using test::made_up_record;

// Halving the substep halves the error: mean observed order over cases between P = 16 and P = 1024.
// The scheme's error jumps about from one P to the next, so the order is taken over a wide range
// and averaged over records.
TEST(rodriguez_nikl, converges_to_the_exact_solution_at_first_order) {
  double coarse = 0, fine = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const auto a = made_up_record(1000, seed, 8.0), w = made_up_record(1000, seed + 30, 3.0);
    for (const double slope_deg : {0.0, 4.0, -7.0}) {
      const Block block{0.2, slope_deg * rad_per_deg};
      const RoofAcceleration roof{0.01, a, w};
      const SlipResult exact = slide(roof, block);
      ASSERT_FALSE(exact.uplift);
      coarse +=
          std::abs(slide_rodriguez_nikl(roof, block, 16).residual.along_m - exact.residual.along_m);
      fine += std::abs(slide_rodriguez_nikl(roof, block, 1024).residual.along_m -
                       exact.residual.along_m);
    }
  }
  const double order = std::log(coarse / fine) / std::log(1024.0 / 16.0);
  EXPECT_GT(order, 0.85);
  EXPECT_LT(order, 1.15);
}

TEST(rodriguez_nikl, reproduces_the_still_plane_exactly_after_its_frictionless_first_substep) {
  // As published sgn(0) = 0, so the first substep has no friction: an error of first order in the
  // substep.
  const Block block{0.1, 7 * rad_per_deg};
  const std::vector<double> still(1001, 0.0);
  const double exact = slide({0.01, still}, block).residual.along_m;
  const double error64 = slide_rodriguez_nikl({0.01, still}, block, 64).residual.along_m - exact;
  const double error128 = slide_rodriguez_nikl({0.01, still}, block, 128).residual.along_m - exact;
  EXPECT_LT(std::abs(error64 / exact), 1e-3);
  EXPECT_NEAR(error64 / error128, 2.0, 0.01);
}

TEST(rodriguez_nikl, sticks_and_slips_as_the_paper_checks) {
  const double slope = 0.5 * rad_per_deg;
  const std::vector<double> still(1000, 0.0);
  EXPECT_GT(
      slide_rodriguez_nikl({0.01, still}, {0.999 * std::tan(slope), slope}, 64).peak_displacement_m,
      0.0);
  EXPECT_LT(
      slide_rodriguez_nikl({0.01, still}, {1.001 * std::tan(slope), slope}, 64).peak_displacement_m,
      1e-12);
}

}  // namespace rodriguez_nikl_test
}  // namespace glissade
