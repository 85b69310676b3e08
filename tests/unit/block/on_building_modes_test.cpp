// SPDX-License-Identifier: GPL-3.0-or-later
// The full model on buildings of several modes.
#include <gtest/gtest.h>

#include "glissade/block/two_axis_lanes.hpp"
#include "unit/block/truth_scenes.hpp"

namespace glissade {
namespace on_building_modes_test {

using test::modes_of;
using test::numbers;
using test::OnBuilding;
using test::ShearBuilding;
using test::StoreyScene;
using test::three_storeys;
using test::TwoAxisTruth;

/// The first modes of a cantilever, in all some 95 % of its mass.
Modes cantilever(double period_s, double alpha, std::size_t count) {
  return Modes(cantilever_modes(period_s, alpha, count));
}

// The truth has the full matrices of mass, damping and stiffness, and no modes.
TEST(slide_on_modes, three_storeys_are_their_full_matrices) {
  int slid = 0;
  for (const bool two_axes : {false, true})
    for (const double mass_ratio : {0.0, 0.1, 0.4})  // times sum of gamma^2 / e, 4.6
      for (const bool ellipse : {false, true}) {
        StoreyScene s(slid % 2 == 0 ? 3 : 8, mass_ratio, two_axes);
        if (ellipse) s.scene.block.friction.across *= 0.7;
        if (ellipse && two_axes) s.scene.block.law = {1.2, 1.3, 100.0};
        SCOPED_TRACE(testing::Message() << two_axes << ' ' << mass_ratio << ' ' << ellipse);
        const TwoAxisTruth truth = s.truth();
        const BuildingSlip r = s.scene.result();
        EXPECT_LT(test::error_of(r.slip, truth), mass_ratio > 0.1 ? 3e-5 : 1.1e-5);
        s.scene.tolerance = 1e-10;
        EXPECT_LT(test::error_of(s.scene.result().slip, truth), 2e-7);
        slid += truth.peak_m > 1e-3L ? 1 : 0;
        // Of the building while the block slides, where that is its largest.
        for (std::size_t n = 0; n < (two_axes ? 2u : 1u); ++n) {
          const auto shear = static_cast<double>(truth.sliding_shear[n]) / standard_gravity_mps2,
                     roof_m = static_cast<double>(truth.sliding_roof_m[n]);
          EXPECT_GT(r.peak_base_shear[n], 0.998 * shear);
          EXPECT_GT(r.peak_roof_displacement_m[n], 0.998 * roof_m);
        }
      }
  EXPECT_GE(slid, 10);
}

// Sliding from the first sample to the end: what the building does is all seen at steps of sliding.
TEST(slide_on_modes, base_shear_and_roof_displacement_are_those_of_the_full_matrices) {
  for (const std::size_t count : {2u, 3u}) {
    StoreyScene s(5, 0.4, true);
    s.scene.block.friction = 0.02;
    s.scene.block.slope_rad = 0.0;
    const TwoAxisTruth truth = s.truth();
    for (Modes& axis : s.scene.building.horizontal)
      axis = Modes(std::span<const Mode>(axis.begin(), count));
    const BuildingSlip r = s.scene.result();
    const double permitted = count == 3 ? 2e-3 : 0.1;  // the third mode moves with the ground
    for (std::size_t n = 0; n < 2; ++n) {
      const auto shear = static_cast<double>(truth.sliding_shear[n]) / standard_gravity_mps2,
                 roof_m = static_cast<double>(truth.sliding_roof_m[n]);
      EXPECT_NEAR(r.peak_base_shear[n], shear, permitted * shear);
      EXPECT_NEAR(r.peak_roof_displacement_m[n], roof_m, permitted * roof_m);
    }
  }
}

// The general equations with one mass in them: a second mode takes no part.
TEST(slide_on_modes, a_mode_of_hardly_any_participation_changes_hardly_anything) {
  OnBuilding scene;
  scene.tolerance = 1e-9;
  const BuildingSlip one = scene.result();
  for (Modes& axis : scene.building.horizontal) {
    const Mode beside[] = {{axis.period_s(), 1.0, 1.0, 0.05}, {0.1, 1e-12, 1e-6, 0.05}};
    axis = Modes(beside);
  }
  const BuildingSlip two = scene.result();
  EXPECT_NEAR(two.slip.peak_displacement_m, one.slip.peak_displacement_m,
              1e-8 * one.slip.peak_displacement_m);
  EXPECT_EQ(two.slip.slip_phases, one.slip.slip_phases);
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_NEAR(two.peak_base_shear[n], one.peak_base_shear[n], 1e-5 * one.peak_base_shear[n]);
    EXPECT_NEAR(two.peak_roof_displacement_m[n], one.peak_roof_displacement_m[n],
                1e-8 * one.peak_roof_displacement_m[n]);
  }
}

// A block of m/M times the sum of gamma^2 / e up to 12 changes its roof at a stop by more than the
// load that holds it. Both kernels stop, and start again, as often as between exact events.
TEST(slide_on_modes, a_block_of_strong_coupling_starts_and_stops_as_often_as_between_exact_events) {
  for (const test::StrongCoupling& of : test::strong_couplings) {
    SCOPED_TRACE(testing::Message() << of.peak_g << ' ' << of.alpha << ' ' << of.mass_ratio);
    const OnBuilding s = of.scene();
    const test::ModesReference truth = of.truth();
    ASSERT_GT(truth.peak_m, 0.003);
    const BuildingSlip full = s.result();
    const TwoAxisScene in_lane{s.building, s.block, {}};
    BuildingPeak lane;
    peak_slip_two_axes(s.ground(), {&in_lane, 1}, {&lane, 1});
    EXPECT_FALSE(lane.failed);
    for (const SlipPeak& r : {SlipPeak(full.slip), SlipPeak(lane)}) {
      EXPECT_EQ(r.slip_phases, truth.phases);
      EXPECT_NEAR(r.peak_displacement_m, truth.peak_m, 1e-6 * truth.peak_m);
      EXPECT_NEAR(r.residual.along_m, truth.residual_m, 1e-6 * truth.peak_m);
    }
    EXPECT_NEAR(full.peak_base_shear[0], truth.base_shear, 1e-3 * truth.base_shear);
  }
}

// Of several modes base shear jumps with the friction by what the array gives to modes that are
// left out. With friction that differs by one unit in the last place, nothing else may.
TEST(slide_on_modes, base_shear_of_neighbouring_frictions_is_the_same) {
  std::mt19937 random(48);
  const auto uniform = [&](double low, double high) { return test::uniform(random, low, high); };
  for (int i = 0; i < 60; ++i) {
    OnBuilding s(static_cast<unsigned>(900 + i), 300, 9.0);
    s.dt_s = 0.01;
    s.up.clear();
    const double period_s = uniform(0.2, 1.5), alpha = uniform(0.0, 20.0),
                 damping_ratio = i % 2 == 0 ? 0.05 : 0.3;
    for (std::size_t n = 0; n < 2; ++n) {
      std::vector<Mode> modes =
          governing_modes(cantilever_modes(n == 0 ? period_s : 0.6 * period_s, alpha, 12));
      for (Mode& mode : modes) mode.damping_ratio = damping_ratio;
      s.building.horizontal[n] = Modes(modes);
    }
    s.building.mass_ratio = uniform(0.05, 1.0);
    const double mu = uniform(0.1, 0.5);
    s.block = {{mu, i % 3 == 0 ? mu : 0.7 * mu}, i % 4 == 0 ? 0.0 : 0.02, uniform(-3.1, 3.1)};
    SCOPED_TRACE(i);
    const BuildingSlip one = s.result();
    s.block.friction.across = std::nextafter(s.block.friction.across, 0.0);
    const BuildingSlip other = s.result();
    for (std::size_t n = 0; n < 2; ++n)
      EXPECT_NEAR(other.peak_base_shear[n], one.peak_base_shear[n], 1e-3 * one.peak_base_shear[n]);
    EXPECT_NEAR(other.slip.peak_displacement_m, one.slip.peak_displacement_m,
                1e-5 * one.slip.peak_displacement_m);
  }
}

OnBuilding on_cantilevers(double mass_ratio) {
  OnBuilding scene;
  scene.building = {{cantilever(0.6, 5.0, 4), cantilever(0.4, 10.0, 3)}, {}, mass_ratio};
  return scene;
}

TEST(slide_on_modes, zeros_after_the_record_change_not_a_bit) {
  OnBuilding scene = on_cantilevers(0.1);
  const std::vector<double> one = numbers(scene.result());
  for (auto* samples : {&scene.first, &scene.second, &scene.up})
    samples->insert(samples->end(), 300, 0.0);
  EXPECT_EQ(numbers(scene.result()), one);
}

TEST(slide_on_modes, a_mode_that_the_record_cannot_excite_moves_with_the_ground) {
  OnBuilding scene = on_cantilevers(0.1);
  std::vector<Mode> modes(scene.building.horizontal[0].begin(), scene.building.horizontal[0].end());
  modes.push_back({scene.dt_s / 20.0, 0.3, 0.02, 0.05});
  const std::vector<double> one = numbers(scene.result());
  scene.building.horizontal[0] = Modes(modes);
  EXPECT_EQ(numbers(scene.result()), one);
}

TEST(slide_on_modes, coupling_is_regular_as_of_a_mass_ratio_times_their_accelerance) {
  const Modes axis = cantilever(0.6, 5.0, 5);
  for (const double mu : {0.5, 2.7, 2.9, 4.0})
    for (const double ratio : {0.02, 0.1, 0.2}) {
      const Block block{{mu, mu}, 0.6, 0.3};
      EXPECT_EQ(coupling_is_regular(block, {{axis, axis}, {}, ratio}),
                coupling_is_regular(
                    block, {{Oscillator{0.5}, Oscillator{0.5}}, {}, ratio * axis.accelerance()}));
    }
}

#ifdef GLISSADE_CONTRACTS
TEST(slide_on_modes, do_not_yield) {
  OnBuilding scene = on_cantilevers(0.0);
  scene.building.yielding[1] = {2.0, 0.05};
  EXPECT_THROW(scene.result(), std::logic_error);
}
#endif

}  // namespace on_building_modes_test
}  // namespace glissade
