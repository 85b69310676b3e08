// SPDX-License-Identifier: GPL-3.0-or-later
#include "project_files.hpp"

namespace glissade {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::SizeIs;

using StudiesOfProject = ProjectFiles;

TEST_F(StudiesOfProject, state_the_projects_numbers_each_with_its_unit) {
  const StudyConfig demand = demand_of(whole_project);
  const Quantities& q = demand.quantities;
  EXPECT_THAT(q.at("building", "period_s").values, ElementsAre(0.5, 1.0));
  EXPECT_THAT(q.at("friction", "mu").values, ElementsAre(DoubleNear(0.42, 1e-12)));
  EXPECT_NEAR(q.at("roof", "slope_deg").values.front(), 1.1935, 1e-4);
  const StudyConfig probability = probability_of(whole_project, {0.5});
  EXPECT_THAT(probability.fragility->thresholds_m, ElementsAre(0.5));
  for (const StudyConfig& study : {demand, probability})
    EXPECT_THAT(study.unmarked_numbers, ElementsAre());
}

TEST_F(StudiesOfProject, compare_the_displacements_that_clearances_allow) {
  const std::string text = whole_project +
                           "[clearances]\nsimilar_array_m = 0.3\nobstruction_m = 0.6\n"
                           "open_edge_m = 1.0\n";
  EXPECT_THAT(compared_displacements_m(read(text), 0.55), ElementsAre(0.5, 0.55, 0.6));
  EXPECT_THAT(probability_of(text, {0.5, 0.55, 0.6}).verdict->exceedance, ElementsAre(0.1));
}

// Without leave the demand study is refused, as any study is.
TEST_F(StudiesOfProject, need_leave_for_a_suite_that_falls_short_beyond_2_s) {
  const std::string text = changed("[suite]", "[clearance]\nwithout_target = true\n[suite]");
  EXPECT_THAT(problems_of(text), SizeIs(1));  // it has no effect up to 2 s
  EXPECT_TRUE(demand_of(changed("[1.0, 0.5]", "[1.0, 2.5]", text)).is_without_target());
}

TEST_F(StudiesOfProject, scale_a_suite_to_one_and_a_half_times_a_long_period) {
  const std::string text = changed("[1.0, 0.5]", "[1.0, 1.4]");
  for (const StudyConfig& study : {demand_of(text), probability_of(text, {0.1})})
    EXPECT_NEAR(study.intensity.scaled_to_s, 2.1, 1e-12);
  EXPECT_EQ(demand_of(whole_project).intensity.scaled_to_s, IntensityConfig{}.scaled_to_s);
}

TEST_F(StudiesOfProject, scale_a_suite_by_the_rule_that_is_stated) {
  const std::string text = with("[suite]", "scaling_rule = \"asce7_16\"");
  for (const StudyConfig& study : {demand_of(text), probability_of(text, {0.1})})
    EXPECT_EQ(study.intensity.scaling_rule, ScalingRule::asce7_16);
}

TEST_F(StudiesOfProject, of_one_period_and_mass_ratio_vary_both_for_the_model_uncertainty) {
  const Quantities q = demand_of(changed("[1.0, 0.5]", "1.0")).quantities;
  EXPECT_THAT(q.at("building", "period_s").values,
              ElementsAre(DoubleNear(0.9, 1e-12), 1.0, DoubleNear(1.1, 1e-12)));
  EXPECT_THAT(q.at("building", "mass_ratio").values, ElementsAre(0.05, 0.1));
}

}  // namespace
}  // namespace glissade
