// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "cli/one_package.hpp"
#include "cli/small_study.hpp"
#include "facts.hpp"
#include "one_line.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;

/// Nothing is printed: of PATH gnuplot alone is left.
class Sites : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder_ = new ScratchFolder;
    path_ = std::getenv("PATH");
    fs::create_directory(folder_->path("bin"));
    for (const char* name : {"gnuplot", "env"})
      fs::create_symlink(fs::path("/usr/bin") / name, folder_->path("bin") / name);
    ::setenv("PATH", folder_->path("bin").c_str(), 1);
    finished_ = run_program(
        {"clearance", folder_->write("campus.toml", two_roofs()), "--out", out().string()});
  }
  static void TearDownTestSuite() {
    ::setenv("PATH", path_.c_str(), 1);
    delete folder_;
  }
  static fs::path out() { return folder_->path("out"); }
  static nlohmann::json json_of(const fs::path& file) {
    return nlohmann::json::parse(read_file(file));
  }

  static inline ScratchFolder* folder_ = nullptr;
  static inline std::string path_;
  static inline Finished finished_;
};

TEST_F(Sites, each_have_a_package_of_their_own_and_a_row_of_the_summary) {
  ASSERT_EQ(finished_.status, 0) << finished_.err;
  const nlohmann::json sites = json_of(out() / "sites.json").at("sites");
  ASSERT_EQ(sites.size(), 2u);
  for (const auto& site : sites) {
    const nlohmann::json package =
        json_of(out() / site.at("folder").get<std::string>() / "package.json");
    EXPECT_EQ(site.at("governing_m"), package.at("governing_m"));
    EXPECT_EQ(site.at("sds_g"), package.at("sds_g"));
    double largest_m = 0.0;
    for (const auto& s : package.at("separations"))
      largest_m = std::max(largest_m, s.at("required_m").get<double>());
    EXPECT_EQ(site.at("largest_required_m"), largest_m);
  }
  EXPECT_EQ(sites[0].at("s1_g"), nullptr);
  EXPECT_EQ(sites[1].at("s1_g"), 0.5);
  EXPECT_GT(sites[0].at("sd1_g"), 0.0);
  EXPECT_EQ(sites[0].at("verdict"), "open");  // simulated motions
  EXPECT_EQ(sites[1].at("verdict"), "not sufficient");
  EXPECT_THAT(one_line(finished_.out),
              states("Roof A", "Roof B", "not sufficient", "site_1, site_2", "sites.html"));
  EXPECT_THAT(finished_.out, testing::Not(testing::HasSubstr("CSV files only")));
}

TEST_F(Sites, a_table_of_a_site_is_in_place_of_that_of_the_project) {
  EXPECT_NEAR(json_of(out() / "site_1/package.json").at("slope_deg"), 1.193, 1e-3);
  EXPECT_NEAR(json_of(out() / "site_2/package.json").at("slope_deg"), 2.386, 1e-3);
  EXPECT_THAT(read_file(out() / "site_2/package.html"), states("campus: Roof B", "2 Side Street"));
}

// ASCE 7-10, 11.4.3 and 11.4.4 (recalled): those of 7-16 have one number more.
TEST_F(Sites, cite_the_clauses_of_their_edition_and_no_other_recollection) {
  const std::string of_7_10 = read_file(out() / "site_2/tables/provisions.csv");
  EXPECT_THAT(of_7_10, states("\"ASCE 7-10, 11.4.3, 11.4.4\""));
  EXPECT_THAT(of_7_10, testing::Not(testing::HasSubstr("11.4.5")));
  for (const char* site : {"site_1", "site_2"})
    EXPECT_THAT(read_file(out() / site / "package.html"),
                testing::Not(testing::HasSubstr("some recall")));
}

TEST_F(Sites, have_a_page_each_after_the_summary) {
  const std::string page = read_file(out() / "sites.html");
  const std::size_t summary = page.find("Largest required separation"),
                    first = page.find("<h2>campus: Roof A"),
                    second = page.find("<h2>campus: Roof B");
  EXPECT_LT(summary, first);
  EXPECT_LT(first, second);
  EXPECT_NE(second, std::string::npos);
  EXPECT_THAT(page, states("<section class=\"site\">", "SIMULATED MOTIONS", "NOT SUFFICIENT"));
}

TEST_F(Sites, go_on_where_they_were_stopped) {
  const std::string page = read_file(out() / "sites.html");
  fs::remove(out() / "sites.html");
  fs::remove_all(out() / "site_2/probability");
  succeeding({"clearance", "--resume", out().string()});
  EXPECT_EQ(read_file(out() / "sites.html"), page);
  EXPECT_THAT(run_program({"clearance", "--resume", out().string()}).out,
              testing::HasSubstr("is finished"));
}

TEST_F(Sites, do_not_go_on_alone) {
  for (const char* end : {"", "/"})
    expect_refused(run_program({"clearance", "--resume", (out() / "site_2").string() + end}),
                   {"site_2", "one site of several", "clearance --resume " + out().string()});
}

TEST_F(Sites, that_are_wrong_are_named_with_their_line_before_anything_runs) {
  const auto refuses = [&](const std::string& from, const std::string& to,
                           const std::vector<std::string>& parts) {
    const std::string file = folder_->write("wrong.toml", replaced(two_roofs(), from, to));
    const fs::path other = folder_->path("refused");
    expect_refused(run_program({"clearance", file, "--out", other.string()}), parts);
    EXPECT_FALSE(fs::exists(other));
  };
  refuses("name = \"Roof B\"", "", {"wrong.toml:", "site.name is missing"});
  refuses("name = \"Roof B\"", "name = \"Roof A\"",
          {"wrong.toml:12", "two sites are named Roof A"});
  refuses("s1_g = 0.5", "s1 = 0.5", {"wrong.toml:11", "site.s1_g is missing"});
  refuses("rise_in_12 = 0.5", "rise_in_12 = 5", {"wrong.toml:21", "roof.rise_in_12"});
}

TEST_F(Sites, check_states_what_each_would_run) {
  const Finished child = succeeding({"check", folder_->path("campus.toml").string()});
  EXPECT_THAT(child.out, states("campus: Roof A", "campus: Roof B", "S_DS 0.800 g"));
}

}  // namespace
}  // namespace glissade::test
