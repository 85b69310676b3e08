// SPDX-License-Identifier: GPL-3.0-or-later
// slide_two_axis against another method, and against itself at a hundredth of its tolerance.
#include <gtest/gtest.h>

#include <algorithm>

#include "unit/block/reference.hpp"
#include "unit/block/two_axis_reference.hpp"

namespace glissade {
namespace {

using test::made_up_record;
using test::TwoAxisReference;

/// Rough motions: noise of 200 Hz, one sample hardly like the last.
struct Rough {
  std::vector<double> first, second, up;
  explicit Rough(unsigned seed, double peak_mps2, std::size_t n = 1200)
      : first(made_up_record(n, seed, peak_mps2)),
        second(made_up_record(n, seed + 50, 0.8 * peak_mps2)),
        up(made_up_record(n, seed + 100, 3.0)) {}
  TwoAxisAcceleration roof() const { return {0.005, {first, second}, up}; }
};

/// Largest difference in any displacement, relative to the peak.
double difference(const TwoAxisResult& a, const TwoAxisResult& b) {
  return std::max({std::abs(a.peak_displacement_m - b.peak_displacement_m),
                   std::abs(a.peak_by_axis.along_m - b.peak_by_axis.along_m),
                   std::abs(a.peak_by_axis.across_m - b.peak_by_axis.across_m),
                   std::abs(a.residual.along_m - b.residual.along_m),
                   std::abs(a.residual.across_m - b.residual.across_m)}) /
         b.peak_displacement_m;
}

// The reference's own error is what is seen: 5e-5 of the peak with 400 steps an interval, 1e-5 with
// 1,600, 1.4e-6 with 3,200.
TEST(slide_two_axis, agrees_with_the_implicit_midpoint_rule_on_small_steps) {
  for (const unsigned seed : {1u, 2u}) {
    for (const auto& mu : {EllipticFriction{0.3, 0.3}, EllipticFriction{0.3, 0.2}}) {
      for (const double slope_deg : {0.0, 1.19, 7.0}) {
        const Rough motion(seed, 10.0, 400);
        const TwoAxisBlock block{mu, slope_deg * rad_per_deg, 0.4};
        const TwoAxisResult r = slide_two_axis(motion.roof(), block);
        const TwoAxisReference other(motion.roof(), block, 1600);
        const double tolerance_m = 2e-5 * other.peak_m;
        EXPECT_NEAR(r.peak_displacement_m, other.peak_m, tolerance_m);
        EXPECT_NEAR(r.peak_by_axis.along_m, other.peak_along_m, tolerance_m);
        EXPECT_NEAR(r.peak_by_axis.across_m, other.peak_across_m, tolerance_m);
        EXPECT_NEAR(r.residual.along_m, other.along_m, tolerance_m);
        EXPECT_NEAR(r.residual.across_m, other.across_m, tolerance_m);
        EXPECT_NEAR(r.path_length_m, other.path_length_m, 2e-5 * other.path_length_m);
        EXPECT_NEAR(r.peak_velocity_mps, other.peak_velocity_mps, 1e-3 * other.peak_velocity_mps);
        EXPECT_GT(other.peak_m, 1e-3);
      }
    }
  }
}

// Where a motion is as rough as these and slips little, each of many short phases adds its error.
TEST(slide_two_axis, converges_with_its_tolerance) {
  for (const bool is_circle : {true, false}) {
    for (const double tolerance : {1e-4, 1e-5, 1e-6}) {
      std::vector<double> errors;
      for (unsigned seed = 1; seed <= 4; ++seed) {
        for (const double mu : {0.1, 0.3}) {
          for (const double slope_deg : {0.0, 4.0}) {
            const Rough motion(seed, 10.0);
            const TwoAxisBlock block{{mu, is_circle ? mu : 0.7 * mu}, slope_deg * rad_per_deg};
            errors.push_back(difference(slide_two_axis(motion.roof(), block, tolerance),
                                        slide_two_axis(motion.roof(), block, 0.01 * tolerance)));
          }
        }
      }
      std::sort(errors.begin(), errors.end());
      EXPECT_LE(errors[errors.size() / 2], 3.0 * tolerance);
      EXPECT_LE(errors.back(), 30.0 * tolerance);
    }
  }
}

}  // namespace
}  // namespace glissade
