// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/project_file.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <cmath>

#include "glissade/design/design_clearance.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/motion/improbable.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using test::states;
using testing::Contains;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::Not;

const std::string whole = R"([project]
name = "one"
[site]
edition = "asce7_16"
ss_g = 1.313
s1_g = 0.471
site_class = "default"
risk_category = "III"
[building]
period_s = [1.0, 0.5]
mass_ratio = 0.05
[roof]
rise_in_12 = 0.25
[friction]
mu = { mean = 0.5, std = 0.04 }
source = "report 7"
[suite]
file = "suite.toml"
)";

class ProjectFile : public testing::Test {
 protected:
  ProjectFile() { folder_.write("suite.toml", ""); }
  Project read(const std::string& text) { return read_project(folder_.write("p.toml", text)); }
  std::vector<Problem> problems_of(const std::string& text) {
    return glissade::problems_of([&] { read(text); });
  }
  static std::string changed(const std::string& from, const std::string& to) {
    std::string text = whole;
    return text.replace(text.find(from), from.size(), to);
  }
  TemporaryFolder folder_;
};

TEST_F(ProjectFile, is_read) {
  const Project project = read(whole);
  EXPECT_THAT(project.building.period_s, ElementsAre(0.5, 1.0));
  EXPECT_THAT(project.slope_deg, ElementsAre(DoubleNear(1.1935, 1e-4)));
  EXPECT_NEAR(project.friction.design(), 0.42, 1e-12);
  EXPECT_EQ(project.importance, 1.25);  // of risk category III
  EXPECT_THAT(project.site.target.site_classes, ElementsAre(SiteClass::unknown));
  EXPECT_EQ(project.suite, folder_.path() / "suite.toml");
}

TEST_F(ProjectFile, the_example_is_one) {
  folder_.write("pull_tests.csv", "mu\n0.50\n0.54\n0.58\n");
  const Project project = read(project_example());
  EXPECT_NEAR(project.friction.mean, 0.54, 1e-12);
  EXPECT_NEAR(project.friction.std, 0.04, 1e-12);
  EXPECT_TRUE(project.friction.lower_bound.has_value());
}

// Everything that is missing, in one run, with an example for each.
TEST_F(ProjectFile, what_is_missing_is_listed_at_once) {
  const auto problems = problems_of("[project]\nname = \"one\"\n");
  for (const char* key : {"site.edition", "site.ss_g", "site.s1_g", "site.site_class",
                          "site.risk_category", "building.period_s", "building.mass_ratio",
                          "roof.rise_in_12", "friction.file", "suite.file"}) {
    const auto found = std::ranges::count_if(problems, [&](const Problem& p) {
      return p.what.starts_with(key) && p.suggestion.find("example") != std::string::npos;
    });
    EXPECT_EQ(found, 1) << key;
  }
  EXPECT_EQ(problems.size(), 10u);
}

TEST_F(ProjectFile, numbers_may_have_units) {
  const Project project =
      read(whole + "[clearances]\nopen_edge_m = \"4 ft\"\n[result]\nround_up_m = \"0.5 in\"\n");
  EXPECT_EQ(project.available_m.at(3), 1.2192);
  EXPECT_EQ(project.round_up_m, 0.0127);
  EXPECT_EQ(read(changed("= 0.25", "= \"1/4:12\"")).slope_deg, read(whole).slope_deg);
  EXPECT_EQ(problems_of(changed("= 0.25", "= \"0.25 kip\"")).size(), 1u);
}

TEST_F(ProjectFile, any_number_of_gaps_have_name_kind_and_clearance) {
  const std::string gap =
      "[[gap]]\nname = \"duct\"\nkind = \"open_edge\"\navailable_m = \"4 ft\"\n";
  const Project project =
      read(whole + gap + "[[gap]]\nname = \"hatch\"\nkind = \"obstruction\"\navailable_m = 2\n");
  ASSERT_EQ(project.gaps.size(), 2u);
  EXPECT_EQ(project.gaps[0].name, "duct");
  EXPECT_EQ(project.gaps[0].available_m, 1.2192);
  EXPECT_THAT(separations_of(project.standard, 1.0).at(project.gaps[0].kind).what,
              HasSubstr("edge without"));
  EXPECT_THAT(separations_of(project.standard, 1.0).at(project.gaps[1].kind).what,
              HasSubstr("fixed object"));
  EXPECT_EQ(problems_of(whole + gap + gap).size(), 1u);
  EXPECT_EQ(problems_of(whole + "[[gap]]\nname = \"duct\"\n").size(), 2u);
  EXPECT_EQ(
      problems_of(whole + "[[gap]]\nname = \"duct\"\nkind = \"wall\"\navailable_m = 1\n").size(),
      1u);
}

