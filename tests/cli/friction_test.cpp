// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "cli/json_of.hpp"
#include "cli/small_study.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

namespace fs = std::filesystem;

const std::string example = GLISSADE_SOURCE_DIR "/studies/data/pull_tests.csv";

/// Two pulls that break away at 0.6 and 0.7 and slide at 0.5 and 0.6 over 0.1 m.
std::string two_pulls() {
  std::string text = "test,direction,time_s,displacement_mm,force_n,normal_kn\n";
  for (const int force_n : {500, 600}) {
    const std::string name = std::to_string(force_n) + ",along,";
    text += name + "0,0,0,1\n" + name + "1,2," + std::to_string(force_n + 100) + ",1\n";
    for (int i = 1; i <= 10; ++i) {
      text += name + std::to_string(1 + i) + "," + std::to_string(10 * i) + "," +
              std::to_string(force_n) + ",1\n";
    }
  }
  return text;
}

class Friction : public testing::Test {
 protected:
  Json friction_json(const std::vector<std::string>& options) const {
    return json_of({"friction"}, options);
  }
  std::string two_pulls_file() const { return folder_.write("two.csv", two_pulls()); }
  ScratchFolder folder_;
};

// 0.5 and 0.6: mean 0.55, std sqrt(0.005).
TEST_F(Friction, is_reported_by_test_and_by_direction) {
  const Json json = friction_json({two_pulls_file()});
  ASSERT_EQ(json["tests"].size(), 2u);
  EXPECT_EQ(json["tests"][0]["test"], "500");
  EXPECT_NEAR(json["tests"][0]["breakaway_mu"], 0.6, 1e-12);
  EXPECT_NEAR(json["tests"][1]["sliding_mu"], 0.6, 1e-12);
  EXPECT_NEAR(json["tests"][1]["sliding_std"], 0.0, 1e-12);
  const Json& sliding = json["directions"][0]["sliding"];
  EXPECT_EQ(json["directions"][0]["direction"], "along");
  EXPECT_EQ(sliding["tests"], 2);
  EXPECT_NEAR(sliding["mean"], 0.55, 1e-12);
  EXPECT_NEAR(sliding["std"], 0.0707106781, 1e-9);
  EXPECT_NEAR(sliding["mean_minus_2_std"], 0.55 - 0.1414213562, 1e-9);
  EXPECT_TRUE(sliding["shapiro_wilk"].is_null());
  EXPECT_NEAR(json["directions"][0]["breakaway"]["mean"], 0.65, 1e-12);
}

TEST_F(Friction, of_one_test_has_null_for_what_is_not_known) {
  const std::string text = two_pulls();
  const std::string one = folder_.write("one.csv", text.substr(0, text.find("600,along,0,0")));
  const Json sliding = friction_json({one})["directions"][0]["sliding"];
  EXPECT_NEAR(sliding["mean"], 0.5, 1e-12);
  for (const char* key : {"std", "mean_minus_2_std", "lower_bound_95", "shapiro_wilk"})
    EXPECT_TRUE(sliding[key].is_null()) << key;
}

// 10 mm in a second: at the upper end of 0.1 to 10 mm/s.
TEST_F(Friction, notes_what_pull_tests_are_asked_for_and_these_do_not_have) {
  const auto notes = [&](const std::string& text) {
    return friction_json({folder_.write("noted.csv", text)})["notes"].dump();
  };
  const std::string two = two_pulls();
  EXPECT_THAT(notes(two), states("2 tests, fewer than 3", "G115"));
  EXPECT_THAT(notes(two), testing::Not(states("not pulled at")));
  std::string without_time, halved;
  for (const std::string& line : lines_of(two)) {
    std::vector<std::string> cells = cells_of(line);
    const bool is_header = cells[2] == "time_s";
    if (!is_header) cells[2] = std::to_string(0.5 * std::stod(cells[2]));
    halved += cells[0] + "," + cells[1] + "," + cells[2] + "," + cells[3] + "," + cells[4] + "," +
              cells[5] + "\n";
    without_time +=
        cells[0] + "," + cells[1] + "," + cells[3] + "," + cells[4] + "," + cells[5] + "\n";
  }
  EXPECT_THAT(notes(halved), states("test 500, 600: not pulled at 0.1 to 10 mm/s"));
  EXPECT_THAT(notes(without_time), states("the speed is not in the file"));
  std::string shorter;
  for (const std::string& line : lines_of(two))
    if (line.find(",80,") == std::string::npos && line.find(",90,") == std::string::npos &&
        line.find(",100,") == std::string::npos)
      shorter += line + "\n";
  EXPECT_THAT(notes(shorter), states("test 500, 600: pulled over less than 3 in"));
}

TEST_F(Friction, text_shows_the_tables_and_the_doubts) {
  const Finished child = succeeding({"friction", example});
  EXPECT_THAT(child.out, states("A1", "across", "95 %"));
}

TEST_F(Friction, of_the_example_comes_out_as_it_was_made) {
  const Json json = friction_json({example});
  ASSERT_EQ(json["directions"].size(), 2u);
  // Means of m; the ripple of 0.02 over 4.7 of its periods leaves less than 0.002.
  EXPECT_NEAR(json["directions"][0]["sliding"]["mean"], 0.55, 0.002);
  EXPECT_NEAR(json["directions"][1]["sliding"]["mean"], 0.60, 0.002);
  EXPECT_GT(json["directions"][0]["breakaway"]["mean"], json["directions"][0]["sliding"]["mean"]);
}

