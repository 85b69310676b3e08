// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/improbable.hpp"
#include "project_files.hpp"

namespace glissade {
namespace {

using test::states;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::Field;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::SizeIs;

using ProjectFile = ProjectFiles;

TEST_F(ProjectFile, is_read) {
  const Project project = read(whole_project);
  EXPECT_THAT(project.building.period_s, ElementsAre(0.5, 1.0));
  EXPECT_THAT(project.slope_deg, ElementsAre(DoubleNear(1.1935, 1e-4)));
  EXPECT_NEAR(project.friction.design(), 0.42, 1e-12);
  EXPECT_EQ(project.importance, 1.25);  // of risk category III
  EXPECT_THAT(project.site.target.site_classes, ElementsAre(SiteClass::unknown));
  EXPECT_EQ(project.suite, folder_.path() / "suite.toml");
  EXPECT_EQ(project.scaling_rule, ScalingRule::walters_2012);
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
  EXPECT_THAT(problems, SizeIs(10));
}

TEST_F(ProjectFile, is_not_taken_for_a_study_nor_the_reverse) {
  folder_.write("a.toml", whole_project);
  EXPECT_THAT(glissade::problems_of([&] { read_study(folder_.path() / "a.toml"); }),
              one_problem("a.toml", "glissade clearance"));
  EXPECT_THAT(problems_of("[study]\nname = \"a\"\n"), one_problem("p.toml", "glissade run"));
}

TEST_F(ProjectFile, unknown_keys_and_contradictions_are_refused) {
  EXPECT_THAT(problems_of(with("[suite]", "fiel = 1")), SizeIs(1));
  EXPECT_THAT(problems_of(changed("mu =", "file = \"x.csv\"\nmu =")), SizeIs(2));
}

// The suite of a project is named at its own line, not at that of a study that is made of it.
TEST_F(ProjectFile, of_a_suite_that_is_not_there_names_its_line) {
  EXPECT_THAT(problems_of(changed("\"suite.toml\"", "\"nowhere.toml\"")),
              one_problem("p.toml:18", "nowhere.toml"));
}

TEST_F(ProjectFile, numbers_may_have_units) {
  const Project project = read(
      whole_project + "[clearances]\nopen_edge_m = \"4 ft\"\n[result]\nround_up_m = \"0.5 in\"\n");
  EXPECT_EQ(project.available_m.at(3), 1.2192);
  EXPECT_EQ(project.round_up_m, 0.0127);
  EXPECT_EQ(read(changed("= 0.25", "= \"1/4:12\"")).slope_deg, read(whole_project).slope_deg);
  EXPECT_THAT(problems_of(changed("= 0.25", "= \"0.25 kip\"")), SizeIs(1));
}

TEST_F(ProjectFile, any_number_of_gaps_have_name_kind_and_clearance) {
  const std::string gap =
      "[[gap]]\nname = \"duct\"\nkind = \"open_edge\"\navailable_m = \"4 ft\"\n";
  const Project project = read(
      whole_project + gap + "[[gap]]\nname = \"hatch\"\nkind = \"obstruction\"\navailable_m = 2\n");
  ASSERT_EQ(project.gaps.size(), 2u);
  EXPECT_EQ(project.gaps[0].name, "duct");
  EXPECT_EQ(project.gaps[0].available_m, 1.2192);
  const auto separations = separations_of(project.standard, 1.0);
  EXPECT_THAT(separations.at(project.gaps[0].kind).what, HasSubstr("edge without"));
  EXPECT_THAT(separations.at(project.gaps[1].kind).what, HasSubstr("fixed object"));
  EXPECT_THAT(problems_of(whole_project + gap + gap), SizeIs(1));
  EXPECT_THAT(problems_of(whole_project + "[[gap]]\nname = \"duct\"\n"), SizeIs(2));
  EXPECT_THAT(problems_of(changed("open_edge", "wall", whole_project + gap)), SizeIs(1));
}

TEST_F(ProjectFile, a_period_and_a_height_are_refused_whether_there_is_a_system_or_not) {
  for (const char* system : {"", "\nsystem = \"other\""}) {
    const auto problems =
        problems_of(changed(period, period + "\nheight_m = 9" + std::string(system)));
    ASSERT_FALSE(problems.empty());
    for (const Problem& problem : problems)
      EXPECT_THAT(problem.suggestion, states("give the period, or the system and the height"));
  }
}

TEST_F(ProjectFile, a_period_comes_from_system_and_height) {
  const std::string text =
      changed(period, "system = \"other\"\nheight_m = 10.668\nperiod_bounds = [1.0, 2.0]");
  const ProjectBuilding building = read(text).building;
  ASSERT_EQ(building.period_s.size(), 5u);
  EXPECT_NEAR(building.period_s.front(), 0.288, 1e-3);
  EXPECT_NEAR(building.period_s.back(), 0.576, 2e-3);
  EXPECT_THAT(building.period_basis, states("0.02 (35 ft)^0.75", "ASCE 7-16, 12.8-7"));
  // C_t of the table in metres
  EXPECT_THAT(read(changed("[site]", "units = \"si\"\n[site]", text)).building.period_basis,
              states("0.0488 (10.67 m)^0.75"));
}

TEST_F(ProjectFile, bounds_of_the_period_have_as_many_periods_as_leave_no_gap) {
  const auto periods = [&](const std::string& bounds) {
    return read(
               changed(period, "system = \"other\"\nheight_m = \"9 m\"\nperiod_bounds = " + bounds))
        .building.period_s;
  };
  EXPECT_THAT(periods("[0.75, 1.5]"), SizeIs(5));
  for (const char* bounds : {"[0.75, 2.5]", "[0.3, 3]", "[0.75, 2.15]"})
    EXPECT_EQ(gaps_between(periods(bounds)), "") << bounds;
}

TEST_F(ProjectFile, the_mass_ratio_may_come_from_weights) {
  const Project project =
      read(changed(mass_ratio, "array_weight_kn = \"60 kip\"\nweight_kn = \"2400 kip\""));
  EXPECT_THAT(project.building.mass_ratio, ElementsAre(DoubleNear(0.025, 1e-9)));
  const Project none = read(changed(mass_ratio, "array_weight_kn = 0\nweight_kn = 900"));
  EXPECT_EQ(none.building.mass_ratio.front(), 0.0);
  EXPECT_THAT(none.building.mass_basis, states("202.3 kip", "900.0 kN"));  // over 4.4482 kN/kip
  for (const std::string& wrong :
       {std::string("array_weight_kn = 60"), std::string("array_weight_kn = 60\nweight_kn = 50"),
        mass_ratio + "\narray_weight_kn = 60\nweight_kn = 900"})
    EXPECT_THAT(problems_of(changed(mass_ratio, wrong)), SizeIs(1)) << wrong;
}

TEST_F(ProjectFile, of_two_storeys_or_more_the_building_has_several_modes) {
  const auto building = [&](const std::string& keys) {
    return read(with("[building]", keys)).building;
  };
  EXPECT_THAT(building("storeys = 1").alpha, IsEmpty());
  const ProjectBuilding two = building("storeys = 2");
  EXPECT_THAT(two.alpha, ElementsAre(0.0, 2.0));
  EXPECT_THAT(two.mass_ratio, ElementsAre(0.0));
  EXPECT_THAT(two.mass_basis, states("0.05", "neglected"));
  EXPECT_THAT(building("storeys = 2\nalpha = 7").alpha, ElementsAre(7.0));
  for (const char* wrong : {"alpha = 7", "storeys = 2\nalpha = -7", "storeys = 2.5"})
    EXPECT_THAT(problems_of(with("[building]", wrong)), SizeIs(1)) << wrong;
}

// In the project's own key, not in that of a study which is made from it.
TEST_F(ProjectFile, values_that_no_building_or_site_has_are_refused_by_their_keys) {
  EXPECT_THAT(problems_of(changed(period, "period_s = 300")), one_problem("p.toml:10", "300 s"));
  EXPECT_THAT(problems_of(changed(period, "system = \"other\"\nheight_m = 7000")),
              one_problem("p.toml:11", "56 s"));
  EXPECT_THAT(problems_of(whole_project + "[hazard]\nk0 = 1756\nk = 2.2\ndesign_life_years = 25\n"),
              one_problem("p.toml:20", "6.244e+06", "k0"));
  EXPECT_THAT(problems_of(changed("ss_g = 1.313", "ss_g = 131.3")),
              one_problem("p.toml:5", "site.ss_g = 131.3", "1.313"));
  EXPECT_THAT(problems_of(changed(period, "system = \"concrete_shear_wall\"\nheight_m = \"9 m\"")),
              ElementsAre(Field(&Problem::suggestion,
                                testing::StartsWith("known are steel_moment_frame"))));
}

// Issue 48: motions of a roof need no building, and a suite that is not there may be of a roof.
TEST_F(ProjectFile, a_suite_that_is_not_there_is_the_only_problem) {
  const std::string below = changed(period + "\n" + mass_ratio + "\n", "storeys = 3\n");
  EXPECT_THAT(problems_of(changed("suite.toml", "roof.toml", below)),
              one_problem("p.toml:17", "no suite", "roof.toml"));
}

TEST_F(ProjectFile, a_period_that_no_building_has_is_refused) {
  for (const char* period_s : {"0.005", "[0.005, 0.5]", "16"})
    EXPECT_THAT(problems_of(changed(period, "period_s = " + std::string(period_s))),
                one_problem("p.toml:10", "no building has"));
}

// A wrong hint is a number ready to be copied: A is hard rock.
TEST_F(ProjectFile, of_site_class_f_requires_a_site_response_analysis) {
  const auto refused = [&](const std::string& site, const auto& problem) {
    EXPECT_THAT(problems_of(changed("\"default\"", site)), problem) << site;
  };
  refused("\"F\"", one_problem("p.toml:7", "20.3.1"));
  refused("\"G\"", one_problem("p.toml:7", "A, B, C, D, E"));
  refused("\"Z\"", testing::SizeIs(1));
  refused("\"G\"", Not(one_problem("p.toml:7", "did you mean")));
  refused("\"d\"", one_problem("p.toml:7", "did you mean \"D\"?"));
}

TEST_F(ProjectFile, a_spectrum_by_points_is_of_its_edition_and_in_g) {
  const auto site = [&](const std::string& edition) {
    return changed("edition = \"asce7_16\"\n" + mapped + site_class,
                   "edition = \"" + edition + "\"\nspectrum = \"site.csv\"\n");
  };
  folder_.write("site.csv", "period_s,mce_sa_g\n0.01,0.7\n0.2,1.8\n1,0.9\n5,0.15\n");
  const Project project = read(site("asce7_22"));
  EXPECT_EQ(to_string(project.site.target), "ASCE 7-22, spectrum of 4 points");
  EXPECT_EQ(project.spectrum_sha256.size(), 64u);
  folder_.write("site.csv", "period_s,mce_sa_g\n0.01,70\n0.2,180\n1,90\n5,15\n");
  const auto is_spectrum = [](const std::string& row) {
    return Field(&Problem::what, states("site.spectrum", "site.csv:" + row, "10 g"));
  };
  // Beside mapped values it is no contradiction: its values in percent are the only fault.
  for (const std::string& text :
       {site("asce7_16"), changed("ss_g = 1.313", "ss_g = 1.313\nspectrum = \"site.csv\"")})
    EXPECT_THAT(
        problems_of(text),
        ElementsAre(is_spectrum("2"), is_spectrum("3"),
                    testing::AllOf(is_spectrum("4"), Field(&Problem::what, states("1 more")))));
  EXPECT_THAT(problems_of(changed("asce7_16", "asce7_22")),
              one_problem("p.toml:3", "ASCE 7-22", "sds_g"));
}

TEST_F(ProjectFile, a_spectrum_whose_s_ds_no_site_has_is_refused_by_its_key) {
  folder_.write("site.csv", "period_s,design_sa_g\n0,34\n0.2,85\n1,45\n5,9\n");
  const auto problems = problems_of(changed(mapped + site_class, "spectrum = \"site.csv\"\n"));
  ASSERT_GE(problems.size(), 1u);
  EXPECT_THAT(problems.front().where, testing::EndsWith("p.toml:5"));
}

TEST_F(ProjectFile, beside_a_spectrum_a_part_of_the_mapped_values_has_no_effect) {
  folder_.write("site.csv", "period_s,design_sa_g\n0,0.4\n0.2,1.0\n1,0.6\n5,0.12\n");
  for (const auto& [from, to] :
       {std::pair{std::string("ss_g = 1.313\n"), "spectrum = \"site.csv\"\n"},
        {mapped + site_class, "spectrum = \"site.csv\"\nss_g = 1.5\n"}})  // s1_g and site_class
    EXPECT_THAT(problems_of(changed(from, to)), SizeIs(2)) << to;
}

}  // namespace
}  // namespace glissade
