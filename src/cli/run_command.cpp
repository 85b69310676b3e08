// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/write_report.hpp"
#include "glissade/study/exchange.hpp"
#include "glissade/study/execute.hpp"
#include "glissade/study/plan.hpp"
#include "glissade/study/reduce.hpp"
#include "progress.hpp"
#include "run_record.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

struct RunOptions {
  std::string study;
  std::string out;
  bool dry_run = false;
  bool no_skip = false;
};

/// A results folder that holds anything is never written into.
void check_results_folder(const fs::path& folder) {
  std::error_code error;
  if (!fs::exists(folder, error)) return;
  if (!fs::is_directory(folder, error)) {
    throw InputError({folder.string(), "is not a folder", "give another --out", ""});
  }
  if (!fs::is_empty(folder, error) || error) {
    throw InputError({folder.string(),
                      "already holds a run or other files, which are never written over",
                      "give a new folder with --out, or remove this one", ""});
  }
}

void make_results_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) {
    throw InputError({folder.string(), "cannot be made: " + error.message(),
                      "give a folder you may write to with --out", ""});
  }
}

/// The results, or nothing: not even their folder.
void write_results_file(const fs::path& folder, const Results& results) {
  try {
    write_results(folder / "results.h5", results);
  } catch (const InputError&) {
    std::error_code ignored;
    fs::remove(folder / "run.json", ignored);
    fs::remove(folder, ignored);  // if empty
    throw;
  }
}

/// What is made from the results can be made again: the error says how.
template <class Write>
void write_beside_results(const fs::path& folder, Write write) {
  try {
    write();
  } catch (const InputError& error) {
    ProblemList problems;
    problems.add(error);
    problems.add({(folder / "results.h5").string(), "is whole",
                  "make the rest again with: glissade report " + (folder / "results.h5").string(),
                  ""});
    problems.throw_if_any();
  }
}

/// Results need room: refused before hours of work rather than after.
void check_room(const fs::path& folder, const Plan& plan) {
  const double values = static_cast<double>(plan.histories()) * (sizeof(double) + 1) +
                        static_cast<double>(plan.runs.size() * plan.suite.motions.size() *
                                            plan.samples.size() * plan.config.thresholds_m.size()) *
                            sizeof(double);
  const double needed = values + 20e6;  // figures, tables, report
  std::error_code error;
  fs::path existing = fs::absolute(folder);
  while (!fs::exists(existing, error) && existing.has_relative_path())
    existing = existing.parent_path();
  const fs::space_info space = fs::space(existing, error);
  if (!error && static_cast<double>(space.available) < needed) {
    throw InputError(
        {folder.string(),
         fmt::format("the disk has {:.0f} MB free and the results need about {:.0f} MB",
                     static_cast<double>(space.available) / 1e6, needed / 1e6),
         "make room, or give a folder on another disk with --out", ""});
  }
}

/// Root prepares what may fail on the user's input; the others learn whether it did.
template <class Prepare>
void on_root(const Communicator& world, Prepare prepare) {
  std::vector<char> ok(1, 1);
  if (world.is_root()) {
    try {
      prepare();
    } catch (const InputError& error) {
      fmt::print(stderr, "glissade: {}\n", error.what());
      ok[0] = 0;
    }
  }
  world.broadcast(ok);
  if (ok[0] == 0) throw ExitStatus{2};
}

/// Every rank makes the plan itself; other processors or mathematical libraries could make another.
void check_same_plan(const Plan& plan, const Communicator& world) {
  std::vector<char> of_root(plan.hash.begin(), plan.hash.end());
  world.broadcast(of_root);
  if (plan.hash != std::string(of_root.begin(), of_root.end())) {
    throw std::runtime_error(
        "the ranks make different plans of one study: run them on one kind of machine, and leave "
        "the study file alone meanwhile");
  }
}

