// SPDX-License-Identifier: GPL-3.0-or-later
#include "study_texts.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;

const std::string head = "[study]\nname = \"chart\"\n[suite]\nfile = \"suite.toml\"\n";
const std::string intensity = "[intensity]\nmeasure = \"sds_g\"\nlevels = [0, 0.5, 1.5]\n";
const std::string axes = "[roof]\nslope_deg = [0, 2, 4]\n[friction]\nmu = [0.3, 0.5]\n";
const std::string chart = head + intensity + axes + "[chart]\n";

class ChartStudy : public StudyFile {};

TEST_F(ChartStudy, slopes_of_cuts_and_questions_may_be_rises_in_12) {
  const StudyConfig study = read(head + intensity +
                                 "[roof]\nrise_in_12 = [0, 0.25, 1]\n[friction]\n"
                                 "mu = [0.3, 0.5]\n[chart]\nshown = { rise_in_12 = \"0.25:12\" }\n"
                                 "[[chart.read]]\nrise_in_12 = 0.5\nmu = 0.4\n");
  EXPECT_EQ(study.chart->shown_slope_deg, study.quantities.at("roof", "slope_deg").values[1]);
  EXPECT_EQ(study.chart->questions.at(0).slope_deg, slope_of_rise_deg(0.5));
}

TEST_F(ChartStudy, axes_cuts_and_questions_are_read) {
  const StudyConfig study = read(chart + R"([chart.shown]
slope_deg = 2
mu = 0.3
level = 0.5
[[chart.read]]
slope_deg = 1.19
mu = 0.47
[[chart.read]]
level = 0.5
slope_deg = 4
displacement_m = 0.6
[building]
period_s = [0.2, 1]
)");
  ASSERT_TRUE(study.chart);
  EXPECT_THAT(study.intensity.levels, ElementsAre(0.0, 0.5, 1.5));
  EXPECT_THAT(study.quantities.at("roof", "slope_deg").values, ElementsAre(0.0, 2.0, 4.0));
  EXPECT_THAT(study.quantities.at("friction", "mu").values, ElementsAre(0.3, 0.5));
  EXPECT_THAT(study.quantities.at("building", "period_s").values, ElementsAre(0.2, 1.0));
  EXPECT_EQ(study.chart->shown_slope_deg, 2.0);
  EXPECT_EQ(study.chart->shown_mu, 0.3);
  EXPECT_EQ(study.chart->shown_level, 0.5);
  ASSERT_EQ(study.chart->questions.size(), 2u);
  EXPECT_EQ(study.chart->questions[0].level, 1.5);  // the highest, where none is named
  EXPECT_EQ(study.chart->questions[0].mu, 0.47);
  EXPECT_EQ(study.chart->questions[1].level, 0.5);
  EXPECT_EQ(study.chart->questions[1].displacement_m, 0.6);
  EXPECT_FALSE(study.chart->questions[1].mu);
  EXPECT_EQ(study.orientation.choice, OrientationChoice::all_permutations);
  EXPECT_TRUE(study.thresholds_m().empty());
}

const std::string published = "[[published]]\n";

TEST_F(ChartStudy, published_values_are_read_in_the_units_of_their_axes) {
  const StudyConfig study = read(
      chart + published + "figure = \"chart_contours\"\nx = 0.4\ny = 3\nsource = \"A (2019)\"\n" +
      published + "figure = \"chart_intensity\"\nx = 1.5\ny = \"10 in\"\nsource = \"B\"\n");
  ASSERT_EQ(study.published.size(), 2u);
  EXPECT_EQ(study.published[0].figure, "chart_contours");
  EXPECT_EQ(study.published[0].x, 0.4);
  EXPECT_EQ(study.published[0].y, 3.0);
  EXPECT_EQ(study.published[0].source, "A (2019)");
  EXPECT_EQ(study.published[1].x, 1.5);
  EXPECT_NEAR(study.published[1].y, 0.254, 1e-15);
}

TEST_F(ChartStudy, what_is_left_out_is_a_rigid_roof_cut_in_the_middle) {
  const StudyConfig study = read(chart);
  EXPECT_TRUE(study.quantities.at("building", "period_s").is_always(0.0));
  EXPECT_EQ(study.chart->shown_slope_deg, 2.0);
  EXPECT_EQ(study.chart->shown_mu, 0.5);
  EXPECT_EQ(study.chart->shown_level, 1.5);
  EXPECT_FALSE(study.draws());
}

TEST_F(ChartStudy, of_friction_that_is_drawn_has_its_samples) {
  const StudyConfig study =
      read(head + intensity +
           "[roof]\nslope_deg = [0, 2]\n[friction]\nmu = { mean = 0.5, std = 0.05 }\n[chart]\n");
  EXPECT_THAT(study.friction.values, ElementsAre(FrictionValue::as_drawn));
  EXPECT_NEAR(study.chart->shown_mu, 0.5, 1e-12);
  EXPECT_TRUE(study.draws());
  EXPECT_EQ(study.orientation.choice, OrientationChoice::all_permutations);
}

