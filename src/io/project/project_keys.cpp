// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/project_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "glissade/core/contract.hpp"
#include "glissade/io/project_file.hpp"

namespace glissade {
namespace {

using enum ProjectKey::Use;

constexpr std::array keys{
    ProjectKey{"project", "name", "\"Warehouse 12, roof array\"", required, "name of the project"},
    ProjectKey{"project", "address", "\"1 Main Street, Anytown\"", usual, "of the building"},
    ProjectKey{"project", "engineer", "\"\"", usual, "empty: a line to fill in by hand"},
    ProjectKey{"project", "date", "\"\"", usual, "empty: a line to fill in by hand"},
    ProjectKey{"project", "units", "\"us\"", usual, "\"us\" (in, ft) or \"si\" (m), of the report"},
    ProjectKey{"site", "edition", "\"asce7_16\"", required,
               "\"asce7_10\", \"asce7_16\" or \"asce7_22\" (with a spectrum, or sds_g and sd1_g)"},
    ProjectKey{"site", "ss_g", "1.5", required, "S_S, g"},
    ProjectKey{"site", "s1_g", "0.6", required, "S_1, g"},
    ProjectKey{"site", "site_class", "\"D\"", required, "\"A\" to \"E\", or \"default\""},
    ProjectKey{"site", "tl_s", "8", usual, "T_L, s"},
    ProjectKey{"site", "sds_g", "1.0", alternative,
               "S_DS, with sd1_g, in place of ss_g, s1_g, site_class"},
    ProjectKey{"site", "sd1_g", "0.6", alternative, "S_D1"},
    ProjectKey{"site", "spectrum", "\"site.csv\"", alternative,
               "a site-specific or multi-period spectrum: period_s, then design_sa_g or mce_sa_g; "
               "ss_g, s1_g, site_class beside it give the 80 % that it may not be below"},
    ProjectKey{"site", "risk_category", "\"II\"", required, "\"I\" to \"IV\""},
    ProjectKey{
        "building", "period_s", "[0.4, 0.5, 0.6]", required,
        "a period, or several that bound it, at most 1.3 times apart; or system and height_m"},
    ProjectKey{"building", "system", "\"other\"", alternative,
               "steel_moment_frame, concrete_moment_frame, eccentrically_braced_frame, "
               "concentrically_braced_frame or other: T_a = C_t h^x"},
    ProjectKey{"building", "height_m", "\"40 ft\"", alternative, "height of the building"},
    ProjectKey{"building", "period_bounds", "[0.75, 1.5]", alternative,
               "times T_a, the usual bounds"},
    ProjectKey{"building", "storeys", "2", usual, "above ground: a condition of the standard"},
    ProjectKey{
        "building", "mass_ratio", "[0.02, 0.1]", required,
        "the array's mass, ballast included, over that of the building, one value or a range"},
    ProjectKey{"building", "array_weight_kn", "\"60 kip\"", alternative,
               "with weight_kn, in place of mass_ratio: weight of the array, ballast included"},
    ProjectKey{"building", "weight_kn", "\"2400 kip\"", alternative,
               "seismic weight of the building"},
    ProjectKey{"building", "damping", "0.05", usual, "damping ratio of the building"},
    ProjectKey{"roof", "rise_in_12", "[0.25, 0.5]", required,
               "slope, one value or a range; or slope_deg"},
    ProjectKey{"roof", "slope_deg", "[1.2, 2.4]", alternative, "slope in degrees"},
    ProjectKey{
        "friction", "file", "\"pull_tests.csv\"", required,
        "pull tests (logs, or one column mu with a test in each row); or mean, std and source"},
    ProjectKey{"friction", "direction", "\"along\"", alternative,
               "of the pull tests; else the one with the lowest design value"},
    ProjectKey{"friction", "mean", "0.50", alternative, "mean coefficient of friction"},
    ProjectKey{"friction", "std", "0.04", alternative, "its standard deviation between tests"},
    ProjectKey{"friction", "tests", "7", alternative,
               "the number of tests behind mean and std, which bounds what they support"},
    ProjectKey{"friction", "source", "\"test report 123\"", alternative,
               "where mean and std come from"},
    ProjectKey{"suite", "file", "\"suite.toml\"", required,
               "suite of ground motions (suites/README.md)"},
    ProjectKey{"suite", "samples", "128", usual,
               "samples of the probability study, a power of two"},
    ProjectKey{"suite", "without_target", "true", alternative,
               "do not scale the suite to 0.9 times the target above 2 s: not for design"},
    ProjectKey{"hazard", "curve", "\"hazard.csv\"", alternative,
               "columns sds_g, annual_rate of the site: annual rates, displacement over the life"},
    ProjectKey{"hazard", "k0", "1e-3", alternative,
               "with k, in place of curve: annual rate k0 S_DS^-k"},
    ProjectKey{"hazard", "k", "2.2", alternative, "with k0"},
    ProjectKey{"hazard", "design_life_years", "25", alternative,
               "displacements are accumulated over so many years"},
    ProjectKey{"clearances", "similar_array_m", "\"2 ft\"", usual, "between arrays, where known"},
    ProjectKey{"clearances", "obstruction_m", "\"4 ft\"", usual, "to a fixed object, where known"},
    ProjectKey{"clearances", "parapet_edge_m", "\"4 ft\"", usual,
               "to an edge with parapet, where known"},
    ProjectKey{"clearances", "open_edge_m", "\"8 ft\"", usual,
               "to an edge without parapet, where known"},
    ProjectKey{"standard", "name", "\"asce7_16\"", usual, "\"asce7_16\" or \"seaoc_pv1_2012\""},
    ProjectKey{"standard", "importance", "1.0", alternative,
               "I_e, where not that of the risk category"},
    ProjectKey{"standard", "peer_reviewed", "false", usual,
               "true: the analysis may fall below the standard's least value"},
    ProjectKey{"result", "round_up_m", "\"0.5 in\"", usual, "displacements are rounded up to this"},
};

}  // namespace

std::span<const ProjectKey> project_keys() { return keys; }

const char* project_example_of(const char* table, const char* key) {
  for (const ProjectKey& row : keys) {
    if (std::string_view(row.table) == table && std::string_view(row.key) == key)
      return row.example;
  }
  GLISSADE_EXPECTS(false);
  return "";
}

std::string project_example() {
  std::string text =
      "# A project: glissade clearance FILE\n"
      "# A number may have a unit in quotes: height_m = \"30 ft\", rise_in_12 = \"0.25:12\"\n";
  std::string table;
  for (const ProjectKey& row : keys) {
    if (table != row.table) {
      table = row.table;
      text += fmt::format("\n[{}]\n", table);
    }
    const std::string line =
        fmt::format("{}{} = {}", row.use == alternative ? "# " : "", row.key, row.example);
    text += fmt::format("{:<40} # {}\n", line, row.meaning);
  }
  return text;
}

}  // namespace glissade
