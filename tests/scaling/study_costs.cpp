// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_costs.hpp"

#include <tbb/task_arena.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <numeric>
#include <utility>

#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/report/write_report.hpp"
#include "glissade/study/run/exchange.hpp"
#include "glissade/study/run/history_assembly.hpp"
#include "glissade/study/run/motion_parts.hpp"
#include "glissade/study/run/reduce.hpp"

namespace glissade::test {
namespace {

double core_s() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <class Work>
double core_seconds_of(Work work) {
  const double begin = core_s();
  work();
  return core_s() - begin;
}

double sum(const std::vector<double>& x) { return std::accumulate(x.begin(), x.end(), 0.0); }

/// On the thread that calls.
StudyCosts measure_here(const std::filesystem::path& study, const std::filesystem::path& scratch) {
  StudyCosts costs;
  const StudyConfig config = read_study(study);
  std::vector<Suite> suites;
  costs.motions_s = core_seconds_of([&] {
    for (const auto& file : config.suite_files) suites.push_back(load_suite(file));
  });
  for (const Suite& suite : suites) costs.motions += static_cast<double>(suite.motions.size());
  costs.motion_bytes = static_cast<double>(sizeof(double) * pack(suites).samples_mps2.size());
  Plan plan;
  costs.plan_s = core_seconds_of([&] {
    plan = begin_plan(config, std::move(suites));
    std::vector<std::vector<double>> spectra_g(spectra_to_scale(plan));
    for (std::size_t i = 0; i < spectra_g.size(); ++i)
      costs.plan_parts_s.push_back(
          core_seconds_of([&] { spectra_g[i] = spectrum_to_scale(plan, i); }));
    scale_plan(plan, std::move(spectra_g));
    finish_plan(plan);
  });
  costs.plan_s -= sum(costs.plan_parts_s);
  costs.name = study.stem().string();
  costs.histories = static_cast<double>(plan.histories());
  costs.units_wanted = units_wanted(plan.kernel.kernel);

  std::vector<std::vector<double>> parts;
  costs.motion_parts = motion_part_count(plan);
  double longest_s = 0.0;
  const auto note_longest = [&](const std::string& what) {
    if (costs.work_s.back() <= longest_s) return;
    longest_s = costs.work_s.back();
    costs.longest = what;
  };
  for (std::size_t i = 0; i < costs.motion_parts; ++i) {
    costs.work_s.push_back(core_seconds_of([&] { parts.push_back(motion_part(plan, i)); }));
    note_longest("spectra");
  }
  RoofStore roofs(plan, Skipping::all);
  HistoryAssembly histories(plan);
  for (const std::size_t number : longest_first(plan, 0)) {
    UnitResult unit;
    costs.work_s.push_back(core_seconds_of([&] { unit = execute(plan, number, roofs); }));
    note_longest(plan.motion(plan.units[number].record).id);
    costs.result_bytes += static_cast<double>(pack(unit).size());
    costs.assembly_s += core_seconds_of([&] { histories.add(unit); });
  }
  Results results;
  costs.analyses_s = core_seconds_of([&] { results = reduce(plan, histories.take(plan), parts); });
  costs.pieces = static_cast<double>(plan.cases.combinations() * config.intensity.levels.size());
  costs.results_s = core_seconds_of([&] { write_results(scratch / "results.h5", results); });
  const auto begin = std::chrono::steady_clock::now();
  write_report(results, scratch, {});
  costs.report_s = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return costs;
}

}  // namespace

double StudyCosts::histories_s() const { return sum(work_s); }

StudyCosts measure_study(const std::filesystem::path& study, const std::filesystem::path& scratch) {
  StudyCosts costs;
  tbb::task_arena(1).execute([&] { costs = measure_here(study, scratch); });
  return costs;
}

StudyCosts grown(const StudyCosts& costs, double factor) {
  // As cut_units() in study/plan: so many units, of 1 ms to 0.5 s.
  const double units = static_cast<double>(costs.work_s.size() - costs.motion_parts);
  const double units_s =
      std::accumulate(costs.work_s.begin() + static_cast<std::ptrdiff_t>(costs.motion_parts),
                      costs.work_s.end(), 0.0);
  const double unit_s = std::clamp(units_s * factor / costs.units_wanted, 1e-3, 0.5);
  const double longer = std::max(1.0, unit_s / (units_s / units));
  StudyCosts more = costs;
  more.histories *= factor;
  more.plan_s *= factor;
  more.assembly_s *= factor;
  more.analyses_s *= factor;
  more.results_s *= factor;
  more.result_bytes *= factor;
  more.work_s.resize(costs.motion_parts);
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round(units * factor / longer)));
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t like = i % (costs.work_s.size() - costs.motion_parts);
    more.work_s.push_back(longer * costs.work_s[costs.motion_parts + like]);
  }
  return more;
}

void PredictedRun::add(PredictedPhase phase) {
  total_s += phase.s;
  phases.push_back(std::move(phase));
}

PredictedRun predict(const StudyCosts& costs, int ranks, int cores, const Network& network,
                     Fetch fetch) {
  constexpr double chunk_bytes = 262144.0;  // of results.h5
  const double slowdown = std::max(1.0, static_cast<double>(ranks) / cores);
  const double on_one_machine = std::min({ranks, cores, 64});
  const double others = ranks - 1, rounds = std::ceil(std::log2(ranks));
  const auto shared_s = [&](double s, double pieces) {
    return s / std::clamp(pieces, 1.0, on_one_machine);
  };
  PredictedRun run;
  run.add({"motions", shared_s(costs.motions_s, costs.motions), costs.motions_s});
  run.add({"motions sent", rounds * costs.motion_bytes / network.bytes_per_s, 0.0});
  run.add({"spectra of the motions",
           makespan_s(costs.plan_parts_s, ranks, network, fetch, slowdown),
           sum(costs.plan_parts_s)});
  run.add({"plan", costs.plan_s, costs.plan_s});
  run.add({"histories", makespan_s(costs.work_s, ranks, network, fetch, slowdown),
           costs.histories_s()});
  run.add(
      {"histories sent",
       costs.result_bytes * others / ranks / network.bytes_per_s + others * 2.0 * network.latency_s,
       0.0});
  run.add({"histories into their table", costs.assembly_s, costs.assembly_s});
  for (std::size_t i = run.phases.size() - 3; i < run.phases.size(); ++i)
    run.histories_s += run.phases[i].s;
  run.add({"analyses", shared_s(costs.analyses_s, costs.pieces), costs.analyses_s});
  run.add(
      {"results.h5", shared_s(costs.results_s, costs.result_bytes / chunk_bytes), costs.results_s});
  run.add({"report", costs.report_s, costs.report_s});
  return run;
}

PredictedPhase largest_loss(const PredictedRun& run, int ranks) {
  return std::ranges::max(run.phases, {}, [&](const PredictedPhase& phase) {
    return phase.s - phase.one_core_s / ranks;
  });
}

double efficiency(const StudyCosts& costs, int ranks, const Network& network, Fetch fetch) {
  return predict(costs, 1, 1, network, fetch).total_s /
         (ranks * predict(costs, ranks, ranks, network, fetch).total_s);
}

}  // namespace glissade::test
