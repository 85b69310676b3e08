// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "complete_project.hpp"
#include "glissade/design/premises.hpp"
#include "project_files.hpp"

// A project that is complete, and each premise removed or contradicted in turn.
namespace glissade {
namespace {

using test::complete_project;
using test::states;
using enum SeparationVerdict;

struct Case {
  std::string key, from, to;
  SeparationVerdict verdict = open;
  bool of_roof = false;
};

const std::string mapped_values = "ss_g = 1.3\ns1_g = 0.45\nsite_class = \"C\"\n",
                  design = "sds_g = 1.0\nsd1_g = 0.6\n", points = "spectrum = \"site.csv\"\n",
                  of_period = "period_s = 0.35\n",
                  typed = "mu = { mean = 0.7, std = 0.02 }\nsource = \"report 7\"\ntests = 9\n",
                  tested = "tested_on = \"2024-10-14\"\n", named = "complete\"\n",
                  of_report = "report = \"report 12\"\nauthor = \"Smith\"\ndate = \"2024-10-14\"\n",
                  of_analysis =
                      "hazard_report = \"report 7\"\nhazard_author = \"Smith\"\nhazard_date = "
                      "\"2024-10-14\"\n";

std::string class_d(const std::string& exceptions) {
  return "ss_g = 1.3\ns1_g = 0.45\nsite_class = \"D\"\nhazard_analysis = " + exceptions + "\n";
}

const std::vector<Case> cases = {
    {"project.units", "\"11 in\"", "0.28"},
    {"standards.compare", "asce7_16\"\n" + mapped_values, "asce7_22\"\n" + design},
    {"standards.compare", "edition = \"asce7_16\"", "edition = \"asce7_10\""},
    {"standards.compare", "compare = \"asce7_16\"", "compare = \"seaoc_pv1_2012\""},
    {"standards.importance", "compare = \"asce7_16\"", "compare = \"asce7_16\"\nimportance = 1.0"},
    {"site.hazard_analysis", "site_class = \"C\"", "site_class = \"D\""},
    {"site.hazard_analysis", mapped_values, class_d("\"exception 1 of 11.4.8\"")},
    {"site.hazard_analysis", mapped_values, class_d("\"exception 3 of 11.4.8\"")},
    {"site.hazard_analysis", mapped_values,
     class_d("[\"exception 2 of 11.4.8\", \"exception 3 of 11.4.8\"]")},
    {"site.hazard_analysis", mapped_values, class_d("\"exception 2 of 11.4.8\""), sufficient},
    {"site.hazard_report", mapped_values, design + "hazard_analysis = \"exception 2 of 11.4.8\"\n"},
    {"site.hazard_report", mapped_values, design + of_analysis, sufficient},
    // Issue 48: a spectrum of the user's own took the premise away.
    {"site.hazard_report", mapped_values, points + mapped_values},
    {"site.hazard_report", mapped_values, points + class_d("\"exception 2 of 11.4.8\""),
     sufficient},
    {"site.hazard_report", mapped_values, points + mapped_values + of_analysis, sufficient},
    {"site.hazard_author", mapped_values,
     points + mapped_values + "hazard_report = \"report 7\"\n"},
    {"site.hazard_date", mapped_values,
     points + mapped_values +
         "hazard_report = \"7\"\nhazard_author = \"S\"\nhazard_date = \"2999-01-01\"\n"},
    {"site.ss_g", mapped_values, points + of_analysis},
    {"site.fault_distance_km", "fault_distance_km = 30\n", ""},
    {"site.fault_distance_km", "fault_distance_km = 30", "fault_distance_km = 8"},
    {"building.diaphragm", "diaphragm = \"rigid\"\n", ""},
    {"building.diaphragm", "\"rigid\"", "\"flexible\""},
    {"building.diaphragm", "\"rigid\"", "\"semirigid\""},
    {"building.period_s", of_period, "period_s = 4.1\n"},  // a frequency
    {"building.period_s", of_period, "period_s = 0.04\n"},
    {"building.period_s", of_period, "period_s = 1.01\n"},
    {"building.period_s", of_period, "period_s = 0.99\n", sufficient},
    {"building.period_s", "storeys = 2\n", ""},
    {"building.period_s", of_period, "system = \"other\"\nheight_m = \"28 ft\"\n", sufficient},
    {"friction.source", "report 7", "not stated: name the test report"},
    {"friction.source", typed, "file = \"pulls.csv\"\n"},
    {"friction.source", typed, "file = \"pulls.csv\"\nsource = \"report 7\"\n", sufficient},
    {"friction.laboratory", "Own laboratory", ""},
    {"friction.laboratory", "Own laboratory", "N/A"},
    {"friction.laboratory", "Own laboratory", "Nonesuch Laboratory", sufficient},
    {"friction.tested_on", tested, ""},
    {"friction.tested_on", "2024-10-14", "last year"},
    {"friction.tested_on", "2024-10-14", "2026-02-30"},
    {"friction.tested_on", "2024-10-14", "2999-01-01"},
    {"friction.tested_on", named, named + "date = \"2024-10-13\"\n"},
    {"friction.tested_on", named, named + "date = \"2024-10-14\"\n", sufficient},
    {"friction.surface", "surface = \"wet\"\n", ""},
    {"array", "interconnection = 0.2\n", ""},
    {"array", "interconnection = 0.2\n", "interconnection = 0.05\n", not_applicable},
    {"suite.file", "recorded.toml", "suite.toml"},
    {"suite.scaling_rule", "recorded.toml\"", "recorded.toml\"\nscaling_rule = \"asce7_10\""},
    {"suite.scaling_rule", "recorded.toml\"", "recorded.toml\"\nscaling_rule = \"asce7_16\"",
     sufficient},
    {"suite.report", "report = \"report 12\"\n", "", open, true},
    {"suite.author", "\"Smith\"", "\"unknown\"", open, true},
    {"suite.date", "date = \"2024-10-14\"\n[sampling]", "date = \"October\"\n[sampling]", open,
     true},
    {"suite.date", "date = \"2024-10-14\"\n[sampling]", "date = \"2999-01-01\"\n[sampling]", open,
     true}};

class PremisesOfProject : public ProjectFiles {
 protected:
  PremisesOfProject() {
    folder_.write("a.csv", "");
    for (const char* of : {"ground", "roof"})
      folder_.write(of == std::string("roof") ? "roof.toml" : "recorded.toml",
                    "[suite]\nname = \"a\"\nmotions = \"" + std::string(of) +
                        "\"\n[[record]]\nid = \"a\"\nfirst = \"a.csv\"\n");
    folder_.write("pulls.csv", "mu\n0.70\n0.71\n0.69\n0.70\n0.71\n0.69\n0.70\n0.71\n0.69\n");
    folder_.write("site.csv", "period_s,design_sa_g\n0,0.6\n0.1,1.3\n0.6,1.3\n5,0.2\n");
  }
  static std::string project(bool of_roof) {
    if (!of_roof) return complete_project;
    const std::string text =
        changed("recorded.toml\"\n", "roof.toml\"\n" + of_report, complete_project);
    return changed("diaphragm = \"rigid\"\n", "",
                   changed(of_period + "mass_ratio = 0.02\n", "", text));
  }
  /// As a package has it, of an analysis that requires little.
  static SeparationVerdict verdict_of(const Project& project) {
    DesignClearance design{.site = site_values(project.site)};
    design.prescribed = prescribed_values(project, design.site);
    for (std::size_t i = 0; const Separation& s : separations_of(project.standard, 0.1))
      design.separations.push_back({s, project.available_m[i++]});
    design.warnings = warnings_on(project);
    return verdict_on(project, design);
  }
};

TEST_F(PremisesOfProject, that_are_all_met_make_it_sufficient) {
  for (const bool of_roof : {false, true}) {
    const Project whole = read(project(of_roof));
    EXPECT_EQ(verdict_of(whole), sufficient);
    for (const Premise& premise : premises_of(whole))
      EXPECT_TRUE(premise.found.is_met) << not_met_text(premise);
  }
}

TEST_F(PremisesOfProject, that_one_is_not_stated_or_contradicted_makes_it_open) {
  std::set<std::string> keys;
  for (const Case& c : cases) {
    SCOPED_TRACE(c.key + ": " + c.to);
    const Project other = read(changed(c.from, c.to, project(c.of_roof)));
    EXPECT_EQ(verdict_of(other), c.verdict);
    const auto premises = premises_of(other);
    const auto unmet =
        std::ranges::find_if(premises, [](const Premise& p) { return !p.found.is_met; });
    EXPECT_EQ(unmet == premises.end(), c.verdict == sufficient);
    if (unmet == premises.end()) continue;
    EXPECT_EQ(unmet->key, c.key);
    EXPECT_THAT(warnings_on(other),
                testing::Contains(testing::Field(&DesignWarning::text, not_met_text(*unmet))));
    keys.insert(c.key);
  }
  for (const PremiseRow& row : premise_rows())
    EXPECT_TRUE(keys.contains(row.key)) << "no case for the premise " << row.what;
}

TEST_F(PremisesOfProject, a_share_above_1_and_a_project_without_a_name_are_refused) {
  EXPECT_THAT(
      problems_of(changed("interconnection = 0.2", "interconnection = 13", complete_project)),
      one_problem("p.toml:30", "array.interconnection = 13", "0.13?"));
  EXPECT_THAT(problems_of(changed("mass_ratio = 0.02", "mass_ratio = 5", complete_project)),
              one_problem("p.toml:13", "building.mass_ratio = 5", "0.05?"));
  for (const char* name : {"\"\"", "\"  \""})
    EXPECT_THAT(problems_of(changed("\"Roof of x_1, complete\"", name, complete_project)),
                one_problem("p.toml:2", "project.name is empty", "name = "));
}

// Issue 48: what was decided by a word in a text.
TEST_F(PremisesOfProject, that_are_of_a_list_are_refused_in_other_words) {
  for (const char* surface : {"dry TPO", "not dry", "Wet", "unknown"})
    EXPECT_THAT(
        problems_of(changed("\"wet\"", "\"" + std::string(surface) + "\"", complete_project)),
        one_problem("p.toml:25", "friction.surface", surface, "surface_description"));
  for (const char* other : {"exception as agreed", "report 7 of Smith, 2026", "exceptions 1, 3"})
    EXPECT_THAT(problems_of(changed(mapped_values, class_d("\"" + std::string(other) + "\""),
                                    complete_project)),
                one_problem("p.toml:8", "site.hazard_analysis", other, "hazard_report"));
  EXPECT_THAT(problems_of(changed(mapped_values, mapped_values + "hazard_report = \"report 7\"\n",
                                  complete_project)),
              one_problem("p.toml:8", "site.hazard_report", "site.spectrum"));
}

TEST_F(PremisesOfProject, a_day_after_the_calculation_is_named_with_that_of_the_calculation) {
  const auto date_of = [&](const std::string& text) {
    for (const Premise& premise : premises_of(read(text)))
      if (premise.key == std::string("friction.tested_on")) return premise.found.text;
    return std::string();
  };
  EXPECT_THAT(date_of(changed(named, named + "date = \"2024-10-13\"\n", complete_project)),
              states("2024-10-14, after 2024-10-13", "project.date"));
  const std::string late = changed("2024-10-14", "2999-01-01", complete_project);
  EXPECT_THAT(date_of(late), states("2999-01-01, after " + read(late).read_on, "UTC"));
  // A calculation of a later day allows no later test.
  EXPECT_EQ(date_of(changed(named, named + "date = \"2999-01-02\"\n", late)), date_of(late));
}

TEST_F(PremisesOfProject, of_roof_motions_are_of_no_suite_of_the_ground) {
  EXPECT_THAT(problems_of(changed("recorded.toml\"\n", "recorded.toml\"\nauthor = \"Smith\"\n",
                                  complete_project)),
              one_problem("p.toml:33", "suite.author", "leave it out"));
}

}  // namespace
}  // namespace glissade
