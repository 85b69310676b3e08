// SPDX-License-Identifier: GPL-3.0-or-later
// Run time against error: of the sliding schemes on one axis and on two, and of a whole fragility.
// See README.md in this folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <fstream>
#include <iostream>

#include "figures.hpp"
#include "glissade/core/file.hpp"
#include "max_pass.hpp"
#include "mpi/timed_run.hpp"
#include "tables.hpp"
#include "two_axes_precision.hpp"

namespace {

using namespace glissade;
using namespace glissade::bench;

const std::filesystem::path source = GLISSADE_SOURCE_DIR;

/// What an exact scheme may be off by before the program fails: rounding; on an oscillator, the
/// interpolation between samples.
double tolerance(const SchemeResult& scheme) {
  return scheme.problem == Problem::oscillator ? 1e-6 : 1e-10;
}

/// "L1 32K, L2 1024K, L3 32768K" of the first core, as Linux states them.
std::string caches_text() {
  std::string text;
  for (int i = 0; i < 8; ++i) {
    const std::filesystem::path cache =
        fmt::format("/sys/devices/system/cpu/cpu0/cache/index{}", i);
    std::string type, level, size;
    std::ifstream(cache / "type") >> type;
    std::ifstream(cache / "level") >> level;
    std::ifstream(cache / "size") >> size;
    if (!size.empty() && type != "Instruction")
      text += fmt::format("{}L{} {}", text.empty() ? "" : ", ", level, size);
  }
  return text.empty() ? "not stated" : text;
}

struct Options {
  std::filesystem::path out;
  bool quick = false;
  std::string only;
  std::size_t scenes = 500;
  FragilityErrorOptions fragility;
};

bool has_column(const Table& table, const std::string& stem) {
  return std::ranges::find(table.columns, stem, &Column::stem) != table.columns.end();
}

/// Prints and writes a table; false where a number is missing.
bool show(const Table& table, const std::filesystem::path& out) {
  write_text_file(out / (table.name + ".csv"), to_csv(table));
  std::cout << to_text(has_column(table, "worst_scene") ? table.without("worst_scene") : table)
            << '\n';
  if (!is_complete(table))
    std::cerr << "bench: a number is missing in " << table.name.text() << '\n';
  return is_complete(table);
}

test::StandardScenes scenes(const Options& options) {
  return options.quick ? test::built_in_scenes(source / "suites", 2)
                       : test::standard_scenes(source / "suites", source / "../shared/records");
}

bool bench_schemes(const Options& options) {
  const test::StandardScenes all = scenes(options);
  std::cout << fmt::format("{} scenes on {}\n", all.scenes.size(), all.motions);
  const std::size_t stride = test::thinning(all.scenes.size(), options.scenes);
  const WorkPrecision measured = work_precision(all, stride, options.quick);
  std::cout << fmt::format("{} compared: {} lift off and {} slip less than 1 mm\n\n",
                           measured.compared, measured.uplift, measured.still);
  bool good = show(scheme_table(measured), options.out);
  good &= show(group_table(measured), options.out);
  good &= show(ratio_table(measured), options.out);
  good &= measured.agreements.empty() || show(agreement_table(measured), options.out);
  good &= show(roof_table(roof_times()), options.out);
  draw_schemes(measured, options.out / "schemes.svg");
  for (const SchemeResult& scheme : measured.schemes) {
    if (!scheme.exact || scheme.largest_error <= tolerance(scheme)) continue;
    std::cerr << fmt::format("bench: {} is off by {}: {}\n", scheme.family, scheme.largest_error,
                             scheme.worst_scene);
    good = false;
  }
  for (const Agreement& a : measured.agreements) {
    if (a.largest_difference <= 1e-10) continue;
    std::cerr << fmt::format("bench: {} are {} apart: {}\n", a.schemes, a.largest_difference,
                             a.worst_scene);
    good = false;
  }
  return good;
}

/// Prints, writes and draws a table of schemes over one set of histories.
bool show_trial(const std::string& name, const std::string& title,
                const std::vector<SchemeResult>& results, const char* figure_title,
                const std::filesystem::path& out) {
  draw_trial(results, figure_title, out / (name + ".svg"));
  return show(trial_table(name, title, results), out);
}

bool bench_two_axes(const Options& options) {
  const test::StandardScenes all = scenes(options);
  return show_trial(
      "two_axes",
      "Two axes at once: time of a history of 8,000 samples against its error, on " + all.motions,
      two_axes_precision(all, options.scenes, options.quick),
      "Error in peak slip over run time: two axes", options.out);
}

bool bench_fragility(const Options& options) {
  const FragilityError measured = fragility_error(source / "suites", options.fragility);
  bool good = show(fragility_table(measured), options.out);
  // A smoke test need not reach 1 %.
  good &= show(histories_table(measured), options.out) || options.quick;
  draw_fragility(measured, options.out / "fragility.svg");
  return good;
}

/// Whole studies, as a user runs them.
bool bench_studies(const Options& options) {
  if (!test::mpirun_is_there()) throw std::runtime_error("mpirun is not there");
  Table table{"studies",
              "Seconds of whole studies by phase, the quickest of three runs",
              {text_column("study", "Study"), {"ranks", "", "Ranks", ColumnKind::count}},
              {}};
  for (const char* study : {"03_throughput", "22_full_model"}) {
    for (const int ranks : {1, 2}) {
      const test::TimedRun run =
          test::quickest_run(source / "studies" / (std::string(study) + ".toml"), ranks, 3);
      std::vector<Cell> row{study, static_cast<double>(ranks)};
      for (const auto& [phase, seconds] : run.phases) {
        if (table.rows.empty()) table.columns.push_back({phase + "_time", "s", phase + ", s"});
        row.emplace_back(seconds);
      }
      row.emplace_back(run.total_s());
      if (table.rows.empty()) table.columns.push_back({"total_time", "s", "all, s"});
      table.add(std::move(row));
    }
  }
  return show(table, options.out);
}

}  // namespace

