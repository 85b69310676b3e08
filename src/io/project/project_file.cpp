// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/project_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <bit>
#include <chrono>
#include <cmath>
#include <set>

#include "enum_names.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/input_file.hpp"
#include "glissade/core/units.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/sampling/friction_statistics.hpp"
#include "keys/hazard_table.hpp"
#include "keys/quantity_table.hpp"
#include "keys/target_table.hpp"
#include "project/project_friction.hpp"
#include "project/project_keys.hpp"
#include "text/scan.hpp"
#include "toml/source_text.hpp"
#include "toml/toml_table.hpp"

namespace glissade {
namespace {

namespace fs = std::filesystem;

std::string example(const char* table, const char* key) {
  return fmt::format("for example: {} = {}", key, project_example_of(table, key));
}

/// UTC: "2026-10-14".
std::string today() {
  const std::chrono::year_month_day day(
      std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now()));
  return fmt::format("{:04}-{:02}-{:02}", static_cast<int>(day.year()),
                     static_cast<unsigned>(day.month()), static_cast<unsigned>(day.day()));
}

/// Another key serves in its place.
bool is_replaced(const TomlTable& table, const std::string& key) {
  const auto has = [&](const char* other) { return table.has(other); };
  if (key == "site.ss_g" || key == "site.s1_g")
    return has("sds_g") || has("sd1_g") || has("spectrum");
  if (key == "site.site_class")
    return has("site_classes") || has("sds_g") || has("sd1_g") || has("spectrum");
  if (key == "building.period_s") return has("system") || has("height_m");
  if (key == "building.mass_ratio") return has("array_weight_kn") || has("weight_kn");
  if (key == "roof.rise_in_12") return has("slope_deg");
  if (key == "friction.file") return has("mu");
  return false;
}

/// A key of a building below the roof.
bool is_below_roof(const GrammarKey& row) {
  return row.table == "building" && row.key != "storeys";
}

/// Everything that is missing, at once.
/// @param of_roof nothing of a building below it: the suite is of a roof, or not there
void require_keys(const TomlTable& root, bool of_roof) {
  const auto require = [&](const char* table, const char* key) {
    const TomlTable at = root.table(table);
    (at.exists() ? at : root)
        .report("", fmt::format("{}.{} is missing", table, key),
                fmt::format("in [{}], {}", table, example(table, key)));
  };
  for (const GrammarKey& row : project_grammar()) {
    if (row.usual != required) continue;
    const TomlTable table = root.table(row.table);
    if (!table.has(row.key) && !is_replaced(table, row.name()) && !(of_roof && is_below_roof(row)))
      require(row.table.c_str(), row.key.c_str());
  }
  const auto together = [&](const char* name, const char* one, const char* other) {
    const TomlTable table = root.table(name);
    if (table.has(one) && !table.has(other)) require(name, other);
  };
  if (!of_roof && !root.table("building").has("period_s")) {  // beside it both are refused
    together("building", "system", "height_m");
    together("building", "height_m", "system");
  }
  if (!of_roof) {
    together("building", "weight_kn", "array_weight_kn");
    together("building", "array_weight_kn", "weight_kn");
  }
  if (!root.table("friction").has("file")) together("friction", "mu", "source");
  together("site", "sds_g", "sd1_g"), together("site", "sd1_g", "sds_g");
}

/// A number, or a list; sorted, each once.
std::vector<double> read_values(const TomlTable& table, const char* key, const NumberRule& rule) {
  std::vector<double> values;
  if (table.is_array(key)) {
    const std::size_t before = table.problem_count();
    values = table.numbers(key, rule).value_or(std::vector<double>{});
    if (values.empty() && table.problem_count() == before)
      table.report(key, table.name_of(key) + " is an empty list");
  } else if (const auto one = table.number(key, rule)) {
    values = {*one};
  }
  std::ranges::sort(values);
  values.erase(std::ranges::unique(values).begin(), values.end());
  return values;
}

void read_site(const TomlTable& table, Project& project) {
  const auto has = [&](const char* key) { return table.has(key); };
  if (!project.site_name.empty()) project.title.name += ": " + project.site_name;
  project.title.address = table.text("address").value_or(project.title.address);
  const bool is_whole = has("edition") && (has("spectrum") || (has("ss_g") && has("s1_g")) ||
                                           (has("sds_g") && has("sd1_g")));
  if (!is_whole) return table.ignore_unknown();  // what is missing has been reported
  const std::size_t before = table.problem_count();
  project.site.target = read_target(table, &project.site.mapped);
  if (project.site.mapped && project.site.target.edition == AsceEdition::asce7_22)
    table.report("ss_g", "ASCE 7-22 has no site coefficients: site.ss_g is of no use here",
                 "leave out ss_g, s1_g and site_class");
  project.site.states_tl = has("tl_s");
  for (const char* key : {"hazard_report", "hazard_author", "hazard_date"})
    if (has(key) && project.site.target.is_mapped())
      table.report_idle(key, table.name_of(key) +
                                 " is of no analysis: it needs site.spectrum, or "
                                 "site.sds_g and sd1_g");
  if (table.problem_count() > before) return;
  if (has("spectrum"))
    project.spectrum_sha256 = sha256_of_file(project.file.parent_path() / project.spectrum_file);
  try {
    const double sds_g = TargetSpectrum(project.site.target).sds_g();
    if (has("spectrum") && sds_g > most_possible_g)
      table.report("spectrum",
                   fmt::format("S_DS of the spectrum is {:.3g} g: no site has more than {:g} g",
                               sds_g, most_possible_g),
                   "give it in g: divide percent by 100, m/s2 by 9.80665, cm/s2 by 980.665");
  } catch (const InputError& error) {
    table.report("", error);
  }
}

/// T_a and values between its bounds.
void periods_of_system(const TomlTable& table, const Project& project, ProjectBuilding& building) {
  const double height_m = table.number("height_m", above_zero).value_or(10.0);
  EnumNames<const StructuralSystem*> names = {
      {structural_systems[0].name, &structural_systems[0]},
      {structural_systems[1].name, &structural_systems[1]},
      {structural_systems[2].name, &structural_systems[2]},
      {structural_systems[3].name, &structural_systems[3]},
      // Table 12.8-2 has it under all other structural systems.
      {"concentrically_braced_frame", &structural_systems[3]}};
  const StructuralSystem* system =
      table.choice<const StructuralSystem*>("system", names).value_or(&structural_systems.back());
  std::vector<double> bounds =
      table.numbers("period_bounds", above_zero).value_or(std::vector<double>{0.75, 1.5});
  if (bounds.size() != 2 || bounds[0] > bounds[1]) {
    table.report("period_bounds", "building.period_bounds are not a lower and an upper factor",
                 example("building", "period_bounds"));
    bounds = {1.0, 1.0};
  }
  building.height_m = height_m;
  const double period_s = approximate_period_s(*system, height_m);
  building.approximate_period_s = period_s;
  // Five, or as many as leave no gap, with periods rounded to milliseconds.
  const double ratio = bounds[1] / bounds[0];
  const double steps =
      std::max(4.0, std::ceil(std::log(ratio) / std::log(0.97 * widest_period_step)));
  for (double i = 0.0; i <= steps; ++i) {
    const double factor = bounds[0] * std::pow(ratio, i / steps);
    building.period_s.push_back(std::round(1e3 * factor * period_s) / 1e3);
  }
  building.period_s.erase(std::ranges::unique(building.period_s).begin(), building.period_s.end());
  // C_t in metres is the table's too, to three digits.
  const double unit_m = project.units == UnitSystem::si ? 1.0 : foot_m;
  building.system = system->text;
  building.system_is_checked = system->provenance == Provenance::checked;
  building.period_basis = fmt::format("T_a = C_t h^x = {:.3g} ({:.4g} {})^{:g} ({}, 12.8-7)",
                                      system->ct * std::pow(unit_m / foot_m, system->exponent),
                                      height_m / unit_m, unit_m == 1.0 ? "m" : "ft",
                                      system->exponent, edition_name(project.site.target.edition));
  building.bounds_text = fmt::format("{:g} to {:g} times T_a", bounds[0], bounds[1]);
}

constexpr NumberRule storeys_rule{"1, 2, 3 or more",
                                  [](double x) { return x >= 1.0 && std::floor(x) == x; }};

/// Of a building whose roof the motions are of.
ProjectBuilding read_building_below(const TomlTable& table) {
  constexpr const char* remedy =
      "leave out all of [building] but storeys: the building is in the motions";
  table.refuse_unknown("modes", remedy);
  std::vector<std::string> given;
  for (const GrammarKey& row : project_grammar())
    if (is_below_roof(row) && table.has(row.key)) given.push_back(row.name());
  if (!given.empty()) {
    table.report("",
                 fmt::format("the suite has motions of the roof, and {} {} of a building below it",
                             fmt::join(given, ", "), given.size() == 1 ? "is" : "are"),
                 remedy);
    table.ignore_unknown();
  }
  return {.period_s = {0.0},
          .period_basis = "in the motions of the roof",
          .storeys = table.number("storeys", storeys_rule),
          .mass_ratio = {0.0},
          .mass_basis = "the array does not act back on the roof"};
}

/// From two storeys on a cantilever, of every alpha in its range. The array's mass is neglected:
/// it makes the displacement smaller (study 34), and the lanes take several modes without it.
void read_model(const TomlTable& table, ProjectBuilding& building) {
  const bool has_storeys = building.storeys.value_or(1.0) > 1.0;
  if (table.has("alpha") && !has_storeys)
    table.report("alpha", "building.alpha needs building.storeys of 2 or more",
                 "give the storeys, or leave alpha out: one storey is one mass");
  if (!has_storeys) return;
  std::string stated;
  for (const double ratio : building.mass_ratio)
    stated += fmt::format("{}{:.3g}", stated.empty() ? "" : ", ", ratio);
  building.mass_basis =
      fmt::format("{}: {}; neglected with several modes, which gives larger displacements",
                  building.mass_basis, stated);
  building.mass_ratio = {0.0};
  if (table.has("alpha")) {
    building.alpha = read_values(
        table, "alpha", {"from 0 to 500", [](double x) { return x >= 0.0 && x <= largest_alpha; }});
    building.model_basis = "project file";
    return;
  }
  std::string name = table.text("system").value_or("other");
  const auto system = std::ranges::find(structural_systems, name, &StructuralSystem::name);
  const StructuralSystem& found =
      system != structural_systems.end()
          ? *system
          : structural_systems[name == "concentrically_braced_frame" ? 2 : 3];
  building.alpha = {found.least_alpha, found.most_alpha};
  std::ranges::replace(name, '_', ' ');
  building.model_basis = fmt::format("usual for {} (Miranda & Taghavi 2005)",
                                     !table.has("system") ? "a system that is not stated"
                                     : name == "other"    ? "all other structural systems"
                                                          : name);
}

/// As it is written; empty where absent or wrong.
std::string diaphragm_of(const TomlTable& table) {
  return table
      .choice<std::string>(
          "diaphragm", {{"rigid", "rigid"}, {"semirigid", "semirigid"}, {"flexible", "flexible"}})
      .value_or("");
}

ProjectBuilding read_building(const TomlTable& table, const Project& project) {
  if (project.of_roof) return read_building_below(table);
  ProjectBuilding building;
  table.refuse_unknown("modes",
                       "give storeys and alpha: a project computes the modes; those of your own "
                       "model are for a study (building.modes)");
  table.refuse_both("period_s", table.has("system") ? "system" : "height_m",
                    "give the period, or the system and the height");
  if (table.has("system")) {
    periods_of_system(table, project, building);
  } else {
    building.period_s = read_values(table, "period_s", above_zero);
    building.period_basis = "as given";
  }
  constexpr double least_period_s = 0.02, most_period_s = 15.0;
  const auto refuse = [&](double period_s, const char* than, double limit_s) {
    table.report(table.has("period_s") ? "period_s" : "height_m",
                 fmt::format("a building period of {:.3g} s: no building has {} than {:g} s",
                             period_s, than, limit_s),
                 "check the units: seconds, metres");
  };
  if (const auto& periods_s = building.period_s; !periods_s.empty()) {
    if (periods_s.front() < least_period_s) refuse(periods_s.front(), "less", least_period_s);
    if (periods_s.back() > most_period_s) refuse(periods_s.back(), "more", most_period_s);
  }
  table.refuse_both("mass_ratio", "weight_kn", "give the ratio, or both weights");
  if (table.has("weight_kn") && table.has("array_weight_kn")) {
    const double array_kn = table.number("array_weight_kn", not_negative).value_or(0.0);
    const double weight_kn = table.number("weight_kn", above_zero).value_or(1.0);
    const double ratio = array_kn / weight_kn;
    if (!share_rule.is_met(ratio))
      table.report("array_weight_kn", "the array weighs more than the building", "check the units");
    building.mass_ratio = {ratio};
    const auto in_both = [&](double value_kn) {
      const std::string si = fmt::format("{:.1f} kN", value_kn),
                        us = fmt::format("{:.1f} kip", value_kn / pound_force_n);
      return project.units == UnitSystem::si ? si + " (" + us + ")" : us + " (" + si + ")";
    };
    building.mass_basis =
        "project file: weights of " + in_both(array_kn) + " and " + in_both(weight_kn);
  } else {
    building.mass_ratio = read_values(table, "mass_ratio", share_rule);
  }
  building.storeys = table.number("storeys", storeys_rule);
  read_model(table, building);
  building.damping =
      table
          .number("damping", {"from 0 to 0.999", [](double x) { return x >= 0.0 && x <= 0.999; },
                              "", "", true})
          .value_or(building.damping);
  building.diaphragm = diaphragm_of(table);
  return building;
}

std::vector<double> read_slopes(const TomlTable& table) {
  constexpr NumberRule flat_enough{"from 0 to 20", [](double x) { return x >= 0.0 && x <= 20.0; }};
  table.refuse_both("slope_deg", "rise_in_12", "give the slope one way");
  if (table.has("slope_deg")) return read_values(table, "slope_deg", flat_enough);
  std::vector<double> slopes = read_values(
      table, "rise_in_12", {"from 0 to 4", [](double x) { return x >= 0.0 && x <= 4.0; }});
  for (double& slope : slopes) slope = std::atan(slope / 12.0) / rad_per_deg;
  return slopes;
}

/// An empty table, as in the example, is as none.
std::optional<ProjectHazard> read_project_hazard(const TomlTable& table, const fs::path& folder) {
  const bool is_given = std::ranges::any_of(std::array{"curve", "k0", "k", "design_life_years"},
                                            [&](const char* key) { return table.has(key); });
  if (!is_given) return std::nullopt;
  const auto config = read_hazard(table, IntensityMeasure::sds_g.key(), 0.0);
  if (!config) return std::nullopt;
  const std::string curve = table.text("curve").value_or("");
  return ProjectHazard{curve,
                       curve.empty() ? "" : sha256_of_file(folder / curve),
                       config->curve.points(),
                       table.number("k0", above_zero).value_or(0.0),
                       table.number("k", above_zero).value_or(0.0),
                       config->design_life_years};
}

/// Kinds are in the order of separations_of().
std::vector<ProjectGap> read_gaps(const TomlTable& root) {
  std::vector<ProjectGap> gaps;
  std::set<std::string> names;
  for (const TomlTable& table : root.tables("gap")) {
    ProjectGap gap{table.required_text("name"), 0,
                   table.required_number("available_m", not_negative)};
    if (!table.has("kind")) table.report_missing("kind", example("gap", "kind"));
    gap.kind =
        table
            .choice<std::size_t>(
                "kind",
                {{"similar_array", 0}, {"obstruction", 1}, {"parapet_edge", 2}, {"open_edge", 3}})
            .value_or(0);
    if (!names.insert(gap.name).second)
      table.report("name", "two gaps are named " + gap.name, "give each a name of its own");
    gaps.push_back(std::move(gap));
  }
  return gaps;
}

/// @return whether the suite that is named is there
bool read_suite(const TomlTable& suite, Project& project) {
  project.suite = (project.file.parent_path() / suite.text("file").value_or("")).lexically_normal();
  const bool is_there = suite.has("file") && fs::is_regular_file(status_of(project.suite));
  if (suite.has("file") && !is_there)
    suite.report("file", "there is no suite " + project.suite.string(),
                 "give the path of a suite file, relative to the project file (suites/README.md)");
  project.of_roof = is_there && has_roof_motions(project.suite);
  project.simulated_motions = is_there && record_files(project.suite).empty();
  if (!is_there || project.of_roof) return is_there || !suite.has("file");
  for (const char* key : {"factor", "report", "author", "date"})
    if (suite.has(key))
      suite.report(key,
                   suite.name_of(key) + " is of motions of a roof, and the suite is of the ground",
                   "leave it out: the site gives the factor on ground motions");
  return true;
}

void check_scaling_rule(const TomlTable& suite, const Project& project) {
  if (project.of_roof && suite.has("scaling_rule"))
    suite.report("scaling_rule", "motions of a roof are not scaled to a design spectrum",
                 "leave it out");
}

void read_rest(const TomlTable& root, Project& project) {
  project.hazard = read_project_hazard(root.table("hazard"), project.file.parent_path());
  if (project.hazard && project.of_roof)
    root.table("hazard").report(
        "", "[hazard] is of S_DS of the ground, and the suite has motions of the roof",
        "leave it out: how often the roof has such motions is not known");
  const TomlTable sampling = root.table("sampling"), clearance = root.table("clearance");
  if (!std::has_single_bit(project.samples))
    sampling.report("samples", "sampling.samples is not a power of two",
                    example("sampling", "samples"));
  if (project.without_target && !project.building.period_s.empty() &&
      project.building.period_s.back() <= longest_scaled_period_s)
    clearance.report_idle("without_target",
                          "clearance.without_target needs a building period above 2 s");

  project.gaps = read_gaps(root);

  const TomlTable standards = root.table("standards");
  project.importance =
      standards
          .number("importance", {"from 1 to 1.5", [](double x) { return x >= 1.0 && x <= 1.5; }})
          .value_or(importance_factor(project.site.risk));
  project.round_up_m = root.table("result")
                           .number("round_up_m", above_zero)
                           .value_or(project.units == UnitSystem::si ? 0.01 : 0.5 * inch_m);
}

/// Of the direction that is taken: what may be the reason of a low design value.
std::string outliers_of(const ProjectFriction& mu) {
  std::string text;
  for (const DirectionFriction& d : mu.tested) {
    if (d.direction != mu.direction) continue;
    for (const std::string& note : outliers_in(d)) text += "; " + note;
  }
  return text;
}

/// What no analysis can answer.
void check_project(const TomlTable& root, const Project& project) {
  const double tangent = std::tan(project.slope_deg.back() * rad_per_deg);
  const ProjectFriction& mu = project.friction;
  if (project.friction.design() <= tangent)
    root.report(
        "friction",
        fmt::format("the design friction, mean - 2 std = {:.3g} - 2 x {:.3g} = {:.3g}, is not "
                    "above tan(slope) = {:.3g}: the array slides without an earthquake{}",
                    mu.mean, mu.std, mu.mean - 2.0 * mu.std, tangent, outliers_of(mu)),
        "anchor the array, or state a higher friction or a flatter roof");
  if (project.hazard)
    check_events(root.table("hazard"),
                 {HazardCurve(project.hazard->points),
                  "",
                  project.hazard->design_life_years,
                  {},
                  0.0,
                  false},
                 levels_of(project).front(),
                 "check the curve's unit: the annual rate with which S_DS, in g, is exceeded; k0 "
                 "is that of 1 g");
}

}  // namespace

