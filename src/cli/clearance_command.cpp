// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/package.hpp"
#include "output_rule.hpp"
#include "run/run_folder.hpp"
#include "run/run_study.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

struct ClearanceOptions {
  std::string project, out;
  bool example = false, overwrite = false;
};

std::vector<ComponentFile> component_files(const fs::path& suite) {
  std::vector<ComponentFile> files;
  for (const RecordFile& f : record_files(suite))
    files.push_back({f.record, f.component, f.name, sha256_of_file(f.path)});
  return files;
}

/// What a program takes from the calculation: all digits, metres.
std::string numbers_json(const DesignClearance& design) {
  using Json = nlohmann::ordered_json;
  Json json{{"sds_g", design.site.sds_g},
            {"sd1_g", design.site.sd1_g},
            {"seismic_design_category", to_string(design.site.category)},
            {"slope_deg", design.slope_deg},
            {"mass_ratio", design.mass_ratio},
            {"period_s", design.period_s},
            {"analysis_m", design.analysis_m},
            {"least_value_m", design.floor_m},
            {"governing_m", design.governing_m},
            {"rounded_m", design.rounded_m}};
  for (const PeriodDemand& d : design.demand)
    json["demand"].push_back({{"period_s", d.period_s},
                              {"mean_m", d.mean_m},
                              {"p84_m", d.p84_m},
                              {"p95_m", d.p95_m},
                              {"largest_m", d.largest_m}});
  for (const ProjectSeparation& s : design.separations)
    json["separations"].push_back({{"between", s.required.what},
                                   {"factor", s.required.factor},
                                   {"required_m", s.required.value_m}});
  for (const ExceedanceAt& e : design.exceedance)
    json["exceedance"].push_back({{"level", e.level},
                                  {"sds_g", e.sds_g},
                                  {"period_s", e.period_s},
                                  {"probability", e.probability},
                                  {"low95", e.interval.low},
                                  {"high95", e.interval.high}});
  for (const DesignCheck& check : design.checks)
    json["checks"].push_back(
        {{"check", check.what}, {"found", check.found}, {"is_met", check.is_met}});
  json["warnings"] = design.warnings;
  return json.dump(2) + "\n";
}

void make_folder(const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error)
    throw InputError({out.string(), "cannot be made: " + error.message(),
                      "give a folder you may write to with --out", ""});
}

/// Writes a study file on root and runs it on all ranks. Of a study that is refused nothing stays,
/// and an earlier file of the name comes back.
void run_made_study(const fs::path& file, const std::function<std::string()>& text, bool overwrite,
                    const Communicator& world) {
  std::optional<std::string> earlier;
  on_root(world, [&] {
    if (fs::exists(file)) earlier = read_text_file(file);
    write_text_file(file, text());
  });
  try {
    run_study({.study = file.string(),
               .out = (file.parent_path() / file.stem()).string(),
               .overwrite = overwrite,
               .quiet = true},
              world);
  } catch (const ExitStatus& exit) {
    std::error_code ignored;
    if (world.is_root() && exit.status == 2) {
      if (earlier) {
        write_text_file(file, *earlier);
      } else {
        fs::remove(file, ignored);
        fs::remove(file.parent_path(), ignored);  // if empty
      }
    }
    throw;
  }
}

void run(const ClearanceOptions& o, const Communicator& world) {
  if (o.project.empty())
    throw InputError({"clearance", "no project file is given",
                      "give one; `glissade clearance --example` prints one to begin with", ""});
  const fs::path out =
      o.out.empty() ? fs::path("results") / fs::path(o.project).stem() : fs::path(o.out);
  std::optional<Project> project;
  on_root(world, [&] {
    project = read_project(o.project);
    check_output_folder(out, o.overwrite);
    make_folder(out);
  });
  run_made_study(
      out / "demand.toml", [&] { return demand_study(*project, out); }, o.overwrite, world);

  std::optional<Results> demand;
  std::optional<DesignClearance> design;
  on_root(world, [&] {
    for (const char* name : {"package.html", "package.json"}) fs::remove(out / name);  // earlier
    demand = read_results(out / "demand" / "results.h5");
    design = design_clearance(*project, *demand);
  });
  run_made_study(
      out / "probability.toml",
      [&] { return probability_study(*project, out, {design->governing_m}); }, o.overwrite, world);

  on_root(world, [&] {
    const Results probability = read_results(out / "probability" / "results.h5");
    add_exceedance(probability, *design);
    const CalculationPackage package{*project,
                                     *design,
                                     *demand,
                                     probability,
                                     component_files(project->suite),
                                     sha256_of_file(project->file)};
    write_package(package, out);
    write_text_file(out / "package.json", numbers_json(*design));
    fmt::print("{}\nPackage  {}   (print it from a browser)\n", package_screen(package),
               (out / "package.html").string());
  });
}

}  // namespace

void add_clearance(CLI::App& program, const Communicator& world) {
  auto o = std::make_shared<ClearanceOptions>();
  CLI::App* command = program.add_subcommand(
      "clearance", "From a project file to required separations and a calculation package");
  command->add_option("project", o->project, "project file (TOML)");
  command->add_option("--out", o->out,
                      "results folder, new or empty [results/NAME OF THE PROJECT FILE]");
  command->add_flag("--example", o->example, "print a commented project file and stop");
  add_overwrite(*command, o->overwrite);
  command->callback([o, world] {
    if (!o->example) return run(*o, world);
    if (world.is_root()) fmt::print("{}", project_example());
  });
}

}  // namespace glissade::cli