TEST_F(ProjectFile, a_period_comes_from_system_and_height) {
  const std::string text = changed(
      "period_s = [1.0, 0.5]", "system = \"other\"\nheight_m = 10.668\nperiod_bounds = [1.0, 2.0]");
  const Project project = read(text);
  ASSERT_EQ(project.building.period_s.size(), 5u);
  EXPECT_NEAR(project.building.period_s.front(), 0.288, 1e-3);
  EXPECT_NEAR(project.building.period_s.back(), 0.576, 2e-3);
  EXPECT_THAT(project.building.period_basis, states("0.02 (35 ft)^0.75", "ASCE 7-16, 12.8-7"));
  // C_t of the table in metres
  EXPECT_THAT(
      read(std::string(text).insert(text.find("[site]"), "units = \"si\"\n")).building.period_basis,
      states("0.0488 (10.67 m)^0.75"));
}

TEST_F(ProjectFile, the_mass_ratio_may_come_from_weights) {
  const std::string ratio = "mass_ratio = 0.05";
  ASSERT_NE(whole.find(ratio), std::string::npos);
  const Project project =
      read(changed(ratio, "array_weight_kn = \"60 kip\"\nweight_kn = \"2400 kip\""));
  EXPECT_THAT(project.building.mass_ratio, ElementsAre(DoubleNear(0.025, 1e-9)));
  const Project none = read(changed(ratio, "array_weight_kn = 0\nweight_kn = 900"));
  EXPECT_EQ(none.building.mass_ratio.front(), 0.0);
  EXPECT_THAT(none.building.mass_basis, states("202.3 kip", "900.0 kN"));  // over 4.4482 kN/kip
  EXPECT_EQ(problems_of(changed(ratio, "array_weight_kn = 60")).size(), 1u);
  EXPECT_EQ(problems_of(changed(ratio, "array_weight_kn = 60\nweight_kn = 50")).size(), 1u);
  EXPECT_EQ(problems_of(changed(ratio, ratio + "\narray_weight_kn = 60\nweight_kn = 900")).size(),
            1u);
}

// In the project's own key, not in that of a study which is made from it.
TEST_F(ProjectFile, an_impossible_period_and_hazard_curve_are_refused_by_their_keys) {
  const std::string period = "period_s = [1.0, 0.5]";
  EXPECT_THAT(problems_of(changed(period, "period_s = 300")), one_problem("p.toml:10", "300 s"));
  EXPECT_THAT(problems_of(changed(period, "system = \"other\"\nheight_m = 7000")),
              one_problem("p.toml:11", "56 s"));
  EXPECT_THAT(problems_of(whole + "[hazard]\nk0 = 1756\nk = 2.2\ndesign_life_years = 25\n"),
              one_problem("p.toml:20", "6.244e+06", "k0"));
}

TEST_F(ProjectFile, a_sheet_of_tests_may_name_tests_and_directions) {
  folder_.write("sheet.csv",
                "test,direction,mu\n1,along,0.50\n2,along,0.54\n1,across,0.60\n2,across,0.66\n");
  const std::size_t begin = whole.find("[friction]");
  const std::string text = whole.substr(0, begin) + "[friction]\nfile = \"sheet.csv\"\n" +
                           whole.substr(whole.find("[suite]"));
  const Project project = read(text);
  EXPECT_EQ(project.friction.direction, "along");  // the lower one
  EXPECT_NEAR(project.friction.mean, 0.52, 1e-12);
  folder_.write("sheet.csv", "test,direction,mu\n1,along,0.5\n2,along,0.5\n1,Along,0.5\n");
  EXPECT_THAT(problems_of(text), one_problem("p.toml:15", "sheet.csv:4", "'1' along"));
  folder_.write("sheet.csv", "direction,mu\nalong,0.5\nalong,5.4\n,0.5\n");
  EXPECT_EQ(problems_of(text).size(), 2u);
}

