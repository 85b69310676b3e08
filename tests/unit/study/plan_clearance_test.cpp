// SPDX-License-Identifier: GPL-3.0-or-later
// Of which suites a clearance is refused.
#include <gmock/gmock.h>

#include <string>

#include "facts.hpp"
#include "glissade/core/error.hpp"
#include "glissade/study/plan/plan.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::fixed;
using test::listed;
using test::small_config;
using test::small_suite;
using test::states;

/// Empty where it is planned.
std::string refusal_of(const StudyConfig& config, const Suite& suite) {
  try {
    make_plan(config, {suite});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

StudyConfig config_without_target(StudyConfig config) {
  config.clearance->without_target = true;
  return config;
}

TEST(plan, refuses_a_clearance_of_a_suite_that_does_not_meet_its_target) {
  StudyConfig config = small_config();
  config.intensity.measure = IntensityMeasure::mce_fraction;
  config.intensity.levels = {1.0};
  config.standards.compare.clear();
  config.clearance = ClearanceConfig{};
  Suite suite = small_suite();
  const auto refusal = [&] { return refusal_of(config, suite); };
  const std::string message = refusal(), before = "multiply the suite's scales by ";
  const std::size_t at = message.find(before);
  ASSERT_NE(at, std::string::npos) << message;
  const double missing = std::stod(message.substr(at + before.size()));
  EXPECT_GT(missing, 1.0);
  for (Motion& motion : suite.motions) motion.scale *= missing;
  EXPECT_EQ(refusal(), "");
  for (Motion& motion : suite.motions) motion.scale *= 0.97;
  EXPECT_NE(refusal(), "");

  config.clearance->without_target = true;
  EXPECT_EQ(refusal(), "");
  const auto of_scale = states("scale");  // of each record, above
  EXPECT_THAT(make_plan(config, {suite}).warnings,
              testing::UnorderedElementsAre(states("NOT FOR DESIGN"), states("one axis"), of_scale,
                                            of_scale));
  config.clearance->without_target = false;
  suite.target.reset();
  EXPECT_NE(refusal(), "");
  suite.target = small_suite().target;
  config.intensity.measure = IntensityMeasure::pga_g;
  EXPECT_NE(refusal(), "");
  config.intensity.measure = IntensityMeasure::sds_g;  // the study scales the suite
  EXPECT_EQ(refusal(), "");

  // to 2 s: of a longer building the suite must have motion at its period too
  config.quantities.at("building", "period_s") = listed({0.5, 4.0});
  EXPECT_THAT(refusal(), states("4 s", "0.9"));
  const double below = make_plan(config_without_target(config), {suite}).factor_at_unit_level[0];
  EXPECT_THAT(refusal(), states("scaled_to_s = 6", "1.799"));
  config.intensity.scaled_to_s = 6.0;
  EXPECT_EQ(refusal(), "");
  EXPECT_NEAR(make_plan(config, {suite}).factor_at_unit_level[0] / below, 1.799, 1e-3);
}

// A mean of seven is one of seven earthquakes.
TEST(plan, refuses_a_clearance_of_copies_of_a_record) {
  Suite suite = small_suite();
  suite.motions.push_back(suite.motions.front());
  suite.motions.back().id = "again";
  StudyConfig config = small_config();
  config.standards.compare.clear();
  config.clearance = ClearanceConfig{};
  EXPECT_THAT(refusal_of(config, suite), states("motion0", "again"));
}

TEST(plan, refuses_a_chart_clearance_alike) {
  StudyConfig config = small_config();
  config.intensity.measure = IntensityMeasure::mce_fraction;
  config.intensity.levels = {1.0};
  config.standards.compare.clear();
  config.chart = ChartConfig{};
  const auto refusal = [&] { return refusal_of(config, small_suite()); };
  EXPECT_THAT(refusal(), states("[chart]", "chart.without_target = true"));
  config.chart->without_target = true;
  EXPECT_EQ(refusal(), "");
  EXPECT_THAT(make_plan(config, {small_suite()}).warnings,
              testing::Contains(testing::StartsWith("NOT FOR DESIGN")));
  config.chart->without_target = false;
  config.intensity.measure = IntensityMeasure::pga_g;  // its chart has no clearance
  EXPECT_EQ(refusal(), "");
}

}  // namespace
}  // namespace glissade
