// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <optional>

#include "build.hpp"
#include "clearance/calculation_record.hpp"
#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/core/output_file.hpp"
#include "glissade/design/design_clearance.hpp"
#include "glissade/io/example_file.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/sha256.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/package.hpp"
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
  std::vector<ComponentFile> files;
  for (const RecordFile& f : record_files(suite))
    files.push_back({f.record, f.component, f.name, sha256_of_file(f.path)});
  return files;
}

void make_folder(const fs::path& out) {
  std::error_code error;
  fs::create_directories(out, error);
  if (error)
    throw InputError({out.string(), "cannot be made: " + error.message(),
                      "give a folder you may write to with --out", ""});
}

/// How far a study of the calculation is.
enum class StudyProgress : char { none, begun, finished };

/// Expects the study as the project now gives it. Throws InputError where a finished one differs.
StudyProgress progress_of(const fs::path& file, const std::string& text) {
  const fs::path folder = file.parent_path() / file.stem();
  std::error_code ignored;
  if (is_finished(folder / "run.json") && fs::exists(folder / "results.h5", ignored)) {
    if (read_text_file(file) != text)
      throw InputError({file.string(), "is not as the project now gives it",
                        "undo the change of its files, or begin again with --overwrite", ""});
    return StudyProgress::finished;
  }
  return has_identity(folder) ? StudyProgress::begun : StudyProgress::none;
}

/// A study of the calculation: the file is written on root, and run on all ranks.
class MadeStudy {
 public:
  MadeStudy(const ClearanceOptions& options, const Communicator& world)
      : options_(options), world_(world) {}

  void run(const fs::path& file, const std::function<std::string()>& text) const {
    std::vector<char> progress(1);
    std::optional<std::string> earlier;
    on_root(world_, [&] {
      const std::string study = text();
      if (!options_.resume.empty()) progress[0] = static_cast<char>(progress_of(file, study));
      if (fs::exists(file)) earlier = read_text_file(file);
      write_text_file(file, study);
    });
    world_.broadcast(progress);
    const auto at = static_cast<StudyProgress>(progress[0]);
    if (at == StudyProgress::finished) return;
    const std::string folder = (file.parent_path() / file.stem()).string();
    const bool go_on = at == StudyProgress::begun;
    try {
      run_study({.study = file.string(),
                 .out = go_on ? "" : folder,
                 .resume = go_on ? folder : "",
                 .overwrite = options_.overwrite || !options_.resume.empty(),
                 .quiet = true,
                 .stop_file = file.parent_path() / "stop"},
                world_);
    } catch (const ExitStatus& exit) {
      if (world_.is_root() && exit.status == 2) put_back(file, earlier);
      throw;
    }
  }

 private:
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
        design_ = design_clearance(*project_, *demand_);
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
      if (resumes && is_finished_calculation(out_)) {
        put("{} is finished: {}\n", out_.string(), (out_ / "package.html").string());
        throw ExitStatus{0};
      }
      project_ = read_project(file);
      const CalculationIdentity now{fs::absolute(file), sha256_of_file(file)};
      if (resumes && now.project_sha256 != identity_.project_sha256)
        throw InputError({file.string(), "was changed since the calculation began",
                          "undo the change, or begin again with --overwrite", ""});
      identity_ = now;
      if (!resumes) check_calculation_folder(out_, options_.overwrite);
      make_folder(out_);
      for (const char* name : {"package.html", "package.json"}) {  // earlier
        std::error_code error;
        fs::remove(out_ / name, error);
        if (error) throw_io_error(out_ / name, "cannot be removed", error.value());
      }
      write_begun_calculation(identity_, "started", out_);
    });
    std::vector<char> out = path_text(out_);
    world_.broadcast(out);
    out_ = std::string(out.begin(), out.end());
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
    write_package(package, out_);
    write_finished_calculation(identity_, package, world_.size(), out_);
    put("{}\nPackage  {}   (print it from a browser)\n", package_screen(package),
        (out_ / "package.html").string());
  }

  /// A refused calculation that has nothing gives its folder back.
  void leave(int status) const {
    std::error_code ignored;
    fs::remove(out_ / "stop", ignored);
    const bool has_study = fs::exists(out_ / "demand", ignored);
    if (status == 2 && !has_study) {
      fs::remove(out_ / "run.json", ignored);
      fs::remove(out_, ignored);  // if empty
    } else if (has_study) {
      write_begun_calculation(identity_, "stopped", out_);
    }
  }

  const ClearanceOptions& options_;
  const Communicator& world_;
  fs::path out_;
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