std::vector<UnitResult> execute_all(const Plan& plan, const Communicator& world,
                                    Skipping skipping) {
  RoofStore roofs(plan, skipping);
  Progress progress(plan.units.size(), plan.histories());
  std::vector<UnitResult> mine;
  self_schedule(world, plan.units.size(), [&](std::uint64_t unit) {
    mine.push_back(execute(plan, unit, roofs));
    if (world.is_root())
      progress.update(unit);  // units go out in order: those before are done or under way
  });
  std::vector<UnitResult> all;
  for (const std::vector<char>& part : world.gather(pack(mine))) {
    for (UnitResult& result : unpack_unit_results(part)) all.push_back(std::move(result));
  }
  if (world.is_root()) progress.finish();
  return all;
}

void run(const RunOptions& options, const Communicator& world) {
  PhaseClock clock;
  const fs::path out = options.out.empty() ? fs::path("results") / fs::path(options.study).stem()
                                           : fs::path(options.out);

  // Read and simulate once, on root; then everybody makes the same plan.
  Suite suite;
  on_root(world, [&] {
    const StudyConfig config = read_study(options.study);
    if (!options.dry_run) check_results_folder(out);
    suite = load_suite(config.suite_file);
  });
  std::vector<char> message = world.is_root() ? pack(suite) : std::vector<char>();
  world.broadcast(message);
  clock.end_phase("motions");
  Plan plan;
  on_root(world, [&] {
    plan = make_plan(read_study(options.study), suite);
    if (!options.dry_run) {
      check_room(out, plan);
      make_results_folder(out);  // before hours of work: it may be refused
      create_text_file(out / "run.json",
                       started_json(plan.config.name, plan.hash));  // and nobody else may take it
    }
  });
  if (!world.is_root()) plan = make_plan(read_study(options.study), unpack_suite(message));
  check_same_plan(plan, world);
  clock.end_phase("plan");
  if (options.dry_run) {
    if (world.is_root()) fmt::print("{}", to_string(plan));
    return;
  }

  const std::vector<UnitResult> units =
      execute_all(plan, world, options.no_skip ? Skipping::none : Skipping::all);
  clock.end_phase("histories");
  on_root(world, [&] {
    const Results results = reduce(plan, units);
    const WorkCount count = total_count(units);
    const std::vector<Skip> skips = skipped(plan, count);
    clock.end_phase("fragilities");
    write_results_file(out, results);
    clock.end_phase("results file");
    write_beside_results(out, [&] { write_report(results, out, skips); });
    clock.end_phase("report");
    write_beside_results(out, [&] {
      write_text_file(out / "run.json", run_json(results, skips, clock, world.size(), count));
    });

    fmt::print("{}\n", summary_text(results, skips));
    std::string phases;
    double total = 0.0;
    for (const auto& [phase, seconds] : clock.phases()) {
      phases += fmt::format("{}{} {:.2f}", phases.empty() ? "" : ", ", phase, seconds);
      total += seconds;
    }
    fmt::print("Seconds on {} rank{}: {:.2f} ({})\n", world.size(), world.size() == 1 ? "" : "s",
               total, phases);
    fmt::print(
        "Histories integrated: {} at the levels, {} in search of capacities, on {} roof motions\n",
        count.integrated, count.searched, count.roofs);
    fmt::print("Report   {}\nResults  {}\nTables   {}\nFigures  {}\nRun      {}\n",
               (out / "report.html").string(), (out / "results.h5").string(),
               (out / "tables").string(), (out / "figures").string(), (out / "run.json").string());
  });
}

}  // namespace

void add_run(CLI::App& program, const Communicator& world) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand(
      "run", "Run a study: fragility curves, slip against the standards, report");
  command->add_option("study", options->study, "study file (TOML); see studies/")->required();
  command->add_option("--out", options->out,
                      "results folder, new or empty [results/NAME OF THE STUDY FILE]");
  command->add_flag("--dry-run", options->dry_run, "print the plan and stop");
  command->add_flag("--no-skip", options->no_skip,
                    "compute also what the study does not need: much slower, the same results to "
                    "the last bit");
  command->callback([options, world] { run(*options, world); });
}

}  // namespace glissade::cli
