// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include "glissade/motion/improbable.hpp"
#include "project_files.hpp"

namespace glissade {
namespace {

using test::states;
using testing::AllOf;
using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

using FrictionOfProject = ProjectFiles;

TEST_F(FrictionOfProject, a_sheet_of_tests_may_name_tests_and_directions) {
  const ProjectFriction friction =
      read(tested("test,direction,mu\n1,along,0.50\n2,along,0.54\n1,across,0.60\n2,across,0.66\n"))
          .friction;
  EXPECT_EQ(friction.direction, "along");  // the lower one
  EXPECT_NEAR(friction.mean, 0.52, 1e-12);
  EXPECT_THAT(problems_of(tested("test,direction,mu\n1,along,0.5\n2,along,0.5\n1,Along,0.5\n")),
              one_problem("p.toml:15", "pulls.csv:4", "'1' along"));
  EXPECT_THAT(problems_of(tested("direction,mu\nalong,0.5\nalong,5.4\n,0.5\n")), SizeIs(2));
}

// The array slides in every direction of the pull tests.
TEST_F(FrictionOfProject, is_the_lowest_design_value_of_all_directions) {
  std::string logs = "test,direction,displacement_m,force_n,normal_n\n";
  for (const auto& [direction, first] : {std::pair{"across", 55}, std::pair{"along", 50}})
    for (int test = 0; test < 3; ++test)
      for (const char* at : {"0", "0.01", "0.02", "0.03", "0.04", "0.05", "0.06"})
        logs += fmt::format("{}{},{},{},{},100\n", direction[1], test, direction, at, first + test);
  const std::string text = tested(logs);
  const Project project = read(text);
  EXPECT_EQ(project.friction.direction, "along");
  EXPECT_NEAR(project.friction.mean, 0.51, 1e-12);
  ASSERT_EQ(project.friction.tested.size(), 2u);
  EXPECT_THAT(
      project.friction.tested[0].sliding_mu,
      ElementsAre(DoubleNear(0.55, 1e-12), DoubleNear(0.56, 1e-12), DoubleNear(0.57, 1e-12)));
  const auto better = Contains(states("direction along", "0.490"));
  EXPECT_THAT(texts_of(warnings_on(project)), Not(better));
  EXPECT_THAT(warnings_of(changed("[suite]", "direction = \"across\"\n[suite]", text)), better);
}

// The array slides in both: a direction with a higher design value may be tested less well.
TEST_F(FrictionOfProject, has_the_lowest_bound_of_all_directions) {
  const ProjectFriction friction =
      read(tested("direction,mu\nalong,0.64\nalong,0.65\nalong,0.66\nalong,0.65\n"
                  "across,0.75\nacross,0.95\nacross,0.85\nacross,0.85\n"))
          .friction;
  EXPECT_EQ(friction.direction, "along");
  EXPECT_EQ(friction.bound_direction, "across");
  EXPECT_EQ(*friction.lower_bound, friction.tested[1].sliding.lower_bound_95);
  EXPECT_LT(*friction.lower_bound, friction.tested[0].sliding.lower_bound_95);
  EXPECT_THAT(bound_name(friction), states("across"));
}

TEST_F(FrictionOfProject, that_is_typed_is_bounded_by_the_number_of_tests) {
  EXPECT_FALSE(read(whole_project).friction.lower_bound.has_value());
  const Project project = read(changed("std = 0.04 }", "std = 0.04 }\ntests = 7"));
  // k of 7 tests with 95 % confidence: 3.399 for 95 % of the population, 4.641 for 99 %
  // (NIST/SEMATECH e-Handbook, 7.2.6.3); here 97.7 %.
  EXPECT_LT(*project.friction.lower_bound, 0.5 - 3.399 * 0.04);
  EXPECT_GT(*project.friction.lower_bound, 0.5 - 4.641 * 0.04);
  const std::vector<StudiedFriction> frictions = frictions_of(project);
  ASSERT_EQ(frictions.size(), 2u);
  EXPECT_EQ(frictions[0].value, *project.friction.lower_bound);
  EXPECT_EQ(frictions[1].value, project.friction.design());
}

TEST_F(FrictionOfProject, that_no_roof_has_is_refused_or_a_warning) {
  EXPECT_THAT(problems_of(changed("mean = 0.5", "mean = 5.0")),
              one_problem("p.toml:15", "friction.mu.mean = 5", "0", "2"));
  EXPECT_THAT(problems_of(changed("std = 0.04", "cov = 0.08")),
              Contains(is_problem(
                  "p.toml:15", std::vector<std::string>{"friction.mu.cov", "std = cov x mean"})));
  EXPECT_THAT(problems_of(changed("mean = 0.5, std = 0.04", "median = 0.5, cov = 0.08")),
              one_problem("p.toml:15", "friction.mu.cov", "std = cov x mean"));
  EXPECT_THAT(warnings_of(changed("mean = 0.5", "mean = 1.5")),
              Contains(states("mean friction of 1.5")));
  EXPECT_THAT(problems_of(tested("mu\n0.50\n0.54\n5.3\n")),
              one_problem("p.toml:15", "pulls.csv:4"));
  EXPECT_THAT(warnings_of(tested("mu\n0.50\n0.54\n0.51\n0.52\n0.84\n")),
              Contains(states("test 5 of 5", "0.84")));
  EXPECT_THAT(problems_of(tested("mu\n0.50\n0.54\n0.51\n0.52\n1.9\n")),  // a design value below 0
              one_problem("p.toml:14", "test 5 of 5", "1.9", "-0.443"));
}

TEST_F(FrictionOfProject, of_few_or_doubtful_tests_is_a_warning) {
  const Project project =
      read(tested("direction,mu\nalong,0.50\nAlong,0.54\nalong,0.52\nalong,0.55\n"
                  "along,0.51\nalong,0.2\nacross,0.6\n"));
  EXPECT_EQ(project.friction.tested.size(), 2u);  // Along is along
  EXPECT_THAT(texts_of(warnings_on(project)),
              AllOf(Contains(states("direction across")), Contains(states("test 6 of 6"))));
}

TEST_F(FrictionOfProject, on_which_the_array_slides_without_an_earthquake_is_refused) {
  EXPECT_THAT(problems_of(changed("rise_in_12 = 0.25", "slope_deg = 19")),
              IsEmpty());  // tan 19 deg is 0.34
  EXPECT_THAT(problems_of(changed("std = 0.04", "std = 0.24")), SizeIs(1));
}

// SEAOC PV1-2012 asks for 3 in or more at 0.1 to 10 mm/s.
TEST_F(FrictionOfProject, of_pull_tests_at_another_speed_does_not_meet_its_check) {
  const auto check_of = [&](double speed_mmps) {
    std::string pulls = "test,direction,time_s,displacement_mm,force_n,normal_n\n";
    for (const auto& [test, force_n] : {std::pair{"A", 550}, {"B", 540}, {"C", 530}})
      for (const double s_mm : {0, 30, 80, 130, 180, 230})
        pulls += fmt::format("{},along,{},{},{},1000\n", test, s_mm / speed_mmps, s_mm, force_n);
    return checks_before_analysis(read(tested(pulls)), 7).back();
  };
  EXPECT_TRUE(check_of(10.0).is_met) << check_of(10.0).found;
  EXPECT_FALSE(check_of(25.0).is_met);
  EXPECT_THAT(check_of(25.0).found, testing::HasSubstr("3 of 3"));
}

}  // namespace
}  // namespace glissade
