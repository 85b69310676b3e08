// SPDX-License-Identifier: GPL-3.0-or-later
// Roofs of extreme buildings: the kernel over an oscillator's tables. Ordinary ones are held
// against the closed form in peak_slip_building_test.cpp.
#include <gtest/gtest.h>

#include <cmath>

#include "glissade/block/peak_slip.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace stress_roof_test {

using test::made_up_record;

const Block block{.friction = 0.2, .slope_rad = 0.05};
constexpr double dt_s = 0.01;
const std::vector<double> dampings = {0.0, 1e-12, 0.05, 0.7, 1 - 1e-9};

RoofTable roof_of(double period_s, double damping) {
  static const auto a = made_up_record(400, 1, 8.0), w = made_up_record(400, 2, 5.0);
  const Oscillator oscillator{period_s, damping};
  return tabulate_roof({dt_s, a, w}, {oscillator, oscillator},
                       {.quiet_horizontal_mps2 = 1.4,
                        .quiet_vertical_mps2 = 0.2,
                        .settle_deceleration_mps2 = 1.4,
                        .longest_ring_down_s = 10.0});
}

TEST(stress_on_a_building, any_period_and_damping_is_finite_with_bounded_work) {
  int slipped = 0;
  for (const double period_s : {0.0, 1e-12, 1e-6, 1e-4, 1e-3, 0.0099, 0.01, 0.3, 40.0, 1e3, 1e9}) {
    for (const double damping : dampings) {
      SCOPED_TRACE(std::to_string(period_s) + " s, " + std::to_string(damping));
      const RoofTable roof = roof_of(period_s, damping);
      const SlipPeak r = peak_slip(roof, block),
                     looking = peak_slip(roof, block, {}, EventSearch::every_interval);
      for (const double value : {r.peak_displacement_m, r.residual.along_m, r.peak_downslope_m,
                                 r.peak_upslope_m, r.slip_duration_s}) {
        EXPECT_TRUE(std::isfinite(value));
      }
      EXPECT_EQ(r.peak_displacement_m, std::max(r.peak_downslope_m, r.peak_upslope_m));
      EXPECT_LE(std::abs(r.residual.along_m), r.peak_displacement_m);
      // An interval of the table is smooth: each direction starts at most twice in one.
      EXPECT_LE(r.slip_phases, 4 * (roof.horizontal->end + 1));
      EXPECT_EQ(r.peak_displacement_m, looking.peak_displacement_m);
      EXPECT_EQ(r.residual.along_m, looking.residual.along_m);
      EXPECT_EQ(r.slip_phases, looking.slip_phases);
      slipped += r.slip_phases > 0 ? 1 : 0;
    }
  }
  EXPECT_GT(slipped, 35);
}

TEST(stress_on_a_building, a_building_much_stiffer_than_a_step_is_rigid) {
  const SlipPeak rigid = peak_slip(roof_of(0.0, 0.05), block);
  EXPECT_GT(rigid.peak_displacement_m, 0.01);
  for (const double damping : dampings) {
    for (const double period_s : {1e-12, 1e-9, 1e-6})
      EXPECT_EQ(peak_slip(roof_of(period_s, damping), block).peak_displacement_m,
                rigid.peak_displacement_m);
    // A twentieth of a step: rings at each kink of the record by a share of T/(2 pi dt) = 1 %.
    EXPECT_NEAR(peak_slip(roof_of(5e-4, damping), block).peak_displacement_m,
                rigid.peak_displacement_m, 0.02 * rigid.peak_displacement_m);
  }
}

// Its roof stays where it was while the ground moves: (2 pi/T)^2 u + 2 zeta (2 pi/T) v is far below
// yield for the metres and metres a second a record has.
TEST(stress_on_a_building, a_building_much_slower_than_the_record_isolates) {
  for (const double period_s : {1e3, 1e6, 1e9}) {
    for (const double damping : dampings) {
      const SlipPeak r = peak_slip(roof_of(period_s, damping), block);
      EXPECT_EQ(r.peak_displacement_m, 0.0) << period_s;
      EXPECT_EQ(r.slip_phases, 0u) << period_s;
    }
  }
}

}  // namespace stress_roof_test
}  // namespace glissade
