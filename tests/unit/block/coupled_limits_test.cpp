// SPDX-License-Identifier: GPL-3.0-or-later
// What the coupled block becomes where array or building is of one kind: nothing, rigid, stuck.
#include <gtest/gtest.h>

#include <cmath>

#include "glissade/block/coupled.hpp"
#include "glissade/block/peak_slip.hpp"
#include "unit/block/reference.hpp"

namespace glissade {
namespace coupled_limits_test {

using test::made_up_record;

constexpr double dt_s = 0.01;
const auto a = made_up_record(600, 1, 7.0), w = made_up_record(600, 2, 3.0);
const GroundMotion ground{dt_s, a, w};
const Block block{.friction = 0.2, .slope_rad = 0.05};

TEST(coupled_limits, without_mass_it_is_the_uncoupled_block) {
  for (const double period_s : {0.1, 0.4, 1.0}) {
    const CoupledResult r = slide_coupled(ground, {}, {{period_s, 0.05}, 0.0}, block);
    // The reference samples the roof: off by (2 pi / n)^2 / 8 of its amplitude.
    const RoofMotion roof = roof_motion(ground, {.horizontal = {period_s, 0.05}},
                                        {.quiet_horizontal_mps2 = 0.2,
                                         .quiet_vertical_mps2 = 0.2,
                                         .settle_deceleration_mps2 = 0.2,
                                         .steps_per_period = 8000});
    const SlipResult uncoupled =
        slide({roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2}, block);
    ASSERT_GT(r.slip.peak_displacement_m, 1e-3);
    EXPECT_NEAR(r.slip.peak_displacement_m, uncoupled.peak_displacement_m,
                3e-6 * uncoupled.peak_displacement_m);
    EXPECT_NEAR(r.slip.residual.along_m, uncoupled.residual.along_m,
                3e-6 * uncoupled.peak_displacement_m);
    EXPECT_NEAR(r.peak_roof_acceleration_mps2, roof.peak_horizontal_mps2,
                3e-6 * roof.peak_horizontal_mps2);
    // The kernel's quintic between nodes: 1e-6.
    const RoofTable table = tabulate_roof(ground, {.horizontal = {period_s, 0.05}},
                                          {.quiet_horizontal_mps2 = 0.2,
                                           .quiet_vertical_mps2 = 0.2,
                                           .settle_deceleration_mps2 = 0.2});
    EXPECT_NEAR(r.slip.peak_displacement_m, peak_slip(table, block).peak_displacement_m,
                1e-6 * uncoupled.peak_displacement_m);
  }
}

TEST(coupled_limits, a_vanishing_mass_gives_the_uncoupled_slip) {
  const CoupledResult none = slide_coupled(ground, {}, {{0.4, 0.05}, 0.0}, block);
  const CoupledResult little = slide_coupled(ground, {}, {{0.4, 0.05}, 1e-12}, block);
  EXPECT_NEAR(little.slip.peak_displacement_m, none.slip.peak_displacement_m,
              1e-10 * none.slip.peak_displacement_m);
  EXPECT_NEAR(little.slip.residual.along_m, none.slip.residual.along_m,
              1e-10 * none.slip.peak_displacement_m);
  EXPECT_EQ(little.slip.slip_phases, none.slip.slip_phases);
}

TEST(coupled_limits, a_rigid_building_is_not_affected_by_the_array) {
  for (const double slope_rad : {0.0, 0.05, -0.05, 0.3}) {
    for (const double vertical_factor : {0.0, 1.0, 6.0}) {
      const Block b{.friction = 0.2, .slope_rad = slope_rad};
      const SlipResult alone = slide({dt_s, a, w, 1.5, vertical_factor}, b);
      const SlipResult r =
          slide_coupled(ground, {1.5, vertical_factor}, {{0.0, 0.05}, 0.3}, b).slip;
      ASSERT_GT(alone.peak_displacement_m, 1e-3);
      const double close = 1e-12 * alone.peak_displacement_m;
      EXPECT_NEAR(r.peak_downslope_m, alone.peak_downslope_m, close);
      EXPECT_NEAR(r.peak_upslope_m, alone.peak_upslope_m, close);
      EXPECT_NEAR(r.residual.along_m, alone.residual.along_m, close);
      EXPECT_NEAR(r.peak_velocity_mps, alone.peak_velocity_mps, 1e-12);
      EXPECT_NEAR(r.path_length_m, alone.path_length_m, close);
      EXPECT_NEAR(r.slip_duration_s, alone.slip_duration_s, 1e-11);
      EXPECT_EQ(r.slip_phases, alone.slip_phases);
      EXPECT_EQ(r.uplift, alone.uplift);
      EXPECT_EQ(r.free_sliding, alone.free_sliding);
    }
  }
}

// An array that never moves makes the building heavier by 1 + r and longer in period by its root.
TEST(coupled_limits, an_array_that_does_not_slide_is_an_anchored_one) {
  const double r = 0.25, root = std::sqrt(1.0 + r);
  const Block sticking{.friction = 10.0, .slope_rad = 0.05};
  const CoupledResult stuck = slide_coupled(ground, {}, {{0.5, 0.05}, r}, sticking);
  const CoupledResult heavier =
      slide_coupled(ground, {}, {{0.5 * root, 0.05 / root}, 0.0}, sticking);
  EXPECT_EQ(stuck.slip.slip_phases, 0u);
  EXPECT_NEAR(stuck.peak_base_shear, (1.0 + r) * heavier.peak_base_shear, 1e-12);
  EXPECT_NEAR(stuck.peak_roof_displacement_m, heavier.peak_roof_displacement_m, 1e-12);
  EXPECT_NEAR(stuck.peak_roof_acceleration_mps2, heavier.peak_roof_acceleration_mps2, 1e-11);
  // V/(M g) of an oscillator without array is its absolute acceleration over g.
  EXPECT_NEAR(heavier.peak_base_shear, heavier.peak_roof_acceleration_mps2 / standard_gravity_mps2,
              1e-12);
}

TEST(coupled_limits, a_level_array_without_friction_leaves_the_building_alone) {
  const Block smooth{.friction = 0.0, .slope_rad = 0.0};
  const CoupledResult with = slide_coupled(ground, {}, {{0.5, 0.05}, 0.4}, smooth);
  const CoupledResult without =
      slide_coupled(ground, {}, {{0.5, 0.05}, 0.0}, {.friction = 10.0, .slope_rad = 0.0});
  EXPECT_NEAR(with.peak_base_shear, without.peak_base_shear, 1e-12);
  EXPECT_NEAR(with.peak_roof_displacement_m, without.peak_roof_displacement_m, 1e-12);
  EXPECT_EQ(with.energy.friction_m2ps2, 0.0);
}

TEST(coupled_limits, mirrored_scenes_mirror) {
  std::vector<double> mirrored(a);
  for (double& value : mirrored) value = -value;
  std::vector<CoupledPoint> one, other;
  const CoupledBuilding building{{0.3, 0.05}, 0.2};
  const CoupledResult r = slide_coupled(ground, {}, building, block, one);
  const CoupledResult m = slide_coupled({dt_s, mirrored, w}, {}, building,
                                        {.friction = 0.2, .slope_rad = -0.05}, other);
  EXPECT_EQ(r.slip.peak_displacement_m, m.slip.peak_displacement_m);
  EXPECT_EQ(r.peak_base_shear, m.peak_base_shear);
  ASSERT_EQ(one.size(), other.size());
  for (std::size_t i = 0; i < one.size(); ++i) {
    ASSERT_EQ(one[i].displacement_m, other[i].displacement_m);
    ASSERT_EQ(one[i].roof_acceleration_mps2, -other[i].roof_acceleration_mps2 + 0.0);
  }
}

TEST(coupled_limits, zeros_after_the_record_change_nothing) {
  std::vector<double> padded(a), padded_w(w);
  padded.resize(900, 0.0);
  padded_w.resize(900, 0.0);
  const CoupledBuilding building{{0.3, 0.02}, 0.2};
  const CoupledResult r = slide_coupled(ground, {}, building, block),
                      p = slide_coupled({dt_s, padded, padded_w}, {}, building, block);
  EXPECT_EQ(r.slip.peak_displacement_m, p.slip.peak_displacement_m);
  EXPECT_EQ(r.slip.residual.along_m, p.slip.residual.along_m);
  EXPECT_EQ(r.energy.input_m2ps2, p.energy.input_m2ps2);
}

// g, a and w times 4: slip times 4, to the last bit.
TEST(coupled_limits, similitude_holds_to_the_last_bit) {
  Block heavy = block;
  heavy.gravity_mps2 *= 4.0;
  const CoupledBuilding building{{0.3, 0.02}, 0.2};
  const CoupledResult r = slide_coupled(ground, {}, building, block),
                      s = slide_coupled(ground, {4.0, 4.0}, building, heavy);
  EXPECT_EQ(4.0 * r.slip.peak_displacement_m, s.slip.peak_displacement_m);
  EXPECT_EQ(4.0 * r.slip.residual.along_m, s.slip.residual.along_m);
  EXPECT_EQ(r.peak_base_shear, s.peak_base_shear);
}

// Round numbers in which the normal force vanishes together with its cause: contact alone would
// make the block lift, and lifted it would land at once.
TEST(coupled_limits, a_block_on_the_verge_of_lifting_does_not_halt_the_walk) {
  for (const double mass_ratio : {0.25, 1.0}) {
    const std::vector<double> push{1.0, -2.0, -2.0}, fall(3, -16.0);
    const Block b{.friction = 0.125, .slope_rad = std::atan(0.125), .gravity_mps2 = 8.0};
    const CoupledResult r =
        slide_coupled({0.0625, push, fall}, {}, {{0.125, 0.2}, mass_ratio, {}}, b);
    EXPECT_TRUE(r.slip.uplift);
    const CoupledEnergy& e = r.energy;
    EXPECT_NEAR(e.input_m2ps2 + e.gravity_m2ps2,
                e.kinetic_m2ps2 + e.strain_m2ps2 + e.damped_m2ps2 + e.friction_m2ps2,
                1e-10 * std::abs(e.input_m2ps2));
  }
}

TEST(coupled_limits, coupling_is_regular_up_to_the_friction_that_locks) {
  // sqrt(1 + mu^2) = 1 + 2/r at the slope that is worst, half the friction angle.
  for (const double r : {0.1, 0.5, 1.0}) {
    const double mu = std::sqrt((1.0 + 2.0 / r) * (1.0 + 2.0 / r) - 1.0);
    const double worst_rad = 0.5 * std::atan(mu);
    EXPECT_TRUE(coupling_is_regular({.friction = 0.999 * mu, .slope_rad = worst_rad}, r));
    EXPECT_FALSE(coupling_is_regular({.friction = 1.001 * mu, .slope_rad = worst_rad}, r));
    for (double slope_rad = -1.5; slope_rad < 1.5; slope_rad += 0.01)
      EXPECT_TRUE(coupling_is_regular({.friction = 0.999 * mu, .slope_rad = slope_rad}, r));
  }
}

}  // namespace coupled_limits_test
}  // namespace glissade
