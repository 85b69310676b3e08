// SPDX-License-Identifier: GPL-3.0-or-later
// How well studies use many ranks: the scheduler simulated with measured costs, beside real runs.
// See README.md in this folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <exception>
#include <iostream>

#include "glissade/core/file.hpp"
#include "glissade/report/figure.hpp"
#include "glissade/report/table.hpp"
#include "mpi/timed_run.hpp"
#include "study_costs.hpp"

namespace glissade::test {
namespace {

// A cluster's network: 2 us one way, a remote atomic in 0.2 us, 5 GB/s; and TCP, whose requests
// rank 0 itself answers.
constexpr Network fabric{2e-6, 0.2e-6, true, 5e9};
constexpr Network tcp{30e-6, 2e-6, false, 1e9};

void show(const Table& table, const std::filesystem::path& out) {
  write_text_file(out / (table.name + ".csv"), to_csv(table));
  std::cout << to_text(table) << '\n';
}

Table cost_table() {
  return {"costs",
          "What the studies cost, seconds of one core",
          {text_column("study", "Study"),
           {"histories", "", "Histories", ColumnKind::count},
           {"units", "", "Units", ColumnKind::count},
           {"shared_time", "s", "Shared by the ranks, s"},
           {"longest_time", "s", "longest part, s"},
           text_column("longest", "its record"),
           {"machine_time", "s", "Shared on rank 0's machine, s"},
           {"analyses_time", "s", "of these the analyses, s"},
           {"results_time", "s", "results.h5, s"},
           {"root_time", "s", "On rank 0 alone, s"},
           {"plan_time", "s", "of these the plan, s"},
           {"report_time", "s", "the report, s"},
           {"result_size", "byte", "Results, byte a history"}},
          {}};
}

void add_costs(const StudyCosts& c, Table& table) {
  double plan_parts_s = 0.0;
  for (const double s : c.plan_parts_s) plan_parts_s += s;
  table.add({c.name, c.histories, static_cast<double>(c.work_s.size() - c.motion_parts),
             c.histories_s() + plan_parts_s, std::ranges::max(c.work_s), c.longest,
             c.motions_s + c.analyses_s + c.results_s, c.analyses_s, c.results_s,
             c.plan_s + c.assembly_s + c.report_s, c.plan_s, c.report_s,
             c.result_bytes / c.histories});
}

Table check_table() {
  return {"check",
          "Simulated and real runs on this machine",
          {text_column("study", "Study"),
           {"ranks", "", "Ranks", ColumnKind::count},
           {"simulated_histories_time", "s", "Histories, s: simulated"},
           {"histories_time", "s", "real"},
           {"simulated_total_time", "s", "All, s: simulated"},
           {"total_time", "s", "real"},
           {"simulated_efficiency", "", "Efficiency: simulated", ColumnKind::share},
           {"efficiency", "", "real", ColumnKind::share}},
          {}};
}

/// @param cores of this machine; more ranks share them
void check(const std::filesystem::path& study, const StudyCosts& costs, int cores, int tries,
           Table& table) {
  const TimedRun one = quickest_run(study, 1, tries);
  const PredictedRun simulated_one = predict(costs, 1, cores, {});
  for (const int ranks : {1, 2, 4, 8}) {
    const TimedRun real = ranks == 1 ? one : quickest_run(study, ranks, tries);
    const PredictedRun simulated = predict(costs, ranks, cores, {});
    const double used = std::min(ranks, cores);
    table.add({costs.name, static_cast<double>(ranks), simulated.histories_s, real.of("histories"),
               simulated.total_s, real.total_s(),
               simulated_one.total_s / (used * simulated.total_s),
               one.total_s() / (used * real.total_s())});
  }
}

constexpr int least_log2 = 0, first_shown_log2 = 6, most_log2 = 14;

/// Efficiency over the ranks, of one way of growing.
struct Scaling {
  std::string name, label;
  std::vector<double> efficiency;  ///< by log2 of the ranks, from 0 on
  std::vector<PredictedRun> runs;  ///< likewise
};

std::vector<Scaling> scalings(const StudyCosts& costs) {
  std::vector<Scaling> all{{"strong", "samples of the study", {}, {}},
                           {"strong_1000", "1,000 × the samples", {}, {}},
                           {"weak", "samples × ranks", {}, {}},
                           {"tcp", "1,000 × the samples, TCP", {}, {}},
                           {"tcp_when_free", "same, not fetched ahead", {}, {}}};
  const StudyCosts large = grown(costs, 1000.0);
  for (int log2 = least_log2; log2 <= most_log2; ++log2) {
    const int ranks = 1 << log2;
    const auto add = [&](Scaling& scaling, const StudyCosts& size, const Network& network,
                         Fetch fetch = Fetch::ahead) {
      scaling.efficiency.push_back(efficiency(size, ranks, network, fetch));
      scaling.runs.push_back(predict(size, ranks, ranks, network, fetch));
    };
    add(all[0], costs, fabric);
    add(all[1], large, fabric);
    add(all[2], grown(costs, ranks), fabric);
    add(all[3], large, tcp);
    add(all[4], large, tcp, Fetch::when_free);
  }
  return all;
}

Table scaling_table() {
  Table table{"scaling",
              "Simulated efficiency on a cluster, every rank on a core of its own",
              {text_column("study", "Study"), text_column("scaling", "Size of the study")},
              {}};
  for (int log2 = first_shown_log2; log2 <= most_log2; log2 += 2) {
    table.columns.push_back(
        {fmt::format("ranks_{}", 1 << log2), "", fmt::format("{}", 1 << log2), ColumnKind::share});
  }
  return table;
}

void add_scaling(const StudyCosts& costs, const Scaling& scaling, Table& table) {
  std::vector<Cell> row{costs.name, scaling.label};
  for (int log2 = first_shown_log2; log2 <= most_log2; log2 += 2)
    row.emplace_back(scaling.efficiency[static_cast<std::size_t>(log2)]);
  table.add(std::move(row));
}

Table loss_table() {
  return {"losses",
          "Where the simulated efficiency falls below 80 %",
          {text_column("study", "Study"),
           text_column("scaling", "Size of the study"),
           {"ranks", "", "Ranks", ColumnKind::count},
           {"efficiency", "", "Efficiency", ColumnKind::share},
           {"total_time", "s", "All, s"},
           text_column("largest_loss", "Largest loss"),
           {"loss_time", "s", "its time beyond an equal share, s"}},
          {}};
}

void add_loss(const StudyCosts& costs, const Scaling& scaling, Table& table) {
  const auto below = std::ranges::find_if(scaling.efficiency, [](double e) { return e < 0.8; });
  if (below == scaling.efficiency.end()) return;
  const auto log2 = below - scaling.efficiency.begin();
  const int ranks = 1 << log2;
  const PredictedRun& run = scaling.runs[static_cast<std::size_t>(log2)];
  const PredictedPhase loss = largest_loss(run, ranks);
  table.add({costs.name, scaling.label, static_cast<double>(ranks), *below, run.total_s, loss.name,
             loss.s - loss.one_core_s / ranks});
}

Panel panel(const StudyCosts& costs, const std::vector<Scaling>& all) {
  Panel panel;
  panel.title = costs.name;
  panel.x = {"Ranks", 0.0, static_cast<double>(most_log2), {}};
  for (int log2 = 0; log2 <= most_log2; log2 += 3)
    panel.x.ticks.push_back({static_cast<double>(log2), fmt::format("{}", 1 << log2)});
  panel.y = {"Efficiency (%)", 0.0, 105.0, {}};
  for (std::size_t i = 0; i < all.size(); ++i) {
    DataSeries series;
    series.kind = DataSeries::Kind::line_and_points;
    series.look = distinct_look(i);
    series.name = all[i].name;
    series.label = all[i].label;
    for (std::size_t log2 = 0; log2 < all[i].efficiency.size(); ++log2) {
      series.x.push_back(static_cast<double>(log2));
      series.y.push_back(100.0 * all[i].efficiency[log2]);
    }
    panel.series.push_back(std::move(series));
  }
  panel.rules.push_back({Rule::Kind::horizontal, 80.0, look(Role::reference), "80 %"});
  return panel;
}

}  // namespace
}  // namespace glissade::test

