// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <unistd.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <tuple>

#include "cli/killed_run.hpp"
#include "cli/one_run.hpp"
#include "facts.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/journal.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;

constexpr int stopped_status = 75;

/// Beside a run that nothing disturbed, to which the resumed ones are compared.
class Resume : public OneRun<longer_study> {
 protected:
  ~Resume() override { fs::remove_all(again_); }

  std::vector<std::string> command(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{GLISSADE_PROGRAM, "run", study_, "--out", again_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  /// Starts the study, waits for the first units, does `end`, waits for the end.
  Finished ended_by(const std::function<void(const Child&)>& end) const {
    Child child(command());
    EXPECT_TRUE(reaches(child, [&] { return some_units_are_done(again_); }));
    end(child);
    return child.wait();
  }
  Finished ended_by(int signal) const {
    return ended_by([&](const Child& child) { ::kill(child.pid(), signal); });
  }
  Finished resume(const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"run", "--resume", again_.string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_program(arguments);
  }
  void expect_stopped(const Finished& child, const std::string& reason) const {
    EXPECT_EQ(child.status, stopped_status) << child.err;
    EXPECT_EQ(child.out, "");
    EXPECT_THAT(child.err, states(reason, "glissade run --resume " + again_.string()));
    EXPECT_FALSE(fs::exists(again_ / "results.h5"));
    const Json json = Json::parse(read_file(again_ / "run.json"));
    EXPECT_EQ(json.at("status"), "stopped");
    EXPECT_GT(json.at("units_done"), 0);
    EXPECT_LT(json.at("units_done"), json.at("units"));
  }
  /// It takes units over, ends, and leaves what an undisturbed run leaves.
  void expect_resumed(const std::vector<std::string>& more = {}) const {
    const Finished child = resume(more);
    ASSERT_EQ(child.status, 0) << child.err;
    const Json json = Json::parse(read_file(again_ / "run.json"));
    EXPECT_EQ(json.at("status"), "finished");
    EXPECT_GT(json.at("units_of_earlier_sessions"), 0);
    expect_same_results();
  }
  void expect_same_results() const {
    EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
    EXPECT_EQ(names_in(again_), names_in(out()));
  }
  static std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
      names.push_back(entry.path().filename().string());
    std::ranges::sort(names);
    return names;
  }

  fs::path again_ = folder_->path("again");
};

TEST_F(Resume, a_run_that_is_signalled_stops_with_status_75_and_goes_on_to_the_same_bits) {
  expect_stopped(ended_by(SIGINT), "SIGINT");
  expect_resumed();
}
TEST_F(Resume, a_run_that_is_terminated_goes_on_with_other_options) {
  expect_stopped(ended_by(SIGTERM), "SIGTERM");
  expect_resumed({"--no-skip"});
}
TEST_F(Resume, a_run_that_its_scheduler_warns_goes_on) {
  expect_stopped(ended_by(SIGUSR1), "SIGUSR1");
  expect_resumed({study_});
}

TEST_F(Resume, a_run_whose_terminal_is_closed_goes_on) {
  expect_stopped(ended_by(SIGHUP), "SIGHUP");
  expect_resumed();
}

TEST_F(Resume, a_stop_file_stops_a_run_once) {
  expect_stopped(ended_by([&](const Child&) { folder_->write("again/stop", ""); }), "the file");
  EXPECT_FALSE(fs::exists(again_ / "stop"));
  expect_resumed();
}

TEST_F(Resume, a_wall_time_stops_every_session_until_the_run_is_finished) {
  Finished child =
      run_child(command({"--walltime-s", "0.01"}));  // runs its first unit all the same
  expect_stopped(child, "--walltime-s 0.01");
  child = resume({"--walltime-s", "0.01"});
  EXPECT_EQ(child.status, stopped_status) << child.err;
  EXPECT_EQ(Json::parse(read_file(again_ / "run.json")).at("units_done"), 2);
  expect_resumed({"--walltime-s", "1000"});
}

// Without fused multiply-add the C library's functions have other last digits.
TEST_F(Resume, a_run_that_began_on_another_kind_of_processor_is_refused_by_that_name) {
  const std::string other = "GLIBC_TUNABLES=glibc.cpu.hwcaps=-FMA,-FMA4,-AVX2 " GLISSADE_PROGRAM;
  const Finished begun =
      run_shell(other + " run " + study_ + " --walltime-s 0.01 --out " + again_.string());
  ASSERT_EQ(begun.status, stopped_status) << begun.err;
  const Finished child = resume();
  if (child.status == 0) GTEST_SKIP() << "the C library has one set of functions here";
  expect_refused(child, {"another kind of processor", "resume it on a machine of the kind"});
  EXPECT_EQ(child.err.find("restore the suite"), std::string::npos);
  EXPECT_EQ(run_shell(other + " run --resume " + again_.string()).status, 0);
}

TEST_F(Resume, a_killed_run_is_recognised_and_goes_on_after_a_second_kill) {
  EXPECT_EQ(ended_by(SIGKILL).status, 128 + SIGKILL);
  expect_refused(run_child(command()),
                 {"stopped or killed", "glissade run --resume", "--overwrite"});
  const std::uintmax_t before = journal_bytes(again_);
  Child second({GLISSADE_PROGRAM, "run", "--resume", again_.string()});
  ASSERT_TRUE(reaches(second, [&] { return journal_bytes(again_) > before + 1000; }));
  ::kill(second.pid(), SIGKILL);
  second.wait();
  expect_resumed();
}

TEST_F(Resume, two_runs_in_one_folder_are_refused) {
  Child first(command());
  ASSERT_TRUE(reaches(first, [&] { return some_units_are_done(again_); }));
  for (const auto& more : {std::vector<std::string>{}, {"--overwrite"}})
    expect_refused(run_child(command(more)), {"a run is going on"});
  expect_refused(resume(), {"a run is going on"});
  EXPECT_TRUE(first.is_running());
  EXPECT_EQ(first.wait().status, 0);
  expect_same_results();
}

TEST_F(Resume, an_overwritten_run_begins_anew) {
  ended_by(SIGKILL);
  ASSERT_EQ(run_child(command({"--overwrite"})).status, 0);
  EXPECT_EQ(Json::parse(read_file(again_ / "run.json")).at("units_of_earlier_sessions"), 0);
  expect_same_results();
}

TEST_F(Resume, a_finished_run_is_left_as_it_is) {
  const Finished child = succeeding({"run", "--resume", out().string()});
  EXPECT_THAT(child.out, states("finished"));
}

TEST_F(Resume, a_finished_run_keeps_journals_that_are_not_its_own_and_makes_a_report_that_is_gone) {
  ended_by(SIGKILL);
  const std::vector<std::string> before = names_in(again_ / "journal");
  const std::string other =
      folder_->write("other.toml", replaced(small_study(), "seed = 7", "seed = 8"));
  ASSERT_EQ(run_program({"run", other, "--out", folder_->path("other").string()}).status, 0);
  for (const char* name : {"results.h5", "run.json"})
    fs::copy_file(folder_->path("other") / name, again_ / name,
                  fs::copy_options::overwrite_existing);
  expect_refused(resume(), {"journal", "of another run"});
  EXPECT_EQ(names_in(again_ / "journal"), before);

  const fs::path finished = folder_->path("other");
  fs::remove(finished / "report.html");
  fs::create_directory(finished / "journal");
  folder_->write("other/journal/mine.units", "of the user");
  EXPECT_EQ(run_program({"run", "--resume", finished.string()}).status, 0);
  EXPECT_TRUE(fs::exists(finished / "report.html"));
  EXPECT_EQ(read_file(finished / "journal/mine.units"), "of the user");
  fs::remove_all(finished);
}

/// Of a run that was killed, then finished; with the journal of the first put back.
TEST_F(Resume, results_that_are_not_whole_are_made_again_from_the_journal) {
  ended_by(SIGKILL);
  const fs::path kept = folder_->path("kept");
  fs::copy(again_ / "journal", kept);
  expect_resumed();
  const std::string whole = read_file(again_ / "results.h5");
  for (int fault = 0; fault < 3; ++fault) {
    fs::copy(kept, again_ / "journal");
    if (fault == 0) fs::remove(again_ / "results.h5");
    if (fault == 1) fs::resize_file(again_ / "results.h5", whole.size() - 1);
    if (fault == 2) {
      std::string changed = whole;
      changed[whole.size() / 2] = static_cast<char>(changed[whole.size() / 2] ^ 1);
      folder_->write("again/results.h5", changed);
    }
    expect_resumed();
  }
  fs::remove_all(kept);
}

TEST_F(Resume, a_finished_run_without_whole_results_says_what_to_do) {
  ASSERT_EQ(run_child(command()).status, 0);
  const std::string run_json = read_file(again_ / "run.json");
  const auto expect_fault = [&](const std::string& fault) {
    const std::vector<std::string> before = names_in(again_);
    expect_refused(resume(), {"results.h5", fault, "no journal", "--overwrite"});
    EXPECT_EQ(names_in(again_), before);
    EXPECT_EQ(read_file(again_ / "run.json"), run_json);
  };
  fs::resize_file(again_ / "results.h5", 5000);
  expect_fault("checksum");
  const std::string other =
      folder_->write("other.toml", replaced(small_study(), "seed = 7", "seed = 8"));
  ASSERT_EQ(run_program({"run", other, "--out", folder_->path("other").string()}).status, 0);
  fs::remove(again_ / "results.h5");
  fs::copy_file(folder_->path("other/results.h5"), again_ / "results.h5");
  expect_fault("another run");
  fs::remove(again_ / "results.h5");
  expect_fault("no such file");
}

TEST_F(Resume, a_report_that_failed_is_made) {
  const auto without_gnuplot = [&] {
    fs::remove_all(again_);
    const Finished child = run_shell("program=\"$0\"; PATH=/nonexistent; exec \"$program\" run '" +
                                     study_ + "' --out '" + again_.string() + "'");
    expect_refused(child, {"gnuplot", "results.h5", "is complete", "glissade run --resume"});
    EXPECT_EQ(Json::parse(read_file(again_ / "run.json")).at("status"),
              "results written, report missing");
  };
  const auto expect_finished = [&] {
    const Json json = Json::parse(read_file(again_ / "run.json")),
               whole = Json::parse(read_file(out() / "run.json"));
    EXPECT_EQ(json.at("status"), "finished");
    EXPECT_FALSE(json.contains("what_to_do"));
    EXPECT_EQ(json.at("skipped"), whole.at("skipped"));
    expect_same_results();
    EXPECT_EQ(read_file(again_ / "report.html"), read_file(out() / "report.html"));
  };
  without_gnuplot();
  EXPECT_EQ(resume().status, 0);
  expect_finished();
  without_gnuplot();
  EXPECT_EQ(run_program({"report", "--overwrite", (again_ / "results.h5").string()}).status, 0);
  expect_finished();
  without_gnuplot();  // a report in another folder does not finish the run
  const std::string elsewhere = folder_->path("elsewhere").string();
  EXPECT_EQ(run_program({"report", (again_ / "results.h5").string(), "--out", elsewhere}).status,
            0);
  EXPECT_NE(Json::parse(read_file(again_ / "run.json")).at("status"), "finished");
}

// Killed between the creation of journal/run.partial.PID and its renaming, or before.
TEST_F(Resume, a_run_that_was_killed_before_it_stated_what_it_is_begins_again) {
  for (const bool half_written : {false, true}) {
    folder_->write("again/journal/lock", "");
    if (half_written) folder_->write("again/journal/run.partial.4711", "half");
    expect_refused(resume(), {again_.string(), "killed before its first unit",
                              "glissade run STUDY.toml --out " + again_.string()});
    const Finished child = run_child(command());
    EXPECT_EQ(child.status, 0) << child.err;
    expect_same_results();
    fs::remove_all(again_);
  }
}

TEST(ResumeOfASuite, what_the_results_say_of_a_record_and_changes_is_named) {
  const ScratchFolder folder;
  const std::string text =
                        "event = \"Quake\"\nstation = \"Here\"\nmagnitude = 6.9\n"
                        "distance_km = 12.0\nvs30_mps = 300.0\n",
                    suite = replaced(suite_of_one_record(), "id = \"a\"\n", "id = \"a\"\n" + text);
  const std::string described =
      replaced(suite, "name = \"one\"\n", "name = \"one\"\ndescription = \"of a record\"\n");
  std::string record;
  for (int i = 0; i < 200; ++i) record += std::to_string(0.5 * std::sin(0.3 * i)) + "\n";
  folder.write("record.txt", record);
  folder.write("suite.toml", described);
  const std::string study =
      folder.write("study.toml",
                   "[study]\nname = \"s\"\n[suite]\nfile = \"suite.toml\"\n[intensity]\n"
                   "measure = \"pga_g\"\nlevels = [0.5, 1.0, 2.0]\n[model]\naxes = 1\n"
                   "[friction]\nmu = { mean = 0.3, std = 0.03 }\n[sampling]\nsamples = 64\n"
                   "[fragility]\nthresholds_m = [0.05]\n");
  const std::string out = folder.path("out").string();
  const Finished stopped = run_program({"run", study, "--out", out, "--walltime-s", "0"});
  ASSERT_EQ(stopped.status, stopped_status) << stopped.err;
  for (const auto& [was, is, named] : {std::tuple("Quake", "Other", "motion a"),
                                       {"Here", "There", "motion a"},
                                       {"6.9", "7.0", "motion a"},
                                       {"12.0", "13.0", "motion a"},
                                       {"300.0", "310.0", "motion a"},
                                       {"of a record", "of another", "description"}}) {
    folder.write("suite.toml", replaced(described, was, is));
    expect_refused(run_program({"run", "--resume", out}), {"suite.toml", named, "restore"});
  }
  folder.write("suite.toml", described);
  succeeding({"run", "--resume", out});
}

TEST_F(Resume, a_finished_run_is_of_its_study_only) {
  const std::vector<std::string> before = names_in(out());
  const auto resumed_with = [&](const std::string& text) {
    return run_program({"run", "--resume", out().string(), folder_->write("given.toml", text)});
  };
  const Finished same = resumed_with(longer_study());
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_THAT(same.out, states("finished"));
  expect_refused(resumed_with(replaced(longer_study(), "seed = 7", "seed = 8")),
                 {"given.toml:3", out().string(), "seed = 8", "seed = 7"});
  // Its text is in the results.
  expect_refused(resumed_with(longer_study() + "# a comment\n"),
                 {"given.toml:" + std::to_string(std::ranges::count(longer_study(), '\n') + 1),
                  "# a comment"});
  EXPECT_EQ(names_in(out()), before);
}

TEST_F(Resume, a_folder_without_a_run_is_refused_and_not_made) {
  expect_refused(resume(), {again_.string(), "no run"});
  EXPECT_FALSE(fs::exists(again_));
}

TEST_F(Resume, another_study_is_refused_with_the_line_that_differs) {
  ended_by(SIGKILL);
  const auto before = names_in(again_ / "journal");
  const std::string other =
      folder_->write("other.toml", replaced(longer_study(), "seed = 7", "seed = 8"));
  const Finished child = resume({other});
  expect_refused(child, {"other.toml:3", "seed = 8", "seed = 7"});
  const std::string commented = folder_->write("commented.toml", "# a comment\n" + longer_study());
  expect_refused(resume({commented}), {"commented.toml:1", "# a comment"});
  EXPECT_EQ(names_in(again_ / "journal"), before);
  expect_resumed();
}

TEST_F(Resume, a_study_that_has_moved_is_given_once) {
  ended_by(SIGKILL);
  const std::string moved = folder_->write("moved.toml", longer_study());
  EXPECT_EQ(resume({moved, "--walltime-s", "0"}).status, 75);
  EXPECT_EQ(read_identity(again_).study_file, moved);
  expect_resumed();
}

TEST_F(Resume, a_damaged_journal_costs_its_units_only) {
  ended_by(SIGKILL);
  const fs::path file = again_ / "journal/0-1.units";
  std::string bytes = read_file(file);
  bytes[bytes.size() - 20] = static_cast<char>(bytes[bytes.size() - 20] ^ 1);
  folder_->write("again/journal/0-1.units", bytes);
  const Finished child = resume();
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(child.out, states("not whole"));
  expect_same_results();
}

TEST_F(Resume, a_dry_run_sees_that_a_folder_is_taken) {
  const Finished child = run_program({"run", study_, "--out", out().string(), "--dry-run"});
  EXPECT_EQ(child.status, 2);
  EXPECT_THAT(child.out, states("units"));  // the plan all the same
  EXPECT_THAT(child.err, states(out().string()));
  EXPECT_EQ(
      run_program({"run", study_, "--out", out().string(), "--dry-run", "--overwrite"}).status, 0);
}

// A limit on the size of files (in blocks of 512 bytes) stands for the full disk.
TEST_F(Resume, a_run_whose_journal_fills_the_disk_goes_on_when_there_is_room) {
  const std::string limited = "\"$0\" run '" + study_ + "' --out '" + again_.string() + "'";
  expect_refused(run_shell("ulimit -f 10; " + limited),
                 {"journal/0-1.units", "File too large", "glissade run --resume"});
  expect_resumed();
}

TEST_F(Resume, a_run_whose_results_do_not_fit_goes_on_when_there_is_room) {
  const auto blocks = fs::file_size(out() / "results.h5") / 512;
  const std::string limited = "\"$0\" run '" + study_ + "' --out '" + again_.string() + "'";
  expect_refused(run_shell("ulimit -f " + std::to_string(blocks - 1) + "; " + limited),
                 {"results.h5", "File too large", "glissade run --resume"});
  expect_resumed();
}

TEST(ResumeOfAStrangeFolder, a_journal_that_cannot_be_read_is_named) {
  const ScratchFolder folder;
  folder.write("run/journal/run", "");
  const std::string run = folder.path("run").string(),
                    study = folder.write("s.toml", small_study()),
                    as_owner = "setpriv --bounding-set=-dac_override,-dac_read_search";
  const bool is_root = ::geteuid() == 0;
  if (is_root && run_shell(as_owner + " true").status != 0) GTEST_SKIP() << "root may read all";
  fs::permissions(folder.path("run/journal"), fs::perms::none);
  for (const std::string& command :
       {"run --resume '" + run + "'", "run '" + study + "' --out '" + run + "'",
        "run '" + study + "' --overwrite --out '" + run + "'"})
    expect_refused(run_shell((is_root ? as_owner : "exec") + " \"$0\" " + command),
                   {"journal", "Permission denied"});
  fs::permissions(folder.path("run/journal"), fs::perms::owner_all);
}

TEST(ResumeOfAStrangeFolder, changes_nothing_that_a_link_leads_to) {
  ScratchFolder folder;
  const fs::path victim = folder.path("victim"), run = folder.path("run");
  fs::create_directories(victim);
  fs::create_directories(run);
  for (const char* name : {"run", "lock", "0-1.units"}) write_text_file(victim / name, "mine");
  write_text_file(run / "run.json", "{\"status\": \"finished\"}");
  fs::create_directory_symlink(victim, run / "journal");
  run_program({"run", "--resume", run.string()});
  for (const char* name : {"run", "lock", "0-1.units"})
    EXPECT_EQ(read_file(victim / name), "mine") << name;
  fs::remove(run / "run.json");
  fs::create_symlink(victim / "run", run / "run.json");
  expect_refused(run_program({"run", "--resume", run.string()}), {"is a link"});
  EXPECT_EQ(read_file(victim / "run"), "mine");
}

}  // namespace
}  // namespace glissade::test
