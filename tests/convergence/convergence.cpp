// SPDX-License-Identifier: GPL-3.0-or-later
// The convergence of the scheme of Rodriguez-Nikl et al. (2019): a table and a figure. See
// README.md in this folder.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <exception>
#include <functional>
#include <future>
#include <iostream>

#include "glissade/core/file.hpp"
#include "glissade/io/suite_file.hpp"
#include "report.hpp"

namespace {

using namespace glissade;
using namespace glissade::convergence;

const std::filesystem::path source = GLISSADE_SOURCE_DIR;

/// Whether there are any: in $GLISSADE_RECORDS, else in ../shared/records.
bool find_recorded_motions() {
  if (std::getenv("GLISSADE_RECORDS") != nullptr) return true;
  const std::filesystem::path folder = source / "../shared/records";
  return std::filesystem::is_directory(folder) &&
         ::setenv("GLISSADE_RECORDS", folder.c_str(), 1) == 0;
}

Group run_suite(const std::string& name, const std::string& kind, std::size_t most_records) {
  const Suite suite = load_suite(source / "suites" / (name + ".toml"));
  Group group{name, "", {}};
  const std::size_t records = std::min(most_records, suite.motions.size());
  std::vector<std::future<std::vector<Case>>> runs;
  for (std::size_t i = 0; i < records; ++i)
    runs.push_back(std::async(std::launch::async, run_cases, std::cref(suite.motions[i]),
                              std::span<const int>(paper_substeps)));
  for (auto& run : runs) std::ranges::move(run.get(), std::back_inserter(group.cases));
  group.motions = fmt::format("{} {} motions", records, kind);
  return group;
}

/// The first record alone: what the verification manual computes again.
Group first_record(const Group& group) {
  const std::string& id = group.cases.front().record;
  Group first{id, id, {}};
  std::ranges::copy_if(group.cases, std::back_inserter(first.cases),
                       [&](const Case& c) { return c.record == id; });
  return first;
}

}  // namespace

int main(int argc, char** argv) try {
  std::filesystem::path out;
  std::size_t records = 22;
  bool built_in_only = false;
  CLI::App program{
      "Convergence of the published sliding scheme over its substeps: table and figure"};
  program.add_option("--out", out, "folder for CSV and SVG; files there are replaced")->required();
  program.add_option("--records", records, "number of records of each suite [22, all]")
      ->check(CLI::Range(1, 22));
  program.add_flag("--built-in", built_in_only, "no recorded motions");
  CLI11_PARSE(program, argc, argv);

  const Group built_in = run_suite("synthetic_far_field", "built-in", records);
  std::vector<Group> groups{first_record(built_in), built_in};
  if (!built_in_only && find_recorded_motions())
    groups.push_back(run_suite("fema_p695_far_field", "recorded", records));
  std::filesystem::create_directories(out);
  write_text_file(out / "first_paper_convergence.csv", table_csv(groups));
  draw(std::span(groups).subspan(1), out / "first_paper_convergence.svg");
  return 0;
} catch (const std::exception& error) {
  std::cerr << "convergence: " << error.what() << '\n';
  return 2;
}
