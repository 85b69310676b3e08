// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/child.hpp"
#include "cli/small_clearance.hpp"
#include "cli/small_study.hpp"
#include "mpi/mpirun.hpp"

namespace glissade::test {
namespace {

class Mpi : public testing::Test {
 protected:
  void SetUp() override {
    if (!mpirun_is_there()) GTEST_SKIP() << "mpirun is not installed";
  }

  /// The bytes of results.h5 of a run on `ranks`; 0: without mpirun.
  std::string results_on(int ranks, const std::string& study) const {
    const std::string out = folder_.path("on" + std::to_string(ranks)).string();
    const Finished child = ranks == 0 ? run_program({"run", study, "--out", out})
                                      : run_on(ranks, {"run", study, "--out", out});
    EXPECT_EQ(child.status, 0) << child.err;
    EXPECT_THAT(read_file(out + "/run.json"),
                testing::HasSubstr("\"ranks\": " + std::to_string(ranks == 0 ? 1 : ranks)));
    return read_file(out + "/results.h5");
  }

  ScratchFolder folder_;
};

/// One of two ranks.
struct OneRank {
  int rank = 0;
  std::vector<std::string> variables = {};  ///< "NAME=VALUE", of faults.cpp or inject.cpp
  std::string folder = {};                  ///< where it starts; empty: here
  bool calls_fail = false;                  ///< those of writing (inject.cpp)
};

/// On two ranks, of which one is in another place. Whoever waits for ever is killed, which is
/// status 137.
Finished run_on_two(const OneRank& one, const std::vector<std::string>& arguments) {
  std::vector<std::string> command{"timeout", "-s", "KILL", "100", "mpirun"};
  for (const int rank : {0, 1}) {
    if (rank == 1) command.emplace_back(":");
    command.insert(command.end(), {"-n", "1"});
    if (rank == one.rank) {
      if (!one.folder.empty()) command.insert(command.end(), {"-wdir", one.folder});
      if (one.calls_fail)
        command.insert(command.end(), {"-x", "FAULT_CALLS=open,write,pwrite,fsync,close,mkdir"});
      else if (!one.variables.empty())
        command.insert(command.end(), {"-x", "LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY});
      for (const std::string& variable : one.variables)
        command.insert(command.end(), {"-x", variable});
    }
    if (rank == one.rank && one.calls_fail) command.emplace_back(GLISSADE_INJECT);
    command.emplace_back(GLISSADE_PROGRAM);
    command.insert(command.end(), arguments.begin(), arguments.end());
  }
  return run_child(command);
}

/// Our message stands once among what mpirun says of the status itself.
void expect_refused_once(const Finished& child, const std::string& part) {
  EXPECT_EQ(child.status, 2) << child.err;
  EXPECT_EQ(child.out.find("glissade: "), std::string::npos);
  const std::size_t first = child.err.find("glissade: ");
  ASSERT_NE(first, std::string::npos) << child.err;
  EXPECT_EQ(child.err.find("glissade: ", first + 1), std::string::npos) << child.err;
  EXPECT_THAT(child.err, testing::HasSubstr(part));
}

TEST_F(Mpi, one_two_three_and_seven_ranks_give_the_bytes_of_none) {
  // Samples enough that the ranks overtake one another.
  const std::string study =
      folder_.write("study.toml", replaced(small_study(), "samples = 8", "samples = 32"));
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {1, 2, 3, 7})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, multiple_stripes_have_the_same_bytes_on_any_ranks) {
  const std::string study = folder_.write("study.toml", stripes_study());
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {2, 3})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, one_and_two_ranks_give_the_same_report_tables_and_figures) {
  const std::string study = folder_.write("study.toml", small_study());
  results_on(1, study), results_on(2, study);
  std::size_t compared = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path("on1"))) {
    const std::string type = entry.path().extension().string();
    if (type != ".html" && type != ".csv" && type != ".svg") continue;
    const auto other = folder_.path("on2") / std::filesystem::relative(entry, folder_.path("on1"));
    EXPECT_TRUE(read_file(entry.path()) == read_file(other)) << other;
    ++compared;
  }
  EXPECT_GT(compared, 10u);
}

TEST_F(Mpi, the_ranks_of_a_machine_store_the_samples_of_motions_once) {
  for (const char* ranks : {"1", "2", "5"}) {
    const Finished child = run_child({"mpirun", "-n", ranks, GLISSADE_SHARED_NUMBERS});
    EXPECT_EQ(child.status, 0) << child.err;
  }
}

