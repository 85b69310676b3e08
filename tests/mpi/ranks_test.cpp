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

TEST_F(Mpi, one_two_three_and_seven_ranks_give_the_bytes_of_none) {
  // Samples enough that the ranks overtake one another.
  const std::string study =
      folder_.write("study.toml", replaced(small_study(), "samples = 8", "samples = 32"));
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {1, 2, 3, 7})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
}

TEST_F(Mpi, the_ranks_of_a_machine_store_the_samples_of_motions_once) {
  for (const char* ranks : {"1", "2", "5"}) {
    const Finished child = run_child({"mpirun", "-n", ranks, GLISSADE_SHARED_NUMBERS});
    EXPECT_EQ(child.status, 0) << child.err;
  }
}

TEST_F(Mpi, a_machine_without_room_in_shared_memory_gives_the_same_bytes) {
  if (run_shell("unshare --mount true").status != 0) GTEST_SKIP() << "needs root: unshare --mount";
  const std::string study = folder_.write("study.toml", small_study());
  const std::string alone = results_on(0, study), out = folder_.path("little").string();
  ASSERT_FALSE(alone.empty());
  const Finished child =
      run_shell("unshare --mount sh -c 'mount -t tmpfs -o size=1M tmpfs /dev/shm && mpirun -n 3 " +
                std::string(GLISSADE_PROGRAM) + " run " + study + " --out " + out + "'");
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_TRUE(read_file(out + "/results.h5") == alone);
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
              testing::HasSubstr("in 1 units"));  // fewer than ranks
  const std::string alone = results_on(0, study);
  ASSERT_FALSE(alone.empty());
  for (const int ranks : {2, 7})
    EXPECT_TRUE(results_on(ranks, study) == alone) << ranks << " ranks";
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
