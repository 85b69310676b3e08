// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <gmock/gmock.h>
#include <stdlib.h>
#include <unistd.h>

#include "cli/child.hpp"
#include "cli/killed_run.hpp"
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

TEST_F(DiskFull, a_standard_output_that_is_full_or_closed_is_reported_by_every_command) {
  const std::string study = "'" + folder_.write("study.toml", small_study()) + "'";
  const std::string suite = GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml";
  for (const std::string& arguments :
       {std::string("--version"), std::string("--help"), std::string("run --help"),
        std::string("explain"), std::string("explain mu"), std::string("clearance --example"),
        std::string("standards --sds-g 1 --json"), "suite show " + suite, "check " + study,
        "init --overwrite --suite " + suite + " '" + folder_.path("new.toml").string() + "'",
        slide_.substr(5), slide_.substr(5) + "--json"}) {
    SCOPED_TRACE(arguments);
    expect_refused(run_shell("\"$0\" " + arguments + " >/dev/full"),
                   {"standard output", "No space left on device"});
    expect_refused(run_shell("\"$0\" " + arguments + " >&-"),
                   {"standard output", "Bad file descriptor"});
  }
  EXPECT_EQ(run_shell("\"$0\" explain | head -1").err, "");  // the reader has what it wanted
}

TEST_F(DiskFull, messages_that_cannot_be_written_change_no_exit_status) {
  const std::string study = "'" + folder_.write("study.toml", short_study()) + "'",
                    out = "'" + folder_.path("out").string() + "'";
  for (const char* to : {" 2>/dev/full", " 2>&-"}) {
    SCOPED_TRACE(to);
    EXPECT_EQ(run_shell("\"$0\" run" + std::string(to)).status, 2);
    EXPECT_EQ(run_shell("\"$0\" run " + study + " --walltime-s 0.01 --out " + out + to).status, 75);
    EXPECT_EQ(run_shell("\"$0\" run --resume " + out + to).status, 0);
    fs::remove_all(folder_.path("out"));
  }
  // A reader that is gone, too: a job script tells a stopped run by 75.
  const Finished stopped = run_child(
      {"bash", "-c",
       "set -o pipefail; \"$0\" run " + study + " --walltime-s 0.01 --out " + out + " | true",
       GLISSADE_PROGRAM});
  EXPECT_EQ(stopped.status, 75);
  // Names that are not UTF-8 are bytes like others.
  EXPECT_EQ(run_shell("\"$0\" run " + study + " --out \"$(printf '" + folder_.path("out").string() +
                      "\\377')\"")
                .status,
            0);
}

// Files that it opens then must not be its standard output or error.
TEST_F(DiskFull, a_run_whose_standard_files_are_closed_writes_the_same_results) {
  const std::string study = folder_.write("study.toml", short_study()),
                    out = folder_.path("out").string(), whole = folder_.path("whole").string();
  ASSERT_EQ(run_program({"run", study, "--out", whole}).status, 0);
  EXPECT_EQ(run_shell("\"$0\" run '" + study + "' --out '" + out + "' <&- >&- 2>&-").status, 2);
  EXPECT_TRUE(read_file(out + "/results.h5") == read_file(whole + "/results.h5"));
  EXPECT_THAT(read_file(out + "/run.json"), testing::HasSubstr("\"finished\""));
  EXPECT_FALSE(fs::exists(out + "/journal"));
}

TEST_F(DiskFull, a_run_whose_terminal_is_gone_goes_on) {
  const int terminal = ::posix_openpt(O_RDWR | O_NOCTTY | O_CLOEXEC);
  ASSERT_TRUE(terminal >= 0 && ::grantpt(terminal) == 0 && ::unlockpt(terminal) == 0);
  const std::string study = folder_.write("study.toml", longer_study()),
                    out = folder_.path("out").string();
  Child child({"/bin/sh", "-c",
               "exec \"$0\" run '" + study + "' --out '" + out + "' 2>" + ::ptsname(terminal),
               GLISSADE_PROGRAM});
  EXPECT_TRUE(reaches(child, [&] { return some_units_are_done(out); }));
  ::close(terminal);
  EXPECT_EQ(child.wait().status, 0);
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
      EXPECT_THAT(read_file(out / "run.json"), testing::HasSubstr("glissade run --resume"));
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
                 {"results.h5: is complete", "glissade run --resume"});
  EXPECT_TRUE(read_file(out + "/results.h5") == read_file(whole / "results.h5"));
}

}  // namespace
}  // namespace glissade::test
