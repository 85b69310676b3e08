// SPDX-License-Identifier: GPL-3.0-or-later
// Suites whose motions are those of a roof.
#include <gmock/gmock.h>

#include "glissade/block/slide.hpp"
#include "glissade/building/modes.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/core/error.hpp"
#include "unit/io/problems.hpp"
#include "unit/study/shear_frame.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::ChainMode;
using test::fixed;
using test::listed;
using test::roofs_of;
using test::ShearFrame;
using testing::HasSubstr;

constexpr double period_s = 0.4, damping = 0.05;

/// The motions of the suite's roofs on one mass, in steps that leave an error of some 1e-6.
Suite roofs_on_one_mass(const Suite& ground) {
  Suite roofs = ground;
  roofs.of_roof = true;
  roofs.target.reset();
  RoofMotionOptions options;
  options.quiet_horizontal_mps2 = 0.02;
  for (Motion& m : roofs.motions) {
    const double dt_s = m.dt_s;
    for (auto& component : m.horizontal_mps2) {
      const RoofMotion roof = roof_motion({dt_s, component}, {{period_s, damping}, {}}, options);
      m.dt_s = roof.dt_s;
      component = roof.horizontal_mps2;
    }
    std::size_t longest = 0;
    for (const auto& component : m.horizontal_mps2) longest = std::max(longest, component.size());
    for (auto& component : m.horizontal_mps2) {
      std::vector<double> samples(component.begin(), component.end());
      samples.resize(longest, 0.0);
      component = std::move(samples);
    }
    m.vertical_mps2 = std::vector<double>();
  }
  return roofs;
}

StudyConfig as_recorded(SlidingAxes axes) {
  StudyConfig config = test::small_config();
  config.model.axes = axes;
  config.intensity.measure = IntensityMeasure::factor;
  config.intensity.levels = {0.5, 1.0, 2.0};
  config.orientation.choice = OrientationChoice::as_recorded;
  config.vertical = {VerticalChoice::none};
  config.standards.compare.clear();
  config.sampling.samples = 1;
  config.quantities.at("building", "period_s") = fixed(0.0);
  config.quantities.at("roof", "slope_deg") = fixed(1.0);
  config.quantities.at("friction", "mu") = listed({0.1, 0.3});
  config.friction.values = {FrictionValue::as_drawn};
  return config;
}

TEST(roof_motions, of_one_mass_give_the_displacements_of_the_ground_on_that_building) {
  const Suite ground = test::small_suite(), roofs = roofs_on_one_mass(ground);
  for (const SlidingAxes axes : {SlidingAxes::one, SlidingAxes::two}) {
    StudyConfig config = as_recorded(axes);
    const HistoryTable on_roof = test::run(make_plan(config, {roofs})).histories;
    config.quantities.at("building", "period_s") = fixed(period_s);
    config.quantities.at("building", "damping") = fixed(damping);
    const HistoryTable on_ground = test::run(make_plan(config, {ground})).histories;
    ASSERT_EQ(on_roof.cases, 2u);
    int slid = 0;
    test::for_each_history(on_ground, [&](std::size_t record, std::size_t c, std::size_t level) {
      const double expected = on_ground.displacement_m(record, c, level);
      slid += expected > 0.0;
      EXPECT_NEAR(on_roof.displacement_m(record, c, level), expected, 1e-4 * expected + 1e-7);
    });
    EXPECT_GT(slid, 9);  // of 18
  }
}

/// Three equal storeys; first period 0.6 s.
constexpr double storey_mass_kg = 1e5;
double storey_stiffness_npm() {
  const double at_one = ChainMode(3, 1, storey_mass_kg, 1.0).omega_radps;
  return std::pow(2.0 * std::numbers::pi / 0.6 / at_one, 2);
}
ShearFrame three_storeys() {
  const double k = storey_stiffness_npm();
  return {{storey_mass_kg, storey_mass_kg, storey_mass_kg}, {k, k, k}, damping};
}

