// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>
#include <unistd.h>

#include "cli/child.hpp"
#include "cli/small_study.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;

class RunInput : public testing::Test {
 protected:
  /// The small study with one line changed must be refused, and leave nothing behind.
  void expect_study_refused(const std::string& from, const std::string& to,
                            std::vector<std::string> parts) const {
    SCOPED_TRACE(to);
    const std::string study = folder_.write("study.toml", replaced(small_study(), from, to));
    expect_refused(run_program({"run", study, "--out", folder_.path("out").string()}), parts);
    EXPECT_EQ(folder_.contents(), std::vector<std::string>{"study.toml"});
  }
  ScratchFolder folder_;
};

TEST_F(RunInput, a_missing_study_is_named) {
  expect_refused(run_program({"run", folder_.path("none.toml").string()}),
                 {"none.toml", "No such file"});
}

TEST_F(RunInput, that_is_wrong_is_reported_with_its_line) {
  expect_study_refused("seed = 7", "seed = ", {"study.toml:3"});
  expect_study_refused("thresholds_m =", "treshold_m =",
                       {"study.toml:24: fragility.treshold_m is not a known key",
                        "did you mean thresholds_m?", "\n  treshold_m = [0.05, 0.2]\n  ^"});
  expect_study_refused(
      "thresholds_m = [0.05, 0.2]", "thresholds_in = [2, 8]",
      {"study.toml:24", "fragility.thresholds_in", "did you mean thresholds_m, in m"});
  expect_study_refused("[building]", "[bulding]",
                       {"study.toml:12", "bulding", "did you mean building?"});
  expect_study_refused("\"sds_g\"", "\"sds\"",
                       {"study.toml:9", "intensity.measure = \"sds\"", "sds_g"});
  expect_study_refused("[0.05, 0.2]", "[-0.05, 0.2]", {"study.toml:24", "-0.05 is not above 0"});
  expect_study_refused("[0.5, 1.0, 2.0]", "[0, 1.0, 2.0]", {"study.toml:10", "0 is not above 0"});
  expect_study_refused("[0.5, 1.0, 2.0]", "[0.5, inf]", {"study.toml:10", "not finite"});
  expect_study_refused("[0.5, 1.0, 2.0]", "[]", {"study.toml:10", "empty"});
  expect_study_refused("[0.5, 1.0, 2.0]", "[0.5, 2.0, 1.0]",
                       {"study.toml:10", "2 is followed by 1"});
  expect_study_refused("mean = 0.3", "mean = \"0.3\"",
                       {"study.toml:16", "friction.mu.mean", "not a number", "quotes"});
  expect_study_refused("[friction]", "[roof]\nslope_deg = 95\n[friction]",
                       {"study.toml:16", "slope_deg", "95"});
  expect_study_refused("[friction]", "[roof]\nslope_deg = 1\nrise_in_12 = 0.25\n[friction]",
                       {"study.toml:16", "roof.slope_deg", "roof.rise_in_12", "both"});
  expect_study_refused("measure = \"sds_g\"", "measure = \"pga_g\"", {"[standards]", "sds_g"});
  expect_study_refused("measure = \"sds_g\"", "measure = \"sds_g\"\nsa_period_s = 1.0",
                       {"study.toml:10", "sa_period_s", "sa_g"});
  expect_study_refused("samples = 8", "samples = 10", {"study.toml:20", "power of two", "8 or 16"});
  expect_study_refused("mu = { mean = 0.3, std = 0.03 }\n", "", {"friction.mu is missing"});
  expect_study_refused("synthetic_level0", "synthetic_level9",
                       {"study.toml:6", "synthetic_level9.toml"});
}

TEST_F(RunInput, everything_wrong_is_reported_at_once) {
  std::string text = replaced(small_study(), "samples = 8", "samples = 0");
  text = replaced(text, "[0.05, 0.2]", "[-1]");
  text = replaced(text, "max = 1.0", "max = 0.1");
  text = replaced(text, "seaoc_pv1_2012", "seaoc");
  const std::string study = folder_.write("study.toml", text);
  expect_refused(
      run_program({"run", study, "--out", folder_.path("out").string()}),
      {"study.toml:13", "study.toml:20", "study.toml:24", "study.toml:27", "seaoc_pv1_2012"});
}

TEST_F(RunInput, a_suite_whose_record_is_bad_leaves_no_folder) {
  folder_.write("record.txt", "0.1\nnan\n");
  folder_.write("suite.toml", suite_of_one_record());
  const std::string study = folder_.write(
      "study.toml",
      replaced(small_study(), GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml", "suite.toml"));
  expect_refused(run_program({"run", study, "--out", folder_.path("out").string()}),
                 {"record.txt:2", "nan"});
  EXPECT_FALSE(fs::exists(folder_.path("out")));
}

TEST_F(RunInput, a_folder_that_holds_a_run_is_never_written_into) {
  const std::string study = folder_.write("study.toml", small_study()),
                    out = folder_.path("out").string();
  fs::create_directory(out);
  folder_.write("out/results.h5", "an earlier run");
  const std::vector<std::string> before = folder_.contents();
  expect_refused(run_program({"run", study, "--out", out}), {out, "holds a run", "--out"});
  EXPECT_EQ(folder_.contents(), before);
  EXPECT_EQ(read_file(folder_.path("out/results.h5")), "an earlier run");
}

TEST_F(RunInput, a_file_is_not_a_results_folder) {
  const std::string study = folder_.write("study.toml", small_study()),
                    out = folder_.write("out", "a file");
  expect_refused(run_program({"run", study, "--out", out}), {out, "not a folder", "--out"});
  EXPECT_EQ(read_file(out), "a file");
}

TEST_F(RunInput, a_folder_that_cannot_be_made_is_reported_before_any_work) {
  const std::string study = folder_.write("study.toml", small_study());
  expect_refused(run_program({"run", study, "--out", study + "/out"}),
                 {"study.toml/out", "cannot be made", "Not a directory", "--out"});
}

TEST_F(RunInput, a_dry_run_says_that_the_folder_could_not_be_written_to) {
  const std::string study = folder_.write("study.toml", small_study());
  const fs::path locked = folder_.path("locked");
  fs::create_directory(locked);
  fs::permissions(locked, fs::perms::owner_read | fs::perms::owner_exec);
  // root without its right to write everywhere, which its programs do not have either
  const std::string unprivileged =
      ::geteuid() == 0 ? "setpriv --bounding-set=-all \"$0\"" : "\"$0\"";
  const auto check = [&](const std::string& command, const fs::path& out) {
    return run_shell(unprivileged + " " + command + " '" + study + "' --out '" + out.string() +
                     "'");
  };
  if (run_shell(unprivileged.substr(0, unprivileged.find('"')) + "true").status != 0)
    GTEST_SKIP() << "setpriv cannot give up the rights of root here";
  EXPECT_EQ(check("check", folder_.path("free")).status, 0);
  for (const fs::path& out : {locked, locked / "new", locked / "two" / "folders"}) {
    const Finished child = check("check", out);
    EXPECT_EQ(child.status, 2);
    EXPECT_THAT(child.out, testing::HasSubstr("units"));  // the plan all the same
    EXPECT_EQ(child.out.find("folder "), std::string::npos) << child.out;
    for (const std::string& part :
         {out.string(), locked.string(), std::string("Permission denied"), std::string("--out")})
      EXPECT_THAT(child.err, testing::HasSubstr(part));
    expect_refused(check("run", out), {out.string(), "Permission denied", "--out"});
  }
  fs::permissions(locked, fs::perms::owner_all);
}

}  // namespace
}  // namespace glissade::test
