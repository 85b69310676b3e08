// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/one_run.hpp"
#include "cli/small_study.hpp"

// What a run does where the system fails it (inject.cpp, faults.cpp).
namespace glissade::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Faults : public OneRun<short_study> {
 protected:
  ~Faults() override { fs::remove_all(again_); }

  Finished run_with(const std::string& faults, const std::string& options = "") const {
    return run_shell(faults + " \"$0\" run '" + study_ + "' --out '" + again_.string() + "' " +
                     options);
  }
  const std::string library_ = " LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY;

  fs::path again_ = folder_->path("again");
};

TEST_F(Faults, a_file_that_the_disk_does_not_give_back_is_refused) {
  for (const char* file : {"results.h5", "run.json"}) {
    for (const char* at : {"FAULT_AT=1", "FAULT_AT=2", "FAULT_FROM=1"}) {
      expect_refused(
          run_shell("FAULT_CALLS=read FAULT_ERRNO=5 " + std::string(at) + " FAULT_IN=" + file +
                    " " GLISSADE_INJECT " \"$0\" report '" + (out() / "results.h5").string() +
                    "' --out '" + again_.string() + "'"),
          {file, "cannot be read: Input/output error"});
    }
  }
}

TEST_F(Faults,
       a_disk_that_is_full_after_the_results_leaves_a_run_that_is_started_and_can_be_resumed) {
  const Finished failed =
      run_with("FAULT_IN=run.json FAULT_CALLS=rename FAULT_FROM=1 FAULT_ERRNO=28 " GLISSADE_INJECT);
  EXPECT_EQ(failed.status, 2) << failed.err;
  EXPECT_THAT(failed.err, HasSubstr("is complete"));
  EXPECT_THAT(read_file(again_ / "run.json"), HasSubstr("\"started\""));
  EXPECT_EQ(run_program({"report", "--overwrite", (again_ / "results.h5").string()}).status, 0);
  succeeding({"run", "--resume", again_.string()});
  EXPECT_THAT(read_file(again_ / "run.json"), HasSubstr("\"finished\""));
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_FALSE(fs::exists(again_ / "journal"));
}

// The journals are flushed to the disk before the results are made of them. How far the run comes
// without more memory depends on what it has free by then; HDF5 can end it by a signal.
TEST_F(Faults, memory_that_ends_after_the_histories_leaves_a_run_that_can_be_resumed) {
  const std::string study =
      folder_->write("large.toml", replaced(short_study(), "samples = 2", "samples = 256"));
  const fs::path whole = folder_->path("whole");
  ASSERT_EQ(run_program({"run", study, "--out", whole.string()}).status, 0);
  const Finished failed = run_shell(
      "FAULT_MEMORY=1 FAULT_IN=.units LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY " \"$0\" run '" + study +
      "' --out '" + again_.string() + "'");
  ASSERT_GE(failed.status, 2) << failed.err;
  const auto json = nlohmann::json::parse(read_file(again_ / "run.json"));
  if (json.at("status") == "stopped") {
    EXPECT_FALSE(fs::exists(again_ / "results.h5"));
    EXPECT_EQ(json.at("what_to_do"), "glissade run --resume " + again_.string());
  } else if (failed.status == 2) {
    EXPECT_EQ(json.at("status"), "results written, report missing");
  } else {
    EXPECT_NE(json.at("status"), "finished");
  }
  succeeding({"run", "--resume", again_.string()});
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(whole / "results.h5"));
}

TEST_F(Faults, a_disk_with_less_room_than_the_results_need_is_refused_before_the_run) {
  // 20 MB for report and figures, and twice the histories, which are small here.
  expect_refused(run_with("FAULT_FREE_MB=20" + library_),
                 {"again", "20 MB free", "make room", "--out"});
  EXPECT_FALSE(fs::exists(again_));
  EXPECT_EQ(run_with("FAULT_FREE_MB=21" + library_).status, 0);
}

TEST_F(Faults, a_dry_run_sees_that_the_disk_is_read_only) {
  const Finished child =
      run_with("FAULT_CALLS=access FAULT_ERRNO=30 FAULT_FROM=1 " GLISSADE_INJECT, "--dry-run");
  EXPECT_EQ(child.status, 2);
  EXPECT_THAT(child.out, HasSubstr("units"));  // the plan all the same
  EXPECT_THAT(child.err, testing::AllOf(HasSubstr("again"), HasSubstr("Read-only file system"),
                                        HasSubstr("--out")));
}

// A limit of processes or of address space.
TEST_F(Faults, a_system_that_starts_no_thread_gives_the_same_results) {
  const Finished child = run_with("FAULT_THREADS=1" + library_);
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_EQ(child.err, "");
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  const Finished report = run_shell("FAULT_THREADS=1 LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY
                                    " \"$0\" report --overwrite '" +
                                    (again_ / "results.h5").string() + "'");
  EXPECT_EQ(report.status, 0) << report.err;
}

TEST_F(Faults, a_clock_that_is_set_during_the_run_neither_stops_it_nor_changes_its_results) {
  const Finished child = run_with("FAULT_CLOCK=1" + library_, "--walltime-s 3600");
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_EQ(child.out.find("-86"), std::string::npos) << child.out;  // no seconds of a day
}

}  // namespace
}  // namespace glissade::test