// The array slides in both: a direction with a higher design value may be tested less well.
TEST_F(ProjectFile, the_bound_of_the_tests_is_the_lowest_of_all_directions) {
  folder_.write("sheet.csv",
                "direction,mu\nalong,0.64\nalong,0.65\nalong,0.66\nalong,0.65\n"
                "across,0.75\nacross,0.95\nacross,0.85\nacross,0.85\n");
  const std::size_t begin = whole.find("[friction]");
  const ProjectFriction friction =
      read(whole.substr(0, begin) + "[friction]\nfile = \"sheet.csv\"\n" +
           whole.substr(whole.find("[suite]")))
          .friction;
  EXPECT_EQ(friction.direction, "along");
  EXPECT_EQ(friction.bound_direction, "across");
  EXPECT_EQ(*friction.lower_bound, friction.tested[1].sliding.lower_bound_95);
  EXPECT_LT(*friction.lower_bound, friction.tested[0].sliding.lower_bound_95);
  EXPECT_THAT(bound_name(friction), states("across"));
}

TEST_F(ProjectFile, plain_numbers_of_a_project_in_us_units_are_a_warning) {
  const std::string clearance = whole + "[clearances]\nopen_edge_m = ";
  EXPECT_THAT(choices_of(read(clearance + "4\n")),
              Contains(states("clearances.open_edge_m = 4", "13.1 ft")));
  for (const std::string& text :
       {clearance + "\"4 ft\"\n",
        std::string(clearance + "4\n").insert(whole.find("[site]"), "units = \"si\"\n")})
    EXPECT_THAT(choices_of(read(text)), Not(Contains(states("clearances.open_edge_m")))) << text;
}

TEST_F(ProjectFile, bounds_of_the_period_have_as_many_periods_as_leave_no_gap) {
  const auto periods = [&](const char* bounds) {
    return read(changed("period_s = [1.0, 0.5]",
                        std::string("system = \"other\"\nheight_m = \"9 m\"\nperiod_bounds = ") +
                            bounds))
        .building.period_s;
  };
  EXPECT_EQ(periods("[0.75, 1.5]").size(), 5u);
  for (const char* bounds : {"[0.75, 2.5]", "[0.3, 3]", "[0.75, 2.15]"})
    EXPECT_EQ(gaps_between(periods(bounds)), "") << bounds;
}

TEST_F(ProjectFile, the_studies_it_makes_have_no_number_without_its_unit) {
  const Project project = read(whole);
  folder_.write("made/suite.toml", "");
  for (const std::string& text : {demand_study(project, folder_.path()),
                                  probability_study(project, folder_.path(), {0.3, 0.6})})
    EXPECT_THAT(read_study(folder_.write("made.toml", text)).unmarked_numbers, ElementsAre());
}

TEST_F(ProjectFile, a_wall_is_no_frame_and_a_coefficient_of_variation_no_deviation) {
  EXPECT_THAT(problems_of(changed("period_s = [1.0, 0.5]",
                                  "system = \"concrete_shear_wall\"\nheight_m = \"9 m\"")),
              ElementsAre(testing::Field(&Problem::suggestion,
                                         testing::StartsWith("known are steel_moment_frame"))));
  EXPECT_THAT(problems_of(changed("std = 0.04", "cov = 0.08")),
              Contains(is_problem(
                  "p.toml:15", std::vector<std::string>{"friction.mu.cov", "std = cov x mean"})));
}

TEST_F(ProjectFile, bounds_without_the_period_between_them_are_a_warning) {
  const auto with_bounds = [&](const char* bounds) {
    return choices_of(read(changed(
        "period_s = [1.0, 0.5]",
        std::string("system = \"other\"\nheight_m = \"35 ft\"\nperiod_bounds = ") + bounds)));
  };
  EXPECT_THAT(with_bounds("[1.1, 1.2]"), Contains(states("period_bounds")));
  EXPECT_THAT(with_bounds("[0.75, 1.5]"), Not(Contains(states("period_bounds"))));
}

TEST_F(ProjectFile, what_no_check_of_a_number_meets_is_a_warning) {
  const auto warned = [&](const std::string& from, const std::string& to, const auto& warning) {
    EXPECT_THAT(choices_of(read(changed(from, to))), Contains(warning)) << to;
    EXPECT_THAT(choices_of(read(whole)), Not(Contains(warning))) << to;
  };
  warned("period_s = [1.0, 0.5]", "period_s = [0.2, 3]", states("0.2", "3 s"));
  warned("mass_ratio = 0.05", "array_weight_kn = 0.27\nweight_kn = 10700", states("2.5e-05"));
  warned("mass_ratio = 0.05", "mass_ratio = 0.05\ndamping = 0", states("damping = 0"));
  EXPECT_THAT(choices_of(read(whole)), Contains(states("site.tl_s", "T_L = 8 s")));
  EXPECT_THAT(choices_of(read(changed("[building]", "tl_s = 8\n[building]"))),
              Not(Contains(states("site.tl_s"))));
  folder_.write("sheet.csv",
                "direction,mu\nalong,0.50\nAlong,0.54\nalong,0.52\nalong,0.55\n"
                "along,0.51\nalong,0.2\nacross,0.6\n");
  const std::size_t begin = whole.find("[friction]");
  const Project project = read(whole.substr(0, begin) + "[friction]\nfile = \"sheet.csv\"\n" +
                               whole.substr(whole.find("[suite]")));
  EXPECT_EQ(project.friction.tested.size(), 2u);  // Along is along
  EXPECT_THAT(choices_of(project), testing::AllOf(Contains(states("direction across")),
                                                  Contains(states("test 6 of 6"))));
}

