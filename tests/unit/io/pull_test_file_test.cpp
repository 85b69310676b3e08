// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/pull_test_file.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/io/study_file.hpp"
#include "glissade/sampling/friction_statistics.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using test::states;
using testing::ElementsAre;
using testing::Not;
using testing::UnorderedElementsAre;

const std::string header = "test,direction,time_s,displacement_m,force_n,normal_n\n";

std::vector<PullTest> read(const std::string& content) {
  const TemporaryFolder folder;
  return read_pull_tests(folder.write("tests.csv", content));
}
std::vector<std::size_t> lines(const std::string& content) {
  return lines_of([&] { read(content); });
}

TEST(pull_test_file, is_read_with_comments_blanks_quotes_and_either_line_end) {
  const auto tests = read("# rig 3\r\ntest, direction ,displacement_m,force_n,normal_n\r\n\r\n" +
                          std::string("\"EPDM 1\",along,0,0,100\r\nEPDM 1, along , 0.1 ,+50,100\n"
                                      "# the next\nEPDM 1,across,0,1,100\n"));
  ASSERT_EQ(tests.size(), 2u);
  EXPECT_EQ(tests[0].test, "EPDM 1");
  EXPECT_THAT(tests[0].displacement_m, ElementsAre(0.0, 0.1));
  EXPECT_THAT(tests[0].force_n, ElementsAre(0.0, 50.0));
  EXPECT_EQ(tests[1].direction, "across");
  EXPECT_THAT(tests[1].place, testing::EndsWith("/tests.csv:7"));
}

TEST(pull_test_file, may_have_its_columns_in_any_order_case_and_known_unit) {
  const auto metric = read("normal_kN,force_kN,displacement_mm,Direction,Test\n1.5,0.75,20,a,1\n");
  EXPECT_DOUBLE_EQ(metric[0].normal_n[0], 1500.0);
  EXPECT_DOUBLE_EQ(metric[0].force_n[0], 750.0);
  EXPECT_DOUBLE_EQ(metric[0].displacement_m[0], 0.02);
  const auto us = read("test,direction,displacement_in,force_lbf,normal_lbf\n1,a,2,100,200\n");
  EXPECT_DOUBLE_EQ(us[0].displacement_m[0], 0.0508);
  EXPECT_DOUBLE_EQ(us[0].force_n[0], 444.82216152605);  // 1 lbf = 4.4482216152605 N exactly
}

TEST(pull_test_file, with_time_that_goes_back_is_refused_once) {
  EXPECT_THAT(lines(header + "1,a,0,0,0,9\n1,a,0.2,0,0,9\n1,a,0.1,0,0,9\n1,a,0.3,0,0,9\n"
                             "1,a,0.2,0,0,9\n"),
              ElementsAre(4));
  EXPECT_EQ(read(header + "1,a,5,0,0,9\n1,a,5,0,0,9\n2,a,0,0,0,9\n").size(), 2u);  // equal
}

TEST(pull_test_file, with_a_normal_force_not_above_zero_is_refused_once) {
  EXPECT_THAT(lines(header + "1,a,0,0,0,-9\n1,a,0,0,0,0\n"), ElementsAre(2));
  EXPECT_THAT(lines(header + "1,a,0,0,0,0\n"), ElementsAre(2));
}

TEST(pull_test_file, reports_every_kind_of_wrong_row) {
  EXPECT_THAT(lines(header + "1,a,0,0,x,9\n1,a,0,0,0\n1,,0,0,0,9\n1,a,0,nan,0,9\n1,a,0,0,0,-1\n"),
              UnorderedElementsAre(2, 3, 4, 6));  // those of one kind once
}

TEST(pull_test_file, has_names_in_utf_8) {
  for (const char* name : {"N\u2013S", "\u00e9", "\U0001F600", "a#1", "a b"})
    EXPECT_EQ(read(header + name + ",a,0,0,0,9\n")[0].test, name);
  // Latin-1; a control character; cut short; overlong; a surrogate; beyond Unicode.
  for (const char* name : {"\xe9t\xe9", "a\x1b[0m", "\xe2\x80", "\xc0\xaf", "\xe0\x80\xaf",
                           "\xed\xa0\x80", "\xf4\x90\x80\x80", "\x80"}) {
    EXPECT_THAT(lines(header + "x" + name + ",a,0,0,0,9\n"), ElementsAre(2));
  }
}

