// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_keys.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "glissade/core/contract.hpp"
#include "glissade/io/project_file.hpp"

namespace glissade {
namespace {

constexpr EnumNames<RiskCategory> risk_names = {{"I", RiskCategory::i},
                                                {"II", RiskCategory::ii},
                                                {"III", RiskCategory::iii},
                                                {"IV", RiskCategory::iv}};

std::vector<KeyTable<Project>> make_tables_of_project() {
  constexpr auto title = &Project::title;
  constexpr auto array = &Project::array;
  constexpr auto friction = &Project::friction;
  constexpr auto roof = &Project::roof;
  /// In the order of separations_of().
  const Reading available{"", "", [](const TomlTable& table, const char* key, Project& project) {
                            project.available_m.push_back(table.number(key, not_negative));
                          }};
  return {
      {"project",
       {{"name", "\"Warehouse 12, roof array\"", required, "name of the project",
         reads<title, &TitleBlock::name>()},
        {"address", "\"1 Main Street, Anytown\"", in_example, "of the building",
         reads<title, &TitleBlock::address>()},
        {"authority", "\"\"", in_example,
         "having jurisdiction; here and below empty: a line to fill in by hand",
         reads<title, &TitleBlock::authority>()},
        {"code", "\"\"", in_example, "governing code and edition: \"2022 CBC\"",
         reads<title, &TitleBlock::code>()},
        {"engineer", "\"\"", in_example, "in responsible charge",
         reads<title, &TitleBlock::engineer>()},
        {"licence", "\"\"", in_example, "number of the engineer's licence",
         reads<title, &TitleBlock::licence>()},
        {"revision", "\"\"", in_example, "of the calculation",
         reads<title, &TitleBlock::revision>()},
        {"date", "\"\"", in_example, "of the calculation: \"2026-10-14\"",
         reads<title, &TitleBlock::date>()},
        {"units", "\"us\"", in_example, "\"us\" (in, ft) or \"si\" (m), of the report",
         reads<&Project::units>(unit_names)}}},
      {"site",
       {{"edition", "\"asce7_16\"", required,
         "\"asce7_10\", \"asce7_16\" or \"asce7_22\" (with a spectrum, or sds_g and sd1_g)"},
        {"name", "\"Roof B\"", alternative,
         "of one of several sites or roofs, each a [[site]] in place of [site]; [site.roof], "
         "[site.building] ... after it are in place of the project's",
         reads<&Project::site_name>()},
        {"address", "\"1 Main Street\"", alternative, "in place of the project's"},
        {"ss_g", "1.5", required, "S_S, g"},
        {"s1_g", "0.6", required, "S_1, g"},
        {"site_class", "\"D\"", required, "\"A\" to \"E\", or \"default\""},
        {"site_classes", "[\"C\", \"D\"]", alternative,
         "several classes, of which the largest spectrum counts, in place of site_class"},
        {"tl_s", "8", in_example, "T_L, s"},
        {"sds_g", "1.0", alternative, "S_DS, with sd1_g, in place of ss_g, s1_g, site_class"},
        {"sd1_g", "0.6", alternative, "S_D1"},
        {"spectrum", "\"site.csv\"", alternative,
         "a site-specific or multi-period spectrum: period_s, then design_sa_g or mce_sa_g; "
         "ss_g, s1_g, site_class beside it give the 80 % that it may not be below",
         reads<&Project::spectrum_file>()},
        {"hazard_analysis", "\"exception 2 of 11.4.8\"", alternative,
         "where ASCE 7-16, 11.4.8, requires a ground motion hazard analysis: the exception that is "
         "taken; of an analysis give the spectrum, or sds_g and sd1_g"},
        {"hazard_report", "\"report 14\"", alternative,
         "of the analysis that gave the spectrum, or sds_g and sd1_g",
         reads<&Project::site, &ProjectSite::analysis, &StatedReport::report>()},
        {"hazard_author", "\"Smith Engineers\"", alternative, "of it",
         reads<&Project::site, &ProjectSite::analysis, &StatedReport::author>()},
        {"hazard_date", "\"2026-10-14\"", alternative, "of it",
         reads<&Project::site, &ProjectSite::analysis, &StatedReport::date>()},
        {"risk_category", "\"II\"", required, "\"I\" to \"IV\"",
         reads<&Project::site, &ProjectSite::risk>(risk_names)},
        {"fault_distance_km", "20", alternative, "to the nearest active fault",
         reads<&Project::site, &ProjectSite::fault_distance_km>(not_negative)}}},
      {"building",
       {{"period_s", "[0.4, 0.5, 0.6]", required,
         "a period, or several that bound it, at most 1.3 times apart; or system and height_m"},
        {"system", "\"other\"", alternative,
         "steel_moment_frame, concrete_moment_frame, eccentrically_braced_frame, "
         "concentrically_braced_frame or other: T_a = C_t h^x"},
        {"height_m", "\"40 ft\"", alternative, "height of the building"},
        {"period_bounds", "[0.75, 1.5]", alternative, "times T_a, the usual bounds"},
        {"storeys", "2", in_example,
         "above ground: a condition of the standard; from two on the building is computed by "
         "modes"},
        {"alpha", "[5, 20]", alternative,
         "of a uniform cantilever of flexure and shear, one value or a range; usual by system "
         "(recalled): moment frames 5 to 20, braced frames 1.5 to 6, other and not stated 0 to 2; "
         "needs two storeys or more"},
        {"mass_ratio", "[0.02, 0.1]", required,
         "the array's mass, ballast included, over that of the building, one value or a range"},
        {"array_weight_kn", "\"60 kip\"", alternative,
         "with weight_kn, in place of mass_ratio: weight of the array, ballast included"},
        {"weight_kn", "\"2400 kip\"", alternative, "seismic weight of the building"},
        {"damping", "0.05", in_example, "damping ratio of the building"},
        {"diaphragm", "\"rigid\"", alternative,
         "of the roof: \"rigid\" (as computed), \"semirigid\", \"flexible\""}}},
      {"roof",
       {{"rise_in_12", "[0.25, 0.5]", required, "slope, one value or a range; or slope_deg"},
        {"slope_deg", "[1.2, 2.4]", alternative, "slope in degrees"}}},
      {"friction",
       {{"file", "\"pull_tests.csv\"", required,
         "pull tests (logs, or one column mu with a test in each row); or mu and source"},
        {"direction", "\"along\"", alternative,
         "of the pull tests; else the one with the lowest design value"},
        {"mu", "{ mean = 0.50, std = 0.04 }", alternative,
         "mean coefficient of friction, and its standard deviation between tests"},
        {"tests", "7", alternative,
         "the number of tests behind mu, which bounds what they support"},
        {"source", "\"test report 123\"", alternative, "number of the test report"},
        {"laboratory", "\"\"", in_example, "that made the tests",
         reads<friction, &ProjectFriction::laboratory>()},
        {"tested_on", "\"\"", in_example, "date of the tests: \"2026-10-14\"",
         reads<friction, &ProjectFriction::tested_on>()},
        {"test_standard", "\"\"", in_example,
         "of the tests: \"ASTM G115\", which the standards require; empty: not stated",
         reads<friction, &ProjectFriction::test_standard>()},
        {"surface", "\"\"", in_example, "in the tests: \"dry\", \"wet\" or \"both\""},
        {"surface_description", "\"TPO, feet of EPDM\"", alternative, "its materials",
         reads<friction, &ProjectFriction::surface_description>()}}},
      {"array",
       {{"model", "\"\"", in_example, "manufacturer and product",
         reads<array, &ProjectArray::model>()},
        {"ballast", "\"\"", in_example, "kind and weight of the ballast",
         reads<array, &ProjectArray::ballast>()},
        {"membrane", "\"\"", in_example, "roof membrane, and what the feet stand on",
         reads<array, &ProjectArray::membrane>()},
        {"centre_of_mass_m", "\"18 in\"", alternative,
         "height of the array's centre of mass above the roof: a condition of the standards",
         reads<array, &ProjectArray::centre_of_mass_m>(above_zero)},
        {"support_spacing_m", "\"5 ft\"", alternative,
         "least spacing of the array's supports in plan: a condition of the standards",
         reads<array, &ProjectArray::support_spacing_m>(above_zero)},
        {"interconnection", "0.2", alternative,
         "horizontal design strength across any section of the array over the weight of its "
         "lighter "
         "side: a condition of the standards",
         reads<array, &ProjectArray::interconnection>(share_rule)}}},
      {"suite",
       {{"file", "\"suite.toml\"", required,
         "suite of motions of the ground, or of the roof (then without periods, mass ratio and "
         "damping "
         "of [building]): suites/README.md"},
        {"factor", "1.0", alternative,
         "on motions of a roof, at the design earthquake (DBE); 1: as they are",
         reads<&Project::roof_factor>(above_zero)},
        {"report", "\"report 12, nonlinear model\"", alternative, "on the motions of a roof",
         reads<roof, &StatedReport::report>()},
        {"author", "\"Smith Engineers\"", alternative, "of them",
         reads<roof, &StatedReport::author>()},
        {"date", "\"2026-10-14\"", alternative, "of them", reads<roof, &StatedReport::date>()},
        {"scaling_rule", "\"asce7_16\"", alternative,
         "how the suite is scaled: \"walters_2012\" (the default), or by the clause of an edition: "
         "\"asce7_10\", \"asce7_16\", \"asce7_22\" (suites/README.md)",
         reads<&Project::scaling_rule>(scaling_rule_names)}}},
      {"sampling",
       {{"samples", "128", in_example, "samples of the probability study, a power of two",
         reads<&Project::samples>(2, 1 << 20)}}},
      {"clearance",
       {{"without_target", "true", alternative,
         "do not scale the suite to 0.9 times the target above 2 s: not for design",
         reads<&Project::without_target>()}}},
      {"hazard",
       {{"curve", "\"hazard.csv\"", alternative,
         "columns sds_g, annual_rate of the site: annual rates, displacement over the life"},
        {"k0", "1e-3", alternative, "with k, in place of curve: annual rate k0 S_DS^-k"},
        {"k", "2.2", alternative, "with k0"},
        {"design_life_years", "25", alternative,
         "years over which displacements are accumulated"}}},
      {"clearances",
       {{"similar_array_m", "\"2 ft\"", in_example, "between arrays, where known", available},
        {"obstruction_m", "\"4 ft\"", in_example, "to a fixed object, where known", available},
        {"parapet_edge_m", "\"4 ft\"", in_example, "to an edge with parapet, where known",
         available},
        {"open_edge_m", "\"8 ft\"", in_example, "to an edge without parapet, where known",
         available}}},
      {"gap",
       {{"name", "\"skylight 3\"", alternative,
         "one more available separation, any number of [[gap]]: each is checked"},
        {"kind", "\"obstruction\"", alternative,
         "\"similar_array\", \"obstruction\", \"parapet_edge\" or \"open_edge\""},
        {"available_m", "\"3 ft\"", alternative, "the available separation"}}},
      {"standards",
       {{"compare", "\"asce7_16\"", in_example,
         "the standard of the permit: \"asce7_16\" or \"seaoc_pv1_2012\"",
         reads<&Project::standard>(standard_names)},
        {"importance", "1.0", alternative, "I_e, where not that of the risk category"},
        {"peer_reviewed", "false", in_example,
         "true: the analysis may fall below the standard's least value",
         reads<&Project::peer_reviewed>()}}},
      {"result",
       {{"round_up_m", "\"0.5 in\"", in_example, "displacements are rounded up to this"}}},
  };
}

}  // namespace

const std::vector<KeyTable<Project>>& project_tables() {
  static const std::vector<KeyTable<Project>> tables = make_tables_of_project();
  return tables;
}

const std::vector<GrammarKey>& project_grammar() {
  static const std::vector<GrammarKey> keys = in_words(project_tables());
  return keys;
}

std::string project_example_of(const char* table, const char* key) {
  const auto& keys = project_grammar();
  const auto row = std::ranges::find(keys, std::string(table) + "." + key, &GrammarKey::name);
  GLISSADE_EXPECTS(row != keys.end());
  return row->value;
}

std::string project_example() {
  std::string text =
      "# A project: glissade clearance FILE\n"
      "# A number may have a unit in quotes: height_m = \"30 ft\", rise_in_12 = \"0.25:12\"\n";
  std::string table;
  for (const GrammarKey& row : project_grammar()) {
    if (table != row.table) {
      table = row.table;
      text += table == "gap" ? "\n# [[gap]]\n" : fmt::format("\n[{}]\n", table);
    }
    const std::string line =
        fmt::format("{}{} = {}", row.usual == alternative ? "# " : "", row.key, row.value);
    text += fmt::format("{:<40} # {}\n", line, row.meaning);
  }
  return text;
}

}  // namespace glissade
