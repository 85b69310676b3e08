// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/improbable.hpp"
#include "project_files.hpp"

// What is computed, and stated as a check or a warning.
namespace glissade {
namespace {

using test::states;
using testing::AllOf;
using testing::Contains;
using testing::Field;
using testing::Not;

using ProjectChecks = ProjectFiles;

TEST_F(ProjectChecks, plain_numbers_in_us_units_are_a_warning) {
  const std::string clearance = whole_project + "[clearances]\nopen_edge_m = ";
  EXPECT_THAT(warnings_of(clearance + "4\n"),
              Contains(states("clearances.open_edge_m = 4", "13.1 ft")));
  for (const std::string& text :
       {clearance + "\"4 ft\"\n", changed("[site]", "units = \"si\"\n[site]", clearance + "4\n")})
    EXPECT_THAT(warnings_of(text), Not(Contains(states("clearances.open_edge_m")))) << text;
  // 4 m in place of 4 ft may make a separation sufficient: it is an open item too.
  EXPECT_THAT(warnings_on(read(clearance + "4\n")),
              Contains(AllOf(Field(&DesignWarning::text, states("clearances.open_edge_m = 4")),
                             Field(&DesignWarning::is_open_item, true))));
}

TEST_F(ProjectChecks, bounds_without_the_period_between_them_are_a_warning) {
  const auto with_bounds = [&](const std::string& bounds) {
    return warnings_of(
        changed(period, "system = \"other\"\nheight_m = \"35 ft\"\nperiod_bounds = " + bounds));
  };
  EXPECT_THAT(with_bounds("[1.1, 1.2]"), Contains(states("period_bounds")));
  EXPECT_THAT(with_bounds("[0.75, 1.5]"), Not(Contains(states("period_bounds"))));
}

// Not also that building.system is missing, nor the keys of a building without such motions.
TEST_F(ProjectChecks, a_building_below_motions_of_its_roof_is_one_problem) {
  folder_.write("suite.toml", "[suite]\nname = \"r\"\nmotions = \"roof\"\n");
  for (const char* building : {"modes = [{ period_s = 0.5 }]", "height_m = \"40 ft\"",
                               "weight_kn = 1000", "period_s = 0.5\nmodes = []"}) {
    const std::vector<Problem> problems =
        problems_of(changed(period + "\n" + mass_ratio, building));
    ASSERT_EQ(problems.size(), std::string(building).starts_with("period_s") ? 2u : 1u) << building;
    for (const Problem& problem : problems)
      EXPECT_THAT(problem.suggestion, states("leave out all of [building] but storeys"));
  }
  folder_.write("suite.toml", "");
  EXPECT_THAT(problems_of(with("[building]", "modes = []")),
              Contains(Field(&Problem::suggestion, states("storeys and alpha"))));
}

TEST_F(ProjectChecks, lengths_that_are_refused_are_named_as_they_are_written) {
  EXPECT_THAT(
      problems_of(whole_project + "[clearances]\nopen_edge_m = \"-2 ft\"\n"),
      Contains(Field(&Problem::what, states("clearances.open_edge_m = '-2 ft' is not 0 or more"))));
}

TEST_F(ProjectChecks, what_no_rule_of_a_number_meets_is_a_warning) {
  const std::vector<std::string> usual = warnings_of(whole_project);
  const auto warned = [&](const std::string& from, const std::string& to, const auto& warning) {
    EXPECT_THAT(warnings_of(changed(from, to)), Contains(warning)) << to;
    EXPECT_THAT(usual, Not(Contains(warning))) << to;
  };
  warned(period, "period_s = [0.2, 3]", states("0.2", "3 s"));
  warned(period, "system = \"other\"\nheight_m = 130\nstoreys = 2", states("213 ft (65 m)"));
  warned(mass_ratio, "array_weight_kn = 0.27\nweight_kn = 10700", states("2.52e-05"));
  warned(mass_ratio, mass_ratio + "\ndamping = 0", states("damping 0 is below"));
  const std::string end = "file = \"suite.toml\"\n";
  warned(end, end + "[result]\nround_up_m = \"10 ft\"\n", states("10 ft (3.05 m)"));
  warned(end, end + "[clearances]\nopen_edge_m = 48\n", states("157 ft (48 m)"));
  EXPECT_THAT(usual, Contains(states("site.tl_s", "T_L = 8 s")));
  EXPECT_THAT(warnings_of(changed("[building]", "tl_s = 8\n[building]")),
              Not(Contains(states("site.tl_s"))));
}

TEST_F(ProjectChecks, a_hazard_curve_that_is_none_of_annual_rates_is_a_warning) {
  const auto with_rate = [&](const std::string& k0) {
    return warnings_of(whole_project + "[hazard]\nk = 2\nk0 = " + k0 +
                       "\ndesign_life_years = 25\n");
  };
  const auto warning = Contains(states("rates", "years"));
  EXPECT_THAT(with_rate("1e-3"), Not(warning));
  EXPECT_THAT(with_rate("0.05"), warning);
}

TEST_F(ProjectChecks, storeys_that_are_not_stated_are_one_mass_with_a_warning) {
  EXPECT_THAT(warnings_of(whole_project),
              Contains(states("two storeys or more", "too little slip", "1.4")));
  for (const char* storeys : {"storeys = 1", "storeys = 2"})
    EXPECT_THAT(warnings_of(with("[building]", storeys)), Not(Contains(states("too little slip"))))
        << storeys;
  // Once: the studies of the project do not repeat it.
  EXPECT_TRUE(demand_of(whole_project).building.is_one_storey);
}

// S_DS 2/3 x 1.2 x 1.5 = 1.2 g and S_D1 2/3 x 2.5 x 0.6 = 1.0 g by 21.3; 80 % of both and of the
// plateau's ends.
TEST_F(ProjectChecks, a_site_specific_spectrum_is_compared_with_that_of_the_site_class) {
  const auto check = [&](const std::string& rows, const std::string& edition = "asce7_16") {
    folder_.write("site.csv", "period_s,design_sa_g\n" + rows);
    const std::string text = changed(mapped, "spectrum = \"site.csv\"\nss_g = 1.5\ns1_g = 0.6\n");
    const Project project = read(changed("asce7_16", edition, text));
    EXPECT_EQ(project.site.mapped->s1_g, 0.6);
    EXPECT_THAT(texts_of(warnings_on(project)), Not(Contains(states("(site.ss_g)"))));
    return checks_before_analysis(project, 7).at(1);
  };
  const std::string plateau = "0,0.39\n0.16667,0.97\n0.83333,0.97\n1,0.81\n2,0.41\n4,0.21\n";
  EXPECT_TRUE(check(plateau + "5,0.17\n").is_met);
  EXPECT_FALSE(check(plateau + "5,0.15\n").is_met);
  EXPECT_THAT(check(plateau + "5,0.15\n").found, states("0.750", "5 s"));
  // Of class E from 0.75 to 1 g of S_S, which its table leaves out, F_a is that of 0.75 g: 1.3.
  const std::string soft = changed(mapped + site_class,
                                   "spectrum = \"site.csv\"\nss_g = 0.9\ns1_g = 0.3\n"
                                   "site_class = \"E\"\n");
  EXPECT_FALSE(checks_before_analysis(read(soft), 7).at(1).found.empty());
  EXPECT_THAT(problems_of(changed("ss_g", "sds_g = 1\nsd1_g = 0.6\nss_g", soft)),
              one_problem("p.toml:6", "site.spectrum", "site.sds_g"));
  // By ASCE 7-10 F_v is 1.5, S_D1 0.6 g.
  EXPECT_TRUE(check(plateau + "5,0.1\n", "asce7_10").is_met);
}

// S_DS of the maps 2/3 x 1.2 x 1.5 = 1.2 g; of points 0.9 x their largest: 0.9 x 1.2 is 0.9 of it.
TEST_F(ProjectChecks, a_spectrum_lowers_s_ds_by_a_fifth_at_most_and_not_by_exception_2) {
  const auto check = [&](const std::string& plateau_g, const std::string& exception) {
    folder_.write("site.csv",
                  "period_s,design_sa_g\n0.01," + plateau_g + "\n5," + plateau_g + "\n");
    return checks_before_analysis(
               read(changed(mapped,
                            "spectrum = \"site.csv\"\nss_g = 1.5\ns1_g = 0.6\n" + exception)),
               7)
        .at(2);
  };
  const std::string exception_2 = "hazard_analysis = \"exception 2 of 11.4.8\"\n";
  EXPECT_TRUE(check("1.2", "").is_met);
  EXPECT_FALSE(check("1.06", "").is_met);
  EXPECT_EQ(check("1.2", exception_2).found, "0.900");
  EXPECT_FALSE(check("1.2", exception_2).is_met);
  EXPECT_TRUE(check("1.3333333333333335", exception_2).is_met);
}

// Only what is known here, and all of it from memory.
TEST_F(ProjectChecks, conditions_of_both_standards_are_of_storeys_and_risk_too) {
  const Project project = read(changed("\"III\"", "\"IV\"", with("[building]", "storeys = 10")));
  for (const PrescribedValue& value : prescribed_values(project, site_values(project.site))) {
    EXPECT_THAT(value.not_met(), states("storeys", "risk category"));
    for (const CodeCondition& c : value.conditions) EXPECT_EQ(c.provenance, Provenance::recalled);
  }
}

TEST_F(ProjectChecks, conditions_of_the_standards_are_met_by_what_they_ask_of_the_array) {
  const std::string array =
      "[array]\ncentre_of_mass_m = \"18 in\"\nsupport_spacing_m = \"5 ft\"\n"
      "interconnection = 0.2\n";
  const Project project = read(changed("[building]\n", array + "[building]\nstoreys = 2\n",
                                       with("[friction]", "test_standard = \"ASTM G115\"")));
  EXPECT_DOUBLE_EQ(project.array.centre_of_mass_m.value(), 0.4572);
  for (const PrescribedValue& value : prescribed_values(project, site_values(project.site)))
    EXPECT_EQ(value.not_met(), "");
}

}  // namespace
}  // namespace glissade
