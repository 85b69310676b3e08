// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>

#include "build.hpp"
#include "clearance/calculation_record.hpp"
#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/folder.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/io/example_file.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/package.hpp"
#include "glissade/study/plan/plan.hpp"
#include "output_rule.hpp"
#include "put.hpp"
#include "run/run_folder.hpp"
#include "run/run_study.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

struct ClearanceOptions {
  std::string project, out, resume;
  bool example = false, overwrite = false;
};

std::vector<ComponentFile> component_files(const fs::path& suite) {
  const std::vector<RecordFile> records = record_files(suite);
  const std::vector<std::string> sums = sha256_of(records);
  std::vector<ComponentFile> files;
  for (std::size_t i = 0; i < records.size(); ++i)
    files.push_back({records[i].record, records[i].component, records[i].name, sums[i]});
  return files;
}

/// A study of the calculation: the file is written on root, and run on all ranks.
class MadeStudy {
 public:
  MadeStudy(const ClearanceOptions& options, const Communicator& world)
      : options_(options), world_(world) {}

  void run(const fs::path& file, const std::function<std::string()>& text) const {
    const std::string folder = (file.parent_path() / file.stem()).string();
    std::optional<std::string> earlier;
    try {
      std::vector<char> goes_on(1);
      on_root(world_, [&] {
        const std::string study = text();
        if (fs::exists(file)) earlier = read_text_file(file);
        write_text_file(file, study);
        const bool resumes = !options_.resume.empty(), is_done = resumes && has_results(folder);
        if (is_done) check_results(folder, file, study);
        goes_on[0] = is_done || (resumes && has_identity(folder)) ? 1 : 0;
      });
      world_.broadcast(goes_on);
      run_study({.study = file.string(),
                 .out = goes_on[0] != 0 ? "" : folder,
                 .resume = goes_on[0] != 0 ? folder : "",
                 .overwrite = options_.overwrite || !options_.resume.empty(),
                 .quiet = true,
                 .stop_file = file.parent_path() / "stop"},
                world_);
    } catch (const ExitStatus& exit) {
      if (world_.is_root() && exit.status == 2) put_back(file, earlier);
      if (exit.status != 0) throw;  // 0: it was finished
    }
  }

 private:
  /// Throws InputError where they are not those of the project as it is now.
  static void check_results(const fs::path& folder, const fs::path& file, const std::string& text) {
    const ResultsOrigin origin = read_origin(folder / "results.h5");
    const StudyConfig study = read_study(file);
    if (origin.study_text == text &&
        origin.plan_hash == make_plan(study, {load_suite(study.suite_files.front())}).hash)
      return;
    throw InputError({(folder / "results.h5").string(),
                      origin.study_text == text
                          ? "is of other motions: the suite, or a file that it names, has changed"
                          : "is not of the study that the project now gives",
                      "undo the change, or begin again with --overwrite", ""});
  }

  /// Of a study that is refused nothing stays, and an earlier file of the name comes back.
  static void put_back(const fs::path& file, const std::optional<std::string>& earlier) {
    std::error_code ignored;
    if (earlier)
      write_text_file(file, *earlier);
    else
      fs::remove(file, ignored);
  }

  const ClearanceOptions& options_;
  const Communicator& world_;
};

/// Both studies and the package.
class Calculation {
 public:
  Calculation(const ClearanceOptions& options, const Communicator& world)
      : options_(options), world_(world) {}

  void run() {
    begin();
    try {
      const MadeStudy study(options_, world_);
      study.run(out_ / "demand.toml", [&] { return demand_study(*project_, out_); });
      on_root(world_, [&] {
        demand_ = read_results(out_ / "demand" / "results.h5");
        design_ = design_clearance(*project_, *demand_, load_suite(project_->suite));
      });
      study.run(out_ / "probability.toml", [&] {
        return probability_study(*project_, out_,
                                 compared_displacements_m(*project_, design_->governing_m));
      });
      on_root(world_, [&] { write(); });
    } catch (const ExitStatus& exit) {
      if (world_.is_root()) leave(exit.status);
      throw;
    }
  }

