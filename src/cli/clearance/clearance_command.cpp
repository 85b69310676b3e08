// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <optional>

#include "clearance/calculation_folder.hpp"
#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/io/example_file.hpp"
#include "glissade/io/product_file.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/parallel/together.hpp"
#include "glissade/report/package.hpp"
#include "glissade/report/site_sheets.hpp"
#include "shared/build.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

std::vector<ComponentFile> component_files(const fs::path& suite) {
  const std::vector<RecordFile> records = record_files(suite);
  const std::vector<std::string> sums = sha256_of(records);
  std::vector<ComponentFile> files;
  for (std::size_t i = 0; i < records.size(); ++i)
    files.push_back({records[i].record, records[i].component, records[i].name, sums[i]});
  return files;
}

constexpr std::array study_names{"demand", "uncertainty", "probability"};

/// The studies and the package.
class Calculation {
 public:
  /// @param site of several; none: the project has one
  Calculation(const ClearanceOptions& options, const Communicator& world,
              std::optional<std::size_t> site = {})
      : options_(options),
        world_(world),
        site_(site),
        folder_(options, world, "package", site.has_value()) {}

  const Project& project() const { return *project_; }
  const SiteSheet& sheet() const { return sheet_; }

  void run() {
    folder_.begin([&](const fs::path& file) {
      project_ = site_ ? read_project(file, *site_) : read_project(file);
      return std::vector<std::string>{study_names.begin(), study_names.end()};
    });
    try {
      folder_.run("demand", [&] { return demand_study(*project_, folder_.path()); });
      on_root(world_, [&] {
        demand_ = read_results(folder_.path() / "demand" / "results.h5");
        design_ = design_clearance(*project_, *demand_, load_suite(project_->suite));
      });
      folder_.run("uncertainty", [&] { return uncertainty_study(*project_, folder_.path()); });
      folder_.run("probability", [&] {
        return probability_study(*project_, folder_.path(),
                                 compared_displacements_m(*project_, design_->governing_m));
      });
      on_root(world_, [&] { write(); });
    } catch (const ExitStatus& exit) {
      if (world_.is_root()) folder_.leave(exit.status);
      throw;
    }
  }

 private:
  void write() {
    const fs::path& out = folder_.path();
    const Results probability = read_results(out / "probability" / "results.h5");
    add_model_uncertainty(*project_, *demand_, read_results(out / "uncertainty" / "results.h5"),
                          *design_);
    add_exceedance(*project_, probability, *design_);
    const CalculationPackage package{*project_,
                                     *design_,
                                     *demand_,
                                     probability,
                                     component_files(project_->suite),
                                     folder_.identity().project_sha256,
                                     sha256_of_file(project_->suite),
                                     build_text()};
    bool is_printed = false;
    folder_.finish(
        [&] { is_printed = write_package(package, out); },
        [&] { write_finished_calculation(folder_.identity(), package, world_.size(), out); });
    sheet_ = site_sheet(package, out.filename().string());
    if (!site_)
      put("{}\nPackage  {}\n", package_screen(package), page_text(out, "package", is_printed));
  }

  const ClearanceOptions& options_;
  const Communicator& world_;
  std::optional<std::size_t> site_;
  CalculationFolder folder_;
  SiteSheet sheet_;  // on root, as all below
  std::optional<Project> project_;
  std::optional<Results> demand_;
  std::optional<DesignClearance> design_;
};

std::string site_folder(std::size_t site) { return fmt::format("site_{}", site + 1); }

