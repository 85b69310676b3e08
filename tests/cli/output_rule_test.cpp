// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <functional>

#include "cli/child.hpp"
#include "cli/one_run.hpp"
#include "cli/small_study.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;

const std::string built_in_suite = GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml";

/// The command is refused where `out` holds `old`, which stays; with --overwrite it is replaced.
void expect_rule(const std::vector<std::string>& command, const std::string& option,
                 const std::string& out) {
  const std::string old = read_file(out);
  expect_refused(run_program(command), {option, out, "--overwrite"});
  EXPECT_EQ(read_file(out), old);
  std::vector<std::string> over = command;
  over.push_back("--overwrite");
  const Finished child = run_program(over);
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_NE(read_file(out), old);
}

/// Every command that takes a path to write to has --overwrite, and no other word for it; those of
/// this list are tested below, here or with their command. `check` writes nothing to its --out.
TEST(OutputRule, is_the_same_of_all_commands) {
  std::vector<std::string> writing;
  for (const std::vector<std::string>& command : all_commands()) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    const std::string help = run_program(arguments).out;
    const bool writes = command != std::vector<std::string>{"check"} &&
                        (help.find("  --out ") != std::string::npos ||
                         help.find("  --history ") != std::string::npos ||
                         help.find("file to write") != std::string::npos);
    EXPECT_EQ(help.find("  --overwrite ") != std::string::npos, writes) << help;
    for (const char* other : {"--force", "--yes", "--clobber"})
      EXPECT_EQ(help.find(other), std::string::npos) << help;
    std::string name;
    for (const std::string& word : command) name += (name.empty() ? "" : " ") + word;
    if (writes) writing.push_back(name);
  }
  EXPECT_THAT(writing, testing::UnorderedElementsAre(
                           "init", "run", "merge", "clearance", "report", "friction", "slide",
                           "suite show", "suite spectra", "suite design", "suite select"));
}

TEST(OutputRule, a_file_is_written_over_with_overwrite_only) {
  const ScratchFolder folder;
  const std::string out = folder.write("out", "mine");
  expect_rule({"suite", "spectra", built_in_suite, "--out", out}, "--out", out);
  folder.write("out", "mine");
  expect_rule({"suite", "show", built_in_suite, "--out", out}, "--out", out);
  folder.write("out", "mine");
  // With --overwrite it would compute for half a minute.
  expect_refused(run_program({"suite", "design", "--level", "0", "--out", out}),
                 {"--out", out, "--overwrite"});
  folder.write("out", "mine");
  expect_rule({"init", out, "--suite", built_in_suite}, "file", out);
  folder.write("out", "mine");
  const std::string record = folder.write("push.txt", "# acceleration_g\n0.5\n0.5\n0.5\n");
  expect_rule(
      {"slide", record, "--dt-s", "0.01", "--mu", "0.1", "--slope-deg", "0", "--history", out},
      "--history", out);
}

TEST(OutputRule, a_link_to_no_file_is_there_already) {
  const ScratchFolder folder;
  const fs::path link = folder.path("link");
  fs::create_symlink(folder.path("nowhere"), link);
  const std::string out = link.string();
  expect_refused(run_program({"suite", "spectra", built_in_suite, "--out", out}),
                 {"--out", out, "--overwrite"});
  EXPECT_TRUE(fs::is_symlink(link));
}

TEST(OutputRule, a_folder_that_is_not_empty_is_refused_before_anything_is_run) {
  const ScratchFolder folder;
  fs::create_directory(folder.path("out"));
  folder.write("out/mine", "mine");
  const std::string out = folder.path("out").string();
  const std::string study = folder.write("study.toml", small_study());
  const std::string project = GLISSADE_SOURCE_DIR "/studies/permit_project.toml";
  expect_refused(run_program({"run", study, "--out", out}), {out, "--overwrite"});
  expect_refused(run_program({"clearance", project, "--out", out}), {out, "--overwrite"});
  EXPECT_EQ(read_file(folder.path("out/mine")), "mine");
}

