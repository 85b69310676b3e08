// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "glissade/io/study_file.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::AllOf;
using testing::DoubleEq;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string head = "[study]\nname = \"chart\"\n[suite]\nfile = \"suite.toml\"\n";
const std::string intensity = "[intensity]\nmeasure = \"sds_g\"\nlevels = [0, 0.5, 1.5]\n";
const std::string axes = "[chart]\nslope_deg = [0, 2, 4]\nmu = [0.3, 0.5]\n";

class ChartStudy : public testing::Test {
 protected:
  ChartStudy() { folder_.write("suite.toml", ""); }
  StudyConfig read(const std::string& content) const {
    return read_study(folder_.write("study.toml", content));
  }
  TemporaryFolder folder_;
};

TEST_F(ChartStudy, axes_cuts_and_questions_are_read) {
  const StudyConfig study = read(head + intensity + axes + R"(period_s = [0.2, 1]
[chart.shown]
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
[array]
centre_of_mass_height_m = 0.3
base_width_m = 1.5
[building]
damping = 0.02
)");
  ASSERT_TRUE(study.chart && study.base);
  EXPECT_THAT(study.intensity.levels, ElementsAre(0.0, 0.5, 1.5));
  EXPECT_THAT(study.chart->slope_deg, ElementsAre(0.0, 2.0, 4.0));
  EXPECT_THAT(study.chart->mu, ElementsAre(0.3, 0.5));
  EXPECT_THAT(study.chart->period_s, ElementsAre(0.2, 1.0));
  EXPECT_EQ(study.chart->shown_slope_deg, 2.0);
  EXPECT_EQ(study.chart->shown_mu, 0.3);
  EXPECT_EQ(study.chart->shown_level, 0.5);
  ASSERT_EQ(study.chart->questions.size(), 2u);
  EXPECT_EQ(study.chart->questions[0].level, 1.5);  // the highest, where none is named
  EXPECT_EQ(study.chart->questions[0].mu, 0.47);
  EXPECT_EQ(study.chart->questions[1].level, 0.5);
  EXPECT_EQ(study.chart->questions[1].displacement_m, 0.6);
  EXPECT_FALSE(study.chart->questions[1].mu);
  EXPECT_EQ(study.base->centre_of_mass_height_m, 0.3);
  EXPECT_EQ(study.base->width_m, 1.5);
  EXPECT_EQ(std::get<Fixed>(study.building.damping).value, 0.02);
  EXPECT_EQ(study.orientation.component, ComponentChoice::both);
  EXPECT_EQ(study.orientation.sign, SignChoice::both);
  EXPECT_TRUE(study.thresholds_m.empty());
}

TEST_F(ChartStudy, what_is_left_out_is_a_rigid_roof_cut_in_the_middle) {
  const StudyConfig study = read(head + intensity + axes);
  EXPECT_THAT(study.chart->period_s, ElementsAre(0.0));
  EXPECT_EQ(study.chart->shown_slope_deg, 2.0);
  EXPECT_EQ(study.chart->shown_mu, 0.5);
  EXPECT_EQ(study.chart->shown_level, 1.5);
  EXPECT_FALSE(study.base);
}

TEST_F(ChartStudy, slopes_of_either_sign_are_mirror_images_to_the_last_bit) {
  const StudyConfig study = read(head + intensity +
                                 "[chart]\nmu = [0.3, 0.5]\n"
                                 "slope_deg = { from = -0.7, to = 0.7, count = 15 }\n");
  const std::vector<double>& slopes = study.chart->slope_deg;
  for (std::size_t i = 0; i < slopes.size(); ++i)
    EXPECT_EQ(slopes[i], -slopes[slopes.size() - 1 - i]);
  EXPECT_EQ(study.orientation.sign, SignChoice::positive);
}

TEST_F(ChartStudy, records_of_the_suite_can_be_named) {
  const StudyConfig study =
      read("[study]\nname = \"a\"\n[suite]\nfile = \"suite.toml\"\nrecords = [\"b\"]\n" +
           intensity + axes);
  EXPECT_THAT(study.records, ElementsAre("b"));
}

struct Fault {
  std::string text, message;
};

