// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "commands.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/write_report.hpp"
#include "output_rule.hpp"
#include "run/run_record.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

/// The report; its summary. An earlier one goes once the results are read.
std::string report_again(const fs::path& file, const fs::path& out) {
  const Results results = read_results(file);
  const std::vector<Skip> skips = skips_in(file.parent_path() / "run.json");
  remove_report(out);
  write_report(results, out, skips);
  return summary_text(results, skips);
}

}  // namespace

void add_report(CLI::App& program) {
  struct ReportOptions {
    std::string results, out;
    bool overwrite = false;
  };
  auto o = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand(
      "report", "Make tables, figures and report.html again from a results file");
  command->add_option("results", o->results, "results.h5 of a run")->required();
  command->add_option("--out", o->out, "folder for the report [the results file's own]");
  add_overwrite(*command, o->overwrite);
  command->callback([o] {
    const fs::path file(o->results);
    const fs::path folder = o->out.empty() ? file.parent_path() : fs::path(o->out);
    const fs::path out = folder.empty() ? fs::path(".") : folder;
    check_report_folder(out, o->overwrite);
    fmt::print("{}\nReport   {}\n", report_again(file, out), (out / "report.html").string());
  });
}

}  // namespace glissade::cli