TEST_F(ProjectFile, a_spectrum_in_another_unit_is_refused_by_its_key) {
  folder_.write("site.csv", "period_s,design_sa_g\n0,34\n0.2,85\n1,45\n5,9\n");
  const auto problems = problems_of(
      changed("ss_g = 1.313\ns1_g = 0.471\nsite_class = \"default\"", "spectrum = \"site.csv\""));
  ASSERT_GE(problems.size(), 1u);
  EXPECT_THAT(problems.front().where, testing::EndsWith("p.toml:5"));
}

TEST_F(ProjectFile, beside_a_spectrum_a_part_of_the_mapped_values_has_no_effect) {
  folder_.write("site.csv", "period_s,design_sa_g\n0,0.4\n0.2,1.0\n1,0.6\n5,0.12\n");
  EXPECT_EQ(problems_of(changed("ss_g = 1.313\n", "spectrum = \"site.csv\"\n")).size(), 2u);
}

// S_DS 2/3 x 1.2 x 1.5 = 1.2 g and S_D1 2/3 x 2.5 x 0.6 = 1.0 g by 21.3; 80 % of both and of the
// plateau's ends.
TEST_F(ProjectFile, a_site_specific_spectrum_is_compared_with_that_of_the_site_class) {
  const auto check = [&](const std::string& rows, const std::string& edition = "asce7_16") {
    folder_.write("site.csv", "period_s,design_sa_g\n" + rows);
    std::string text = changed("ss_g = 1.313\ns1_g = 0.471\n",
                               "spectrum = \"site.csv\"\nss_g = 1.5\ns1_g = 0.6\n");
    const Project project = read(text.replace(text.find("asce7_16"), 8, edition));
    EXPECT_EQ(project.site.mapped->s1_g, 0.6);
    EXPECT_TRUE(choices_of(project).empty() ||
                choices_of(project).front().find("not checked") == std::string::npos);
    return checks_before_analysis(project, 7).at(1);
  };
  const std::string plateau = "0,0.39\n0.16667,0.97\n0.83333,0.97\n1,0.81\n2,0.41\n4,0.21\n";
  EXPECT_TRUE(check(plateau + "5,0.17\n").is_met);
  EXPECT_FALSE(check(plateau + "5,0.15\n").is_met);
  EXPECT_THAT(check(plateau + "5,0.15\n").found, states("0.750", "5 s"));
  // Of class E from 0.75 to 1 g of S_S, which its table leaves out, F_a is that of 0.75 g: 1.3.
  std::string soft = changed("ss_g = 1.313\ns1_g = 0.471\nsite_class = \"default\"",
                             "spectrum = \"site.csv\"\nss_g = 0.9\ns1_g = 0.3\n"
                             "site_class = \"E\"");
  EXPECT_FALSE(checks_before_analysis(read(soft), 7).at(1).found.empty());
  EXPECT_THAT(problems_of(soft.insert(soft.find("ss_g"), "sds_g = 1\nsd1_g = 0.6\n")),
              one_problem("p.toml:6", "site.spectrum", "site.sds_g"));
  // By ASCE 7-10 F_v is 1.5, S_D1 0.6 g.
  EXPECT_TRUE(check(plateau + "5,0.1\n", "asce7_10").is_met);
  EXPECT_EQ(problems_of(changed("ss_g = 1.313\ns1_g = 0.471\nsite_class = \"default\"",
                                "spectrum = \"site.csv\"\nss_g = 1.5"))
                .size(),
            2u);  // s1_g and site_class
}