/// By closed forms of its modes: a_g + sum of gamma D'', where the gamma are 1 together.
std::vector<double> closed_form_roof_mps2(double dt_s, std::span<const double> ground, int parts,
                                          double free_s) {
  std::vector<double> roof;
  for (int j = 1; j <= 3; ++j) {
    const ChainMode mode(3, j, storey_mass_kg, storey_stiffness_npm());
    const auto a = mode.acceleration_mps2(dt_s, ground, parts, free_s, damping);
    roof.resize(a.size());
    for (std::size_t i = 0; i < a.size(); ++i) roof[i] += mode.participation * a[i];
  }
  return roof;
}

TEST(roof_motions, of_a_frame_by_full_matrices_are_those_of_its_modes_in_closed_form) {
  const Motion m = test::small_suite().motions.front();
  const auto by_matrices = three_storeys().roof_mps2(m.dt_s, m.horizontal_mps2[0], 5, 2.0),
             by_modes = closed_form_roof_mps2(m.dt_s, m.horizontal_mps2[0], 5, 2.0);
  ASSERT_EQ(by_matrices.size(), by_modes.size());
  double largest = 0.0, difference = 0.0;
  for (std::size_t i = 0; i < by_modes.size(); ++i) {
    largest = std::max(largest, std::abs(by_modes[i]));
    difference = std::max(difference, std::abs(by_matrices[i] - by_modes[i]));
  }
  EXPECT_GT(largest, 1.0);
  EXPECT_LT(difference, 1e-11 * largest);
}

// The reference has the closed form at three times as many instants.
TEST(roof_motions, of_a_frame_give_the_displacements_of_its_roof_in_closed_form) {
  const Suite ground = test::small_suite();
  constexpr int parts = 100, finer = 3;
  constexpr double free_s = 6.0;
  const StudyConfig config = as_recorded(SlidingAxes::one);
  const HistoryTable found =
      test::run(make_plan(config, {roofs_of(three_storeys(), ground, parts, free_s)})).histories;
  std::vector<std::vector<double>> roofs;
  for (const Motion& m : ground.motions)
    roofs.push_back(closed_form_roof_mps2(m.dt_s, m.horizontal_mps2[0], finer * parts, free_s));
  int slid = 0;
  test::for_each_history(found, [&](std::size_t record, std::size_t c, std::size_t level) {
    const Motion& m = ground.motions[record];
    const RoofAcceleration roof{.dt_s = m.dt_s / (finer * parts),
                                .horizontal_mps2 = roofs[record],
                                .horizontal_factor = m.scale * config.intensity.levels[level]};
    const Block block{.friction = config.quantities.at("friction", "mu").values[c],
                      .slope_rad = 1.0 * rad_per_deg};
    const double expected_m = slide(roof, block).peak_displacement_m;
    slid += expected_m > 0.0;
    EXPECT_NEAR(found.displacement_m(record, c, level), expected_m, 5e-6 * expected_m + 1e-9);
  });
  EXPECT_GT(slid, 9);  // of 18
}

// The same building by the modes of a study, and by motions of its roof that a frame model of its
// own made: the roof's samples are joined by lines.
TEST(roof_motions, of_a_frame_give_the_displacements_of_a_study_of_its_modes) {
  const Suite ground = test::small_suite();
  for (const SlidingAxes axes : {SlidingAxes::one, SlidingAxes::two}) {
    StudyConfig config = as_recorded(axes);
    config.vertical = {VerticalChoice::none};
    const HistoryTable by_roof =
        test::run(make_plan(config, {roofs_of(three_storeys(), ground, 100, 6.0)})).histories;
    config.quantities.at("building", "period_s") = fixed(0.6);
    config.quantities.at("building", "damping") = fixed(damping);
    config.building.kind = BuildingModel::Kind::modes;  // all three
    for (std::vector<Mode>& modes : config.building.modes) {
      modes = shear_building_modes(std::vector(3, storey_mass_kg),
                                   std::vector(3, storey_stiffness_npm()));
      for (Mode& mode : modes) mode.period_s /= 0.6;
    }
    const HistoryTable by_modes = test::run(make_plan(config, {ground})).histories;
    int slid = 0;
    test::for_each_history(by_modes, [&](std::size_t record, std::size_t c, std::size_t level) {
      const double expected_m = by_roof.displacement_m(record, c, level);
      slid += expected_m > 0.0;
      EXPECT_NEAR(by_modes.displacement_m(record, c, level), expected_m, 1e-5 * expected_m + 1e-9);
    });
    EXPECT_GT(slid, 5);
  }
}