TEST_F(ChartStudy, what_makes_no_chart_has_one_clear_message_each) {
  const std::string chart = head + intensity + axes;
  const auto with_axes = [](const std::string& text) {
    return head + intensity + "[chart]\n" + text;
  };
  const std::vector<Fault> faults = {
      {with_axes("slope_deg = [2]\nmu = [0.3, 0.5]\n"), "chart.slope_deg has one value"},
      {with_axes("slope_deg = [0, 2]\nmu = [0.3]\n"), "chart.mu has one value"},
      {with_axes("slope_deg = []\nmu = [0.3, 0.5]\n"), "chart.slope_deg is empty"},
      {with_axes("slope_deg = [0, 2]\nmu = []\n"), "chart.mu is empty"},
      {with_axes("mu = [0.3, 0.5]\n"), "chart.slope_deg is missing"},
      {with_axes("slope_deg = [0, 95]\nmu = [0.3, 0.5]\n"), "-89.9 to 89.9"},
      {with_axes("slope_deg = [0, 2]\nmu = [-0.3, 0.5]\n"), "from 0 to 10"},
      {with_axes("slope_deg = [0, 2]\nmu = [0.3, 1e100]\n"), "from 0 to 10"},
      {with_axes("slope_deg = { from = 0, to = 7, count = 2000 }\n"
                 "mu = { from = 0, to = 1, count = 2000 }\n"),
       "12000000 combinations of slope, friction, period and level"},
      {with_axes("slope_deg = [-2, 2]\nmu = [0.3, 0.5]\n"), "one slope and its mirror image"},
      {with_axes("slope_deg = [2, 0]\nmu = [0.3, 0.5]\n"), "is not increasing"},
      {with_axes("slope_deg = [-3, 0, 2]\nmu = [0.3, 0.5]\n"), "not its mirror image 3"},
      {chart + "period_s = []\n", "chart.period_s is empty"},
      {chart + "period_s = [-1]\n", "0 or more"},
      {chart + "[orientation]\ncomponent = \"random\"\n", "first"},
      {with_axes("slope_deg = [-2, 0, 2]\nmu = [0.3, 0.5]\n[orientation]\nsign = \"both\"\n"),
       "run everything twice"},
      {chart + "[friction]\nmu = 0.5\n", "[friction] does not go with [chart]"},
      {chart + "[clearance]\nthresholds_m = [0.5]\n", "[clearance] does not go with [chart]"},
      {chart + "[building]\nperiod_s = 0.5\n", "give chart.period_s"},
      {chart + "[building]\ndamping = { distribution = \"uniform\", min = 0.02, max = 0.1 }\n",
       "a chart has one damping"},
      {chart + "[chart.shown]\nmu = 0.4\n", "chart.shown.mu = 0.4 is not on the chart"},
      {chart + "[chart.shown]\nlevel = 0.7\n", "is not on the chart"},
      {chart + "[[chart.read]]\nslope_deg = 5\nmu = 0.4\n", "is outside the chart"},
      {chart + "[[chart.read]]\nslope_deg = 2\nmu = 0.2\n", "is outside the chart"},
      {chart + "[[chart.read]]\nslope_deg = 2\n", "asks for a displacement or for a friction"},
      {chart + "[[chart.read]]\nslope_deg = 2\nmu = 0.4\ndisplacement_m = 0.5\n",
       "asks for a displacement or for a friction"},
      {chart + "[array]\nbase_width_m = 1\n", "array.centre_of_mass_height_m is missing"},
      {chart + "[array]\nbase_width_m = 0\ncentre_of_mass_height_m = 1\n", "above 0"},
      {head + "[intensity]\nmeasure = \"sds_g\"\nlevels = [0]\n" + axes, "no level above 0"},
      {"[study]\nname = \"a\"\n[suite]\nfile = \"suite.toml\"\nrecords = []\n" + intensity + axes,
       "suite.records is empty"},
  };
  for (const Fault& fault : faults) {
    try {
      read(fault.text);
      ADD_FAILURE() << "accepted: " << fault.message;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr(fault.message), HasSubstr("study.toml:")));
      EXPECT_EQ(error.problems().size(), 1u) << error.what();
    }
  }
}

}  // namespace
}  // namespace glissade