/// A calculation for each site, in a folder of its own, and their summary.
void run_sites(const ClearanceOptions& options, const Communicator& world, std::size_t sites) {
  CalculationFolder folder(options, world, "sites");
  folder.begin([&](const fs::path& project) {
    std::vector<std::string> studies;
    for (std::size_t i = 0; i < sites; ++i) {
      static_cast<void>(read_project(project, i));  // nothing runs where one is wrong
      for (const char* study : study_names) studies.push_back(site_folder(i) + "/" + study);
    }
    return studies;
  });
  try {
    SiteSheets sheets;
    for (std::size_t i = 0; i < sites; ++i) {
      const std::string part = (folder.path() / site_folder(i)).string();
      const bool goes_on =
          root_says(world, [&] { return !options.resume.empty() && is_calculation(part); });
      const ClearanceOptions of_site{.project = folder.identity().project.string(),
                                     .out = goes_on ? "" : part,
                                     .resume = goes_on ? part : "",
                                     .overwrite = options.overwrite || !options.resume.empty()};
      Calculation calculation(of_site, world, i);
      calculation.run();
      if (!world.is_root()) continue;
      const Project& project = calculation.project();
      sheets.name = project.title.name.substr(
          0, project.title.name.size() - std::string(": ").size() - project.site_name.size());
      sheets.units = project.units;
      sheets.sites.push_back(calculation.sheet());
    }
    on_root(world, [&] {
      bool is_printed = false;
      folder.finish(
          [&] { is_printed = write_site_sheets(sheets, folder.path()); },
          [&] { write_finished_sites(folder.identity(), sheets, world.size(), folder.path()); });
      put("{}\nSummary  {}\n", sites_screen(sheets), page_text(folder.path(), "sites", is_printed));
    });
  } catch (const ExitStatus& exit) {
    if (world.is_root()) folder.leave(exit.status);
    throw;
  }
}

}  // namespace

void run_calculation(const ClearanceOptions& options, const Communicator& world) {
  std::vector<char> sites;  // one for each
  on_root(world, [&] {
    sites.resize(site_names(options.resume.empty() ? fs::path(options.project)
                                                   : read_calculation(options.resume).project)
                     .size());
  });
  world.broadcast(sites);
  sites.empty() ? Calculation(options, world).run() : run_sites(options, world, sites.size());
}

void check_calculation_folder(const fs::path& out, bool overwrite) {
  if (!overwrite && is_calculation(out) && !is_finished_calculation(out))
    throw InputError({"--out", out.string() + " holds a calculation that was stopped or killed",
                      "go on with: " + resume_calculation_command(out) +
                          ", or give another --out, or --overwrite",
                      ""});
  check_output_folder(out, overwrite);
}

void add_clearance(CLI::App& program, const Communicator& world) {
  auto o = std::make_shared<ClearanceOptions>();
  CLI::App* command = program.add_subcommand("clearance",
                                             "From a project file to required separations and a "
                                             "calculation package; from a product file to "
                                             "its sheet");
  CLI::Option* project =
      command->add_option("project", o->project, "project or product file (TOML)");
  CLI::Option* out = command->add_option(
      "--out", o->out, "results folder, new or empty [results/NAME OF THE PROJECT FILE]");
  CLI::Option* resume = command->add_option(
      "--resume", o->resume,
      "go on with the calculation in this folder, which was stopped or killed, to its package");
  command->add_flag("--example", o->example, "print a commented project file and stop");
  add_overwrite(*command, o->overwrite);
  for (CLI::Option* other : {project, out, command->get_option("--overwrite")})
    resume->excludes(other);
  command->footer(
      "Ctrl-C stops a calculation: exit status 75, and --resume goes on with it.\n"
      "`glissade check PROJECT` says what would run.\n"
      "A product file has [product] and [[target]]: `glissade explain product`.");
  command->callback([o, world] {
    if (o->example) {
      if (world.is_root()) put("{}", ExampleFile::project().text());
      return;
    }
    if (o->project.empty() && o->resume.empty())
      throw CLI::ValidationError(
          "clearance",
          "no project file is given; `glissade clearance --example` prints one to begin with");
    const bool of_product = root_says(world, [&] {
      if (!o->resume.empty()) check_is_no_site(o->resume);
      return is_product(o->resume.empty() ? fs::path(o->project)
                                          : read_calculation(o->resume).project);
    });
    of_product ? run_product(*o, world) : run_calculation(*o, world);
  });
}

}  // namespace glissade::cli
