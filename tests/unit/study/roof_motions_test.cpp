// SPDX-License-Identifier: GPL-3.0-or-later
// Suites whose motions are those of a roof.
#include <gmock/gmock.h>

#include "glissade/building/roof_motion.hpp"
#include "glissade/core/error.hpp"
#include "unit/io/problems.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::fixed;
using test::listed;
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