int main(int argc, char** argv) try {
  Options options;
  CLI::App program{"Run time against error: tables and figures"};
  program.option_defaults()->always_capture_default();
  program.add_option("--out", options.out, "folder for CSV and SVG; files there are replaced")
      ->required();
  program.add_flag("--quick", options.quick,
                   "a smoke test of some seconds: few scenes and samples");
  program.add_option("--only", options.only, "one of them")
      ->check(CLI::IsMember({"schemes", "two_axes", "fragility", "studies"}));
  program.add_option("--scenes", options.scenes, "scenes on which all schemes are compared")
      ->check(CLI::PositiveNumber);
  program.add_option("--log2-samples", options.fragility.most_log2, "largest number of samples")
      ->check(CLI::Range(5, 20));
  program.add_option("--replicates", options.fragility.replicates, "of each number of samples")
      ->check(CLI::Range(2, 1000));
  program.add_option("--threads", options.fragility.threads, "fragilities side by side")
      ->check(CLI::Range(1, 64));
  CLI11_PARSE(program, argc, argv);
  if (options.quick) {
    options.scenes = 40;
    options.fragility = {.least_log2 = 4, .most_log2 = 6, .replicates = 4};
  }
  std::filesystem::create_directories(options.out);
  std::cout << "Vectors: " << max_pass_target() << "; caches: " << caches_text() << '\n';
  bool good = true;
  const auto wanted = [&](const char* part) {
    return options.only.empty() || options.only == part;
  };
  if (wanted("schemes")) good &= bench_schemes(options);
  if (wanted("two_axes")) good &= bench_two_axes(options);
  if (wanted("fragility")) good &= bench_fragility(options);
  if (wanted("studies") && !options.quick) good &= bench_studies(options);
  return good ? 0 : 1;
} catch (const std::exception& error) {
  std::cerr << "bench: " << error.what() << '\n';
  return 2;
}
