// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "mpi/kill.hpp"
#include "mpi/mpirun.hpp"
#include "sanitized.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;

/// Still under way when the ranks notice that mpirun is dead.
std::string long_study() {
  return replaced(small_study(), "samples = 8", "samples = " + std::to_string(128 / slowdown));
}

/// Beside the results of one process that nothing disturbed.
class Kills : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    study_ = folder_->write("study.toml", long_study());
    run_program({"run", study_, "--out", folder_->path("whole").string()});
    whole_ = read_file(folder_->path("whole/results.h5"));
  }
  void SetUp() override {
    if (!mpirun_is_there()) GTEST_SKIP() << "mpirun is not installed";
    ASSERT_FALSE(whole_.empty());
  }
  ~Kills() override { fs::remove_all(out_); }
  static void TearDownTestSuite() {
    delete folder_;
    folder_ = nullptr;
  }

  void expect_resumed_on(int ranks) const {
    const Finished child = run_on(ranks, {"run", "--resume", out_.string()});
    EXPECT_EQ(child.status, 0) << child.err;
    EXPECT_TRUE(read_file(out_ / "results.h5") == whole_);
    EXPECT_FALSE(fs::exists(out_ / "journal"));
  }
  void expect_killed(Victim victim, int ranks, int ranks_of_the_resumed) const {
    const Killed killed = kill_run(study_, out_, {victim, ranks, some_units_are_done});
    EXPECT_TRUE(killed.under_way);
    EXPECT_FALSE(fs::exists(out_ / "results.h5"));
    expect_resumed_on(ranks_of_the_resumed);
  }

  static inline ScratchFolder* folder_ = nullptr;
  static inline std::string study_, whole_;
  fs::path out_ = folder_ ? folder_->path("out") : fs::path();
};

TEST_F(Kills, a_run_whose_last_rank_is_killed_goes_on_alone) {
  expect_killed(Victim::last_rank, 3, 1);
}
TEST_F(Kills, a_run_whose_root_is_killed_goes_on_on_more_ranks) {
  expect_killed(Victim::root, 2, 3);
}
TEST_F(Kills, a_run_whose_ranks_are_all_killed_goes_on) { expect_killed(Victim::all_ranks, 3, 2); }
TEST_F(Kills, a_run_whose_mpirun_is_killed_goes_on) { expect_killed(Victim::mpirun, 2, 2); }

TEST_F(Kills, a_signal_that_mpirun_passes_on_stops_every_rank_with_status_75) {
  Child child(mpirun_command(3, {"run", study_, "--out", out_.string()}));
  ASSERT_TRUE(reaches(child, [&] { return some_units_are_done(out_); }));
  ::kill(child.pid(), SIGUSR1);
  const Finished finished = child.wait();
  EXPECT_EQ(finished.status, 75) << finished.err;
  EXPECT_THAT(finished.err, testing::HasSubstr("stopped by SIGUSR1"));
  expect_resumed_on(2);
}

TEST_F(Kills, a_signal_to_one_rank_stops_every_rank) {
  Child child(mpirun_command(3, {"run", study_, "--out", out_.string()}));
  ASSERT_TRUE(reaches(child, [&] { return some_units_are_done(out_); }));
  ::kill(ranks_of(child).back(), SIGTERM);
  const Finished finished = child.wait();
  EXPECT_EQ(finished.status, 75) << finished.err;
  EXPECT_THAT(finished.err, testing::HasSubstr("stopped by SIGTERM"));
  expect_resumed_on(3);
}

TEST_F(Kills, ctrl_c_of_mpirun_loses_nothing) {
  Child child(mpirun_command(2, {"run", study_, "--out", out_.string()}));
  ASSERT_TRUE(reaches(child, [&] { return some_units_are_done(out_); }));
  ::kill(child.pid(), SIGINT);
  EXPECT_NE(child.wait().status, 0);
  EXPECT_GT(journal_bytes(out_), 1000u);
  expect_resumed_on(2);
}

}  // namespace
}  // namespace glissade::test
