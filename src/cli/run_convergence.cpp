// SPDX-License-Identifier: GPL-3.0-or-later
#include "run_convergence.hpp"

#include <fmt/format.h>

#include <chrono>

#include "glissade/core/file.hpp"
#include "glissade/io/convergence_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/convergence_report.hpp"
#include "glissade/study/convergence_error.hpp"
#include "output_folder.hpp"
#include "progress.hpp"
#include "run_folder.hpp"
#include "run_record.hpp"

namespace glissade::cli {
namespace {

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

std::vector<ConvergenceUnit> execute_all(const ConvergencePlan& plan, const Communicator& world) {
  const std::size_t records = plan.suite.motions.size();
  Progress progress(records, plan.histories());
  std::vector<ConvergenceUnit> mine;
  self_schedule(world, records, [&](std::uint64_t record) {
    mine.push_back(execute(plan, record, seconds_now));
    if (world.is_root()) progress.update(record);
  });
  std::vector<ConvergenceUnit> all;
  for (const std::vector<char>& part : world.gather(pack(mine))) {
    for (ConvergenceUnit& unit : unpack_convergence_units(part)) all.push_back(std::move(unit));
  }
  if (world.is_root()) progress.finish();
  return all;
}

}  // namespace

void run_convergence(const ConvergenceRun& run, const Communicator& world) {
  PhaseClock clock;
  Suite suite;
  on_root(world, [&] {
    const ConvergenceConfig config = read_convergence_study(run.study);
    if (!run.dry_run) check_output_folder(run.out);
    suite = load_suite(config.suite_file);
  });
  share(suite, world);
  clock.end_phase("motions");
  ConvergencePlan plan;
  on_root(world, [&] {
    plan = make_plan(read_convergence_study(run.study), suite);
    if (!run.dry_run) {
      take_results_folder(run.out, static_cast<double>(plan.histories()) * sizeof(double),
                          started_json(plan.config.name, plan.hash));
    }
  });
  if (!world.is_root()) plan = make_plan(read_convergence_study(run.study), suite);
  check_same_plan(plan.hash, world);
  clock.end_phase("plan");
  if (run.dry_run) {
    if (world.is_root()) fmt::print("{}", to_string(plan));
    return;
  }

  const std::vector<ConvergenceUnit> units = execute_all(plan, world);
  clock.end_phase("histories");
  on_root(world, [&] {
    const ConvergenceResults results = reduce(plan, units);
    const ConvergenceTimes times = time_summary(units, plan.config.substeps.size());
    write_or_leave_folder(run.out, [&] { write_convergence(run.out / "results.h5", results); });
    clock.end_phase("results file");
    write_beside_results(run.out, [&] { write_convergence_report(results, times, run.out); });
    clock.end_phase("report");
    write_beside_results(run.out, [&] {
      write_text_file(run.out / "run.json", run_json(results, times, clock, world.size()));
    });
    fmt::print("{}\n", convergence_summary(results, times));
    print_seconds(clock, world.size());
    print_where(run.out);
  });
}

}  // namespace glissade::cli
