// SPDX-License-Identifier: GPL-3.0-or-later
// [hazard] in study files.
#include "study_texts.hpp"

namespace glissade {
namespace {

class HazardStudy : public StudyFile {
 protected:
  void read_with_curve(const std::string& csv) const {
    folder_.write("h.csv", csv);
    read(needed + "[hazard]\ncurve = \"h.csv\"\ndesign_life_years = 25\n");
  }
};

TEST_F(HazardStudy, takes_a_curve_of_the_study_s_intensity_measure) {
  folder_.write("h.csv", "# a site\nsds_g,annual_rate\n0.1,0.02\n0.5,0.002\n2,1e-5\n");
  const StudyConfig study = read(needed + "[hazard]\ncurve = \"h.csv\"\ndesign_life_years = 25\n");
  ASSERT_TRUE(study.hazard);
  EXPECT_EQ(study.hazard->curve.points().size(), 3u);
  EXPECT_EQ(study.hazard->curve.points()[1].annual_rate, 0.002);
  EXPECT_EQ(study.hazard->source, "h.csv");
  EXPECT_EQ(study.hazard->design_life_years, 25.0);
  // 1/700, 1/2475, and 1 % in 50 years
  EXPECT_THAT(study.hazard->target_rates_per_year,
              testing::ElementsAre(1.0 / 700, 1.0 / 2475, rate_of(0.01, 50.0)));
}

TEST_F(HazardStudy, takes_a_power_law_and_target_rates) {
  const StudyConfig study =
      read(needed +
           "[hazard]\nk0 = 1e-4\nk = 2.5\ndesign_life_years = 50\ntarget_rates_per_year = [1e-4, "
           "1e-3]\n");
  EXPECT_NEAR(study.hazard->curve.annual_rate(4.0), 1e-4 / 32, 1e-19);
  EXPECT_THAT(study.hazard->target_rates_per_year, testing::ElementsAre(1e-3, 1e-4));
}

TEST_F(HazardStudy, assumes_a_curve_from_s_ds_by_the_risk_target) {
  const std::string life = "design_life_years = 25\n";
  const StudyConfig study = read(needed + "[hazard]\nsds_g = 1.2\nk = 2.5\n" + life);
  EXPECT_EQ(study.hazard->sds_g, 1.2);
  const HazardCurve expected = HazardCurve::of_risk_target(1.8, 2.5);
  EXPECT_NEAR(study.hazard->curve.annual_rate(0.7) / expected.annual_rate(0.7), 1.0, 1e-12);
  EXPECT_THAT(study.hazard->source, test::states("S_DS = 1.2 g"));
  // Beside a curve it is the site's S_DS.
  const StudyConfig law = read(needed + "[hazard]\nsds_g = 1.2\nk0 = 1e-3\nk = 2.5\n" + life);
  EXPECT_EQ(law.hazard->curve.annual_rate(1.0), 1e-3);
  EXPECT_EQ(law.hazard->sds_g, 1.2);
}

TEST_F(HazardStudy, refuses_no_curve_two_curves_and_half_a_law) {
  const std::string life = "design_life_years = 25\n";
  folder_.write("h.csv", "sds_g,annual_rate\n0.1,0.02\n0.5,0.002\n");
  const std::string hazard = needed + "[hazard]\n";
  refuses({{hazard + life, "study.toml:13", {"[hazard]", "curve"}},
           {hazard + "sds_g = 1.2\n" + life, "study.toml:13", {"[hazard]", "curve"}},
           {hazard + "curve = \"h.csv\"\nk0 = 1e-4\nk = 2\n" + life,
            "study.toml:14",
            {"[hazard]", "curve"}},
           {hazard + "k0 = 1e-4\n" + life, "study.toml:13", {"hazard.k"}},
           {hazard + "k0 = 1e-4\nk = 2\n", "study.toml:13", {"hazard.design_life_years"}},
           {hazard + "k0 = -1\nk = 2\n" + life, "study.toml:14", {"hazard.k0 = -1"}}});
}

TEST_F(HazardStudy, refuses_return_periods_and_warns_of_probabilities_in_place_of_rates) {
  refuses({{needed + "[hazard]\nk0 = 1e-4\nk = 2\ndesign_life_years = 25\n"
                     "target_rates_per_year = [475, 2475]\n",
            "study.toml:17",
            {"hazard.target_rates_per_year = 475", "return period", "1/475"}}});
  const auto warning = [](std::vector<HazardPoint> points) {
    return improbable_rates(HazardCurve(std::move(points)));
  };
  // Of 63, 10 and 2 % in 50 years, and the rates that these are.
  EXPECT_THAT(warning({{0.1, 0.63}, {0.5, 0.10}, {1.0, 0.02}}),
              test::states("0.5 g once in 10 years", "probabilities in 50 years"));
  EXPECT_EQ(warning({{0.1, rate_of(0.63, 50)}, {0.5, rate_of(0.1, 50)}, {1.0, rate_of(0.02, 50)}}),
            "");
  EXPECT_EQ(improbable_rates(HazardCurve::power_law(1e-3, 2.2)), "");
  EXPECT_NE(improbable_rates(HazardCurve::power_law(0.02, 2.2)), "");
}

TEST_F(HazardStudy, refuses_a_curve_that_is_none) {
  const auto read_curve = [&](const std::string& csv) { read_with_curve(csv); };
  const std::string head = "sds_g,annual_rate\n";
  expect_refusals(read_curve, {{"pga_g,annual_rate\n0.1,0.02\n0.5,0.002\n",
                                "study.toml:14",
                                {"h.csv:1", "sds_g,annual_rate"}},
                               {head + "0.1,0.02\n0.5,0.02\n", "study.toml:14", {"h.csv:3"}},
                               {head + "0.1,0.02\n0.1,0.01\n", "study.toml:14", {"h.csv:3"}},
                               {head + "0,0.02\n0.1,0.01\n", "study.toml:14", {"h.csv:2"}},
                               {head + "0.1,0.02\n0.2,0\n", "study.toml:14", {"h.csv:3"}},
                               {head + "0.1,0.02\n", "study.toml:14", {"hazard.curve"}}});
}

// The lowest level is 0.5: 10 x 0.5^-2 = 40 earthquakes a year.
TEST_F(HazardStudy, needs_a_fragility_every_history_and_earthquakes_that_can_be_followed) {
  const std::string hazard = "[hazard]\nk0 = 1e-4\nk = 2\ndesign_life_years = 25\n";
  EXPECT_THAT(problems_of([&] { read(without_fragility + hazard); }),
              testing::Contains(is_problem("study.toml:11",
                                           std::vector<std::string>{"[hazard]", "[fragility]"})));
  refuses({{needed + "stop_at_largest = true\n" + hazard, "study.toml:13", {"[hazard]"}},
           {needed + "[hazard]\nk0 = 10\nk = 2\ndesign_life_years = 50\n",
            "study.toml:14",
            {"2000", "0.5", "1000"}}});
}

}  // namespace
}  // namespace glissade