bool is_project(const std::filesystem::path& file) {
  TomlDocument document(file);
  return document.root().has("project") && !document.root().has("study");
}

namespace {

/// @param site of [[site]]; none: the file has one [site]
Project read_one(const fs::path& file, std::optional<std::size_t> site) {
  TomlDocument document(file);
  if (site) document.choose("site", *site);
  const TomlTable root = document.root();
  if (!root.has("project") && root.has("study"))
    throw InputError({file.string(), "is a study file, not a project",
                      "run it with: glissade run " + quoted_for_shell(file.string()), ""});
  if (!root.has("project") && (root.has("record") || root.has("recipe")))
    throw InputError({file.string(), "is a suite file, not a project",
                      "name it in a project as [suite] file (glissade clearance --example)", ""});
  document.read_only([](const std::string& name) { return has_key(project_grammar(), name); });
  Project project;
  project.file = file;
  project.source_text = without_comments(document.text());
  project.read_on = today();
  const auto read = [&](std::initializer_list<const char*> tables) {
    read_keys(project_tables(), tables, root, project);
  };
  read({"suite"});
  const bool has_suite = read_suite(root.table("suite"), project);
  check_scaling_rule(root.table("suite"), project);
  require_keys(root, project.of_roof || !has_suite);
  const std::size_t before = root.problem_count();
  read({"project"});
  if (const TomlTable head = root.table("project");
      head.has("name") && trimmed(project.title.name).empty() && root.problem_count() == before)
    head.report("name", "project.name is empty", example("project", "name"));
  read({"site"});
  read_site(root.table("site"), project);
  project.building = read_building(root.table("building"), project);
  project.slope_deg = read_slopes(root.table("roof"));
  read({"friction"});
  read_project_friction(root.table("friction"), file.parent_path(), project.friction);
  read({"array", "sampling", "clearance", "clearances", "standards", "result"});
  read_rest(root, project);
  if (project.units == UnitSystem::us_customary)
    project.unmarked_numbers = document.unmarked_numbers();
  if (root.problem_count() == 0) check_project(root, project);
  document.finish();
  return project;
}

}  // namespace

std::vector<std::string> site_names(const fs::path& file) {
  TomlDocument document(file);
  const TomlTable root = document.root();
  root.ignore_unknown();
  std::vector<std::string> names;
  if (!root.is_array("site")) return names;
  for (const TomlTable& table : root.tables("site")) {
    table.ignore_unknown();
    names.push_back(table.required_text("name", "[[site]] needs a name: name = \"Roof B\""));
    if (std::ranges::count(names, names.back()) > 1)
      table.report("name", "two sites are named " + names.back(), "give each a name of its own");
  }
  document.finish();
  return names;
}

Project read_project(const fs::path& file, std::size_t site) { return read_one(file, site); }

Project read_project(const fs::path& file) {
  if (const std::vector<std::string> names = site_names(file); !names.empty())
    throw InputError({file.string(),
                      "has " + counted(names.size(), "site") + ", and one is needed here",
                      "give a project with one [site] in place of [[site]]", ""});
  return read_one(file, {});
}

}  // namespace glissade