TEST_F(ChartStudy, slopes_of_either_sign_are_mirror_images_to_the_last_bit) {
  const StudyConfig study = read(head + intensity +
                                 "[friction]\nmu = [0.3, 0.5]\n[chart]\n[roof]\n"
                                 "slope_deg = { from = -0.7, to = 0.7, count = 15 }\n");
  const std::vector<double>& slopes = study.quantities.at("roof", "slope_deg").values;
  ASSERT_EQ(slopes.size(), 15u);
  for (std::size_t i = 0; i < slopes.size(); ++i)
    EXPECT_EQ(slopes[i], -slopes[slopes.size() - 1 - i]);
  EXPECT_GE(study.chart->shown_slope_deg, 0.0);
}

TEST_F(ChartStudy, what_makes_no_chart_has_one_clear_message_each) {
  const auto with_axes = [](const std::string& slope, const std::string& mu) {
    return head + intensity + "[chart]\n[roof]\nslope_deg = " + slope + "\n[friction]\nmu = " + mu +
           "\n";
  };
  const std::string drawn = with_axes("[0, 2]", "{ mean = 0.5, std = 0.05 }");
  refuses({
      {with_axes("2", "[0.3, 0.5]"), "study.toml:8", {"roof.slope_deg"}},
      {with_axes("[-2, 2]", "[0.3, 0.5]"), "study.toml:8", {"roof.slope_deg"}},
      {with_axes("{ distribution = \"uniform\", min = 0, max = 2 }", "[0.3, 0.5]"),
       "study.toml:8",
       {"roof.slope_deg"}},
      {head + intensity + "[chart]\n[friction]\nmu = [0.3, 0.5]\n",
       "study.toml:8",
       {"roof.slope_deg"}},
      {with_axes("[-3, 0, 2, 4]", "[0.3, 0.5]"), "study.toml:10", {"roof.slope_deg", "-3", "3"}},
      {chart + "[chart.shown]\nmu = 0.4\n", "study.toml:14", {"chart.shown.mu = 0.4"}},
      {chart + "[chart.shown]\nlevel = 0.7\n", "study.toml:14", {"chart.shown.level = 0.7"}},
      {chart + "[[chart.read]]\nslope_deg = 5\nmu = 0.4\n",
       "study.toml:14",
       {"chart.read.slope_deg = 5", "0", "4"}},
      {chart + "[[chart.read]]\nslope_deg = 2\nmu = 0.2\n",
       "study.toml:15",
       {"chart.read.mu = 0.2", "0.3", "0.5"}},
      {chart + "[[chart.read]]\nslope_deg = 2\n",
       "study.toml:13",
       {"[[chart.read]]", "displacement_m", "mu"}},
      {chart + "[[chart.read]]\nslope_deg = 2\nmu = 0.4\ndisplacement_m = 0.5\n",
       "study.toml:13",
       {"[[chart.read]]", "displacement_m", "mu"}},
      {chart + "[sampling]\nsamples = 64\n", "study.toml:14", {"sampling.samples"}},
      {chart + "[sampling]\nmethod = \"sobol\"\n", "study.toml:14", {"sampling.method"}},
      {drawn + "value = \"design\"\n", "study.toml:13", {"friction.value"}},
      {drawn + "value = [\"sampled\", \"design\"]\n",
       "study.toml:13",
       {"\"design\"", "friction.value"}},
      {drawn + "[chart.shown]\nmu = 0.4\n", "study.toml:14", {"chart.shown.mu = 0.4"}},
      {drawn + "[[chart.read]]\nslope_deg = 1\nmu = 0.4\n",
       "study.toml:15",
       {"chart.read.mu = 0.4", "0.5"}},
      {head + "[intensity]\nmeasure = \"sds_g\"\nlevels = [0]\n" + axes + "[chart]\n",
       "study.toml:7",
       {"intensity.levels", "0"}},
      {chart + published + "figure = \"contours\"\nx = 1\ny = 1\nsource = \"A\"\n",
       "study.toml:14",
       {"\"contours\"", "\"chart_contours\"", "\"period\""}},
      {chart + published + "figure = \"period\"\nx = 1\ny = 1\nsource = \"A\"\n",
       "study.toml:14",
       {"period is a figure of [clearance]", "add that table"}},
      {chart + published + "figure = \"chart_intensity\"\nx = 1\ny = -1\nsource = \"A\"\n",
       "study.toml:16",
       {"published.y", "0 or more"}},
      {chart + published + "figure = \"chart_contours\"\nx = 0.3\ny = \"1 in\"\nsource = \"A\"\n",
       "study.toml:16",
       {"published.y", "1 in"}},
      {chart + published + "figure = \"chart_contours\"\nx = 0.3\ny = 1\n",
       "study.toml:13",
       {"published.source is missing"}},
      {head + "[intensity]\nmeasure = \"pga_g\"\nlevels = [1]\n" + axes +
           "[chart]\n[standards]\ncompare = [\"asce7_16\"]\n",
       "study.toml:13",
       {"[standards] needs intensity.measure = \"sds_g\""}},
  });
}

}  // namespace
}  // namespace glissade