TEST_F(ProjectFile, clearances_allow_displacements_that_are_compared) {
  const Project project =
      read(whole + "[clearances]\nsimilar_array_m = 0.3\nobstruction_m = 0.6\nopen_edge_m = 1.0\n");
  EXPECT_THAT(compared_displacements_m(project, 0.55), ElementsAre(0.5, 0.55, 0.6));
  const std::string study = probability_study(project, folder_.path(), {0.5, 0.55, 0.6});
  folder_.write("probability.toml", study);
  EXPECT_THAT(read_study(folder_.path() / "probability.toml").verdict->exceedance,
              ElementsAre(0.1));
}

TEST_F(ProjectFile, an_array_that_slides_without_an_earthquake_is_refused) {
  const auto problems = problems_of(changed("rise_in_12 = 0.25", "slope_deg = 19"));
  EXPECT_TRUE(problems.empty());  // tan 19 deg is 0.34
  EXPECT_EQ(problems_of(changed("std = 0.04", "std = 0.24")).size(), 1u);
}

TEST_F(ProjectFile, unknown_keys_and_contradictions_are_refused) {
  EXPECT_EQ(problems_of(changed("[suite]", "[suite]\nfiel = 1")).size(), 1u);
  EXPECT_EQ(problems_of(changed("mu =", "file = \"x.csv\"\nmu =")).size(), 3u);
  EXPECT_EQ(problems_of(changed("site_class = \"default\"", "site_class = \"Z\"")).size(), 1u);
}

// A wrong hint is a number ready to be copied: A is hard rock.
TEST_F(ProjectFile, of_site_class_f_requires_a_site_response_analysis) {
  const auto refused = [&](const std::string& site, const auto& problem) {
    EXPECT_THAT(problems_of(changed("\"default\"", site)), problem) << site;
  };
  refused("\"F\"", one_problem("p.toml:7", "20.3.1"));
  refused("\"G\"", one_problem("p.toml:7", "A, B, C, D, E"));
  refused("\"G\"", Not(one_problem("p.toml:7", "did you mean")));
  refused("\"d\"", one_problem("p.toml:7", "did you mean \"D\"?"));
}

TEST_F(ProjectFile, the_number_of_tests_bounds_a_friction_that_is_typed) {
  EXPECT_FALSE(read(whole).friction.lower_bound.has_value());
  const Project project = read(changed("std = 0.04 }", "std = 0.04 }\ntests = 7"));
  // k of 7 tests with 95 % confidence: 3.399 for 95 % of the population, 4.641 for 99 %
  // (NIST/SEMATECH e-Handbook, 7.2.6.3); here 97.7 %.
  EXPECT_LT(*project.friction.lower_bound, 0.5 - 3.399 * 0.04);
  EXPECT_GT(*project.friction.lower_bound, 0.5 - 4.641 * 0.04);
  const std::vector<StudiedFriction> frictions = frictions_of(project);
  ASSERT_EQ(frictions.size(), 4u);
  EXPECT_EQ(frictions[0].value, *project.friction.lower_bound);
  EXPECT_EQ(frictions[1].value, project.friction.design());
}

// The suite of a project is named at its own line, not at that of a study that is made of it.
TEST_F(ProjectFile, of_a_suite_that_is_not_there_names_its_line) {
  EXPECT_THAT(problems_of(changed("\"suite.toml\"", "\"nowhere.toml\"")),
              one_problem("p.toml:18", "nowhere.toml"));
}

TEST_F(ProjectFile, values_that_no_building_or_site_has_are_refused) {
  EXPECT_EQ(problems_of(changed("mass_ratio", "storeys = 2.5\nmass_ratio")).size(), 1u);
  EXPECT_THAT(problems_of(changed("ss_g = 1.313", "ss_g = 131.3")),
              one_problem("p.toml:5", "site.ss_g = 131.3", "1.313"));
}

// The array slides in every direction of the pull tests.
TEST_F(ProjectFile, of_several_directions_the_lowest_design_friction_counts) {
  std::string logs = "test,direction,displacement_m,force_n,normal_n\n";
  for (const auto& [direction, first] : {std::pair{"across", 55}, std::pair{"along", 50}}) {
    for (int test = 0; test < 3; ++test) {
      for (const char* at : {"0", "0.01", "0.02", "0.03", "0.04", "0.05", "0.06"})
        logs += direction[1] + std::to_string(test) + "," + direction + "," + at + "," +
                std::to_string(first + test) + ",100\n";
    }
  }
  folder_.write("pulls.csv", logs);
  const std::string tested =
      changed("mu = { mean = 0.5, std = 0.04 }\nsource = \"report 7\"", "file = \"pulls.csv\"");
  const Project project = read(tested);
  EXPECT_EQ(project.friction.direction, "along");
  EXPECT_NEAR(project.friction.mean, 0.51, 1e-12);
  ASSERT_EQ(project.friction.tested.size(), 2u);
  EXPECT_THAT(
      project.friction.tested[0].sliding_mu,
      ElementsAre(DoubleNear(0.55, 1e-12), DoubleNear(0.56, 1e-12), DoubleNear(0.57, 1e-12)));
  const auto better = Contains(states("direction along", "0.490"));
  EXPECT_THAT(choices_of(project), Not(better));
  std::string across = tested;
  across.replace(across.find("[suite]"), 0, "direction = \"across\"\n");
  EXPECT_THAT(choices_of(read(across)), better);
}

