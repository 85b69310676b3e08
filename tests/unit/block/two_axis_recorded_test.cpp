// SPDX-License-Identifier: GPL-3.0-or-later
// slide_on_building() and peak_slip_two_axes() on recorded motions, against the independent solver.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "glissade/block/two_axis_lanes.hpp"
#include "glissade/io/record_file.hpp"
#include "unit/block/modes_reference.hpp"
#include "unit/block/truth_scenes.hpp"

namespace glissade {
namespace two_axis_recorded_test {

std::filesystem::path recorded() {
  const char* chosen = std::getenv("GLISSADE_RECORDS");
  return chosen != nullptr ? chosen : GLISSADE_SOURCE_DIR "/../shared/records";
}

/// Both horizontal components of a record of the FEMA P-695 far-field set.
struct Pair {
  double dt_s = 0.0;
  std::vector<double> first, second;

  Pair(const std::string& one, const std::string& other) {
    const auto folder = recorded() / "fema_p695_far_field";
    const auto x = read_record(folder / one), y = read_record(folder / other);
    const std::size_t n = std::min(x.acceleration_mps2.size(), y.acceleration_mps2.size());
    dt_s = x.dt_s;
    first.assign(x.acceleration_mps2.begin(), x.acceleration_mps2.begin() + n);
    second.assign(y.acceleration_mps2.begin(), y.acceleration_mps2.begin() + n);
  }
  static bool exists() { return std::filesystem::exists(recorded() / "fema_p695_far_field"); }
  double pga_mps2() const {
    double pga = 0.0;
    for (const auto* samples : {&first, &second})
      for (const double a : *samples) pga = std::max(pga, std::abs(a));
    return pga;
  }
  BuildingGround ground() const {
    return {
        {std::make_shared<GroundTable>(dt_s, first), std::make_shared<GroundTable>(dt_s, second)},
        nullptr};
  }
};

// Histories of study 02, with the vertical: an implicit step of the lanes became shorter and
// shorter, for seconds to minutes. After some ten thousand steps they are for the scalar scheme.
TEST(two_axes_recorded, a_history_whose_steps_become_shorter_and_shorter_is_the_scalar_one) {
  if (!Pair::exists()) GTEST_SKIP() << recorded() << " has no fema_p695_far_field";
  struct Case {
    const char *first, *second, *up;
    double period_s, friction, factor;
  };
  for (const Case& c :
       {Case{"RSN1602_DUZCE_BOL090.AT2", "RSN1602_DUZCE_BOL000.AT2", "RSN1602_DUZCE_BOL-UP.AT2",
             0.2775096305878833, 0.53521791929470863, 1.763596354046663},
        Case{"RSN68_SFERN_PEL090.AT2", "RSN68_SFERN_PEL180.AT2", "RSN68_SFERN_PEL-UP.AT2",
             1.2759128766832872, 0.4, 1.5478263593995409}}) {
    const Pair motion(c.first, c.second);
    const auto up = read_record(recorded() / "fema_p695_far_field" / c.up);
    BuildingGround ground = motion.ground();
    ground.vertical = std::make_shared<MotionTable>(
        tabulate_rigid(std::make_shared<GroundTable>(motion.dt_s, up.acceleration_mps2)));
    const Oscillator axis{c.period_s, 0.05};
    const TwoAxisScene scene{{.horizontal = {axis, axis}, .yielding = {}, .mass_ratio = 0.05},
                             {{c.friction, c.friction}, 1.19 * rad_per_deg, 0.0},
                             {c.factor, c.factor}};
    BuildingPeak peak;
    peak_slip_two_axes(ground, {&scene, 1}, {&peak, 1});
    const double scalar_m = slide_on_building(ground, scene.factors, scene.building, scene.block)
                                .slip.peak_displacement_m;
    EXPECT_GT(scalar_m, 0.05);
    EXPECT_EQ(peak.peak_displacement_m, scalar_m);
  }
}

// RSN 68, T 1 s, m/M 0.05, mu 0.1 by 0.08: 5e-6 off at 1e-6, 1e-7 and 1e-8, because a block that
// the load moved on was taken to stop, at 3 um/s.
TEST(two_axes_recorded, is_the_independent_solver_where_the_load_is_near_friction) {
  if (!Pair::exists()) GTEST_SKIP() << recorded() << " has no fema_p695_far_field";
  const Pair motion("RSN68_SFERN_PEL090.AT2", "RSN68_SFERN_PEL180.AT2");
  const BuildingGround ground = motion.ground();
  const BiaxialBuilding building{.horizontal = {Oscillator{1.0, 0.05}, Oscillator{0.8, 0.05}},
                                 .yielding = {},
                                 .mass_ratio = 0.05};
  struct Case {
    double pga_g, azimuth_deg;
  };
  for (const Case& c : {Case{0.2, 90.0}, {0.5, 0.0}}) {
    const double factor = c.pga_g * standard_gravity_mps2 / motion.pga_mps2();
    const TwoAxisScene scene{
        building, {{0.1, 0.08}, 0.0, c.azimuth_deg * rad_per_deg}, {factor, 0.0}};
    const test::TwoAxisTruth truth(
        {motion.dt_s, {motion.first, motion.second}, {}, scene.factors, building, scene.block});
    for (const double tolerance : {1e-6, 1e-8}) {
      const BuildingSlip r =
          slide_on_building(ground, scene.factors, building, scene.block, tolerance);
      EXPECT_LE(test::error_of(r.slip, truth), 2.0 * tolerance) << c.pga_g;
      BuildingPeak peak;
      peak_slip_two_axes(ground, {&scene, 1}, {&peak, 1}, tolerance);
      EXPECT_LE(test::error_of(peak, truth), 2.0 * tolerance) << c.pga_g;
    }
  }
}

// RSN 1602, T 0.5 s, m/M 0.05, mu 0.3: 1.4e-5 off at 1e-6, because a block at 2 um/s that the load
// turned to its side was taken to come to rest first.
TEST(two_axes_recorded, a_slow_block_that_the_load_turns_does_not_come_to_rest) {
  if (!Pair::exists()) GTEST_SKIP() << recorded() << " has no fema_p695_far_field";
  const Pair motion("RSN1602_DUZCE_BOL000.AT2", "RSN1602_DUZCE_BOL090.AT2");
  const double factor = 1.5 * standard_gravity_mps2 / motion.pga_mps2();
  const TwoAxisScene scene{{.horizontal = {Oscillator{0.5, 0.05}, Oscillator{0.4, 0.05}},
                            .yielding = {},
                            .mass_ratio = 0.05},
                           {{0.3, 0.3}, 1.19 * rad_per_deg, 0.0},
                           {factor, 0.0}};
  const BuildingGround ground = motion.ground();
  const double truth_m = slide_on_building(ground, scene.factors, scene.building, scene.block, 1e-9)
                             .slip.peak_displacement_m;
  BuildingPeak peak;
  peak_slip_two_axes(ground, {&scene, 1}, {&peak, 1}, 1e-6);
  EXPECT_NEAR(peak.peak_displacement_m, truth_m, 2e-6 * truth_m);
}

Modes cantilever(double period_s, double alpha, double damping_ratio) {
  std::vector<Mode> modes = governing_modes(cantilever_modes(period_s, alpha, 12));
  for (Mode& mode : modes) mode.damping_ratio = damping_ratio;
  return Modes(modes);
}

// It ended as too many steps.
TEST(two_axes_recorded, a_block_of_the_mass_of_the_building_stops_as_between_exact_events) {
  if (!Pair::exists()) GTEST_SKIP() << recorded() << " has no fema_p695_far_field";
  const auto record = read_record(recorded() / "fema_p695_far_field/RSN169_IMPVALL.H_H-DLT262.AT2");
  const BuildingGround ground{
      {std::make_shared<GroundTable>(record.dt_s, record.acceleration_mps2), nullptr}, nullptr};
  const Modes axis = cantilever(0.3, 7.0, 0.1);
  const Block block{.friction = 0.2, .slope_rad = 1.0 * rad_per_deg};
  const std::vector<double> samples(record.acceleration_mps2.begin(),
                                    record.acceleration_mps2.end());
  const test::ModesReference truth(samples, record.dt_s, axis, 1.0, block, 5.0, 20);
  const BuildingSlip r = slide_on_building(ground, {}, {{axis, axis}, {}, 1.0}, block);
  EXPECT_EQ(r.slip.slip_phases, truth.phases);
  EXPECT_NEAR(r.slip.peak_displacement_m, truth.peak_m, 2e-6 * truth.peak_m);
  EXPECT_NEAR(r.peak_base_shear[0], truth.base_shear, 1e-3 * truth.base_shear);
}

// It was 8 % larger than between steps of 1e-9: friction of another direction at a stop.
TEST(two_axes_recorded, base_shear_of_several_modes_does_not_depend_on_the_tolerance) {
  if (!Pair::exists()) GTEST_SKIP() << recorded() << " has no fema_p695_far_field";
  const Pair motion("RSN1787_HECTOR_HEC000.AT2", "RSN1787_HECTOR_HEC090.AT2");
  for (const double mass_ratio : {0.3, 1.0}) {
    const BiaxialBuilding building{
        {cantilever(0.5, 5.0, 0.3), cantilever(0.3, 5.0, 0.3)}, {}, mass_ratio};
    const BuildingGround ground = motion.ground();
    for (const double across : {0.28, std::nextafter(0.28, 0.0)}) {
      const Block block{{0.4, across}, 0.0, -110.0 * rad_per_deg};
      const MotionFactors factors{1.5, 1.5};
      const BuildingSlip fine = slide_on_building(ground, factors, building, block, 1e-9),
                         r = slide_on_building(ground, factors, building, block);
      EXPECT_EQ(r.slip.slip_phases, fine.slip.slip_phases);
      for (std::size_t n = 0; n < 2; ++n)
        EXPECT_NEAR(r.peak_base_shear[n], fine.peak_base_shear[n], 1e-3 * fine.peak_base_shear[n]);
    }
  }
}

}  // namespace two_axis_recorded_test
}  // namespace glissade
