// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <optional>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/output_file.hpp"
#include "glissade/core/wrap.hpp"
#include "glissade/io/example_file.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/improbable.hpp"
#include "glissade/report/format.hpp"
#include "shared/option_errors.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

struct InitOptions {
  std::string file, kind = "study", suite, units = "si", name, edition, site_class, system, height,
                    pull_tests, direction;
  std::vector<std::string> slopes;
  std::optional<double> ss_g, s1_g, mu, mu_std;
  std::vector<double> period_s;
  bool overwrite = false;
  bool of_roof = false;  ///< the suite has motions of a roof

  bool is_project() const { return kind == "project"; }
  bool has_site() const { return ss_g.has_value(); }
};

const std::string study_head =
    "# Made by `glissade init`. `glissade check FILE` says what it would run; other keys:\n"
    "# `glissade explain`. A number may have a unit, in quotes: \"18 in\", \"0.25:12\".\n";

/// What a study and a project have in common.
void set_common(const InitOptions& o, ExampleFile& file) {
  const fs::path folder = fs::absolute(o.file).parent_path();
  const char* head = o.is_project() ? "project" : "study";
  file.set_text(head, "name", o.name.empty() ? fs::path(o.file).stem().string() : o.name);
  file.set_text(head, "units", o.units);
  file.set_path("suite", "file", o.suite, folder);
  if (!o.period_s.empty()) file.set_numbers("building", "period_s", o.period_s);
  if (o.slopes.size() == 1) file.set_text("roof", "slope_deg", o.slopes.front());
  if (o.slopes.size() > 1) {
    std::vector<std::string> texts;
    for (const std::string& slope : o.slopes) texts.push_back(ExampleFile::string_value(slope));
    file.set("roof", "slope_deg", fmt::format("[{}]", fmt::join(texts, ", ")));
  }
  if (o.mu) file.set("friction", "mu", fmt::format("{{ mean = {}, std = {} }}", *o.mu, *o.mu_std));
  if (!o.pull_tests.empty()) file.set_path("friction", "file", o.pull_tests, folder);
  if (!o.direction.empty()) file.set_text("friction", "direction", o.direction);
}

ExampleFile study_file(const InitOptions& o) {
  ExampleFile file = ExampleFile::study();
  set_common(o, file);
  file.set_text("study", "description", "");
  file.comment_out("suite", "normalise");  // a choice that depends on the suite
  if (o.of_roof) {
    file.set_example("intensity", "measure", "\"factor\"");
    file.set_example("intensity", "levels", "[1.0]");
    file.leave_out("building");
    file.leave_out("standards");  // compare by S_DS
  }
  if (o.has_site())
    file.set("intensity", "target",
             fmt::format("{{ edition = {}, ss_g = {}, s1_g = {}, site_class = {} }}",
                         ExampleFile::string_value(o.edition), *o.ss_g, *o.s1_g,
                         ExampleFile::string_value(o.site_class)));
  if (!o.pull_tests.empty()) file.comment_out("friction", "mu");
  if (o.units == "us")
    file.set_example("fragility", "thresholds_m", R"(["6 in", "12 in", "24 in"])");
  return file;
}

ExampleFile project_file(const InitOptions& o) {
  ExampleFile file = ExampleFile::project();
  set_common(o, file);
  for (const char* key : {"similar_array_m", "obstruction_m", "parapet_edge_m", "open_edge_m"})
    file.comment_out("clearances", key);
  file.comment_out("building", "storeys");
  if (o.of_roof)
    for (const char* key : {"period_s", "mass_ratio", "damping"}) file.comment_out("building", key);
  file.set_text("project", "address", "");
  file.set_example("result", "round_up_m", o.units == "us" ? "\"0.5 in\"" : "0.01");
  if (o.has_site()) {
    file.set_text("site", "edition", o.edition);
    file.set_numbers("site", "ss_g", {*o.ss_g});
    file.set_numbers("site", "s1_g", {*o.s1_g});
    file.set_text("site", "site_class", o.site_class);
  }
  if (!o.slopes.empty()) file.comment_out("roof", "rise_in_12");
  if (!o.system.empty()) {
    file.comment_out("building", "period_s");
    file.set_text("building", "system", o.system);
    file.set_text("building", "height_m", o.height);
  }
  if (!o.pull_tests.empty()) return file;
  file.comment_out("friction", "file");
  if (!o.mu) file.take_example("friction", "mu");
  file.set_example("friction", "source", "\"not stated: name the test report\"");
  return file;
}

/// From a tenth to three times the S_DS of the target; DBE and MCE are among them.
std::vector<double> levels_around(double sds_g) {
  std::vector<double> levels;
  for (const double share : {0.1, 0.25, 0.5, 0.75, 1.0, 1.25, mce_over_dbe, 2.0, 2.5, 3.0}) {
    const bool is_earthquake = share == 1.0 || share == mce_over_dbe;
    const double level = share * sds_g;
    if (is_earthquake || level <= most_probable_g)
      levels.push_back(rounded_to(level, is_earthquake ? 12 : 3));
  }
  return levels;
}

/// That of the study, else of its suite.
std::optional<DesignTarget> target_of(const StudyConfig& study) {
  if (study.intensity.target) return study.intensity.target;
  const auto stated = find_stated_target(study.suite_files.front());
  return stated ? std::optional(stated->target) : std::nullopt;
}

/// The option whose value a problem of the file is about.
std::string option_of(const std::string& what) {
  for (const auto& [key, option] : {std::pair{"site_class", "--site-class"},
                                    {"edition", "--edition"},
                                    {"ss_g", "--ss-g"},
                                    {"s1_g", "--s1-g"},
                                    {"slope_deg", "--slope"},
                                    {"period_s", "--period-s"},
                                    {"system", "--system"},
                                    {"height_m", "--height"},
                                    {"direction", "--direction"},
                                    {"pull test", "--pull-tests"},
                                    {"friction", "--mu"}}) {
    if (what.find(key) != std::string::npos) return option;
  }
  return "init";
}