TEST(OutputRule, an_empty_path_is_refused) {
  const ScratchFolder folder;
  const std::string study = folder.write("study.toml", small_study());
  expect_refused(run_program({"run", study, "--out", ""}), {"--out", "empty"});
  expect_refused(run_program({"run", study, "--out="}), {"--out=", "empty"});
}

class OutputRuleOfAFolder : public OneRun<small_study> {};

TEST_F(OutputRuleOfAFolder, a_report_is_made_again_in_its_folder_with_overwrite_only) {
  const std::string results = (out() / "results.h5").string(),
                    run_json = read_file(out() / "run.json");
  const std::string page = read_file(out() / "report.html");
  folder_->write("out/tables/of_another_study.csv", "old");
  folder_->write("out/tables/notes.txt", "mine");
  expect_refused(run_program({"report", results}), {"--out", out().string(), "--overwrite"});
  EXPECT_TRUE(fs::exists(out() / "tables/of_another_study.csv"));

  const Finished child = run_program({"report", results, "--overwrite"});
  ASSERT_EQ(child.status, 0) << child.err;
  EXPECT_EQ(read_file(out() / "report.html"), page);
  EXPECT_EQ(read_file(out() / "run.json"), run_json);
  EXPECT_FALSE(fs::exists(out() / "tables/of_another_study.csv"));
  EXPECT_EQ(read_file(out() / "tables/notes.txt"), "mine");
}

TEST_F(OutputRuleOfAFolder, a_run_takes_the_place_of_another_with_overwrite_only) {
  const std::string study =
      folder_->write("other.toml", replaced(small_study(), "seed = 7", "seed = 8"));
  const std::string old = read_file(out() / "results.h5");
  expect_refused(run_program({"run", study, "--out", out().string()}),
                 {"--out", out().string(), "--overwrite"});
  EXPECT_TRUE(read_file(out() / "results.h5") == old);
  const Finished child = run_program({"run", study, "--out", out().string(), "--overwrite"});
  ASSERT_EQ(child.status, 0) << child.err;
  EXPECT_FALSE(read_file(out() / "results.h5") == old);
}

TEST_F(OutputRuleOfAFolder, a_run_json_of_another_form_is_refused_by_report) {
  const std::string results = folder_->path("apart/results.h5").string(),
                    again = folder_->path("again").string();
  fs::create_directory(folder_->path("apart"));
  fs::copy_file(out() / "results.h5", results);
  for (const auto& [text, wrong] :
       {std::pair(R"({"skipped": 3})", "skipped"),
        {R"({"skipped": [1]})", "entry"},
        {R"({"status": "finished", "skips": [3]})", "\"skipped\""},
        {R"({"skipped": [{"what": 1, "why": "", "count": 1}]})", "\"what\""},
        {R"({"skipped": [{"what": "a", "why": [], "count": 1}]})", "\"why\""},
        {R"({"skipped": [{"what": "a", "why": "b", "count": "many"}]})", "\"count\""},
        {R"({"skipped": [{"what": "a", "why": "b", "count": -1}]})", "\"count\""},
        {R"({"skipped": [{"what": "a", "why": "b"}]})", "\"count\""},
        {"[]", "object"},
        {"[1]", "object"},
        {"\"text\"", "object"},
        {"{", "object"},
        {"", "object"}}) {
    folder_->write("apart/run.json", text);
    const Finished child = run_program({"report", results, "--out", again});
    expect_refused(child, {"run.json", "is not as glissade run writes it", wrong, "remove it"});
    EXPECT_THAT(child.err, testing::Not(testing::HasSubstr("json.exception"))) << text;
  }
  fs::remove(folder_->path("apart/run.json"));
  EXPECT_EQ(run_program({"report", results, "--out", again}).status, 0);
}

}  // namespace
}  // namespace glissade::test