TEST_F(Friction, leaves_tables_and_figure_in_a_new_folder_only) {
  const fs::path out = folder_.path("out");
  const std::string file = two_pulls_file();
  EXPECT_EQ(run_program({"friction", file, "--out", out.string()}).status, 0);
  for (const char* name : {"tables/friction.csv", "tables/pull_tests.csv", "figures/friction.svg",
                           "figures/friction.pdf", "figures/friction.gp"}) {
    EXPECT_GT(fs::exists(out / name) ? fs::file_size(out / name) : 0, 0u) << name;
  }
  const std::vector<std::string> table = lines_of(read_file(out / "tables" / "friction.csv"));
  EXPECT_EQ(table[0],
            "direction,friction,tests,mean,std,mean_minus_2_std,lower_bound_95,shapiro_wilk_w,"
            "shapiro_wilk_p");
  const std::vector<std::string> before = folder_.contents();
  expect_refused(run_program({"friction", file, "--out", out.string()}),
                 {out.string(), "--overwrite"});
  expect_refused(run_program({"friction", file, "--out", file}), {"two.csv", "is not a folder"});
  EXPECT_EQ(folder_.contents(), before);
}

TEST_F(Friction, that_is_refused_leaves_nothing) {
  const std::string bad =
      folder_.write("bad.csv", replaced(two_pulls(), "500,along,3,", "500,along,0.5,"));
  expect_refused(run_program({"friction", bad, "--out", folder_.path("out").string()}),
                 {"bad.csv:5: time goes back", "from 2 to 0.5 s"});
  EXPECT_EQ(folder_.contents(), std::vector<std::string>{"bad.csv"});
}

TEST_F(Friction, from_a_normal_force_that_is_not_positive_is_refused) {
  const std::string bad =
      folder_.write("bad.csv", replaced(two_pulls(), "500,along,0,0,0,1", "500,along,0,0,0,-1"));
  expect_refused(run_program({"friction", bad, "--json"}),
                 {"bad.csv:2: the normal force of test 500 along, -1000 N, is not above 0"});
}

TEST_F(Friction, without_sliding_is_refused) {
  expect_refused(run_program({"friction", two_pulls_file(), "--sliding-from-m", "0.2"}),
                 {"two.csv:2", "two.csv:14", "no sliding"});
}

TEST_F(Friction, refuses_distances_out_of_order) {
  expect_refused(run_program({"friction", example, "--slip-m", "0"}), {"--slip-m: 0 is not above"});
  expect_refused(run_program({"friction", example, "--slip-m", "0.05"}),
                 {"--sliding-from-m: 0.02 is below"});
}

TEST_F(Friction, of_tests_is_what_a_study_runs_with_and_says_so) {
  const std::string text = replaced(small_study(), "mu = { mean = 0.3, std = 0.03 }\n",
                                    "file = \"two.csv\"\ndirection = \"along\"\n");
  two_pulls_file();
  const Finished child = succeeding({"run", folder_.write("study.toml", text), "--dry-run"});
  // Two combinations: as drawn, and mean - 2 std.
  EXPECT_THAT(child.out, states("mean 0.55, std 0.07071", "2 combinations", "2 pull tests"));
}

TEST_F(Friction, of_the_example_serves_a_study_beside_it) {
  const std::string text = replaced(small_study(), "mu = { mean = 0.3, std = 0.03 }\n",
                                    "file = \"" + example + "\"\ndirection = \"across\"\n");
  const fs::path out = folder_.path("out");
  succeeding({"run", folder_.write("study.toml", text), "--out", out.string()});
  EXPECT_THAT(read_file(out / "report.html"), states("6 pull tests"));
}

// 0.50, 0.54, 0.58: mean 0.54, std 0.04. The same sheet serves a project.
TEST_F(Friction, of_a_sheet_of_values_is_evaluated_and_serves_a_study) {
  const std::string sheet = folder_.write("sheet.csv", "# tests of May\nmu\n0.50\n0.54\n0.58\n");
  const Json json = friction_json({sheet});
  EXPECT_NEAR(json["directions"][0]["sliding"]["mean"], 0.54, 1e-12);
  EXPECT_NEAR(json["directions"][0]["sliding"]["std"], 0.04, 1e-12);
  EXPECT_TRUE(json["directions"][0]["breakaway"].is_null());
  const fs::path out = folder_.path("out");
  EXPECT_EQ(run_program({"friction", sheet, "--out", out.string()}).status, 0);
  EXPECT_TRUE(fs::exists(out / "tables/friction.csv"));
  const std::string text =
      replaced(small_study(), "mu = { mean = 0.3, std = 0.03 }\n", "file = \"sheet.csv\"\n");
  const Finished child = succeeding({"check", folder_.write("study.toml", text)});
  EXPECT_THAT(child.out, states("mean 0.54, std 0.04"));
}

// The tolerance factor of few tests did not converge where long double has fewer digits (valgrind).
TEST_F(Friction, rests_on_no_arithmetic_beyond_double) {
  const Finished symbols = run_shell("nm -C " GLISSADE_PROGRAM " | grep boost::");
  ASSERT_EQ(symbols.status, 0) << symbols.err;
  ASSERT_THAT(symbols.out, testing::HasSubstr("boost::math::"));
  for (const std::string& line : lines_of(symbols.out)) {
    const auto has = [&](const char* part) { return line.find(part) != line.npos; };
    const bool is_table = has("unchecked_factorial");  // of constants
    EXPECT_FALSE(has("boost::") && has("long double") && !is_table) << line;
  }
}

}  // namespace
}  // namespace glissade::test
