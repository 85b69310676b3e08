// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <sys/stat.h>

#include "cli/child.hpp"
#include "cli/small_study.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

TEST(Usage, help_names_every_command_and_succeeds) {
  const Finished child = run_program({"--help"});
  EXPECT_EQ(child.status, 0);
  EXPECT_EQ(child.err, "");
  EXPECT_THAT(child.out, states("run", "slide", "fit", "friction", "suite", "building", "standards",
                                "report"));
}

TEST(Usage, version_is_one_line) {
  EXPECT_THAT(run_program({"--version"}).out,
              testing::MatchesRegex("glissade [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST(Usage, a_working_directory_that_is_gone_is_named) {
  const ScratchFolder folder;
  const std::string study = folder.write("study.toml", small_study()),
                    gone = folder.path("gone").string();
  expect_refused(run_shell("mkdir '" + gone + "'; cd '" + gone + "'; rmdir '" + gone +
                           "'; \"$0\" run '" + study + "' --out out"),
                 {"the working directory", "No such file"});
}

TEST(Usage, a_misspelt_command_or_option_is_named_with_the_nearest) {
  expect_refused(run_program({"slid", "x"}), {"slid is not a command", "did you mean slide?"});
  expect_refused(run_program({"suite", "sho", "x"}),
                 {"sho is not a command", "did you mean show?"});
  expect_refused(run_program({"--hlep"}), {"--hlep is not an option", "did you mean --help?"});
  // Also where a required one is missing.
  expect_refused(run_program({"slide", "--hlep"}), {"did you mean --help?"});
  expect_refused(run_program({"run", "x", "--outt=y"}), {"did you mean --out?"});
}
TEST(Usage, every_command_has_help_which_fits_a_terminal) {
  for (const std::vector<std::string>& command : all_commands()) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    const Finished help = succeeding(arguments);
    EXPECT_THAT(help.out, states("--help"));
    for (const std::string& line : lines_of(help.out)) EXPECT_LE(line.size(), 80u) << line;
  }
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"explain"},
                                                    {"clearance", "--example"},
                                                    {"standards", "--sds-g", "1.566"}}) {
    for (const std::string& line : lines_of(run_program(arguments).out))
      EXPECT_LE(line.size(), 80u) << line;
  }
}
TEST(Usage, explain_answers_for_a_measure_a_value_and_a_key_without_its_table) {
  const auto explained = [](const char* word) { return run_program({"explain", word}).out; };
  EXPECT_THAT(explained("sa"), states("\"sa_g\"", "intensity.sa_period_s"));
  EXPECT_THAT(explained("pgv"), states("velocity"));
  EXPECT_THAT(explained("all_permutations"), states("[orientation]"));
  EXPECT_THAT(explained("period_s"), states("[building]", "project"));
  EXPECT_THAT(explained("obstruction_m"), states("[clearances]", "project"));
  expect_refused(run_program({"explain", "sb"}), {"sb", "glissade explain"});
  expect_refused(run_program({"explain", "heigth_m"}), {"height_m"});
}
TEST(Usage, options_take_numbers_with_units_as_files_do) {
  const auto standards = [](const char* sds) {
    return run_program({"standards", "--sds-g", sds}).out;
  };
  EXPECT_NE(standards("1.2"), "");
  EXPECT_EQ(standards("1.2 g"), standards("1.2"));
  EXPECT_EQ(standards("11.76798 m/s2"), standards("1.2"));
  expect_refused(run_program({"standards", "--sds-g", "1.2 in"}), {"--sds-g", "an acceleration"});
}
TEST(Usage, what_is_missing_unknown_or_no_number_is_named) {
  expect_refused(run_program({}), {"--help"});
  expect_refused(run_program({"slide", "r", "--mu", "1", "--slope-deg", "1", "--frobnicate"}),
                 {"--frobnicate"});
  expect_refused(run_program({"slide", "r", "--mu", "1"}), {"--slope-deg", "required"});
  expect_refused(run_program({"slide", "r", "--mu", "high", "--slope-deg", "1"}), {"--mu", "high"});
}

TEST(Usage, all_impossible_numbers_are_reported_together) {
  expect_refused(
      run_program({"slide", "r", "--mu", "-0.5", "--slope-deg", "95", "--scale", "0", "--period-s",
                   "-1", "--damping", "1", "--substeps", "0", "--method", "newmark"}),
      {"--mu: -0.5", "--slope-deg: 95", "--scale: 0", "--period-s: -1", "--damping: 1",
       "--substeps: 0", "--method: newmark"});
}

TEST(Usage, numbers_that_are_not_finite_are_refused) {
  expect_refused(run_program({"slide", "r", "--mu", "inf", "--slope-deg", "nan", "--pga-g", "inf"}),
                 {"--mu: inf", "--slope-deg: nan", "--pga-g: inf"});
}

TEST(Usage, contradictory_options_are_refused) {
  expect_refused(
      run_program({"slide", "r", "--mu", "1", "--slope-deg", "1", "--scale", "2", "--pga-g", "1"}),
      {"--scale", "--pga-g"});
  expect_refused(run_program({"slide", "r", "--mu", "1", "--slope-deg", "1", "--method",
                              "rodriguez-nikl", "--history", "h.csv"}),
                 {"--history", "event"});
  expect_refused(run_program({"slide", "r", "--mu", "1", "--slope-deg", "1", "--json", "--history",
                              "/dev/stdout"}),
                 {"--history", "/dev/stdout"});
}

TEST(Usage, a_report_of_what_is_no_results_file_is_refused) {
  const ScratchFolder folder;
  expect_refused(run_program({"report", folder.path("none.h5").string()}),
                 {"none.h5", "no such file"});
  expect_refused(run_program({"report", folder.write("text.h5", "not HDF5")}),
                 {"text.h5", "not a complete glissade results file"});
  EXPECT_EQ(folder.contents(), std::vector<std::string>{"text.h5"});
}

// To open a named pipe waits for a process that writes to it.
TEST(Usage, a_named_pipe_in_place_of_a_file_is_refused_by_every_command) {
  const ScratchFolder folder;
  folder.write("suite.toml", suite_of_one_record());
  const auto pipe = [&](const std::string& name) {
    std::filesystem::create_directories(folder.path(name).parent_path());
    EXPECT_EQ(::mkfifo(folder.path(name).c_str(), 0600), 0) << name;
    return "'" + folder.path(name).string() + "'";
  };
  const auto refuses = [](const std::string& command, const std::string& name) {
    SCOPED_TRACE(command);
    expect_refused(run_shell("timeout -s KILL 60 \"$0\" " + command), {name, "no regular file"});
  };
  const std::string file = pipe("pipe");
  for (const char* command : {"run", "check", "report", "friction", "suite show", "clearance"})
    refuses(command + (" " + file), "pipe");
  refuses("slide " + file + " --mu 0.5 --slope-deg 1", "pipe");
  refuses("fit --counts " + file, "pipe");
  pipe("record.txt");
  refuses("suite show '" + folder.path("suite.toml").string() + "'", "record.txt");
  pipe("run/run.json");
  const std::string run = "'" + folder.path("run").string() + "'";
  refuses("run --resume " + run, "run.json");
  expect_refused(run_shell("timeout -s KILL 60 \"$0\" clearance --resume " + run),
                 {"no calculation"});
  pipe("part/journal/run");
  refuses(
      "merge '" + folder.path("part").string() + "' --out '" + folder.path("merged").string() + "'",
      "journal/run");
}

}  // namespace
}  // namespace glissade::test
