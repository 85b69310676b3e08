// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/child.hpp"
#include "cli/small_study.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

class Stripes : public testing::Test {
 protected:
  std::string study(const std::string& text) const { return folder_.write("study.toml", text); }
  ScratchFolder folder_;
};

TEST_F(Stripes, are_run_reported_and_reported_again_from_their_results) {
  const std::string out = folder_.path("out").string(), again = folder_.path("again").string();
  const Finished child = succeeding({"run", study(stripes_study()), "--out", out});
  EXPECT_THAT(child.out, states("14 records x 8 samples x 1 of 2 levels", "scatter less",
                                "suite.stripes", "0 in search of"));
  const std::string fits = read_file(out + "/tables/fragility.csv");
  EXPECT_THAT(fits, states("sampled,0.05,stripes"));
  EXPECT_THAT(fits, testing::Not(states("capacities")));
  EXPECT_THAT(read_file(out + "/tables/stripes.csv"), states("sampled,0.05,0.4,56,"));
  EXPECT_FALSE(std::filesystem::exists(out + "/figures/ida.svg"));
  EXPECT_FALSE(std::filesystem::exists(out + "/tables/recrossing.csv"));
  EXPECT_THAT(read_file(out + "/report.html"), states("Each level has records of its own"));
  const Finished report = succeeding({"report", out + "/results.h5", "--out", again});
  for (const char* table : {"fragility", "fragility_band", "slip", "stripes", "samples"})
    EXPECT_EQ(read_file(again + "/tables/" + table + ".csv"),
              read_file(out + "/tables/" + table + ".csv"))
        << table;
}

TEST_F(Stripes, in_parts_give_the_bits_of_the_whole) {
  const std::string text = study(stripes_study()), whole = folder_.path("whole").string(),
                    merged = folder_.path("merged").string();
  ASSERT_EQ(run_program({"run", text, "--out", whole}).status, 0);
  std::vector<std::string> merge{"merge"};
  for (const char* part : {"1/2", "2/2"}) {
    merge.push_back(folder_.path(std::string("part") + part[0]).string());
    succeeding({"run", text, "--out", merge.back(), "--part", part});
  }
  merge.insert(merge.end(), {"--out", merged});
  succeeding(merge);
  EXPECT_TRUE(read_file(merged + "/results.h5") == read_file(whole + "/results.h5"));
}

TEST_F(Stripes, refuse_what_needs_a_record_at_all_levels) {
  const auto refused = [&](const std::string& table, const std::string& name) {
    expect_refused(run_program({"check", study(stripes_study() + table)}),
                   {name + " reads each record at every level", "suite.stripes"});
  };
  refused("[shape]\n", "[shape]");
  refused("[sensitivity]\n", "[sensitivity]");
  refused("[intensity_measures]\n", "[intensity_measures]");
  refused("[impact]\n", "[impact]");
  refused("[base_shear]\n", "[base_shear]");
  refused("[hazard]\nk0 = 1e-4\nk = 2.5\n", "[hazard]");
  expect_refused(run_program({"check", study(replaced(stripes_study(), "thresholds_m",
                                                      "stop_at_largest = true\nthresholds_m"))}),
                 {"fragility.stop_at_largest needs a study without suite.stripes"});
}

TEST_F(Stripes, are_as_many_as_the_levels) {
  expect_refused(run_program({"check", study(replaced(stripes_study(), "[0.4, 1.5]", "[0.4]"))}),
                 {"suite.stripes has 2 suites, and intensity.levels 1 level"});
  expect_refused(run_program({"check", study(replaced(stripes_study(),
                                                      "stripes =", "file = \"a\"\nstripes ="))}),
                 {"suite.stripes and suite.file are both given"});
  expect_refused(
      run_program({"check", study(replaced(stripes_study(), "sa_period_s = 0.5\n", ""))}),
      {"sa_period_s"});
  expect_refused(run_program({"check", study(replaced(stripes_study(), "sa_rotd50_g", "pga_g"))}),
                 {"intensity.sa_period_s needs measure = sa_g or sa_rotd50_g"});
}

}  // namespace
}  // namespace glissade::test
