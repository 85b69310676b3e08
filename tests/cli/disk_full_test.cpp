// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/child.hpp"
#include "cli/small_study.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;

// A limit on the size of files (`ulimit -f`, in blocks of 512 bytes) stands for the full disk where
// a file is cut off half way; /dev/full is one that is full from the start.

class DiskFull : public testing::Test {
 protected:
  ScratchFolder folder_;
  std::string record_ =
      folder_.write("push.txt", "# acceleration_g\n0.5\n0.5\n0.5\n0.5\n0.5\n0.5\n");
  std::string slide_ = "\"$0\" slide '" + record_ + "' --dt-s 0.01 --mu 0.1 --slope-deg 1 ";
};

TEST_F(DiskFull, a_history_on_a_full_disk_is_reported) {
  expect_refused(run_shell(slide_ + "--history /dev/full --json"),
                 {"/dev/full", "No space left on device", "make room"});
}

TEST_F(DiskFull, a_full_standard_output_is_reported) {
  for (const std::string& command :
       {slide_ + "--json", slide_, std::string("\"$0\" standards --sds-g 1 --json")}) {
    expect_refused(run_shell(command + " >/dev/full"),
                   {"standard output", "No space left on device"});
  }
}

TEST_F(DiskFull, no_half_of_a_history_is_left) {
  std::string long_record = "# acceleration_g\n";
  for (int i = 0; i < 2000; ++i) long_record += "0.5\n";
  folder_.write("push.txt", long_record);  // a history of some 100 kB
  const std::string history = folder_.path("history.csv").string();
  expect_refused(run_shell("ulimit -f 20; " + slide_ + "--history '" + history + "'"),
                 {"history.csv", "File too large"});
  EXPECT_EQ(folder_.contents(), (std::vector<std::string>{"push.txt"}));
}

TEST_F(DiskFull, an_older_history_is_not_written_over) {
  folder_.write("push.txt", "# acceleration_g\n0.5\n");
  const std::string history = folder_.write("history.csv", "an older one");
  expect_refused(run_shell(slide_ + "--history '" + history + "'"),
                 {"--history", "history.csv", "--overwrite"});
  EXPECT_EQ(read_file(history), "an older one");
}

// A limit on the address space stands for the full memory. Where it is met depends on the limit: in
// the histories, in what is made of them, in the report.
TEST_F(DiskFull,
       a_run_out_of_memory_leaves_its_folder_free_or_can_be_resumed_or_says_what_is_whole) {
  const std::string study =
      folder_.write("study.toml", replaced(replaced(small_study(), "samples = 8", "samples = 2048"),
                                           "[building]", "[model]\naxes = 1\n\n[building]"));
  const fs::path out = folder_.path("out");
  for (int limit_kb = 40000; limit_kb <= 64000; limit_kb += 4000) {
    const Finished child = run_shell("ulimit -v " + std::to_string(limit_kb) + "; \"$0\" run '" +
                                     study + "' --out '" + out.string() + "'");
    if (child.status == 0) break;
    if (fs::exists(out / "results.h5")) {
      EXPECT_THAT(read_file(out / "run.json"), testing::HasSubstr("glissade report --overwrite"));
    } else if (fs::exists(out)) {
      const Finished resumed = run_program({"run", "--resume", out.string()});
      EXPECT_EQ(resumed.status, 0) << limit_kb << child.err << resumed.err;
    }
    fs::remove_all(out);
  }
}

TEST_F(DiskFull, results_that_fit_are_kept_when_the_report_does_not) {
  const std::string study = folder_.write("study.toml", small_study()),
                    out = folder_.path("out").string();
  ASSERT_EQ(run_program({"run", study, "--out", folder_.path("whole").string()}).status, 0);
  const fs::path whole = folder_.path("whole");
  const auto size = fs::file_size(whole / "results.h5");
  ASSERT_GT(fs::file_size(whole / "report.html"),
            size + 512);  // else the limit would not part them
  expect_refused(run_shell("ulimit -f " + std::to_string(size / 512 + 1) + "; \"$0\" run '" +
                           study + "' --out '" + out + "'"),
                 {"results.h5: is complete", "glissade report"});
  EXPECT_TRUE(read_file(out + "/results.h5") == read_file(whole / "results.h5"));
}

}  // namespace
}  // namespace glissade::test
