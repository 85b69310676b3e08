// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
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

/// Writes a study that root made, and runs it.
void run_made_study(const fs::path& file, bool overwrite, const Communicator& world) {
  run_study({.study = file.string(),
             .out = (file.parent_path() / file.stem()).string(),
             .overwrite = overwrite,
             .quiet = true},
            world);
}

void run(const ClearanceOptions& o, const Communicator& world) {
  if (o.project.empty())
    throw InputError({"clearance", "no project file is given",
                      "give one; `glissade clearance --example` prints one to begin with", ""});
  const fs::path out =
      o.out.empty() ? fs::path("results") / fs::path(o.project).stem() : fs::path(o.out);
  const fs::path demand_file = out / "demand.toml", probability_file = out / "probability.toml";
  std::optional<Project> project;
  on_root(world, [&] {
    project = read_project(o.project);
    check_output_folder(out, o.overwrite);
    fs::create_directories(out);
    write_text_file(demand_file, demand_study(*project, out));
  });
  run_made_study(demand_file, o.overwrite, world);

  std::optional<Results> demand;
  std::optional<DesignClearance> design;
  on_root(world, [&] {
    demand = read_results(out / "demand" / "results.h5");
    design = design_clearance(*project, *demand);
    write_text_file(probability_file, probability_study(*project, out, {design->governing_m}));
  });
  run_made_study(probability_file, o.overwrite, world);

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
    fmt::print("{}\nPackage  {}   (print it from a browser, or: weasyprint)\n",
               package_screen(package), (out / "package.html").string());
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
