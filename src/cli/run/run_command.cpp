// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "commands.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/write_report.hpp"
#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/exchange.hpp"
#include "glissade/study/run/execute.hpp"
#include "glissade/study/run/reduce.hpp"
#include "output_rule.hpp"
#include "run/progress.hpp"
#include "run/run_folder.hpp"
#include "run/run_record.hpp"
#include "run/run_study.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

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
void write_all(const Plan& plan, const std::vector<UnitResult>& units, const fs::path& out,
               PhaseClock& clock, int ranks, bool quiet) {
  const WorkCount count = total_count(units);
  const std::vector<Skip> skips = skipped(plan, count);
  const Results results = reduce(plan, units);
  clock.end_phase("analyses");
  write_results(out / "results.h5", results);
  clock.end_phase("results file");
  write_beside_results(out, [&] { write_report(results, out, skips); });
  clock.end_phase("report");
  write_beside_results(out, [&] {
    write_text_file(out / "run.json", run_json(results, skips, clock, ranks, count));
  });
  if (quiet) return;
  fmt::print("{}\n", summary_text(results, skips));
  print_seconds(clock, ranks);
  fmt::print(
      "Histories integrated: {} at the levels, {} in search of capacities, on {} roof motions\n",
      count.integrated, count.searched, count.roofs);
  print_where(out);
}

/// What would run, what it would cost, and whether its folder is free.
void print_check(const Plan& plan, const fs::path& out) {
  fmt::print("{}", to_string(plan));
  fmt::print("time        roughly {:.0f} s on one core\n", std::ceil(plan.predicted_seconds()));
  fmt::print("results     about {:.1f} MB in results.h5, and in the memory of the first rank\n",
             bytes_of(plan.config, plan.records.size(), plan.cases.size()) / 1e6);
  std::string folder = out.string() + ": free";
  try {
    check_output_folder(out, false);
  } catch (const InputError& error) {
    folder = "NOT FREE: " + error.problems().front().what;
  }
  fmt::print("folder      {}\n", folder);
}

}  // namespace

void run_study(const RunOptions& options, const Communicator& world) {
  const fs::path out = options.out.empty() ? fs::path("results") / fs::path(options.study).stem()
                                           : fs::path(options.out);
  PhaseClock clock;

  // Read and simulate once, on root; then everybody makes the same plan.
  std::vector<Suite> suites;
  on_root(world, [&] {
    const StudyConfig config = read_study(options.study);
    if (!options.dry_run) check_output_folder(out, options.overwrite);
    suites = load_suites(config.suite_files);
  });
  share(suites, world);
  clock.end_phase("motions");
  Plan plan;
  on_root(world, [&] {
    plan = make_plan(read_study(options.study), suites);
    if (!options.dry_run) {
      take_results_folder(out, bytes_of(plan.config, plan.records.size(), plan.cases.size()),
                          started_json(plan.config.name, plan.hash), options.overwrite);
    }
  });
  const ResultsFolderGuard guard(options.dry_run ? fs::path() : out, world);
  if (!world.is_root()) plan = make_plan(read_study(options.study), suites);
  check_same_plan(plan.hash, world);
  clock.end_phase("plan");
  if (options.dry_run) {
    if (world.is_root()) print_check(plan, out);
    return;
  }

  const std::vector<UnitResult> units =
      execute_all(plan, world, options.no_skip ? Skipping::none : Skipping::all);
  clock.end_phase("histories");
  on_root(world, [&] { write_all(plan, units, out, clock, world.size(), options.quiet); });
}

void add_run(CLI::App& program, const Communicator& world) {
  auto options = std::make_shared<RunOptions>();
  CLI::App* command = program.add_subcommand(
      "run", "Run a study: histories, its analyses, tables, figures and report");
  command->add_option("study", options->study, "study file (TOML); see studies/")->required();
  command->add_option("--out", options->out,
                      "results folder, new or empty [results/NAME OF THE STUDY FILE]");
  add_overwrite(*command, options->overwrite);
  command->add_flag("--dry-run", options->dry_run, "the same as `glissade check`");
  command->add_flag("--no-skip", options->no_skip,
                    "compute also what the study does not need: much slower, the same results to "
                    "the last bit");
  command->callback([options, world] { run_study(*options, world); });

  CLI::App* check = program.add_subcommand(
      "check", "What a study would run, its cost and warnings; nothing is run or written");
  check->add_option("study", options->study, "study file (TOML); see studies/")->required();
  check->add_option("--results", options->out, "folder that is to be free [as of run]");
  check->callback([options, world] {
    options->dry_run = true;
    run_study(*options, world);
  });
}

}  // namespace glissade::cli