TEST_F(ProjectFile, warns_of_a_height_in_feet_and_of_coarse_rounding) {
  EXPECT_THAT(choices_of(read(whole + "[result]\nround_up_m = \"10 ft\"\n")),
              Contains(states("10 ft (3.05 m)")));
  EXPECT_THAT(choices_of(read(changed("period_s = [1.0, 0.5]",
                                      "system = \"other\"\nheight_m = 130\nstoreys = 2"))),
              Contains(states("213 ft (65 m)")));
}

TEST_F(ProjectFile,
       warns_of_a_clearance_in_inches_and_of_a_hazard_curve_that_is_none_of_annual_rates) {
  EXPECT_THAT(choices_of(read(whole + "[clearances]\nopen_edge_m = 48\n")),
              Contains(states("157 ft (48 m)")));
  const auto with_rate = [&](const char* k0) {
    return choices_of(read(whole + "[hazard]\nk = 2\nk0 = " + k0 + "\ndesign_life_years = 25\n"));
  };
  const auto warning = Contains(states("rates", "years"));
  EXPECT_THAT(with_rate("1e-3"), Not(warning));
  EXPECT_THAT(with_rate("0.05"), warning);
}

TEST_F(ProjectFile, friction_that_no_roof_has_is_refused_or_a_warning) {
  EXPECT_THAT(problems_of(changed("mean = 0.5", "mean = 5.0")),
              one_problem("p.toml:15", "friction.mu.mean = 5", "0", "2"));
  EXPECT_THAT(choices_of(read(changed("mean = 0.5", "mean = 1.5"))),
              Contains(states("mean friction of 1.5")));

  const std::string tested =
      changed("mu = { mean = 0.5, std = 0.04 }\nsource = \"report 7\"", "file = \"pulls.csv\"");
  folder_.write("pulls.csv", "mu\n0.50\n0.54\n5.3\n");
  EXPECT_THAT(problems_of(tested), one_problem("p.toml:15", "pulls.csv:4"));
  folder_.write("pulls.csv", "mu\n0.50\n0.54\n0.51\n0.52\n0.84\n");
  EXPECT_THAT(choices_of(read(tested)), Contains(states("test 5 of 5", "0.84")));
  folder_.write("pulls.csv", "mu\n0.50\n0.54\n0.51\n0.52\n1.9\n");  // a design value below 0
  EXPECT_THAT(problems_of(tested), one_problem("p.toml:14", "test 5 of 5", "1.9", "-0.443"));
}

// Only what is known here, and all of it from memory.
TEST_F(ProjectFile, conditions_of_both_standards_are_of_storeys_and_risk_too) {
  std::string text = changed("\"III\"", "\"IV\"");
  text.replace(text.find("mass_ratio"), 0, "storeys = 10\n");
  const Project project = read(text);
  for (const PrescribedValue& value : prescribed_values(project, site_values(project.site))) {
    EXPECT_THAT(value.not_met(), states("storeys", "risk category"));
    for (const CodeCondition& c : value.conditions) EXPECT_EQ(c.provenance, Provenance::recalled);
  }
}

// SEAOC PV1-2012 asks for 3 in or more at 0.1 to 10 mm/s.
TEST_F(ProjectFile, pull_tests_at_another_speed_do_not_meet_their_check) {
  const auto check_of = [&](double speed_mmps) {
    std::string pulls = "test,direction,time_s,displacement_mm,force_n,normal_n\n";
    for (const auto& [test, force_n] : {std::pair{"A", 550}, {"B", 540}, {"C", 530}})
      for (const double s_mm : {0, 30, 80, 130, 180, 230})
        pulls += fmt::format("{},along,{},{},{},1000\n", test, s_mm / speed_mmps, s_mm, force_n);
    folder_.write("pulls.csv", pulls);
    return checks_before_analysis(
               read(changed("mu = { mean = 0.5, std = 0.04 }\nsource = \"report 7\"",
                            "file = \"pulls.csv\"")),
               7)
        .back();
  };
  EXPECT_TRUE(check_of(10.0).is_met) << check_of(10.0).found;
  EXPECT_FALSE(check_of(25.0).is_met);
  EXPECT_THAT(check_of(25.0).found, testing::HasSubstr("3 of 3"));
}

