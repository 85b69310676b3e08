// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <optional>

#include "commands.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/io/project_file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/write_report.hpp"
#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/reduce.hpp"
#include "output_rule.hpp"
#include "run/run_folder.hpp"
#include "run/run_record.hpp"
#include "run/run_study.hpp"
#include "run/run_units.hpp"
#include "run/stop_request.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

/// Every suite's problems, reported together.
std::vector<Suite> load_suites(const std::vector<fs::path>& files) {
  ProblemList problems;
  std::vector<Suite> suites;
  for (const fs::path& file : files) {
    try {
      suites.push_back(load_suite(file));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
  return suites;
}

/// What root does with the histories of all ranks.
void write_all(Plan whole, RunParts parts, std::uint64_t resumed, const RunOptions& options,
               StopRequest& stop, PhaseClock& clock, int ranks) {
  const fs::path out = options.folder();
  const std::size_t done = parts.units.size();
  const Plan plan = first_blocks(std::move(whole), done);
  const WorkCount count = total_count(parts.units);
  const std::vector<Skip> skips = skipped(plan, count);
  const Results results = reduce(plan, std::move(parts.units), parts.motion_parts);
  clock.end_phase("analyses");
  if (stop.requested()) end_stopped(out, stop.reason(), done, done);
  keeping_units(out, [&] { write_results(out / "results.h5", results); });
  clock.end_phase("results file");
  write_beside_results(out, [&] { write_report(results, out, skips); });
  clock.end_phase("report");
  write_beside_results(out, [&] {
    write_text_file(out / "run.json",
                    run_json(results, skips, clock, ranks, count, resumed, parts.other_ranks_mb));
  });
  if (options.quiet) return;
  fmt::print("{}\n", summary_text(results, skips));
  print_seconds(clock, ranks);
  fmt::print(
      "Histories integrated: {} at the levels, {} in search of capacities, on {} roof motions\n",
      count.integrated, count.searched, count.roofs);
  print_where(out);
}

/// Reads and simulates once, on root; the study's path to everybody.
std::vector<Suite> prepare_motions(RunOptions& options, StoppedRun& stopped,
                                   const Communicator& world) {
  std::vector<Suite> suites;
  on_root(world, [&] {
    if (!options.resume.empty()) {
      stopped = take_stopped_run(options.resume);
      if (options.study.empty()) options.study = stopped.begun.study_file.string();
    } else if (!options.dry_run) {
      check_run_folder(options.folder(), options.overwrite);
    }
    suites = load_suites(read_study(options.study).suite_files);
  });
  std::vector<char> study(options.study.begin(), options.study.end());
  world.broadcast(study);
  options.study.assign(study.begin(), study.end());
  share(suites, world);
  return suites;
}

/// The same on every rank. The ranks share its spectra; input that is invalid is so on all of them.
Plan make_shared_plan(const std::string& study, std::vector<Suite> suites,
                      const Communicator& world) {
  Plan plan;
  std::optional<InputError> invalid;
  try {
    plan = make_plan(
        read_study(study), std::move(suites),
        [&](std::size_t count, const Part& part) { return share_parts(world, count, part); });
  } catch (const InputError& error) {
    invalid = error;
  }
  on_root(world, [&] {
    if (invalid) throw *invalid;
  });
  check_same_plan(plan.hash, world);
  return plan;
}

/// The units of earlier sessions, on root.
Journal open_journals(const fs::path& out, const StoppedRun& stopped, const RunIdentity& run,
                      const Plan& plan) {
  check_same_run(stopped.begun, run, out);
  Journal journal = read_journals(out, run, plan);
  write_text_file(out / "run.json", started_json(plan.config.name, plan.hash));
  fmt::print("Resumed: {} of {} units are in the journals", journal.units.size(),
             plan.units.size());
  if (journal.bytes_not_read > 0)
    fmt::print(", beside {} bytes that are not whole records", journal.bytes_not_read);
  fmt::print("\n");
  return journal;
}

/// What would run, what it would cost, and whether its folder is free; if not, that is an error.
void check_study(const Plan& plan, const fs::path& out, bool overwrite) {
  fmt::print("{}", to_string(plan));
  fmt::print("time        roughly {:.0f} s on one core\n", std::ceil(plan.predicted_seconds()));
  fmt::print("results     about {:.1f} MB in results.h5, and in the memory of the first rank\n",
             bytes_of(plan.config, plan.records.size(), plan.cases.size()) / 1e6);
  std::fflush(stdout);
  check_run_folder(out, overwrite);
  fmt::print("folder      {}: free\n", out.string());
}

}  // namespace

fs::path RunOptions::folder() const {
  if (!resume.empty()) return resume;
  return out.empty() ? fs::path("results") / fs::path(study).stem() : fs::path(out);
}

void run_study(RunOptions options, const Communicator& world) {
  const auto start = std::chrono::steady_clock::now();
  PhaseClock clock;
  StoppedRun stopped;  // on root, where it is resumed
  std::vector<Suite> suites = prepare_motions(options, stopped, world);
  const fs::path out = options.folder();
  clock.end_phase("motions");

  Plan plan = make_shared_plan(options.study, std::move(suites), world);
  const RunIdentity identity = identity_of(plan, GLISSADE_VERSION);
  Journal journal;
  on_root(world, [&] {
    if (options.dry_run) return check_study(plan, out, options.overwrite);
    if (stopped.lock) {
      journal = open_journals(out, stopped, identity, plan);
    } else {
      stopped.lock = take_run_folder(out, plan, identity, options.overwrite);
    }
  });
  const RunFolderGuard guard(options.dry_run ? fs::path() : out, world);
  clock.end_phase("plan");
  if (options.dry_run) return;

  StopRequest stop(world.is_root() ? out / "stop" : fs::path(), options.walltime_s, start);
  const std::uint64_t resumed = journal.units.size();
  RunParts parts =
      run_units(plan, options.no_skip ? Skipping::none : Skipping::all, std::move(journal),
                JournalWriter(out, world.rank(), identity), stop, out, world);
  clock.end_phase("histories");
  on_root(world, [&] {
    write_all(std::move(plan), std::move(parts), resumed, options, stop, clock, world.size());
    stopped.lock->remove_journals();
  });
}

void add_run(CLI::App& program, const Communicator& world) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand(
      "run", "Run a study: histories, its analyses, tables, figures and report");
  CLI::Option* study =
      command->add_option("study", options->study, "study file (TOML); see studies/");
  CLI::Option* out = command->add_option(
      "--out", options->out, "results folder, new or empty [results/NAME OF THE STUDY FILE]");
  CLI::Option* resume = command->add_option(
      "--resume", options->resume,
      "go on with the run in this results folder, which was stopped or killed; on any number of "
      "ranks, the results are the same to the last bit");
  command
      ->add_option("--walltime-s", options->walltime_s,
                   "stop by itself before so many seconds are over; the run can be resumed")
      ->check(CLI::PositiveNumber);
  add_overwrite(*command, options->overwrite);
  CLI::Option* dry_run =
      command->add_flag("--dry-run", options->dry_run, "the same as `glissade check`");
  command->add_flag("--no-skip", options->no_skip,
                    "compute also what the study does not need: much slower, the same results to "
                    "the last bit");
  for (CLI::Option* other : {out, dry_run, command->get_option("--overwrite")})
    resume->excludes(other);
  command->footer(
      "SIGINT (Ctrl-C), SIGTERM, SIGUSR1 or a file named stop in the results folder\n"
      "stop a run: exit status 75, and --resume goes on with it.");
  command->callback([options, study, world] {
    if (options->study.empty() && options->resume.empty())
      throw CLI::RequiredError(study->get_name());
    run_study(*options, world);
  });

  CLI::App* check = program.add_subcommand(
      "check",
      "What a study or project would run, its cost and warnings; nothing is run or written");
  check->add_option("study", options->study, "study or project file (TOML); see studies/")
      ->required();
  check->add_option("--results", options->out, "folder that is to be free [as of run]");
  check->callback([options, world] {
    bool of_project = false;
    on_root(world, [&] {
      of_project = is_project(options->study);
      if (of_project) check_project(options->study, options->folder());
    });
    std::vector<char> ends(1, of_project ? 1 : 0);
    world.broadcast(ends);
    if (ends[0] != 0) return;
    options->dry_run = true;
    run_study(*options, world);
  });
}

}  // namespace glissade::cli
