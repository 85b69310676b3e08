// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <sys/stat.h>

#include <functional>

#include "cli/child.hpp"
#include "cli/one_package.hpp"
#include "cli/one_run.hpp"
#include "cli/small_study.hpp"
#include "glissade/io/journal.hpp"
#include "glissade/report/results_folder.hpp"

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
  succeeding(over);
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
                           "suite show", "suite spectra", "suite scale", "suite design",
                           "suite import", "suite select", "suite target"));
}

TEST(OutputRule, a_file_is_written_over_with_overwrite_only) {
  const ScratchFolder folder;
  const std::string out = folder.write("out", "mine");
  expect_rule({"suite", "spectra", built_in_suite, "--out", out}, "--out", out);
  folder.write("out", "mine");
  expect_rule({"suite", "show", built_in_suite, "--out", out}, "--out", out);
  folder.write("out", "mine");
  expect_rule({"suite", "target", "--period-s", "0.5", "--sa-g", "0.6", "--magnitude", "7",
               "--distance-km", "20", "--vs30-mps", "400", "--out", out},
              "--out", out);
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
  const std::string list = read_file(out() / "report_files.txt");
  folder_->write("out/tables/of_another_study.csv", "old");
  folder_->write("out/report_files.txt", list + "tables/of_another_study.csv\n");
  expect_refused(run_program({"report", results}), {"--out", out().string(), "--overwrite"});
  EXPECT_TRUE(fs::exists(out() / "tables/of_another_study.csv"));

  succeeding({"report", results, "--overwrite"});
  EXPECT_EQ(read_file(out() / "report.html"), page);
  EXPECT_EQ(read_file(out() / "run.json"), run_json);
  EXPECT_EQ(read_file(out() / "report_files.txt"), list);
  EXPECT_FALSE(fs::exists(out() / "tables/of_another_study.csv"));
}

TEST_F(OutputRuleOfAFolder, files_of_the_user_stay_whatever_takes_the_place_of_a_report) {
  const std::vector<std::string> mine = {"tables/mine.csv", "figures/thesis.pdf", "figures/my.svg",
                                         "figures/model.dat.partial.1", "notes.partial.2"};
  for (const std::string& name : mine) folder_->write("out/" + name, "mine");
  folder_->write("mine.csv", "mine");
  // Anybody could have written the list.
  folder_->write("out/report_files.txt",
                 read_file(out() / "report_files.txt") +
                     "../mine.csv\ntables/../../mine.csv\nrun.json\nfigures/../run.json\n" +
                     folder_->path("mine.csv").string() + "\n/tables/mine.csv\n");
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"report", (out() / "results.h5").string()},
        {"run", study_, "--out", out().string()}}) {
    std::vector<std::string> over = command;
    over.emplace_back("--overwrite");
    succeeding(over);
    for (const std::string& name : mine) EXPECT_EQ(read_file(out() / name), "mine") << name;
    EXPECT_EQ(read_file(folder_->path("mine.csv")), "mine");
  }
}

TEST_F(OutputRuleOfAFolder, what_is_not_listed_is_the_user_s_and_is_not_written_over) {
  const fs::path other = folder_->path("unlisted");
  fs::create_directory(other);
  fs::copy_file(out() / "results.h5", other / "results.h5");
  folder_->write("unlisted/tables/fragility.csv", "old");
  folder_->write("unlisted/tables/unknown.csv", "old");
  const std::string results = (other / "results.h5").string();
  expect_refused(run_program({"report", results}), {"--overwrite"});
  EXPECT_EQ(read_file(other / "tables/fragility.csv"), "old");
  expect_refused(run_program({"report", results, "--overwrite"}),
                 {"tables/fragility.csv", "report_files.txt does not list it", "move it away"});
  EXPECT_EQ(read_file(other / "tables/fragility.csv"), "old");
  fs::remove(other / "tables/fragility.csv");
  succeeding({"report", results, "--overwrite"});
  EXPECT_EQ(read_file(other / "tables/fragility.csv"), read_file(out() / "tables/fragility.csv"));
  EXPECT_EQ(read_file(other / "tables/unknown.csv"), "old");
}

/// Of a pattern of output_names().
std::string name_of(std::string pattern) {
  for (std::size_t at = 0; (at = pattern.find_first_of("#*")) != std::string::npos;)
    pattern.replace(at, 1, pattern[at] == '#' ? "1" : "fragility");
  return pattern;
}

