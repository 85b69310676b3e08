// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/fault_walk.hpp"

#include <cerrno>
#include <utility>

#include "cli/shaking.hpp"
#include "cli/small_study.hpp"

// Calls that fail, by command. GLISSADE_FAULTS=all: each call of each command in turn by each
// error, or so many of each function, for tests/verification/reliability.md.
namespace glissade::test {
namespace {

/// Two components of one record, and a table of two.
void write_records(const fs::path& in, const fs::path&) {
  for (const int azimuth : {0, 90})
    write_input(in / ("PLC-" + std::string(azimuth == 0 ? "000" : "090") + ".txt"),
                two_columns(shaking_g(0.1 + azimuth)));
  write_input(in / "ROOF.csv", two_columns(shaking_g(0.4)));
}

void write_pull_tests(const fs::path& in, const fs::path&) {
  write_input(in / "pulls.csv", "direction,mu\nx,0.31\nx,0.28\nx,0.33\n");
}

const std::string suite_2 = GLISSADE_SOURCE_DIR "/suites/synthetic_level2.toml";

const std::string a_site = " --edition asce7_16 --ss-g 1.5 --s1-g 0.6 --site-class C";
/// Written over where it was put in place and the folder could not be flushed to the disk.
Walked one_file(const std::string& name, const std::string& arguments, auto prepare) {
  return {name, arguments, prepare, true, arguments + " --overwrite", true};
}

/// Every command that writes: a new one joins by a line.
const std::vector<Walked> commands = {
    {"run", "run IN/study.toml --out OUT", with("study.toml", short_study), false,
     "run IN/study.toml --out OUT --overwrite"},
    {"resume", "run --resume OUT",
     [](const fs::path& in, const fs::path& out) {
       write_input(in / "study.toml", short_study());
       run_shell(line_of("run IN/study.toml --out OUT --walltime-s 0.01", in, out));
     }},
    {"report", "report --overwrite OUT/results.h5", finished_run(), false, "", true},
    {"new_report", "report IN/run/results.h5 --out OUT",
     [of = finished_run()](const fs::path& in, const fs::path&) { of(in, in / "run"); }, false,
     "report IN/run/results.h5 --out OUT --overwrite"},
    {"clearance", "clearance --resume OUT", finished_calculation(moved_project)},
    {"sites", "clearance --resume OUT", finished_calculation(two_roofs)},
    {"product", "clearance --resume OUT", finished_calculation(small_product)},
    {"friction", "friction IN/pulls.csv --out OUT", write_pull_tests, true,
     "friction IN/pulls.csv --out OUT --overwrite"},
    one_file("import", "suite import IN --directions-from-names --out OUT/suite.toml",
             write_records),
    one_file("select",
             "suite select " + suite_2 + a_site + " --count 3 --max-scale 50 --out OUT/suite.toml",
             nullptr),
    one_file("spectra", "suite spectra " + suite_2 + " --out OUT/spectra.csv", nullptr),
    one_file("init", "init OUT/study.toml --suite " + suite_2 + " --mu 0.5 --mu-std 0.04", nullptr),
    one_file(
        "init_project",
        "init OUT/project.toml --kind project --suite " + suite_2 + " --pull-tests IN/pulls.csv",
        write_pull_tests),
    one_file("slide",
             "slide IN/PLC-000.txt --mu 0.3 --slope-deg 1 --json --history OUT/history.csv",
             write_records)};

INSTANTIATE_TEST_SUITE_P(, FaultWalk, testing::ValuesIn(commands),
                         [](const auto& of) { return of.param.name; });

TEST_P(FaultWalk, is_whole_or_reports_it_where_any_call_fails) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::map<std::string, long> calls = count(GLISSADE_INJECT);
  std::size_t sample = GetParam().name.size();  // without a number every fourth function
  for (const Function& function : system_functions)
    if (calls.contains(function.name) && (wanted_calls() > 0 || ++sample % 4 == 0))
      walk(function.name, function.errors, calls.at(function.name), GLISSADE_INJECT);
}
TEST_P(FaultWalk, is_whole_or_reports_it_where_memory_ends_at_any_allocation) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::string program = "LD_PRELOAD=" GLISSADE_MEMORY_FAULTS_LIBRARY;
  walk("malloc", {ENOMEM}, count(program).at("malloc"), program);
}