TEST_F(ProjectFile, a_hazard_analysis_is_an_exception_or_a_report) {
  const auto stating = [&](const std::string& what) {
    return changed("site_class = \"default\"",
                   "site_class = \"default\"\nhazard_analysis = \"" + what + "\"");
  };
  EXPECT_THAT(problems_of(stating("none")),
              one_problem("p.toml:8", "site.hazard_analysis", "none", "exception 1"));
  EXPECT_TRUE(problems_of(stating("exception 2 of 11.4.8")).empty());
  EXPECT_TRUE(problems_of(stating("report 14 of Smith, 2026")).empty());
}

TEST_F(ProjectFile, states_what_the_standards_ask_of_the_array) {
  const std::string text =
      "[array]\ncentre_of_mass_m = \"18 in\"\nsupport_spacing_m = \"5 ft\"\n"
      "interconnection = 0.2\n\n[building]\nstoreys = 2\n";
  std::string stated = changed("[building]\n", text);
  stated.replace(stated.find("[friction]\n"), 11, "[friction]\ntest_standard = \"ASTM G115\"\n");
  const Project project = read(stated);
  EXPECT_DOUBLE_EQ(project.array.centre_of_mass_m.value(), 0.4572);
  for (const PrescribedValue& value : prescribed_values(project, site_values(project.site)))
    EXPECT_EQ(value.not_met(), "");
}

TEST_F(ProjectFile, of_two_storeys_or_more_the_building_has_several_modes) {
  const auto building = [&](const std::string& keys) {
    return read(changed("[building]\n", "[building]\n" + keys)).building;
  };
  EXPECT_THAT(building("storeys = 1\n").alpha, testing::IsEmpty());
  const ProjectBuilding two = building("storeys = 2\n");
  EXPECT_THAT(two.alpha, ElementsAre(0.0, 2.0));
  EXPECT_THAT(two.mass_ratio, ElementsAre(0.0));
  EXPECT_THAT(two.mass_basis, states("neglected"));
  EXPECT_THAT(building("storeys = 2\nalpha = 7\n").alpha, ElementsAre(7.0));
  EXPECT_EQ(problems_of(changed("[building]\n", "[building]\nalpha = 7\n")).size(), 1u);
  EXPECT_EQ(problems_of(changed("[building]\n", "[building]\nstoreys = 2\nalpha = -7\n")).size(),
            1u);
}

TEST_F(ProjectFile, storeys_that_are_not_stated_are_one_mass_with_a_warning) {
  const auto of_storeys = [&](const char* storeys) {
    return choices_of(read(changed("[building]\n", std::string("[building]\n") + storeys)));
  };
  EXPECT_THAT(of_storeys(""), Contains(states("two storeys or more", "too little slip", "1.4")));
  for (const char* storeys : {"storeys = 1\n", "storeys = 2\n"})
    EXPECT_THAT(of_storeys(storeys), Not(Contains(states("too little slip")))) << storeys;
}

TEST_F(ProjectFile, a_spectrum_by_points_is_of_its_edition_and_in_g) {
  const auto site = [&](const std::string& edition) {
    std::string text = changed("edition = \"asce7_16\"\nss_g = 1.313\ns1_g = 0.471\n",
                               "edition = \"" + edition + "\"\nspectrum = \"site.csv\"\n");
    return text.erase(text.find("site_class"), std::string("site_class = \"default\"\n").size());
  };
  folder_.write("site.csv", "period_s,mce_sa_g\n0.01,0.7\n0.2,1.8\n1,0.9\n5,0.15\n");
  const Project project = read(site("asce7_22"));
  EXPECT_EQ(to_string(project.site.target), "ASCE 7-22, spectrum of 4 points");
  EXPECT_EQ(project.spectrum_sha256.size(), 64u);
  folder_.write("site.csv", "period_s,mce_sa_g\n0.01,70\n0.2,180\n1,90\n5,15\n");
  const auto is_spectrum = [](const std::string& row) {
    return testing::Field(&Problem::what, states("site.spectrum", "site.csv:" + row, "10 g"));
  };
  // Beside mapped values it is no contradiction: its values in percent are the only fault.
  for (const std::string& text :
       {site("asce7_16"), changed("ss_g = 1.313", "ss_g = 1.313\nspectrum = \"site.csv\"")})
    EXPECT_THAT(problems_of(text),
                ElementsAre(is_spectrum("2"), is_spectrum("3"),
                            testing::AllOf(is_spectrum("4"),
                                           testing::Field(&Problem::what, states("1 more")))));
  EXPECT_THAT(problems_of(changed("asce7_16", "asce7_22")),
              one_problem("p.toml:3", "ASCE 7-22", "sds_g"));
}

