// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "commands.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/write_report.hpp"
#include "run_record.hpp"

namespace glissade::cli {

void add_report(CLI::App& program) {
  struct ReportOptions {
    std::string results, out;
  };
  auto o = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand(
      "report", "Make tables, figures and report.html again from a results file");
  command->add_option("results", o->results, "results.h5 of a run")->required();
  command->add_option("--out", o->out, "folder for the report [the results file's own]");
  command->callback([o] {
    const Results results = read_results(o->results);
    const std::filesystem::path file(o->results);
    const std::filesystem::path out =
        o->out.empty() ? file.parent_path() : std::filesystem::path(o->out);
    const std::vector<Skip> skips = skips_in(file.parent_path() / "run.json");
    write_report(results, out.empty() ? "." : out, skips);
    fmt::print("{}\nReport   {}\n", summary_text(results, skips), (out / "report.html").string());
  });
}

}  // namespace glissade::cli