 private:
  void begin() {
    on_root(world_, [&] {
      const bool resumes = !options_.resume.empty();
      if (resumes) identity_ = read_calculation(options_.resume);
      const fs::path file = resumes ? identity_.project : fs::path(options_.project);
      out_ = resumes                ? fs::path(options_.resume)
             : options_.out.empty() ? fs::path("results") / file.stem()
                                    : fs::path(options_.out);
      if (resumes) check_own(out_);
      project_ = read_project(file);
      const CalculationIdentity now{fs::absolute(file), sha256_of_file(file)};
      if (resumes && now.project_sha256 != identity_.project_sha256)
        throw InputError({file.string(), "was changed since the calculation began",
                          "undo the change, or begin again with --overwrite", ""});
      if (resumes && is_whole()) {
        put("{} is finished: {}\n", out_.string(), (out_ / "package.html").string());
        throw ExitStatus{0};
      }
      identity_ = now;
      check_project_path(identity_.project);
      if (!resumes) check_calculation_folder(out_, options_.overwrite);
      lock_ = take_folder(out_);
      for (const char* name : {"package.html", "package.json", "package.pdf", "package.xlsx"})
        remove_file(out_ / name);  // earlier
      write_begun_calculation(identity_, "started", out_);
    });
    std::vector<char> out = path_text(out_);
    world_.broadcast(out);
    out_ = std::string(out.begin(), out.end());
  }

  /// Everything that a finished calculation writes is there, and its results are whole.
  bool is_whole() const {
    std::error_code ignored;
    return is_finished_calculation(out_) &&
           std::ranges::all_of(std::array{"package.html", "package.json"},
                               [&](const char* name) {
                                 const auto bytes = fs::file_size(out_ / name, ignored);
                                 return !ignored && bytes > 0;
                               }) &&
           has_results(out_ / "demand") && has_results(out_ / "probability");
  }

  static std::vector<char> path_text(const fs::path& path) {
    const std::string text = path.string();
    return {text.begin(), text.end()};
  }

  void write() {
    const Results probability = read_results(out_ / "probability" / "results.h5");
    add_exceedance(*project_, probability, *design_);
    const CalculationPackage package{*project_,
                                     *design_,
                                     *demand_,
                                     probability,
                                     component_files(project_->suite),
                                     identity_.project_sha256,
                                     sha256_of_file(project_->suite),
                                     build_text()};
    const bool is_printed = write_package(package, out_, options_.overwrite);
    write_finished_calculation(identity_, package, world_.size(), out_);
    lock_->give_back();
    put("{}\nPackage  {}{}\n", package_screen(package),
        (out_ / (is_printed ? "package.pdf" : "package.html")).string(),
        is_printed ? "" : "   (print it from a browser: WeasyPrint is not installed)");
  }

  /// A refused calculation that has nothing gives its folder back.
  void leave(int status) {
    std::error_code ignored;
    fs::remove(out_ / "stop", ignored);
    const bool has_study = fs::exists(out_ / "demand", ignored);
    if (status == 2 && !has_study) {
      fs::remove(out_ / "run.json", ignored);
      lock_.reset();
      fs::remove(out_, ignored);  // if empty
    } else if (has_study) {
      write_begun_calculation(identity_, "stopped", out_);
    }
  }

  const ClearanceOptions& options_;
  const Communicator& world_;
  fs::path out_;
  std::unique_ptr<RunLock> lock_;  // on root
  CalculationIdentity identity_;
  std::optional<Project> project_;
  std::optional<Results> demand_;
  std::optional<DesignClearance> design_;
};

}  // namespace

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
  CLI::App* command = program.add_subcommand(
      "clearance", "From a project file to required separations and a calculation package");
  CLI::Option* project = command->add_option("project", o->project, "project file (TOML)");
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
      "`glissade check PROJECT` says what would run.");
  command->callback([o, world] {
    if (o->example) {
      if (world.is_root()) put("{}", ExampleFile::project().text());
      return;
    }
    if (o->project.empty() && o->resume.empty())
      throw CLI::ValidationError(
          "clearance",
          "no project file is given; `glissade clearance --example` prints one to begin with");
    Calculation(*o, world).run();
  });
}

}  // namespace glissade::cli