// Whoever gives somebody a results folder could have put links to that person's files into it.
TEST_F(OutputRuleOfAFolder, nothing_is_written_or_removed_where_a_name_is_taken) {
  const std::string project = folder_->write("project.toml", moved_project()),
                    sites = folder_->write("sites.toml", two_roofs()),
                    product = folder_->write("product.toml", small_product()),
                    sheet = folder_->write("sheet.csv", "mu\n0.50\n0.54\n0.58\n");
  const fs::path stranger = folder_->path("stranger"), victim = folder_->path("victim");
  const std::string there = stranger.string();
  const std::vector<std::vector<std::string>> commands = {
      {"run", study_, "--out", there, "--overwrite"},
      {"run", "--resume", there},
      {"report", (out() / "results.h5").string(), "--out", there, "--overwrite"},
      {"friction", sheet, "--out", there, "--overwrite"},
      {"clearance", project, "--out", there, "--overwrite"},
      {"clearance", sites, "--out", there, "--overwrite"},
      {"clearance", product, "--out", there, "--overwrite"},
      {"clearance", "--resume", there}};
  // Of a file of the user only those that would write it: by number in the list.
  const auto would_write = [](const std::vector<std::string>& command, const std::string& name) {
    const std::string file = command.size() > 1 ? fs::path(command[1]).filename().string() : "";
    if (name.starts_with("tables/") || name.starts_with("figures/") || name == "report.html")
      return command[0] == "report";
    for (const auto& [begin, project] : {std::pair{"package", "project.toml"},
                                         {"demand.", "project.toml"},
                                         {"uncertainty.", "project.toml"},
                                         {"probability.", "project.toml"},
                                         {"sites.", "sites.toml"},
                                         {"product", "product.toml"},
                                         {"target_1.", "product.toml"}})
      if (name.starts_with(begin)) return file == project;
    return command[0] != "report";
  };
  std::size_t turn = 0;  // a third of the others than links
  for (const std::string& pattern : output_names()) {
    const bool is_folder = pattern.ends_with('/');
    const std::string name = name_of(is_folder ? pattern.substr(0, pattern.size() - 1) : pattern);
    const fs::path path = stranger / name;
    const auto try_with = [&](const std::string& kind, const std::vector<std::string>& command) {
      SCOPED_TRACE(command[0] + " " + command[1] + " with a " + kind + " " + name);
      fs::remove_all(stranger);
      folder_->write("victim/mine", "mine");
      fs::create_directories(path.parent_path());
      if (command[1] == "--resume")  // of another calculation, as far as it was begun
        folder_->write("stranger/run.json", R"({"command": "clearance", "project": ")" + project +
                                                R"(", "project_sha256": "", "status": "started"})");
      if (kind == "link") {
        fs::remove(path);
        fs::create_symlink(is_folder ? victim : victim / "mine", path);
      } else if (kind == "pipe") {
        fs::remove(path);
        ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
      } else if (kind == "folder") {
        fs::remove(path);
        folder_->write("stranger/" + name + "/mine", "mine");
      } else {
        folder_->write("stranger/" + name, "mine");
      }
      expect_refused(run_program(command), {command[1] == "--resume" ? "" : "stranger"});
      EXPECT_EQ(read_file(victim / "mine"), "mine");
      const fs::file_status status = fs::symlink_status(path);
      EXPECT_TRUE(kind == "link"   ? fs::is_symlink(status)
                  : kind == "pipe" ? fs::is_fifo(status)
                                   : read_file(kind == "folder" ? path / "mine" : path) == "mine");
    };
    for (const std::string kind : {"link", "pipe", "folder", "file"}) {
      const bool by_writers =
          (kind == "file" && !is_folder) || pattern.find('*') != std::string::npos;
      if ((kind == "folder" && is_folder) || (kind == "file" && name.ends_with(".units"))) continue;
      for (const std::vector<std::string>& command : commands)
        if ((!by_writers || would_write(command, name)) && (kind == "link" || ++turn % 3 == 0))
          try_with(kind, command);
    }
  }
}

TEST_F(OutputRuleOfAFolder, nor_a_link_in_the_place_of_a_table_or_figure) {
  const std::string victim = folder_->write("mine.txt", "mine");
  for (const char* name : {"tables/fragility.csv", "figures/fragility.svg", "figures/ida.pdf"}) {
    const std::string text = read_file(out() / name);
    fs::remove(out() / name);
    fs::create_symlink(victim, out() / name);
    expect_refused(run_program({"report", (out() / "results.h5").string(), "--overwrite"}),
                   {name, "is a link"});
    EXPECT_EQ(read_file(victim), "mine");
    fs::remove(out() / name);
    // A second name of a file is no link to look for: the file keeps its content under the other.
    fs::create_hard_link(victim, out() / name);
    EXPECT_EQ(run_program({"report", (out() / "results.h5").string(), "--overwrite"}).status, 0);
    EXPECT_EQ(read_file(victim), "mine");
    EXPECT_EQ(read_file(out() / name), text);
  }
}

TEST_F(OutputRuleOfAFolder, what_killed_commands_left_goes_with_the_next_unless_one_is_going_on) {
  const std::vector<std::string> left = {
      "results.h5.partial.1",           "run.json.partial.22",
      "report.html.partial.1.2",        "report_files.txt.partial.33",
      "tables/fragility.csv.partial.1", "figures/ida.svg.partial.4.1"};
  const std::vector<std::string> mine = {"my.h5.partial.1", "results.h5.partial.of_mine",
                                         "tables/my.csv.partial.1"};
  for (const std::string& name : left) folder_->write("out/" + name, "left");
  for (const std::string& name : mine) folder_->write("out/" + name, "mine");
  const std::vector<std::string> command = {"report", (out() / "results.h5").string(),
                                            "--overwrite"};
  {
    const RunLock of_another(out());
    expect_refused(run_program(command), {"a run is going on"});
    for (const std::string& name : left) EXPECT_TRUE(fs::exists(out() / name)) << name;
  }
  ASSERT_EQ(run_program(command).status, 0);
  for (const std::string& name : left) EXPECT_FALSE(fs::exists(out() / name)) << name;
  for (const std::string& name : mine) EXPECT_EQ(read_file(out() / name), "mine") << name;
  EXPECT_FALSE(fs::exists(out() / "journal"));
}

TEST_F(OutputRuleOfAFolder, a_run_takes_the_place_of_another_with_overwrite_only) {
  const std::string study =
      folder_->write("other.toml", replaced(small_study(), "seed = 7", "seed = 8"));
  const std::string old = read_file(out() / "results.h5");
  expect_refused(run_program({"run", study, "--out", out().string()}),
                 {"--out", out().string(), "--overwrite"});
  EXPECT_TRUE(read_file(out() / "results.h5") == old);
  succeeding({"run", study, "--out", out().string(), "--overwrite"});
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