TEST_F(Mpi, a_step_that_fails_on_one_rank_fails_on_all_with_one_message) {
  for (const char* ranks : {"2", "3"}) {
    const Finished child =
        run_child({"timeout", "-s", "KILL", "100", "mpirun", "-n", ranks, GLISSADE_FAILING_STEPS});
    EXPECT_EQ(child.status, 0) << child.err;
  }
}

/// Three ranks where the folders of shared memory are as the mounts make them.
Finished run_with_mounts(const std::string& mounts, const std::string& study,
                         const std::string& out, const std::string& options = "") {
  return run_shell("timeout -s KILL 100 unshare --mount sh -c '" + mounts + " && mpirun " +
                   options + " -n 3 " GLISSADE_PROGRAM " run " + study + " --out " + out + "'");
}
std::string mount_of(const std::string& folder, const std::string& size) {
  return "mount -t tmpfs -o size=" + size + " tmpfs " + folder;
}

TEST_F(Mpi, a_machine_without_room_in_shared_memory_gives_the_same_bytes) {
  if (run_shell("unshare --mount true").status != 0) GTEST_SKIP() << "needs root: unshare --mount";
  const std::string study = folder_.write("study.toml", short_study());
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const std::string size : {"4k", "1M", "24M"}) {
    const std::string out = folder_.path(size).string();
    const Finished child = run_with_mounts(mount_of("/dev/shm", size), study, out);
    EXPECT_EQ(child.status, 0) << size << child.err;
    EXPECT_EQ(child.err, "");
    EXPECT_TRUE(read_file(out + "/results.h5") == alone);
  }
}

TEST_F(Mpi, a_target_error_ends_the_run_after_the_same_scramble_on_any_number_of_ranks) {
  const std::string study = folder_.write("target.toml", target_study());
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {1, 2, 3})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, a_chart_has_the_same_bytes_on_any_number_of_ranks) {
  const std::string study = folder_.write("chart.toml", small_chart());
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {1, 2, 3, 7})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, every_model_has_the_same_bytes_on_any_number_of_ranks) {
  const std::string impact = replaced(small_study(), "[0.05, 0.2]", "[0.05, 0.2]\n[impact]");
  for (const char* building :
       {"[building]\nmass_ratio = 0.1",
        "[building]\nmass_ratio = 0.1\nyield_coefficient = 0.2\nhardening_ratio = 0.05",
        "[model]\naxes = 2\n[building]\nmass_ratio = 0.1"}) {
    const std::string study = folder_.write("model.toml", replaced(impact, "[building]", building));
    const std::string alone = results_on(0, study);
    ASSERT_FALSE(alone.empty());
    EXPECT_TRUE(results_on(3, study) == alone) << building;
    for (const char* out : {"on0", "on3"}) std::filesystem::remove_all(folder_.path(out));
  }
}

TEST_F(Mpi, a_verdict_on_neighbouring_arrays_has_the_same_bytes_on_any_number_of_ranks) {
  std::string text =
      replaced(small_study(), "levels = [0.5, 1.0, 2.0]", "levels = [0.5, 1.0, 1.5]");
  text = replaced(text, "[sampling]", "neighbour_mu = { mean = 0.3, std = 0.03 }\n[sampling]");
  text = replaced(text, "{ distribution = \"uniform\", min = 0.2, max = 1.0 }", "0.5");
  const std::string study = folder_.write("verdict.toml", text + "[verdict]\n");
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {2, 3})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, a_clearance_study_has_the_same_bytes_on_any_number_of_ranks) {
  const std::string study = folder_.write("clearance.toml", small_clearance());
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {1, 2, 7})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, parts_of_different_numbers_of_ranks_are_merged_on_three_to_the_same_bytes) {
  const std::string study = folder_.write("study.toml", small_study());
  const std::string alone = results_on(0, study), first = folder_.path("1").string(),
                    second = folder_.path("2").string(), out = folder_.path("merged").string();
  ASSERT_EQ(run_program({"run", study, "--out", first, "--part", "1/2"}).status, 0);
  ASSERT_EQ(run_on(2, {"run", study, "--out", second, "--part", "2/2"}).status, 0);
  const Finished child = run_on(3, {"merge", first, second, "--out", out});
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_TRUE(read_file(out + "/results.h5") == alone);
}

