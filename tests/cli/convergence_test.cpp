// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "cli/one_run.hpp"
#include "cli/small_convergence.hpp"
#include "cli/small_study.hpp"
#include "one_line.hpp"

namespace glissade::test {
namespace {

using Json = nlohmann::json;
using testing::HasSubstr;
namespace fs = std::filesystem;

using Convergence = OneRun<small_convergence>;

TEST_F(Convergence, leaves_results_report_tables_figure_and_its_record) {
  for (const char* name :
       {"results.h5", "run.json", "report.html", "tables/convergence.csv", "tables/records.csv",
        "tables/scenes.csv", "figures/convergence.svg", "figures/convergence.pdf",
        "figures/convergence.gp", "figures/convergence.dat"}) {
    EXPECT_GT(fs::exists(out() / name) ? fs::file_size(out() / name) : 0, 0u) << name;
  }
  for (const std::string& name : folder_->contents())
    EXPECT_EQ(name.find(".partial"), std::string::npos) << name;
}

TEST_F(Convergence, ends_with_what_the_paper_states_beside_what_came_out) {
  EXPECT_EQ(finished_.err, "");
  for (const std::string& part :
       {std::string("8 scenes on 3 records"), std::string("The paper states 0.48 % at P = 64"),
        std::string("the paper states less than 0.09 s"), (out() / "report.html").string()}) {
    EXPECT_THAT(one_line(finished_.out), HasSubstr(part));
  }
}

TEST_F(Convergence, run_json_tells_how_long_histories_took) {
  const Json json = Json::parse(read_file(out() / "run.json"));
  EXPECT_EQ(json.at("status"), "finished");
  EXPECT_EQ(json.at("ranks"), 1);
  const Json& history = json.at("history_seconds");
  ASSERT_EQ(history.at("published").size(), 4u);
  EXPECT_EQ(history.at("published")[3].at("substeps"), 256);
  EXPECT_GE(history.at("published")[3].at("longest"), history.at("published")[3].at("median"));
  EXPECT_GT(history.at("exact").at("median"), 0.0);
}

TEST_F(Convergence, comes_out_the_same_to_the_last_byte_though_times_differ) {
  const std::string again = folder_->path("again").string();
  ASSERT_EQ(run_program({"run", study_, "--out", again}).status, 0);
  EXPECT_TRUE(read_file(again + "/results.h5") == read_file(out() / "results.h5"));
  EXPECT_NE(read_file(again + "/run.json"), read_file(out() / "run.json"));
}

TEST_F(Convergence, errors_shrink_as_substeps_grow) {
  const std::vector<std::string> lines = lines_of(read_file(out() / "tables/convergence.csv"));
  ASSERT_EQ(lines.size(), 6u);  // title, header, four P
  const std::vector<std::string> header = cells_of(lines[1]);
  const auto column = static_cast<std::size_t>(
      std::find(header.begin(), header.end(), "median_error_of_exact_peak_percent") -
      header.begin());
  ASSERT_LT(column, header.size());
  double before = 1e9;
  for (std::size_t i = 2; i < lines.size(); ++i) {
    const double error = std::stod(cells_of(lines[i])[column]);
    EXPECT_LT(error, before);
    EXPECT_GT(error, 0.0);
    before = error;
  }
}

TEST_F(Convergence, report_makes_the_same_again_with_the_times_of_its_run) {
  const fs::path again = folder_->path("report_again");
  const Finished child =
      run_program({"report", (out() / "results.h5").string(), "--out", again.string()});
  ASSERT_EQ(child.status, 0) << child.err;
  for (const char* name : {"report.html", "tables/convergence.csv", "tables/scenes.csv",
                           "figures/convergence.svg", "figures/convergence.pdf"})
    EXPECT_TRUE(read_file(again / name) == read_file(out() / name)) << name;
}

TEST_F(Convergence, report_without_the_run_json_tells_no_times) {
  fs::create_directory(folder_->path("alone"));
  const std::string alone = folder_->write("alone/results.h5", read_file(out() / "results.h5"));
  const Finished child = run_program({"report", alone});
  ASSERT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(one_line(child.out), HasSubstr("The paper states 0.48 % at P = 64"));
  EXPECT_THAT(one_line(child.out), testing::Not(HasSubstr("less than 0.09 s")));
  EXPECT_TRUE(fs::exists(folder_->path("alone/report.html")));
}

TEST_F(Convergence, never_writes_into_a_folder_in_use) {
  const std::string before = read_file(out() / "results.h5");
  expect_refused(run_program({"run", study_, "--out", out().string()}), {"already holds a run"});
  EXPECT_TRUE(read_file(out() / "results.h5") == before);
}

TEST_F(Convergence, a_dry_run_tells_the_plan_and_writes_nothing) {
  const std::string out = folder_->path("dry").string();
  const Finished child = run_program({"run", study_, "--out", out, "--dry-run"});
  EXPECT_EQ(child.status, 0) << child.err;
  for (const char* part : {"Convergence study small convergence", "(3 records)",
                           "8: slope 0, 7 deg", "P = 1, 16, 64, 256", "96 by the published scheme"})
    EXPECT_THAT(child.out, HasSubstr(part));
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Convergence, input_that_is_wrong_is_told_with_its_line_and_leaves_nothing) {
  const std::string out = folder_->path("refused").string();
  const auto told = [&](const std::string& from, const std::string& to, const std::string& part) {
    const std::string study = folder_->write("wrong.toml", replaced(small_convergence(), from, to));
    expect_refused(run_program({"run", study, "--out", out}), {part});
    EXPECT_FALSE(fs::exists(out));
  };
  told("[1, 16, 64, 256]", "[64]", "wrong.toml:12: convergence.substeps has one value");
  told("mu =", "mue =", "wrong.toml:10: convergence.mue is not a known key");
  told("\"level0_2\"", "\"level0_22\"", "suite.records names level0_22, which is not in");
}

}  // namespace
}  // namespace glissade::test
