// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>

#include "commands.hpp"
#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "glissade/io/study_file.hpp"
#include "glissade/report/summary.hpp"
#include "glissade/report/tables.hpp"
#include "glissade/report/write_report.hpp"
#include "glissade/study/run/reduce.hpp"
#include "run/run_record.hpp"
#include "shared/output_rule.hpp"
#include "shared/put.hpp"

namespace glissade::cli {
namespace {

namespace fs = std::filesystem;

struct ReportOptions {
  std::string results, study, out;
  bool overwrite = false;

  fs::path folder() const {
    const fs::path folder = out.empty() ? fs::path(results).parent_path() : fs::path(out);
    return folder.empty() ? fs::path(".") : folder;
  }
};

/// The report; its summary. What is there goes once the results are read and analysed.
std::string report_again(const ReportOptions& o) {
  const fs::path file(o.results), out = o.folder();
  Results results = o.study.empty() ? read_results(file) : read_histories(file);
  std::vector<Skip> skips = skips_in(file.parent_path() / "run.json");
  if (!o.study.empty()) {
    const StudyConfig study = read_study_again(o.study, results);
    skips = skipped_again(study, skips);
    analyse_again(study, results);
  }
  const auto taken = take_folder(out);
  if (!o.study.empty()) write_results(out / "results.h5", results, data_tables(results));
  write_report(results, out, skips);
  const fs::path run_json = out / "run.json";
  if (state_in(run_json) == RunState::unreported && plan_hash_in(run_json) == results.plan_hash &&
      fs::equivalent(file, out / "results.h5")) {
    put_reported(run_json);
    taken->remove_journals();
  }
  taken->give_back();
  return summary_text(results, skips);
}

void check_folder(const ReportOptions& o) {
  if (o.study.empty()) return check_report_folder(o.folder(), o.overwrite);
  if (o.out.empty())
    throw InputError({"--study", "makes results of their own, which need a folder of their own",
                      "give --out", ""});
  check_output_folder(o.folder(), o.overwrite);
}

}  // namespace

void add_report(CLI::App& program) {
  auto o = std::make_shared<ReportOptions>();
  CLI::App* command = program.add_subcommand(
      "report", "Make tables, figures and report.html again from a results file");
  command->add_option("results", o->results, "results.h5 of a run")->required();
  command->add_option("--study", o->study,
                      "the study of these results with other analyses, which are made of the "
                      "histories that were run; needs --out");
  command->add_option("--out", o->out, "folder for the report [the results file's own]");
  add_overwrite(*command, o->overwrite);
  command->callback([o] {
    check_folder(*o);
    put("{}\nReport   {}\n", report_again(*o), (o->folder() / "report.html").string());
  });
}

}  // namespace glissade::cli
