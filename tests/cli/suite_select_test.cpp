// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "cli/json_of.hpp"
#include "facts.hpp"

namespace glissade::test {
namespace {

/// A library of chirps that sweep from 0.3 to 15 Hz, of different strength and metadata, in its
/// folder "library".
class SuiteSelect : public testing::Test {
 protected:
  void SetUp() override {
    std::filesystem::create_directories(folder_.path("library"));
    std::string text = "[suite]\nname = \"library\"\nunits = \"g\"\n";
    for (int i = 0; i < 5; ++i) {
      const std::string id = "r" + std::to_string(i);
      std::string columns[2];
      for (int axis = 0; axis < 2; ++axis) {
        for (int n = 0; n < 800; ++n) {
          const double t = n / 800.0;
          const double phase = 40.0 * std::pow(t, 1.5 + 0.2 * i) + axis;
          columns[axis] += std::to_string((0.3 + 0.1 * i) * std::sin(6.2832 * phase)) + "\n";
        }
        folder_.write("library/" + id + "_" + std::to_string(axis) + ".acc", columns[axis]);
      }
      text += "[[record]]\nid = \"" + id + "\"\nevent = \"event " + std::to_string(i / 2) +
              "\"\nmagnitude = 6." + std::to_string(5 + i) + "\ndistance_km = 20\n" +
              (i == 4 ? "" : "vs30_mps = " + std::to_string(300 + 50 * i) + "\n") +
              "first = { file = \"" + id + "_0.acc\", dt_s = 0.01 }\n" +
              (i == 3 ? "" : "second = { file = \"" + id + "_1.acc\", dt_s = 0.01 }\n");
    }
    library_ = folder_.write("library/library.toml", text);
  }
  Finished select(const std::vector<std::string>& arguments) const {
    return run_program(with({"suite", "select", library_}, arguments));
  }
  Json select_json(const std::vector<std::string>& arguments) const {
    return json_of({"suite", "select", library_}, arguments);
  }
  ScratchFolder folder_;
  std::string library_;
};

const std::vector<std::string> a_site = {"--edition", "asce7_10", "--ss-g",      "0.4",
                                         "--s1-g",    "0.15",     "--max-scale", "50"};

TEST_F(SuiteSelect, prints_the_records_how_the_average_compares_and_who_is_left_out) {
  const Finished child = select(with(a_site, {"--count", "2"}));
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_EQ(child.err, "");
  EXPECT_THAT(child.out, states("Intensity Level 0", "A, B, C, D", "4 candidates", "5 records",
                                "1.000", "r3"));
}

TEST_F(SuiteSelect, json_reports_the_same_and_respects_limits) {
  const Json result = select_json(
      with(a_site, {"--count", "2", "--min-magnitude", "6.6", "--max-vs30-mps", "450"}));
  EXPECT_EQ(result["candidates"], 2);
  EXPECT_EQ(result["target"]["intensity_level"], 0);
  ASSERT_EQ(result["records"].size(), 2u);
  for (const Json& record : result["records"]) {
    EXPECT_GE(record["magnitude"], 6.6);
    EXPECT_LE(record["scale"], 50.0);
  }
  EXPECT_GE(result["average"]["lowest"]["ratio"], 1.0 - 1e-9);
  EXPECT_EQ(result["average"]["reaches_target"], true);
  ASSERT_EQ(result["left_out"].size(), 3u);
  EXPECT_EQ(result["left_out"][0]["reasons"], Json({"magnitude outside the limits"}));
  EXPECT_EQ(result["left_out"][2]["reasons"], Json({"no Vs30 given"}));
}

TEST_F(SuiteSelect, writes_a_suite_file_elsewhere_that_scales_to_the_same_factors) {
  const std::string out = folder_.path("deep/er/mine.toml").string();
  std::filesystem::create_directories(folder_.path("deep/er"));
  const Json records = select_json(with(a_site, {"--count", "3", "--out", out}))["records"];
  EXPECT_THAT(run_program({"suite", "show", out}).out, states("nearest"));
  const Finished scaled = succeeding({"suite", "scale", out, "--max-factor", "50"});
  const std::vector<std::string> lines = lines_of(scaled.out);
  const auto header = std::find(lines.begin(), lines.end(), "id,scale");
  ASSERT_EQ(lines.end() - header, 4);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<std::string> cells = cells_of(header[1 + static_cast<std::ptrdiff_t>(i)]);
    EXPECT_EQ(cells[0], records[i]["id"]);
    EXPECT_NEAR(std::stod(cells[1]), records[i]["scale"].get<double>(), 1.01e-4);
  }
}

TEST_F(SuiteSelect, never_writes_over_a_file) {
  const std::string out = folder_.write("mine.toml", "mine");
  expect_refused(select(with(a_site, {"--count", "2", "--out", out})), {"mine.toml", "--out"});
  EXPECT_EQ(read_file(out), "mine");
}

TEST_F(SuiteSelect, a_level_brings_its_limits_which_can_be_widened) {
  // Level 2, class E: V_S30 115 to 285 m/s, which none has.
  expect_refused(
      select({"--level", "2", "--site-class", "E", "--count", "1"}),
      {"candidates left: 0 of 5", "4 with Vs30 outside the limits", "1 with no Vs30 given"});
  const Json wider = select_json({"--level", "2", "--site-class", "E", "--count", "1",
                                  "--max-vs30-mps", "500", "--max-scale", "40"});
  EXPECT_EQ(wider["target"]["site_classes"], Json({"E"}));
  const Json kept =
      select_json({"--level", "2", "--count", "1", "--keep-incomplete", "--max-scale", "40"});
  EXPECT_EQ(kept["candidates"], 2);  // r2, and r4, which has no V_S30
}

TEST_F(SuiteSelect, a_shortfall_is_reported_and_is_no_error) {
  const Finished child =
      select({"--edition", "asce7_10", "--ss-g", "3", "--s1-g", "1", "--max-scale", "0.5",
              "--count", "2", "--out", folder_.path("short.toml").string()});
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(child.out, states("below"));
  EXPECT_THAT(read_file(folder_.path("short.toml")), states("below"));
}

TEST_F(SuiteSelect, a_site_may_state_its_one_class) {
  EXPECT_EQ(
      select_json(with(a_site, {"--site-class", "C", "--count", "2"}))["target"]["site_classes"],
      Json({"C"}));
}

TEST_F(SuiteSelect, a_target_by_a_spectrum_is_that_of_a_project) {
  folder_.write("site.csv", "period_s,design_sa_g\n0.01,0.2\n0.1,0.4\n0.5,0.4\n1,0.2\n5,0.04\n");
  const std::string project = folder_.write(
      "p.toml",
      "[project]\nname = \"p\"\n[site]\nedition = \"asce7_22\"\nspectrum = \"site.csv\"\n");
  const std::string out = folder_.path("chosen/suite.toml").string();
  std::filesystem::create_directories(folder_.path("chosen"));
  const Finished child =
      select({"--site", project, "--count", "2", "--max-scale", "50", "--out", out});
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(child.out, states("ASCE 7-22, spectrum of 5 points"));
  const Finished shown = succeeding({"suite", "show", out});
  EXPECT_THAT(shown.out, states("ASCE 7-22, spectrum of 5 points"));
  expect_refused(select({"--site", project, "--level", "2"}), {"--site", "--level"});
  expect_refused(select({"--site", folder_.write("n.toml", "[a]\n")}), {"no [site]"});
}

TEST_F(SuiteSelect, mistakes_are_refused) {
  expect_refused(select({"--level", "2", "--ss-g", "1"}), {"--level", "--ss-g"});
  expect_refused(select({}), {"--ss-g", "--s1-g", "--level", "--edition"});
  expect_refused(select({"--level", "2", "--edition", "asce7_16"}), {"--edition", "ASCE 7-10"});
  expect_refused(select({"--edition", "asce7_05", "--ss-g", "1", "--s1-g", "0.4"}),
                 {"asce7_05", "asce7_16"});
  expect_refused(select({"--ss-g", "-1", "--s1-g", "0.2"}), {"--ss-g", "not above 0"});
  expect_refused(select({"--edition", "asce7_16", "--ss-g", "200", "--s1-g", "0.2"}),
                 {"--ss-g: 200 g", "percent", "give 2"});
  expect_refused(select({"--level", "9"}), {"9", "0 to 4"});
  expect_refused(select({"--level", "2", "--site-class", "C"}), {"--site-class", "A to D"});
  expect_refused(select(with(a_site, {"--site-class", "E", "--site-classes", "D"})),
                 {"--site-class", "one of them"});
  expect_refused(select(with(a_site, {"--site-classes", "A,F"})), {"F"});
  expect_refused(select(with(a_site, {"--min-magnitude", "7", "--max-magnitude", "6"})),
                 {"--min-magnitude", "admits nothing"});
  expect_refused(select({"--edition", "asce7_10", "--ss-g", "1", "--s1-g", "0.4", "--max-scale",
                         "-2", "--count", "0"}),
                 {"--max-scale", "--count"});
  expect_refused(select(with(a_site, {"--count", "2", "--per-event", "0"})), {"--per-event"});
  expect_refused(select(with(a_site, {"--count", "4", "--per-event", "1"})),
                 {"4 records are required", "1 of an event allows 3"});
}

TEST_F(SuiteSelect, simulated_motions_are_written_as_a_recipe_of_the_selected) {
  const std::string out = folder_.path("out.toml").string();
  succeeding({"suite", "select", GLISSADE_SOURCE_DIR "/suites/synthetic_level0.toml", "--level",
              "0", "--count", "3", "--out", out});
  const Finished shown = succeeding({"suite", "show", out});
  EXPECT_THAT(shown.out, states("nearest", "level0_2"));
}

const std::vector<std::string> an_earthquake = {"--magnitude", "7",   "--distance-km", "12",
                                                "--vs30-mps",  "400", "--period-s",    "0.5",
                                                "--sa-g",      "0.8"};

/// The cells of the row of a period.
std::vector<std::string> row_at(const std::string& csv, const std::string& period) {
  for (const std::string& line : lines_of(csv))
    if (line.starts_with(period + ",")) return cells_of(line);
  return {};
}

TEST_F(SuiteSelect, target_prints_the_conditional_spectrum_as_csv) {
  const Finished child = succeeding(with({"suite", "target"}, an_earthquake));
  EXPECT_THAT(child.err, states("Sa(0.5 s) = 0.8 g", "M 7", "R_JB 12 km", "epsilon"));
  EXPECT_THAT(child.out,
              testing::StartsWith("period_s,predicted_median_sa_g,predicted_sigma,correlation,"
                                  "median_sa_g,sigma,p2_5_sa_g,p97_5_sa_g"));
  const std::vector<std::string> known = row_at(child.out, "0.5");
  ASSERT_EQ(known.size(), 8u);
  EXPECT_NEAR(std::stod(known[4]), 0.8, 1e-12);
  EXPECT_EQ(std::stod(known[5]), 0.0);
  const double epsilon = std::log(0.8 / std::stod(known[1])) / std::stod(known[2]);
  // Stated by its epsilon it is the same.
  std::vector<std::string> by_epsilon = with({"suite", "target"}, an_earthquake);
  *std::ranges::find(by_epsilon, "--sa-g") = "--epsilon";
  *std::ranges::find(by_epsilon, "0.8") = std::to_string(epsilon);
  const Finished same = run_program(by_epsilon);
  EXPECT_NEAR(std::stod(row_at(same.out, "0.5")[4]), 0.8, 1e-6);
}

TEST_F(SuiteSelect, records_of_a_conditional_spectrum_are_compared_with_it) {
  const std::string out = folder_.path("stripe.toml").string();
  const Json result =
      select_json(with(an_earthquake, {"--count", "3", "--max-scale", "50", "--out", out}));
  EXPECT_EQ(result["candidates"], 4);
  EXPECT_EQ(result["records"].size(), 3u);
  EXPECT_EQ(result["spectrum"].size(), 30u);
  EXPECT_EQ(result["left_out"][0]["reasons"], Json({"no second horizontal"}));
  EXPECT_THAT(result["warnings"].dump(), states("4 candidates for 3 records", "loosely"));
  const std::string suite = read_file(out);
  EXPECT_THAT(suite, states("Sa(0.5 s) = 0.8 g", "seed 1", "WARNING: ", "objective"));
  EXPECT_EQ(result["starts"], 60);
  EXPECT_GT(result["objective"], 0.0);
  EXPECT_THAT(suite, testing::Not(testing::HasSubstr("nearest_to_target")));
  EXPECT_EQ(run_program({"suite", "show", out}).status, 0);
  const Finished printed =
      select(with(an_earthquake, {"--count", "3", "--max-scale", "50", "--seed", "1"}));
  EXPECT_THAT(printed.out,
              states("WARNING", "records std", "objective", "60 starts", "left out", "r3"));
}

TEST_F(SuiteSelect, the_figure_of_a_conditional_spectrum_goes_to_a_folder_of_its_own) {
  const std::string figures = folder_.path("figures").string();
  const Finished child =
      select(with(an_earthquake, {"--count", "3", "--max-scale", "50", "--figures", figures}));
  EXPECT_EQ(child.status, 0) << child.err;
  EXPECT_THAT(read_file(figures + "/conditional_spectrum.svg"), states("target, mean"));
  expect_refused(select(with(an_earthquake, {"--count", "3", "--figures", figures})),
                 {"figures", "--overwrite"});
}

// As the head of the suite says, which the study takes.
TEST_F(SuiteSelect, a_stripe_of_the_example_study_is_what_is_selected_for_it) {
  const Json records =
      json_of({"suite", "select", GLISSADE_SOURCE_DIR "/suites/simulated_library.toml",
               "--period-s", "0.5", "--sa-g", "0.6", "--magnitude", "7", "--distance-km", "10",
               "--vs30-mps", "400", "--count", "10"})["records"];
  ASSERT_EQ(records.size(), 10u);
  const std::string stripe = read_file(GLISSADE_SOURCE_DIR "/studies/data/stripe_3.toml");
  for (const Json& record : records)
    EXPECT_THAT(stripe, testing::HasSubstr("id = " + record["id"].dump() + "\n"));
}

TEST_F(SuiteSelect, mistakes_of_a_conditional_spectrum_are_refused) {
  expect_refused(select({"--period-s", "0.5"}),
                 {"--sa-g", "--magnitude", "--distance-km", "--vs30-mps", "is missing"});
  expect_refused(select(with(an_earthquake, {"--level", "2"})), {"--period-s", "--level"});
  expect_refused(select(with(an_earthquake, {"--epsilon", "1"})), {"--epsilon", "one of them"});
  expect_refused(select(with(an_earthquake, {"--mechanism", "normal"})), {"normal", "reverse"});
  expect_refused(select(with(an_earthquake, {"--from-s", "1"})), {"--from-s", "--period-s"});
  expect_refused(select(with(an_earthquake, {"--max-scale", "1.01"})),
                 {"20 records are required", "with a factor outside the limit"});
  expect_refused(select(with(a_site, {"--count", "2", "--seed", "3"})), {"--seed", "conditional"});
  expect_refused(run_program({"suite", "target", "--period-s", "20"}),
                 {"--period-s: 20 s is not from 0.01 to 10 s"});
}

TEST_F(SuiteSelect, an_improbable_earthquake_is_warned_of) {
  const Finished child =
      succeeding({"suite", "target", "--period-s", "0.5", "--sa-g", "2.5", "--magnitude", "5",
                  "--distance-km", "80", "--vs30-mps", "760"});
  EXPECT_THAT(child.err, states("WARNING", "standard deviations above the median"));
}

// BSSA14: V_S30 from 150 to 1500 m/s, R_JB from 0 km.
TEST_F(SuiteSelect, a_site_outside_the_range_of_the_model_is_warned_of) {
  const auto target = [](const char* vs30, const char* distance) {
    return succeeding({"suite", "target", "--period-s", "0.5", "--epsilon", "1", "--magnitude", "7",
                       "--distance-km", distance, "--vs30-mps", vs30})
        .err;
  };
  EXPECT_THAT(target("120", "12"),
              states("WARNING", "V_S30 of 120 m/s is outside 150 to 1500 m/s", "BSSA14"));
  EXPECT_THAT(target("1600", "12"), testing::HasSubstr("V_S30 of 1600 m/s"));
  EXPECT_THAT(target("150", "0"), testing::Not(testing::HasSubstr("WARNING")));
}

}  // namespace
}  // namespace glissade::test