TEST_F(Mpi, more_ranks_than_units_of_work_give_the_same_bytes) {
  std::string record;
  for (int i = 0; i < 500; ++i) record += i % 40 < 20 ? "0.5\n" : "-0.5\n";
  folder_.write("record.txt", record);
  folder_.write("suite.toml", suite_of_one_record());
  const std::string study =
      folder_.write("study.toml",
                    "[study]\nname = \"one\"\n[suite]\nfile = \"suite.toml\"\n[intensity]\nmeasure "
                    "= \"pga_g\"\nlevels = [0.4, 0.8]\n[model]\naxes = 1\n"
                    "[friction]\nmu = { mean = 0.3, std = 0.03 }\n[sampling]\nsamples = "
                    "2\n[fragility]\nthresholds_m = [0.05]\n");
  ASSERT_THAT(run_program({"run", study, "--dry-run"}).out,
              testing::HasSubstr("in 1 unit"));  // fewer than ranks
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {2, 7})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, a_machine_without_room_anywhere_for_shared_memory_says_so) {
  if (run_shell("unshare --mount true").status != 0) GTEST_SKIP() << "needs root: unshare --mount";
  const std::string study = folder_.write("study.toml", short_study());
  const std::string small = folder_.path("small").string(), out = folder_.path("out").string();
  std::filesystem::create_directory(small);
  expect_refused_once(run_with_mounts(mount_of("/dev/shm", "4k") + " && " + mount_of(small, "4k"),
                                      study, out, "-x TMPDIR=" + small),
                      "make room in /dev/shm");
}

TEST_F(Mpi, a_journal_that_fails_on_one_rank_ends_all_with_one_message_and_loses_nothing) {
  const std::string study =
      folder_.write("study.toml", replaced(short_study(), "samples = 2", "samples = 128"));
  const std::string alone = results_on(0, study), out = folder_.path("out").string();
  ASSERT_FALSE(alone.empty());
  for (const int rank : {0, 1}) {
    const std::string name = "journal/" + std::to_string(rank) + "-";
    for (const char* fault : {"FAULT_FROM=1", "FAULT_FROM=5", "FAULT_AT=3"}) {
      SCOPED_TRACE(name + " " + fault);
      const std::vector<std::string> variables{"FAULT_IN=" + name, "FAULT_ERRNO=28", fault};
      const Finished child = run_on_two({rank, variables, "", true}, {"run", study, "--out", out});
      expect_refused_once(child, name + "1.units: cannot be ");
      EXPECT_EQ(child.err.find("glissade: rank 1: ") != std::string::npos, rank == 1);
      EXPECT_THAT(child.err, testing::HasSubstr("No space left on device"));
      std::vector<std::string> again{"run", study, "--out", out};
      if (std::filesystem::exists(out)) again = {"run", "--resume", out};
      const Finished resumed = run_on(2, again);
      EXPECT_EQ(resumed.status, 0) << resumed.err;
      EXPECT_TRUE(read_file(out + "/results.h5") == alone);
      std::filesystem::remove_all(out);
    }
  }
}

TEST_F(Mpi, what_the_first_rank_cannot_write_ends_all_with_one_message) {
  const std::string study = folder_.write("study.toml", short_study());
  const std::string out = folder_.path("out").string();
  for (const char* file : {"out/journal/lock", "out/journal/run", "out/run.json", "out/results.h5",
                           "out/tables", "out/figures", "out/report.html"}) {
    SCOPED_TRACE(file);
    expect_refused_once(
        run_on_two(
            {0, {std::string("FAULT_IN=") + file, "FAULT_ERRNO=28", "FAULT_FROM=1"}, "", true},
            {"run", study, "--out", out}),
        "No space left on device");
    std::filesystem::remove_all(out);
  }
}

// HDF5 without memory can end the process by a signal, after which as after kill -9 nothing is
// lost.
TEST_F(Mpi, memory_that_ends_on_one_rank_ends_all_or_is_enough) {
  const std::string study = folder_.write("study.toml", short_study());
  const std::string alone = results_on(0, study), out = folder_.path("out").string();
  for (const auto& [rank, left_kb] : std::vector<std::pair<int, int>>{{0, 1}, {0, 2000}, {1, 1}}) {
    SCOPED_TRACE(std::to_string(rank) + " with KB: " + std::to_string(left_kb));
    const Finished child =
        run_on_two({rank, {"FAULT_MEMORY=" + std::to_string(left_kb), "FAULT_IN=.units"}},
                   {"run", study, "--out", out});
    ASSERT_NE(child.status, 137) << "waits for ever: " << child.err;
    if (child.status == 2) expect_refused_once(child, "memory");
    if (child.status != 0) {
      const Finished resumed = run_on(2, {"run", "--resume", out});
      EXPECT_EQ(resumed.status, 0) << child.err << resumed.err;
    }
    EXPECT_TRUE(read_file(out + "/results.h5") == alone);
    std::filesystem::remove_all(out);
  }
}