TEST(pull_test_file, has_one_direction_where_names_differ_in_case_or_blanks) {
  const TemporaryFolder folder;
  std::string logs = header;
  for (const char* name : {"1,Along", "2,along", "3,\" ALONG \""}) {
    for (int i = 0; i <= 10; ++i)
      logs += std::string(name) + "," + std::to_string(i) + "," + std::to_string(0.01 * i) +
              ",50,100\n";
  }
  for (const std::string& text :
       {logs, std::string("test,direction,mu\n1,Along,0.5\n2,along,0.5\n3,\" ALONG \",0.5\n")}) {
    const PullTestResults results = read_pull_test_results(folder.write("t.csv", text), {});
    ASSERT_EQ(results.summary.directions.size(), 1u);
    const DirectionFriction& along = results.summary.directions[0];
    EXPECT_EQ(along.direction, "Along");
    EXPECT_EQ(along.sliding.tests, 3u);
    EXPECT_THAT(along.note, states("ALONG, along", "one direction"));
    EXPECT_THAT(results.summary.notes, testing::Contains(along.note));
    EXPECT_EQ(find_direction(results.summary, "aLong "), &along);
  }
  EXPECT_THAT(
      lines("test,direction,displacement_m,force_n,normal_n\n1,a,0,0,9\n2,a,0,0,9\n1,A,0,0,9\n"),
      ElementsAre(4));
}

TEST(pull_test_file, names_what_a_file_is_that_is_no_csv) {
  const std::string utf16("\xff\xfet\0e\0", 6);
  expect_refusals(read,
                  {{"test\tdirection\tmu\n1\talong\t0.5\n", "tests.csv:1", {"tabs", "commas"}},
                   {utf16, "tests.csv", {"UTF-16", "CSV"}},
                   {std::string("PK\x03\x04\0\0", 6), "tests.csv", {"Excel (xlsx)", "CSV"}},
                   {"\xd0\xcf\x11\xe0", "tests.csv", {"Excel (xls)", "CSV"}},
                   {std::string("a\0b", 3), "tests.csv", {"not a text file"}}});
}

TEST(pull_test_file, keeps_the_rows_of_a_test_together) {
  EXPECT_THAT(lines(header + "1,a,0,0,0,9\n2,a,0,0,0,9\n1,a,1,0,0,9\n1,a,2,0,0,9\n"),
              ElementsAre(4));
}

TEST(pull_test_file, needs_its_columns_each_once) {
  EXPECT_THAT(faults_of([] { read("test,displacement,force_n,normal_n,force_kn\n1,0,0,9,0\n"); }),
              testing::Each(testing::StartsWith("1 ")));
  std::string header_faults;
  for (const Problem& p :
       problems_of([] { read("test,displacement,force_n,normal_n,force_kn\n1,0,0,9,0\n"); }))
    header_faults += to_string(p) + "\n";
  EXPECT_THAT(header_faults, states("direction", "'displacement'", "displacement_mm", "force_lbf"));
  EXPECT_THAT(lines("1,a,0,0,0,9\n"), testing::Each(1));
}

TEST(pull_test_file, has_one_problem_for_a_header_that_is_not_understood) {
  const TemporaryFolder folder;
  expect_refusals(
      [&](const std::string& text) { read_pull_test_results(folder.write("tests.csv", text), {}); },
      {{"mu,speed_m/s\n0.5,0.1\n", "tests.csv:1", {"has mu", "'speed_m/s'", "leave"}},
       {"mu,test,Mu\n0.5,1,0.1\n", "tests.csv:1", {"'Mu'", "each once"}},
       {"force_N,weight_N\n50,100\n",
        "tests.csv:1",
        {"'weight_N' is not known", "the columns test; direction; displacement_m", "normal_n"}},
       {"test,direction,displacement_m,force_nn,normal_n\n1,a,0,0,9\n",
        "tests.csv:1",
        {"the column 'force_nn' (force_n, force_kn or force_lbf?) is not known;"}}});
}

