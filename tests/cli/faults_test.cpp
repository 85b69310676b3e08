// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/child.hpp"
#include "cli/one_run.hpp"
#include "cli/small_study.hpp"

// Runs beside which the disk fills or becomes read-only at some call of the system, or the clock is
// set (faults.cpp). GLISSADE_FAULTS=all: at every call, for tests/README.md.
namespace glissade::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A tenth of a second.
std::string short_study() {
  return replaced(replaced(small_study(), "samples = 8", "samples = 2"), "[building]",
                  "[model]\naxes = 1\n\n[building]");
}

class Faults : public OneRun<short_study> {
 protected:
  ~Faults() override { fs::remove_all(again_); }

  Finished run_with(const std::string& variables, const std::string& options = "") const {
    return run_shell(variables + " LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY " \"$0\" run '" + study_ +
                     "' --out '" + again_.string() + "' " + options);
  }
  int writing_calls() const {
    const std::string count = folder_->path("count").string();
    EXPECT_EQ(run_with("FAULT_COUNT='" + count + "'").status, 0);
    fs::remove_all(again_);
    return std::stoi("0" + read_file(count));
  }
  /// What is left is whole, and what the message says makes the rest.
  void expect_mended(const Finished& failed) const {
    const std::string out = again_.string();
    std::vector<std::string> mend{"run", study_, "--out", out, "--overwrite"};
    if (fs::exists(again_ / "results.h5")) {
      EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(this->out() / "results.h5"));
      if (failed.status == 0) return;
      EXPECT_THAT(failed.err, HasSubstr("is complete"));
      mend = {"report", "--overwrite", out + "/results.h5"};
    } else if (fs::exists(again_ / "journal/run")) {
      mend = {"run", "--resume", out};
    }
    EXPECT_EQ(failed.status, 2) << failed.err;
    EXPECT_THAT(failed.err, testing::StartsWith("glissade: "));
    const Finished mended = run_program(mend);
    EXPECT_EQ(mended.status, 0) << mended.err;
    EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(this->out() / "results.h5"));
    EXPECT_THAT(read_file(again_ / "report.html"), HasSubstr("</html>"));
  }
  /// At the first calls, in which the folder is taken, and at some of the others; or at all.
  void expect_mended_at_every_stage(int error) const {
    const int calls = writing_calls();
    ASSERT_GT(calls, 20);
    const bool every_call = getenv("GLISSADE_FAULTS") != nullptr;
    int stages = 0;
    for (int at = 1; at <= calls; at += every_call || at < 8 ? 1 : std::max(1, calls / 6)) {
      const Finished failed =
          run_with("FAULT_ERRNO=" + std::to_string(error) + " FAULT_FROM=" + std::to_string(at));
      SCOPED_TRACE("call " + std::to_string(at) + " of " + std::to_string(calls) + ": " +
                   failed.err);
      expect_mended(failed);
      fs::remove_all(again_);
      ++stages;
    }
    std::printf("%d of %d writing calls failed\n", stages, calls);
  }

  fs::path again_ = folder_->path("again");
};

TEST_F(Faults, a_disk_that_fills_at_any_stage_leaves_what_is_whole_and_a_way_on) {
  expect_mended_at_every_stage(ENOSPC);
}
TEST_F(Faults, a_disk_that_becomes_read_only_at_any_stage_leaves_what_is_whole_and_a_way_on) {
  expect_mended_at_every_stage(EROFS);
}

// The last call would write run.json.
TEST_F(Faults,
       a_disk_that_is_full_after_the_results_leaves_a_run_that_is_started_and_can_be_resumed) {
  const Finished failed = run_with("FAULT_ERRNO=" + std::to_string(ENOSPC) +
                                   " FAULT_FROM=" + std::to_string(writing_calls() - 2));
  EXPECT_EQ(failed.status, 2) << failed.err;
  EXPECT_THAT(failed.err, HasSubstr("is complete"));
  EXPECT_THAT(read_file(again_ / "run.json"), HasSubstr("\"started\""));
  EXPECT_EQ(run_program({"report", "--overwrite", (again_ / "results.h5").string()}).status, 0);
  EXPECT_THAT(read_file(again_ / "run.json"), HasSubstr("\"started\""));
  const Finished resumed = run_program({"run", "--resume", again_.string()});
  EXPECT_EQ(resumed.status, 0) << resumed.err;
  EXPECT_THAT(read_file(again_ / "run.json"), HasSubstr("\"finished\""));
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_FALSE(fs::exists(again_ / "journal"));
}

// The journals are flushed to the disk before the results are made of them. How far the run comes
// without more memory depends on what it has free by then.
TEST_F(Faults, memory_that_ends_after_the_histories_never_leaves_a_run_that_is_started) {
  const std::string study =
      folder_->write("large.toml", replaced(short_study(), "samples = 2", "samples = 256"));
  const fs::path whole = folder_->path("whole");
  ASSERT_EQ(run_program({"run", study, "--out", whole.string()}).status, 0);
  const Finished failed = run_shell(
      "FAULT_MEMORY=1 FAULT_IN=.units LD_PRELOAD=" GLISSADE_FAULTS_LIBRARY " \"$0\" run '" + study +
      "' --out '" + again_.string() + "'");
  EXPECT_EQ(failed.status, 2) << failed.err;
  const auto json = nlohmann::json::parse(read_file(again_ / "run.json"));
  if (json.at("status") == "stopped") {
    EXPECT_FALSE(fs::exists(again_ / "results.h5"));
    EXPECT_EQ(json.at("what_to_do"), "glissade run --resume " + again_.string());
    const Finished resumed = run_program({"run", "--resume", again_.string()});
    EXPECT_EQ(resumed.status, 0) << resumed.err;
  } else {
    EXPECT_EQ(json.at("status"), "results written, report failed");
  }
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(whole / "results.h5"));
}

TEST_F(Faults, a_disk_with_less_room_than_the_results_need_is_refused_before_the_run) {
  // 20 MB for report and figures, and twice the histories, which are small here.
  expect_refused(run_with("FAULT_FREE_MB=20"), {"again", "20 MB free", "make room", "--out"});
  EXPECT_FALSE(fs::exists(again_));
  EXPECT_EQ(run_with("FAULT_FREE_MB=21").status, 0);
}

TEST_F(Faults, a_dry_run_sees_that_the_disk_is_read_only) {
  const Finished child =
      run_with("FAULT_ERRNO=" + std::to_string(EROFS) + " FAULT_FROM=1", "--dry-run");
  EXPECT_EQ(child.status, 2);
  EXPECT_THAT(child.out, HasSubstr("units"));  // the plan all the same
  EXPECT_THAT(child.err, testing::AllOf(HasSubstr("again"), HasSubstr("Read-only file system"),
                                        HasSubstr("--out")));
}

TEST_F(Faults, a_clock_that_is_set_during_the_run_neither_stops_it_nor_changes_its_results) {
  const Finished child = run_with("FAULT_CLOCK=1", "--walltime-s 3600");
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_TRUE(read_file(again_ / "results.h5") == read_file(out() / "results.h5"));
  EXPECT_EQ(child.out.find("-86"), std::string::npos) << child.out;  // no seconds of a day
}

}  // namespace
}  // namespace glissade::test