/// Commands and what they read, below IN: a new one joins by a line.
const std::vector<Walked> readers = {
    one_file("import", "suite import IN --directions-from-names --out OUT/suite.toml",
             write_records),
    {"show", "suite show IN", write_records, true},
    one_file("init", "init OUT/study.toml --suite IN/suite.toml --mu 0.5 --mu-std 0.04",
             [](const fs::path& in, const fs::path&) {
               write_input(in / "suite.toml", read_file(suite_2));
             }),
    {"check", "check IN/study.toml", with("study.toml", short_study), true}};

class FaultyInput : public FaultWalk {};
INSTANTIATE_TEST_SUITE_P(, FaultyInput, testing::ValuesIn(readers),
                         [](const auto& of) { return of.param.name; });

// Not that it is not there, or a file of another kind: each call of each function.
TEST_P(FaultyInput, is_reported_where_the_system_does_not_read_it) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::string program = "FAULT_IN=" + in_quotes(in_) + " " GLISSADE_INJECT;
  const std::map<std::string, long> calls = count(program);
  for (const Function& function : system_functions)
    for (const char* reads : {"open", "read", "list", "stat", "readlink"})
      if (function.name == std::string(reads) && calls.contains(reads))
        for (long at = 1; at <= calls.at(reads); ++at)
          fail(reads, program, function.errors[at % function.errors.size()], true, at);
}

class FailedLookUp : public FaultWalk {};
INSTANTIATE_TEST_SUITE_P(, FailedLookUp,
                         testing::Values(Walked{"run", "run --resume OUT", finished_run()},
                                         Walked{"clearance", "clearance --resume OUT",
                                                finished_calculation(moved_project)}),
                         [](const auto& of) { return of.param.name; });

// calculation_folder.cpp took a study as absent and removed run.json, so that nothing went on.
TEST_P(FailedLookUp, does_not_count_as_an_absent_file) {
  ASSERT_NO_FATAL_FAILURE(begin());
  for (const auto& [name, error] : {std::pair{"/report.html", EACCES},
                                    {"/journal", EIO},
                                    {"/demand", EIO},
                                    {"/report_files.txt", EACCES}}) {
    const std::string in = "FAULT_IN=" + in_quotes(out_.string() + name) + " ";
    fail("stat", in + GLISSADE_INJECT, error, false, 1);
  }
  EXPECT_GT(tallies_["stat"].reported, 1);
}

class LostWrites : public FaultWalk {};
INSTANTIATE_TEST_SUITE_P(, LostWrites, testing::Values(commands.front()),
                         [](const auto& of) { return of.param.name; });

TEST_P(LostWrites, are_found_out_where_the_disk_reports_none) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const long calls = count(GLISSADE_INJECT).at("pwrite"),
             step = std::max(1L, calls / (wanted_calls() > 0 ? wanted_calls() : 4));
  tallies_["pwrite"].calls = calls;
  for (long at = step; at <= calls; at += step) fail("pwrite", GLISSADE_INJECT, 0, true, at);
  fail("pwrite", GLISSADE_INJECT, 0, true, calls);  // the checksum
  EXPECT_GT(tallies_["pwrite"].reported, 0);
}

/// Two million histories at rest, which are in pages of a file.
std::string study_of_pages() {
  std::string levels = "levels = [0.01";
  for (int i = 2; i <= 80; ++i) levels += ", " + std::to_string(0.01 * i);
  std::string study = replaced(short_study(), "levels = [0.5, 1.0, 2.0", levels);
  study = replaced(study, "mean = 0.3", "mean = 1.9");
  study = replaced(study, "\"sampled\", \"design\"", "\"sampled\"");
  return replaced(study, "samples = 2", "samples = 4096");
}

class PagesOfARun : public FaultWalk {};
INSTANTIATE_TEST_SUITE_P(, PagesOfARun,
                         testing::Values(Walked{"run", "run IN/study.toml --out OUT",
                                                with("study.toml", study_of_pages)}),
                         [](const auto& of) { return of.param.name; });

TEST_P(PagesOfARun, that_are_refused_are_reported) {
  ASSERT_NO_FATAL_FAILURE(begin());
  const std::string program = "FAULT_IN=out/# " GLISSADE_INJECT;  // the file has no name
  const std::map<std::string, long> calls = count(program);
  for (const auto& [function, error] : {std::pair{"fallocate", ENOSPC}, {"mmap", ENOMEM}})
    fail(function, program, error, true, calls.at(function));
}

}  // namespace
}  // namespace glissade::test