TEST(roof_motions, refuse_what_needs_the_ground_or_a_building) {
  const Suite roofs = roofs_on_one_mass(test::small_suite());
  const auto refusal = [&](const auto& change) {
    StudyConfig config = as_recorded(SlidingAxes::two);
    change(config);
    return message_of([&] { make_plan(config, {roofs}); });
  };
  EXPECT_EQ(refusal([](StudyConfig&) {}), "");
  EXPECT_THAT(refusal([](StudyConfig& c) { c.intensity.measure = IntensityMeasure::sds_g; }),
              HasSubstr("sds_g"));
  EXPECT_THAT(refusal([](StudyConfig& c) { c.intensity.measure = IntensityMeasure::mce_fraction; }),
              HasSubstr("mce_fraction"));
  EXPECT_THAT(refusal([](StudyConfig& c) { c.quantities.at("building", "period_s") = fixed(0.5); }),
              HasSubstr("building.period_s"));
  EXPECT_THAT(
      refusal([](StudyConfig& c) { c.quantities.at("building", "mass_ratio") = fixed(0.05); }),
      HasSubstr("building.mass_ratio"));
  EXPECT_THAT(refusal([](StudyConfig& c) { c.quantities.at("vertical", "period_s") = fixed(0.1); }),
              HasSubstr("vertical.period_s"));
  EXPECT_THAT(refusal([](StudyConfig& c) { c.base_shear = true; }), HasSubstr("[base_shear]"));
  EXPECT_THAT(refusal([](StudyConfig& c) { c.intensity_measures.emplace(); }),
              HasSubstr("[intensity_measures]"));
  EXPECT_THAT(refusal([](StudyConfig& c) { c.normalise_by_pgv = true; }), HasSubstr("normalise"));
  StudyConfig two = as_recorded(SlidingAxes::two);
  two.suite_files.push_back("other.toml");
  EXPECT_THAT(message_of([&] {
                make_plan(two, {roofs, test::small_suite()});
              }),
              HasSubstr("of the ground"));
}

TEST(roof_motions, that_are_turned_have_a_warning_and_meet_no_target) {
  const Suite roofs = roofs_on_one_mass(test::small_suite());
  StudyConfig config = as_recorded(SlidingAxes::two);
  config.clearance.emplace();
  EXPECT_THAT(make_plan(config, {roofs}).warnings,
              testing::Not(testing::Contains(HasSubstr("axes of its building"))));
  config.orientation.choice = OrientationChoice::all_permutations;  // slopes along both axes
  EXPECT_THAT(make_plan(config, {roofs}).warnings,
              testing::Not(testing::Contains(HasSubstr("axes of its building"))));
  config.orientation.choice = OrientationChoice::azimuths;
  EXPECT_THAT(make_plan(config, {roofs}).warnings,
              testing::Contains(HasSubstr("axes of its building")));
}

TEST(roof_motions, are_measured_by_the_peak_of_the_roof) {
  StudyConfig config = as_recorded(SlidingAxes::one);
  config.intensity.measure = IntensityMeasure::pga_g;
  const Results results = test::run(make_plan(config, {roofs_on_one_mass(test::small_suite())}));
  EXPECT_THAT(results.intensity_label, HasSubstr("peak roof acceleration"));
}

TEST(roof_motions, are_another_plan_than_the_same_motions_of_the_ground) {
  Suite suite = roofs_on_one_mass(test::small_suite());
  const StudyConfig config = as_recorded(SlidingAxes::two);
  const std::string of_roof = make_plan(config, {suite}).hash;
  suite.of_roof = false;
  EXPECT_NE(of_roof, make_plan(config, {suite}).hash);
}

}  // namespace
}  // namespace glissade
