// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <set>

#include "glissade/design/premises.hpp"
#include "project_files.hpp"

// A project that is complete, and each premise removed or contradicted in turn.
namespace glissade {
namespace {

using test::states;
using enum SeparationVerdict;

const std::string complete = R"([project]
name = "complete"
units = "us"
[site]
edition = "asce7_16"
ss_g = 1.5
s1_g = 0.6
site_class = "C"
tl_s = 8
risk_category = "III"
fault_distance_km = "20 mi"
[building]
period_s = [0.18, 0.22]
mass_ratio = 0.05
storeys = 2
diaphragm = "rigid"
[roof]
rise_in_12 = 0.25
[friction]
mu = { mean = 0.55, std = 0.04 }
source = "report 7"
tests = 7
laboratory = "Own laboratory"
tested_on = "2026-10-14"
test_standard = "ASTM G115"
surface = "wet TPO, feet of EPDM"
[array]
centre_of_mass_m = "11 in"
support_spacing_m = "32 in"
interconnection = 0.2
[suite]
file = "recorded.toml"
[clearances]
similar_array_m = "30 ft"
obstruction_m = "30 ft"
parapet_edge_m = "30 ft"
open_edge_m = "30 ft"
[standards]
compare = "asce7_16"
)";

struct Case {
  std::string key, from, to;
  SeparationVerdict verdict = open;
  bool of_roof = false;
};

const std::string mapped = "ss_g = 1.5\ns1_g = 0.6\nsite_class = \"C\"\n",
                  tested = "tested_on = \"2026-10-14\"\n",
                  surface = "surface = \"wet TPO, feet of EPDM\"\n",
                  of_report = "report = \"report 12\"\nauthor = \"Smith\"\ndate = \"2026-10-14\"\n";

std::string class_d(const std::string& stated) {
  return "ss_g = 1.5\ns1_g = 0.6\nsite_class = \"D\"\nhazard_analysis = \"" + stated + "\"\n";
}

const std::vector<Case> cases = {
    {"project.units", "\"11 in\"", "0.28"},
    {"standards.compare", "asce7_16\"\n" + mapped, "asce7_22\"\nsds_g = 1.0\nsd1_g = 0.6\n"},
    {"standards.compare", "edition = \"asce7_16\"", "edition = \"asce7_10\""},
    {"standards.compare", "compare = \"asce7_16\"", "compare = \"seaoc_pv1_2012\""},
    {"standards.importance", "compare = \"asce7_16\"", "compare = \"asce7_16\"\nimportance = 1.0"},
    {"site.hazard_analysis", "site_class = \"C\"", "site_class = \"D\""},
    {"site.hazard_analysis", mapped, class_d("exception 1 of 11.4.8")},
    {"site.hazard_analysis", mapped, class_d("exception 3 of 11.4.8")},
    {"site.hazard_analysis", mapped, class_d("exception as agreed")},
    {"site.hazard_analysis", mapped, class_d("report 7 of Smith, 2026")},  // its spectrum is not
    {"site.hazard_analysis", mapped, class_d("exception 2 of 11.4.8"), sufficient},
    {"site.hazard_analysis", mapped,
     "sds_g = 1.0\nsd1_g = 0.6\nhazard_analysis = \"exception 2 of 11.4.8\"\n"},
    {"site.hazard_analysis", mapped,
     "sds_g = 1.0\nsd1_g = 0.6\nhazard_analysis = \"report 7 of Smith, 2026\"\n", sufficient},
    {"site.ss_g", mapped, "spectrum = \"site.csv\"\n"},
    {"site.ss_g", mapped, "spectrum = \"site.csv\"\n" + mapped, sufficient},
    {"site.fault_distance_km", "fault_distance_km = \"20 mi\"\n", ""},
    {"site.fault_distance_km", "20 mi", "8 km"},
    {"building.diaphragm", "diaphragm = \"rigid\"\n", ""},
    {"building.diaphragm", "\"rigid\"", "\"flexible\""},
    {"building.diaphragm", "\"rigid\"", "\"semirigid\""},
    {"building.period_s", "[0.18, 0.22]", "4.1"},  // a frequency
    {"building.period_s", "[0.18, 0.22]", "0.04"},
    {"building.period_s", "[0.18, 0.22]", "1.01"},
    {"building.period_s", "[0.18, 0.22]", "0.99", sufficient},
    {"building.period_s", "period_s = [0.18, 0.22]", "system = \"other\"\nheight_m = \"28 ft\"",
     sufficient},
    {"friction.source", "report 7", "not stated: name the test report"},
    {"friction.laboratory", "Own laboratory", ""},
    {"friction.laboratory", "Own laboratory", "N/A"},
    {"friction.laboratory", "Own laboratory", "Nonesuch Laboratory", sufficient},
    {"friction.tested_on", tested, ""},
    {"friction.tested_on", "2026-10-14", "last year"},
    {"friction.tested_on", "2026-10-14", "2026-02-30"},
    {"friction.surface", surface, ""},
    {"friction.surface", "wet TPO", "TPO"},
    {"array", "interconnection = 0.2\n", ""},
    {"array", "interconnection = 0.2\n", "interconnection = 0.05\n", not_applicable},
    {"suite.file", "recorded.toml", "suite.toml"},
    {"suite.scaling_rule", "recorded.toml\"", "recorded.toml\"\nscaling_rule = \"asce7_10\""},
    {"suite.scaling_rule", "recorded.toml\"", "recorded.toml\"\nscaling_rule = \"asce7_16\"",
     sufficient},
    {"suite.report", "report = \"report 12\"\n", "", open, true},
    {"suite.author", "\"Smith\"", "\"unknown\"", open, true},
    {"suite.date", "date = \"2026-10-14\"", "date = \"October\"", open, true}};

class PremisesOfProject : public ProjectFiles {
 protected:
  PremisesOfProject() {
    folder_.write("a.csv", "");
    for (const char* of : {"ground", "roof"})
      folder_.write(of == std::string("roof") ? "roof.toml" : "recorded.toml",
                    "[suite]\nname = \"a\"\nmotions = \"" + std::string(of) +
                        "\"\n[[record]]\nid = \"a\"\nfirst = \"a.csv\"\n");
    folder_.write("site.csv", "period_s,design_sa_g\n0,0.6\n0.1,1.3\n0.6,1.3\n5,0.2\n");
  }
  static std::string project(bool of_roof) {
    if (!of_roof) return complete;
    const std::string text = changed("recorded.toml\"\n", "roof.toml\"\n" + of_report, complete),
                      below = "period_s = [0.18, 0.22]\nmass_ratio = 0.05\n";
    return changed("diaphragm = \"rigid\"\n", "", changed(below, "", text));
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
  EXPECT_THAT(problems_of(changed("interconnection = 0.2", "interconnection = 13", complete)),
              one_problem("p.toml:30", "array.interconnection = 13", "0.13?"));
  EXPECT_THAT(problems_of(changed("mass_ratio = 0.05", "mass_ratio = 5", complete)),
              one_problem("p.toml:14", "building.mass_ratio = 5", "0.05?"));
  for (const char* name : {"\"\"", "\"  \""})
    EXPECT_THAT(problems_of(changed("\"complete\"", name, complete)),
                one_problem("p.toml:2", "project.name is empty", "name = "));
}

TEST_F(PremisesOfProject, of_roof_motions_are_of_no_suite_of_the_ground) {
  EXPECT_THAT(
      problems_of(changed("recorded.toml\"\n", "recorded.toml\"\nauthor = \"Smith\"\n", complete)),
      one_problem("p.toml:33", "suite.author", "leave it out"));
}

}  // namespace
}  // namespace glissade
