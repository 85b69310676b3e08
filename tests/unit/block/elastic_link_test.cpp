// SPDX-License-Identifier: GPL-3.0-or-later
#include "elastic_link/elastic_link.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "unit/block/reference.hpp"

namespace glissade::test {
namespace elastic_link_test {

constexpr double g = standard_gravity_mps2;

double omega(const ElasticLink& link, const Block& block) {
  return explicit_step(link, block) / link.longest_substep_s;
}

/// Flat roof whose acceleration jumps to `level_mps2` and stays for `seconds`, at 0.1 ms.
std::vector<double> jump(double level_mps2, double seconds) {
  std::vector<double> a(static_cast<std::size_t>(seconds / 1e-4), level_mps2);
  a.front() = 0.0;
  return a;
}

// omega^2 = k g / W with W = 1 N: sqrt(1e5 N/m x 9.80665 m/s2 / 1 N) = 990.3 /s.
TEST(elastic_link, of_the_paper_steps_by_half_the_stable_step) {
  EXPECT_NEAR(explicit_step({}, {}), 0.9903, 1e-4);
  EXPECT_GT(explicit_step({.stiffness_npmm = 1000.0}, {}), 2.0);
}

// A spring that meets a sudden force overshoots to twice its static force.
TEST(elastic_link, does_not_slip_under_a_jump_to_less_than_half_the_friction) {
  const auto a = jump(0.49 * 0.3 * g, 0.1);
  EXPECT_LT(std::abs(slide_on_elastic_link({1e-4, a}, {.friction = 0.3}, {}).peak_displacement_m),
            1e-15);
}

// A jump to p mu g, 1/2 < p < 1: the spring reaches mu g at cos(omega t) = 1 - 1/p with the
// velocity v = (p mu g / omega) sin(omega t), and slides v^2 / (2 (1 - p) mu g). The rigid block
// does not move. Where the motion ends the same spring is let go from at most mu g: it holds.
TEST(elastic_link, slips_where_the_rigid_block_holds_by_its_springs_overshoot) {
  const Block block{.friction = 0.3};
  const ElasticLink link{.longest_substep_s = 1e-5};
  for (const double p : {0.6, 0.7, 0.8}) {
    const auto a = jump(p * 0.3 * g, 0.1);
    const double cosine = 1.0 - 1.0 / p;
    const double velocity = p * 0.3 * g / omega(link, block) * std::sqrt(1.0 - cosine * cosine);
    const double slip = velocity * velocity / (2.0 * (1.0 - p) * 0.3 * g);
    const LinkSlip r = slide_on_elastic_link({1e-4, a}, block, link);
    EXPECT_NEAR(r.peak_displacement_m / slip, 1.0, 0.01) << "p = " << p;
    EXPECT_EQ(slide({1e-4, a}, block).peak_displacement_m, 0.0);
  }
}

TEST(elastic_link, rests_on_a_still_slope_from_its_static_equilibrium) {
  const std::vector<double> still(101, 0.0);
  for (const FrictionLaw law : {FrictionLaw::elastic_plastic, FrictionLaw::wen})
    for (const double slope_deg : {-4.0, 4.0, 5.5}) {
      const LinkSlip r =
          slide_on_elastic_link({0.01, still}, {0.1, slope_deg * rad_per_deg}, {.law = law});
      EXPECT_LT(r.peak_displacement_m, 1e-12) << slope_deg;
    }
}

TEST(elastic_link, is_mirrored_with_motion_and_slope) {
  const auto a = made_up_record(800, 3, 6.0);
  const Block block{0.2, 4.0 * rad_per_deg}, mirrored{0.2, -4.0 * rad_per_deg};
  for (const FrictionLaw law : {FrictionLaw::elastic_plastic, FrictionLaw::wen}) {
    const LinkSlip r = slide_on_elastic_link({0.005, a}, block, {.law = law});
    const LinkSlip m = slide_on_elastic_link({0.005, a, {}, -1.0}, mirrored, {.law = law});
    EXPECT_EQ(r.peak_displacement_m, m.peak_displacement_m);
    EXPECT_EQ(r.residual.along_m, m.residual.along_m);
  }
}

// Its velocity is off by at most 2 mu g / omega: the swing of a spring within +-mu N. The springs'
// own deflection and, with the rounded knee, creep down the slope go with 1 / omega^2.
TEST(elastic_link, converges_to_the_rigid_block_at_least_as_one_over_omega) {
  for (const FrictionLaw law : {FrictionLaw::elastic_plastic, FrictionLaw::wen}) {
    std::vector<double> mean_error;
    for (const double stiffness_npmm : {100.0, 10000.0}) {
      const ElasticLink link{stiffness_npmm, 0.005 / std::sqrt(stiffness_npmm), law};
      double sum = 0.0;
      for (unsigned seed = 1; seed <= 8; ++seed) {
        const auto a = made_up_record(800, seed, 8.0);
        for (const double slope_deg : {0.0, 4.0}) {
          const Block block{0.2, slope_deg * rad_per_deg};
          const SlipResult exact = slide({0.005, a}, block);
          const double error =
              std::abs(slide_on_elastic_link({0.005, a}, block, link).residual.along_m -
                       exact.residual.along_m);
          EXPECT_LT(error, 2.0 * 0.2 * g / omega(link, block) * exact.slip_duration_s);
          sum += error;
        }
      }
      mean_error.push_back(sum);
    }
    const double order = std::log(mean_error[0] / mean_error[1]) / std::log(10.0);  // in omega
    EXPECT_GT(order, 0.8);
    EXPECT_LT(order, 2.0);
  }
}

}  // namespace elastic_link_test
}  // namespace glissade::test