int main(int argc, char** argv) try {
  using namespace glissade;
  using namespace glissade::test;
  std::filesystem::path out;
  std::vector<std::filesystem::path> studies;
  int cores = 2, tries = 1;
  CLI::App program{"Efficiency of studies on many ranks: simulated, and real on this machine"};
  program.option_defaults()->always_capture_default();
  program.add_option("--out", out, "folder for CSV and SVG; files there are replaced")->required();
  program.add_option("studies", studies, "study files")->required();
  program.add_option("--cores", cores, "of this machine")->check(CLI::PositiveNumber);
  program.add_option("--tries", tries, "real runs, of which the quickest counts; 0: none")
      ->check(CLI::NonNegativeNumber);
  CLI11_PARSE(program, argc, argv);
  std::filesystem::create_directories(out);

  Table costs_of_all = cost_table(), checks = check_table(), scaling = scaling_table(),
        losses = loss_table();
  Figure figure{.name = "scaling",
                .title = "Efficiency over the number of ranks, simulated with measured costs",
                .below = "one core's time over the time of all ranks",
                .caption = ""};
  for (const std::filesystem::path& study : studies) {
    const ScratchFolder scratch;
    std::filesystem::create_directories(scratch.path(""));
    const StudyCosts costs = measure_study(study, scratch.path(""));
    add_costs(costs, costs_of_all);
    if (tries > 0 && mpirun_is_there()) check(study, costs, cores, tries, checks);
    const std::vector<Scaling> all = scalings(costs);
    for (const Scaling& one : all) {
      add_scaling(costs, one, scaling);
      add_loss(costs, one, losses);
    }
    figure.panels.push_back(panel(costs, all));
  }
  show(costs_of_all, out);
  if (!checks.rows.empty()) show(checks, out);
  show(scaling, out);
  show(losses, out);
  render_figure(figure, out);
  return 0;
} catch (const std::exception& error) {
  std::cerr << "scaling: " << error.what() << '\n';
  return 2;
}