/// Written only if it is read without an error, and at once with its levels around the target of a
/// study, if it has one, which is returned.
std::optional<DesignTarget> write_checked(const InitOptions& o, ExampleFile& example) {
  std::optional<DesignTarget> target;
  write_file(o.file, [&](OutputFile& file, const fs::path& partial) {
    const auto write = [&] {
      const std::string text = (o.is_project() ? "" : study_head) + example.text();
      file.resize(0);
      file.write_at(0, text);
      std::optional<StudyConfig> study;
      with_changed_problems([](Problem& problem) { problem.where = option_of(problem.what); },
                            [&] {
                              if (o.is_project())
                                static_cast<void>(read_project(partial));
                              else
                                study = read_study(partial);
                            });
      if (study) target = target_of(*study);
    };
    write();
    if (!target) return;
    example.set_numbers("intensity", "levels", levels_around(TargetSpectrum(*target).sds_g()));
    write();
  });
  return target;
}

/// Options of the ground or of a building, which motions of a roof do not have.
void check_options_of_roof(const InitOptions& o) {
  const char* option = !o.period_s.empty()               ? "--period-s"
                       : !o.system.empty()               ? "--system"
                       : o.has_site() && !o.is_project() ? "--ss-g"
                                                         : nullptr;
  if (o.of_roof && option != nullptr)
    throw InputError({option, "is not used with " + o.suite + ", which has motions of a roof",
                      "leave it out: ground and building are in the motions", ""});
}

void init(InitOptions o) {
  if (!o.is_project() && !o.system.empty())
    throw InputError(
        {"--system", "is of a project's building", "add --kind project, or give --period-s", ""});
  o.of_roof = has_roof_motions(o.suite);
  check_options_of_roof(o);
  if (o.file.empty()) o.file = o.kind + ".toml";
  check_output_file(o.file, "file", o.overwrite);
  ExampleFile file = o.is_project() ? project_file(o) : study_file(o);
  const std::optional<DesignTarget> target = write_checked(o, file);
  put("File    {}\nValues of the example, not yours yet:\n{}", o.file, file.of_example());
  if (!o.is_project() && !o.has_site() && !o.of_roof)
    put("  {}\n",
        wrapped(target ? "intensity.target: that of the suite, " + to_string(*target) +
                             "; --ss-g, --s1-g, --site-class and --edition give that of your site"
                       : "intensity.target: none, and the suite has none; give --ss-g and its site",
                terminal_width, 4));
  if (o.is_project())
    put("Not stated: {}\n",
        wrapped(
            (o.of_roof ? "suite.factor, report, author and date, building.storeys"
                       : "building.storeys, building.diaphragm, hazard") +
                std::string(", site.fault_distance_km, friction.source, laboratory, tested_on and "
                            "surface, array, clearances"),
            terminal_width, 2));
  put("Next    glissade check {}\n", quoted_for_shell(o.file));
}

}  // namespace

void add_init(CLI::App& program) {
  auto o = std::make_shared<InitOptions>();
  CLI::App* command =
      program.add_subcommand("init", "Write a commented study or project file for your case");
  command->add_option("file", o->file, "file to write, with its folder [study.toml, project.toml]");
  command->add_option("--kind", o->kind, "study (for run) or project (for clearance)")
      ->check(CLI::IsMember({"study", "project"}));
  command->add_option("--suite", o->suite, "suite of ground motions (suites/README.md)")
      ->required()
      ->check(CLI::ExistingFile);
  command->add_option("--units", o->units, "of the report: us or si")
      ->check(CLI::IsMember({"us", "si"}));
  command->add_option("--name", o->name, "name of the study or project [that of the file]");
  CLI::Option* ss = command->add_option("--ss-g", o->ss_g, "S_S of the site");
  CLI::Option* s1 = command->add_option("--s1-g", o->s1_g, "S_1 of the site");
  CLI::Option* site = command->add_option("--site-class", o->site_class, "A to E, or default");
  CLI::Option* edition = command->add_option("--edition", o->edition, "asce7_10 or asce7_16");
  for (CLI::Option* one : {ss, s1, site, edition}) {
    for (CLI::Option* other : {ss, s1, site, edition})
      if (one != other) one->needs(other);
  }
  command->add_option("--slope", o->slopes, "of the roof, with units: 0.25:12,0.5:12, \"4 deg\"")
      ->delimiter(',');
  CLI::Option* period =
      command->add_option("--period-s", o->period_s, "of the building: one, or several")
          ->delimiter(',');
  CLI::Option* system =
      command->add_option("--system", o->system, "of a project's building, for T_a = C_t h^x")
          ->excludes(period);
  CLI::Option* height =
      command->add_option("--height", o->height, "of the building: \"54 ft\"")->needs(system);
  system->needs(height);
  CLI::Option* tests = command->add_option("--pull-tests", o->pull_tests, "pull tests (CSV)")
                           ->check(CLI::ExistingFile);
  command->add_option("--direction", o->direction, "of the pull tests, where there are several")
      ->needs(tests);
  CLI::Option* mu = command->add_option("--mu", o->mu, "mean coefficient of friction");
  mu->excludes(tests);
  CLI::Option* mu_std =
      command->add_option("--mu-std", o->mu_std, "its standard deviation between tests")->needs(mu);
  mu->needs(mu_std);
  add_overwrite(*command, o->overwrite);
  command->callback([o] { init(*o); });
}

}  // namespace glissade::cli
