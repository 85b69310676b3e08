// SPDX-License-Identifier: GPL-3.0-or-later
// Of which suites a clearance is refused.
#include <gmock/gmock.h>

#include <string>

#include "facts.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/rotated_spectrum.hpp"
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
  EXPECT_THAT(
      make_plan(config, {suite}).warnings,
      testing::UnorderedElementsAre(states("NOT FOR DESIGN"), states("one axis"), of_scale,
                                    of_scale, states("one mass"), states("scaled by more than 5")));
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

/// The average RotD100 (or SRSS) spectrum over the target, at periods of its
/// own, in 0.15 %: lowest and mean.
std::pair<double, double> plain_ratios(const Suite& suite, const std::vector<double>& factors,
                                       bool is_rotd100, double from_s, double to_s) {
  std::vector<double> periods_s;
  for (double t_s = from_s; t_s < to_s; t_s *= 1.0015) periods_s.push_back(t_s);
  periods_s.push_back(to_s);
  std::vector<double> sum(periods_s.size(), 0.0);
  for (std::size_t m = 0; m < factors.size(); ++m) {
    const Motion& motion = suite.motions[m];
    const std::vector<double> sa =
        is_rotd100 ? rotated_spectrum(motion, periods_s).rotd100_mps2
                   : horizontal_spectrum_mps2(motion, periods_s, HorizontalCombination::srss);
    for (std::size_t i = 0; i < sa.size(); ++i) sum[i] += factors[m] * sa[i];
  }
  const TargetSpectrum target(*suite.target);
  double lowest = 1e9, mean = 0.0;
  for (std::size_t i = 0; i < sum.size(); ++i) {
    const double ratio = sum[i] / static_cast<double>(factors.size()) / standard_gravity_mps2 *
                         target.sds_g() / target.design_sa_g(periods_s[i]);
    lowest = std::min(lowest, ratio);
    mean += ratio / static_cast<double>(sum.size());
  }
  return {lowest, mean};
}

// Buildings of 0.4 s and, across, 1.5 times that; of 0.9 s and 1.35 s.
TEST(plan, scales_a_suite_by_the_clause_of_an_edition_over_the_periods_of_its_buildings) {
  StudyConfig config = small_config();
  config.model.axes = SlidingAxes::two;
  config.quantities.at("building", "period_s") = listed({0.4, 0.9});
  config.quantities.at("building", "period_ratio") = fixed(1.5);
  config.intensity.levels = {1.0};
  config.standards.compare.clear();
  config.fragility.reset();
  config.sampling.samples = 1;
  config.quantities.at("roof", "slope_deg") = fixed(1.0);
  config.quantities.at("friction", "mu") = fixed(0.4);
  config.clearance = ClearanceConfig{};
  const Suite suite = small_suite();
  for (const auto& [rule, to_s] : {std::pair{ScalingRule::asce7_10, 1.5 * 1.35},
                                   {ScalingRule::asce7_16, 2.0 * 1.35},
                                   {ScalingRule::asce7_22, 2.0 * 1.35}}) {
    config.intensity.scaling_rule = rule;
    const Plan plan = make_plan(config, {suite});
    const auto [lowest, mean] =
        plain_ratios(suite, plan.factor_at_unit_level, is_of_16_2(rule), 0.2 * 0.4, to_s);
    EXPECT_NEAR(is_of_16_2(rule) ? std::min(lowest / 0.9, mean) : lowest, 1.0, 3e-3);
    EXPECT_THAT(plan.warnings, testing::Contains(is_of_16_2(rule) ? states("16.2.2", "11 at least")
                                                                  : states("fewer than 7")));
  }
  config.intensity.scaling_rule = ScalingRule::asce7_16;
  config.intensity.to_one_and_a_half = true;
  const Plan plan = make_plan(config, {suite});
  const auto [lowest, mean] =
      plain_ratios(suite, plan.factor_at_unit_level, true, 0.2 * 0.4, 1.5 * 1.35);
  EXPECT_NEAR(std::min(lowest / 0.9, mean), 1.0, 3e-3);

  // The file's own scales for MCE must meet the same clause.
  StudyConfig by_file = config;
  by_file.intensity.measure = IntensityMeasure::mce_fraction;
  Suite scaled = suite;
  const double mce = 1.5 * TargetSpectrum(*suite.target).sds_g();
  for (std::size_t m = 0; m < scaled.motions.size(); ++m)
    scaled.motions[m].scale = mce * plan.factor_at_unit_level[m];
  EXPECT_EQ(refusal_of(by_file, scaled), "");
  for (Motion& motion : scaled.motions) motion.scale *= 0.97;
  EXPECT_THAT(refusal_of(by_file, scaled), states("RotD100", "ASCE 7-16", "16.2.3.1", "1.031"));

  config.quantities.at("building", "period_s") = listed({0.0, 0.9});
  EXPECT_THAT(refusal_of(config, suite), states("asce7_16", "rigid", "walters_2012"));
  config.quantities.at("building", "period_s") = listed({0.4, 4.0});  // to 12 s
  EXPECT_EQ(refusal_of(config, suite), "");
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

TEST(plan, refuses_a_chart_alike) {
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
