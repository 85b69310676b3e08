// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_clearance.hpp"

#include <fmt/format.h>

#include "glissade/core/file.hpp"
#include "glissade/io/clearance_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/clearance_report.hpp"
#include "output_rule.hpp"
#include "progress.hpp"
#include "run_folder.hpp"
#include "run_record.hpp"

namespace glissade::cli {
namespace {

std::vector<ClearanceUnit> execute_all(const ClearancePlan& plan, const Communicator& world) {
  Progress progress(plan.units(), plan.histories());
  std::vector<ClearanceUnit> mine;
  self_schedule(world, plan.units(), [&](std::uint64_t unit) {
    mine.push_back(execute(plan, unit));
    if (world.is_root()) progress.update(unit);
  });
  std::vector<ClearanceUnit> all;
  for (const std::vector<char>& part : world.gather(pack(mine))) {
    for (ClearanceUnit& unit : unpack_clearance_units(part)) all.push_back(std::move(unit));
  }
  if (world.is_root()) progress.finish();
  return all;
}

/// Every suite's problems, told together.
std::vector<Suite> load_suites(const std::vector<std::filesystem::path>& files) {
  ProblemList problems;
  std::vector<Suite> suites;
  for (const std::filesystem::path& file : files) {
    try {
      suites.push_back(load_suite(file));
    } catch (const InputError& error) {
      problems.add(error);
    }
  }
  problems.throw_if_any();
  return suites;
}

/// Root's suites to everybody.
void share_all(std::vector<Suite>& suites, const Communicator& world) {
  std::vector<char> count(world.is_root() ? suites.size() : 0);  // as many bytes as suites
  world.broadcast(count);
  suites.resize(count.size());
  for (Suite& suite : suites) share(suite, world);
}

}  // namespace

void run_clearance(const ClearanceRun& run, const Communicator& world) {
  PhaseClock clock;
  std::vector<Suite> suites;
  on_root(world, [&] {
    const ClearanceConfig config = read_clearance_study(run.study);
    if (!run.dry_run) check_output_folder(run.out, run.overwrite);
    suites = load_suites(config.suite_files);
  });
  share_all(suites, world);
  clock.end_phase("motions");
  ClearancePlan plan;
  on_root(world, [&] {
    plan = make_plan(read_clearance_study(run.study), suites);
    if (!run.dry_run) {
      const std::size_t histories =
          plan.records.size() * plan.orientations.size() * plan.config.grid.count();
      take_results_folder(run.out, static_cast<double>(histories * sizeof(ClearanceHistory)),
                          started_json(plan.config.name, plan.hash), run.overwrite);
    }
  });
  const ResultsFolderGuard guard(run.dry_run ? std::filesystem::path() : run.out, world);
  if (!world.is_root()) plan = make_plan(read_clearance_study(run.study), suites);
  check_same_plan(plan.hash, world);
  clock.end_phase("plan");
  if (run.dry_run) {
    if (world.is_root()) fmt::print("{}", to_string(plan));
    return;
  }

  const std::vector<ClearanceUnit> units = execute_all(plan, world);
  clock.end_phase("histories");
  on_root(world, [&] {
    const ClearanceResults results = reduce(plan, units);
    write_clearance(run.out / "results.h5", results);
    clock.end_phase("results file");
    write_beside_results(run.out, [&] { write_clearance_report(results, run.out); });
    clock.end_phase("report");
    write_beside_results(run.out, [&] {
      write_text_file(run.out / "run.json",
                      run_json(results, plan.histories(), clock, world.size()));
    });
    fmt::print("{}\n", clearance_summary(results));
    print_seconds(clock, world.size());
    print_where(run.out);
  });
}

}  // namespace glissade::cli