TEST(pull_test_file, with_semicolons_or_without_rows_is_refused_for_that_alone) {
  expect_refusals(read, {{"test;direction;mu\n1;along;0.5\n", "tests.csv:1", {"semicolons"}},
                         {"", "tests.csv", {}},
                         {header, "tests.csv", {}}});
  EXPECT_THAT(problems_of([] { read_pull_tests("none.csv"); }), one_problem("none.csv"));
}

/// The example's rule, as its comments state it.
struct ExampleSample {
  double displacement_m, force_n, normal_n;
};
ExampleSample example_at(double t_s, double m) {
  const double s_mm = 25.0 * std::clamp(t_s - 1.0, 0.0, 12.0);
  const double mu = m * (1.0 + 0.15 * std::exp(-s_mm / 5.0)) +
                    0.02 * std::sin(2.0 * std::numbers::pi * s_mm / 60.0);
  const double normal_n = 1500.0 * (1.0 + 0.01 * std::sin(2.0 * std::numbers::pi * t_s / 1.3));
  const double loading = std::min(t_s, 1.0) * (1.0 - 0.2 * std::max(t_s - 13.0, 0.0));
  return {1e-3 * (2.0 * std::min(t_s, 1.0) + s_mm), mu * loading * normal_n, normal_n};
}

TEST(example_pull_tests, follow_the_rule_they_state) {
  const auto tests = read_pull_tests(GLISSADE_SOURCE_DIR "/studies/data/pull_tests.csv");
  const std::vector<double> m = {0.578, 0.526, 0.494, 0.562, 0.598, 0.542,
                                 0.603, 0.655, 0.570, 0.632, 0.538, 0.602};
  ASSERT_EQ(tests.size(), m.size());
  for (std::size_t k = 0; k < m.size(); ++k) {
    ASSERT_EQ(tests[k].force_n.size(), 71u);
    for (std::size_t i = 0; i < 71; ++i) {
      const ExampleSample expected = example_at(static_cast<double>(i) / 5.0, m[k]);
      EXPECT_NEAR(tests[k].displacement_m[i], expected.displacement_m, 1e-12);
      EXPECT_NEAR(tests[k].force_n[i], expected.force_n, 0.0501);
      EXPECT_NEAR(tests[k].normal_n[i], expected.normal_n, 0.0501);
    }
  }
}

class StudyWithPullTests : public testing::Test {
 protected:
  StudyWithPullTests() {
    folder_.write("suite.toml", "");
    folder_.write("tests.csv", traces("along", {0.50, 0.55, 0.60}));
  }
  /// Even pulls, one for each friction.
  static std::string traces(const std::string& direction, const std::vector<double>& frictions) {
    std::string text = "test,direction,displacement_m,force_n,normal_n\n";
    return text + rows(direction, frictions);
  }
  static std::string rows(const std::string& direction, const std::vector<double>& frictions) {
    std::string text;
    for (std::size_t k = 0; k < frictions.size(); ++k) {
      for (int i = 0; i <= 10; ++i) {
        text += std::to_string(k) + "," + direction + "," + std::to_string(0.01 * i) + "," +
                std::to_string(1000.0 * frictions[k]) + ",1000\n";
      }
    }
    return text;
  }
  StudyConfig read(const std::string& friction) const {
    return read_study(folder_.write("study.toml",
                                    "[study]\nname = \"s\"\n[suite]\nfile = \"suite.toml\"\n"
                                    "[intensity]\nmeasure = \"sds_g\"\nlevels = [1.0]\n"
                                    "[fragility]\nthresholds_m = [0.1]\n[friction]\n" +
                                        friction));
  }
  static double mean_mu(const StudyConfig& study, const char* key) {
    return mean(*study.quantities.at("friction", key).drawn);
  }
  void refuses(const std::vector<Refusal>& refusals) const {
    expect_refusals([&](const std::string& friction) { read(friction); }, refusals);
  }
  TemporaryFolder folder_;
};

TEST_F(StudyWithPullTests, takes_mean_and_deviation_over_the_tests) {
  const StudyConfig study = read("file = \"tests.csv\"\n");
  const Distribution& friction = *study.quantities.at("friction", "mu").drawn;
  const auto mu = std::get<TruncatedNormal>(friction);
  EXPECT_NEAR(mu.mean, 0.55, 1e-12);
  EXPECT_NEAR(mu.std, 0.05, 1e-12);
  EXPECT_EQ(mu.min, 0.0);
  EXPECT_TRUE(std::isinf(mu.max));
  EXPECT_NEAR(design_friction(friction), 0.45, 1e-12);
  EXPECT_THAT(study.friction.note, states("3 pull tests", "along", "tests.csv", "0.55", "95 %"));
}