// A rank in another folder does not see the files of the study, as one on another machine may not.
TEST_F(Mpi, the_first_rank_alone_reads_the_files_of_a_study) {
  const std::string elsewhere = folder_.path("elsewhere").string();
  std::filesystem::create_directory(elsewhere);
  folder_.write("pulls.csv", "direction,mu\nx,0.31\nx,0.28\nx,0.33\n");
  folder_.write("hazard.csv", "sds_g,annual_rate\n0.2,0.01\n1,0.001\n3,0.0001\n");
  std::filesystem::copy(GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml",
                        folder_.path("suite.toml"));
  std::string text =
      replaced(small_study(), GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml", "suite.toml");
  text = replaced(text, "mu = { mean = 0.3, std = 0.03 }", "file = \"pulls.csv\"");
  folder_.write("study.toml", text + "[hazard]\ncurve = \"hazard.csv\"\ndesign_life_years = 25\n");
  const std::string out = folder_.path("out").string();
  const std::string here = "cd '" + folder_.path("").string() + "' && ";
  const Finished alone = run_shell(here + "\"$0\" run study.toml --out alone");
  ASSERT_EQ(alone.status, 0) << alone.err;
  const std::vector<std::string> run{"run", "study.toml", "--out", out};
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path(""));
  const Finished child = run_on_two({1, {}, elsewhere}, run);
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_TRUE(read_file(out + "/results.h5") == read_file(folder_.path("alone/results.h5")));
  expect_refused_once(run_on_two({0, {}, elsewhere}, {"check", "study.toml"}),
                      "study.toml: cannot be read");
  std::filesystem::current_path(before);
}

TEST_F(Mpi, more_ranks_than_processors_say_nothing_of_threads) {
  const std::string study = folder_.write("study.toml", short_study());
  const Finished child =
      run_child({"taskset", "-c", "0", "mpirun", "--bind-to", "none", "-n", "3", GLISSADE_PROGRAM,
                 "run", study, "--out", folder_.path("out").string()});
  EXPECT_EQ(child.status, 0);
  EXPECT_EQ(child.err, "");
}

TEST_F(Mpi, an_input_error_is_reported_once_by_three_ranks) {
  const std::string study =
      folder_.write("study.toml", replaced(small_study(), "[0.05, 0.2]", "[-0.05]"));
  const std::string out = folder_.path("out").string();
  expect_refused_once(run_on(3, {"run", study, "--out", out}),
                      "study.toml:24: fragility.thresholds_m = -0.05 is not above 0");
  EXPECT_EQ(folder_.contents(), std::vector<std::string>{"study.toml"});
}

TEST_F(Mpi, a_command_line_error_is_reported_once_by_three_ranks) {
  expect_refused_once(run_on(3, {"run"}), "study is required");
  expect_refused_once(run_on(3, {"slid"}), "did you mean slide?");
  expect_refused_once(run_on(3, {"run", "s.toml", "--out", ""}), "--out: is given an empty value");
  expect_refused_once(run_on(3, {"run", "s.toml", "--walltime-s", "5 in"}), "--walltime-s");
  expect_refused_once(run_on(3, {"clearance"}), "no project file");
}

TEST_F(Mpi, a_results_folder_in_use_is_reported_once_by_three_ranks) {
  const std::string study = folder_.write("study.toml", small_study());
  std::filesystem::create_directory(folder_.path("out"));
  folder_.write("out/results.h5", "an earlier run");
  expect_refused_once(run_on(3, {"run", study, "--out", folder_.path("out").string()}),
                      "holds a run");
}

TEST_F(Mpi, the_other_commands_answer_once_on_three_ranks) {
  const Finished child = run_on(3, {"standards", "--sds-g", "1.5", "--json"});
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_EQ(child.out, run_program({"standards", "--sds-g", "1.5", "--json"}).out);
  expect_refused_once(run_on(3, {"fit"}), "needs one of --counts");
}

TEST_F(Mpi, a_dry_run_prints_one_plan_on_three_ranks) {
  const std::string study = folder_.write("study.toml", small_study());
  EXPECT_EQ(run_on(3, {"run", study, "--dry-run"}).out,
            run_program({"run", study, "--dry-run"}).out);
}

}  // namespace
}  // namespace glissade::test