// Without leave the demand study is refused, as any study is.
TEST_F(ProjectFile, a_suite_that_falls_short_beyond_2_s_needs_leave) {
  std::string text = changed("[suite]", "[clearance]\nwithout_target = true\n[suite]");
  EXPECT_EQ(problems_of(text).size(), 1u);  // it has no effect up to 2 s
  text.replace(text.find("[1.0, 0.5]"), 10, "[1.0, 2.5]");
  folder_.write("demand.toml", demand_study(read(text), folder_.path()));
  EXPECT_TRUE(read_study(folder_.path() / "demand.toml").is_without_target());
}

TEST_F(ProjectFile, of_a_long_period_scales_its_suite_to_one_and_a_half_times_that) {
  const std::string text = changed("[1.0, 0.5]", "[1.0, 1.4]");
  for (const std::string& study : {demand_study(read(text), folder_.path()),
                                   probability_study(read(text), folder_.path(), {0.1})}) {
    folder_.write("demand.toml", study);
    EXPECT_NEAR(read_study(folder_.path() / "demand.toml").intensity.scaled_to_s, 2.1, 1e-12);
  }
  folder_.write("demand.toml", demand_study(read(whole), folder_.path()));
  EXPECT_EQ(read_study(folder_.path() / "demand.toml").intensity.scaled_to_s,
            IntensityConfig{}.scaled_to_s);
}

TEST_F(ProjectFile, scales_its_suite_by_the_rule_that_it_states) {
  const std::string text = changed("[suite]", "[suite]\nscaling_rule = \"asce7_16\"");
  for (const std::string& study : {demand_study(read(text), folder_.path()),
                                   probability_study(read(text), folder_.path(), {0.1})}) {
    folder_.write("demand.toml", study);
    EXPECT_EQ(read_study(folder_.path() / "demand.toml").intensity.scaling_rule,
              ScalingRule::asce7_16);
  }
  EXPECT_EQ(read(whole).scaling_rule, ScalingRule::walters_2012);
}

TEST_F(ProjectFile, of_one_period_and_mass_ratio_varies_both_for_the_sensitivity) {
  folder_.write("demand.toml", demand_study(read(changed("[1.0, 0.5]", "1.0")), folder_.path()));
  const StudyConfig study = read_study(folder_.path() / "demand.toml");
  EXPECT_THAT(study.quantities.at("building", "period_s").values,
              ElementsAre(DoubleNear(0.9, 1e-12), 1.0, DoubleNear(1.1, 1e-12)));
  EXPECT_THAT(study.quantities.at("building", "mass_ratio").values, ElementsAre(0.05, 0.1));
}

TEST_F(ProjectFile, is_not_taken_for_a_study_nor_the_reverse) {
  folder_.write("a.toml", whole);
  EXPECT_THAT(glissade::problems_of([&] { read_study(folder_.path() / "a.toml"); }),
              one_problem("a.toml", "glissade clearance"));
  EXPECT_THAT(problems_of("[study]\nname = \"a\"\n"), one_problem("p.toml", "glissade run"));
}

// The studies that are made are study files: the plan of their numbers.
TEST_F(ProjectFile, studies_state_the_projects_numbers) {
  const Project project = read(whole);
  folder_.write("demand.toml", demand_study(project, folder_.path()));
  const auto of_demand = read_study(folder_.path() / "demand.toml").quantities;
  EXPECT_THAT(of_demand.at("building", "period_s").values, ElementsAre(0.5, 1.0));
  EXPECT_THAT(of_demand.at("friction", "mu").values,
              ElementsAre(DoubleNear(0.42, 1e-12), 0.5, DoubleNear(0.58, 1e-12)));
  EXPECT_NEAR(of_demand.at("roof", "slope_deg").values.front(), 1.1935, 1e-4);
  folder_.write("probability.toml", probability_study(project, folder_.path(), {0.5}));
  EXPECT_THAT(read_study(folder_.path() / "probability.toml").fragility->thresholds_m,
              ElementsAre(0.5));
}

}  // namespace
}  // namespace glissade
