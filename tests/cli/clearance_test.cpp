// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "cli/one_run.hpp"
#include "cli/small_clearance.hpp"
#include "cli/small_study.hpp"
#include "cli/table_rows.hpp"
#include "facts.hpp"
#include "one_line.hpp"

namespace glissade::test {
namespace {

using testing::Not;
namespace fs = std::filesystem;

using Clearance = OneRun<small_clearance>;

TEST_F(Clearance, leaves_results_report_tables_figures_and_its_record) {
  for (const char* name :
       {"results.h5", "run.json", "report.html", "tables/clearances.csv", "tables/by_period.csv",
        "tables/orientations.csv", "tables/histories.csv", "figures/spectra.svg",
        "figures/period.svg", "figures/orientations.svg"}) {
    EXPECT_GT(fs::exists(out() / name) ? fs::file_size(out() / name) : 0, 0u) << name;
  }
  for (const std::string& name : folder_->contents())
    EXPECT_EQ(name.find(".partial"), std::string::npos) << name;
}

TEST_F(Clearance, ends_with_what_came_out) {
  EXPECT_EQ(finished_.err, "");
  EXPECT_THAT(one_line(finished_.out),
              states(std::string("2 conditions"), std::string("3 records of synthetic_level2"),
                     std::string("4 differ"), (out() / "report.html").string()));
}

TEST_F(Clearance, of_a_study_without_base_shear_does_not_mention_it) {
  EXPECT_THAT(finished_.out, Not(testing::ContainsRegex("[Bb]ase shear")));
  for (const char* name : {"report.html", "tables/histories.csv"})
    EXPECT_THAT(read_file(out() / name), Not(testing::ContainsRegex("[Bb]ase shear"))) << name;
}

std::string small_base_shear() {
  const std::string text = replaced(small_clearance(), "small clearance", "small shear");
  return replaced(text.substr(0, text.find("without_target")), "[clearance]", "[base_shear]");
}
using BaseShear = OneRun<small_base_shear>;

TEST_F(BaseShear, is_an_analysis_by_itself) {
  EXPECT_THAT(finished_.out, states("Base shear"));
  EXPECT_THAT(finished_.out, Not(testing::ContainsRegex("[Cc]learance")));
  for (const char* name : {"tables/base_shear.csv", "figures/base_shear.svg"})
    EXPECT_FALSE(read_file(out() / name).empty()) << name;
  EXPECT_FALSE(fs::exists(out() / "tables/clearances.csv"));
  expect_report_gives_again({"tables/base_shear.csv", "report.html"});
}

TEST_F(Clearance, run_json_counts_the_histories_that_were_run) {
  const auto json = nlohmann::json::parse(read_file(out() / "run.json"));
  EXPECT_EQ(json.at("status"), "finished");
  EXPECT_EQ(json.at("histories_integrated"), 3 * 4 * 2);  // records x different orientations x T
}

TEST_F(Clearance, run_json_and_terminal_state_the_orientation_that_counts) {
  const auto json = nlohmann::json::parse(read_file(out() / "run.json"));
  EXPECT_EQ(json.at("required_clearance").at("orientation"), "largest");
  const std::vector<Row> rows = rows_of(read_file(out() / "tables/clearances.csv"));
  ASSERT_EQ(rows.size(), 1u);
  const double clearance_m = number(rows[0], "clearance_m");
  EXPECT_EQ(clearance_m, number(rows[0], "clearance_highest_m"));
  EXPECT_GT(clearance_m, number(rows[0], "clearance_median_m"));
  EXPECT_NEAR(json.at("required_clearance").at("largest_m"), clearance_m, 1e-6);
  EXPECT_THAT(one_line(finished_.out), states("largest"));
}

TEST_F(Clearance, report_makes_the_same_again) {
  expect_report_gives_again({"report.html", "tables/clearances.csv", "tables/histories.csv",
                             "figures/period.svg", "figures/spectra.pdf"});
}

TEST_F(Clearance, a_dry_run_reports_the_plan_and_writes_nothing) {
  const std::string out = folder_->path("dry").string();
  const Finished child = succeeding({"run", study_, "--out", out, "--dry-run"});
  EXPECT_THAT(child.out, states("small clearance", "synthetic_level2", "3 motions",
                                "16 orientations", "8 differ", "24 histories"));
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Clearance, never_writes_into_a_folder_in_use) {
  expect_refused(run_program({"run", study_, "--out", out().string()}), {"holds a run"});
}

TEST_F(Clearance, input_that_is_wrong_is_reported_with_its_line_and_leaves_nothing) {
  const std::string out = folder_->path("refused").string();
  const auto refuses = [&](const std::string& from, const std::string& to,
                           const std::string& part) {
    const std::string study = folder_->write("wrong.toml", replaced(small_clearance(), from, to));
    expect_refused(run_program({"run", study, "--out", out}), {part});
    EXPECT_FALSE(fs::exists(out));
  };
  refuses("mass_ratio = 0.05", "mass_ratio = 1.5", "building.mass_ratio is outside its range");
  refuses("mu = 0.47", "mue = 0.47", "friction.mue is not a known key");
  refuses("\"level2_2\"", "\"level2_22\"", "suite.records names level2_22, which is not in");
}

}  // namespace
}  // namespace glissade::test