TEST_F(StudyWithPullTests, takes_the_direction_it_names) {
  folder_.write("tests.csv", traces("along", {0.5, 0.6}) + rows("across", {0.7, 0.8}));
  EXPECT_NEAR(mean_mu(read("file = \"tests.csv\"\ndirection = \"across\"\n"), "mu"), 0.75, 1e-6);
  refuses({{"file = \"tests.csv\"\n", "study.toml:11", {"\"along\"", "\"across\""}},
           {"file = \"tests.csv\"\ndirection = \"up\"\n",
            "study.toml:12",
            {"friction.direction = \"up\"", "\"along\""}}});
}

TEST_F(StudyWithPullTests, takes_a_direction_for_each_of_two_axes) {
  folder_.write("tests.csv", traces("along", {0.5, 0.6}) + rows("across", {0.7, 0.8}));
  const std::string along = "file = \"tests.csv\"\ndirection = \"along\"\n";
  const std::string both = along + "across_direction = \"across\"\n";
  const StudyConfig study = read(both + "[model]\naxes = 2\n");
  EXPECT_NEAR(mean_mu(study, "mu"), 0.55, 1e-6);
  EXPECT_TRUE(study.friction.across_is_given);
  EXPECT_NEAR(mean_mu(study, "across_mu"), 0.75, 1e-6);
  EXPECT_THAT(study.friction.note, states("direction across"));
  const auto warns_of_the_other = states("NOT", "direction \"across\"", "0.75");
  EXPECT_THAT(study.friction.note, Not(warns_of_the_other));
  EXPECT_THAT(read(along).friction.note, warns_of_the_other);
  refuses({{both + "[model]\naxes = 1\n", "study.toml:13", {"friction.across_direction"}},
           {along + "across_direction = \"up\"\n[model]\naxes = 2\n",
            "study.toml:13",
            {"friction.across_direction = \"up\""}}});
}

TEST_F(StudyWithPullTests, takes_equal_tests_as_one_number) {
  folder_.write("tests.csv", traces("along", {0.5, 0.5}));
  EXPECT_TRUE(read("file = \"tests.csv\"\n").quantities.at("friction", "mu").is_always(0.5));
}

TEST_F(StudyWithPullTests, needs_two_tests) {
  folder_.write("tests.csv", traces("along", {0.5}));
  refuses({{"file = \"tests.csv\"\n", "study.toml:11", {"friction.file"}}});
}

TEST_F(StudyWithPullTests, refuses_friction_given_twice_and_nothing_else) {
  refuses(
      {{"file = \"tests.csv\"\nmu = 0.5\n", "study.toml:12", {"friction.file", "friction.mu"}}});
}

TEST_F(StudyWithPullTests, follows_its_own_sliding_rule) {
  const auto at = [](const std::string& line) {
    return is_problem("study.toml:11",
                      std::vector<std::string>{"tests.csv:" + line, "0.1 m", "0.5 m"});
  };
  EXPECT_THAT(problems_of([&] { read("file = \"tests.csv\"\nsliding_from_m = 0.5\n"); }),
              ElementsAre(at("2"), at("13"), at("24")));
  refuses({{"file = \"tests.csv\"\nslip_m = 0.1\nsliding_from_m = 0.05\n",
            "study.toml:11",
            {"sliding_from_m", "0.05", "slip_m = 0.1"}},
           {"file = \"tests.csv\"\nslip_m = -1\n", "study.toml:12", {"friction.slip_m = -1"}}});
}

TEST_F(StudyWithPullTests, reports_the_problems_of_the_tests_at_their_lines) {
  folder_.write("tests.csv", "test,direction,displacement_m,force_n,normal_n\n1,a,0,0,-1\n");
  refuses({{"file = \"tests.csv\"\n", "study.toml:11", {"tests.csv:2", "normal force"}},
           {"file = \"none.csv\"\n", "study.toml:11", {"none.csv"}}});
}

}  // namespace
}  // namespace glissade
