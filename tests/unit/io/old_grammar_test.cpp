// SPDX-License-Identifier: GPL-3.0-or-later
//
// Studies of the earlier grammar: what the messages name, and that what they say to write gives
// the study of before.
#include <algorithm>

#include "study_texts.hpp"

namespace glissade {
namespace {

using testing::IsEmpty;
using testing::UnorderedElementsAre;

class OldGrammar : public StudyFile {
 protected:
  std::vector<Problem> problems(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& refused) {
      return refused.problems();
    }
    return {};
  }
  /// The key that each problem begins with.
  std::vector<std::string> keys(const std::string& text) const {
    std::vector<std::string> found;
    for (const Problem& p : problems(text)) found.push_back(p.what.substr(0, p.what.find(' ')));
    return found;
  }
  /// A message says to write each of these.
  void expect_suggested(const std::string& text, const std::vector<std::string>& written) const {
    for (const std::string& w : written) {
      EXPECT_TRUE(std::ranges::any_of(problems(text), [&](const Problem& p) {
        return p.suggestion.find(w) != std::string::npos;
      })) << w;
    }
  }
  const std::string head_ = study_part + suite_part;
  const std::string levels_ = "[intensity]\nmeasure = \"sds_g\"\nlevels = [0.1, 2]\n";
};

TEST_F(OldGrammar, a_fragility_study_becomes_the_same_study_on_one_axis) {
  const std::string old = head_ + levels_ +
                          "[friction]\nmean = 0.55\nstd = 0.04\ndesign_run = false\n"
                          "[orientation]\ncomponent = \"random\"\n[vertical]\nuse = \"none\"\n"
                          "[sampling]\nsamples = 8192\n[clearance]\nthresholds_m = [0.15]\n";
  EXPECT_THAT(keys(old),
              UnorderedElementsAre("friction.mean", "friction.std", "friction.design_run",
                                   "clearance.thresholds_m", "model.axes"));
  expect_suggested(old, {"friction.mu", "friction.value = \"sampled\"", "[fragility]", "axes = 1"});
  const StudyConfig now =
      read(head_ + levels_ +
           "[friction]\nmu = { mean = 0.55, std = 0.04 }\nvalue = \"sampled\"\n"
           "[orientation]\ncomponent = \"random\"\n[vertical]\nuse = \"none\"\n"
           "[sampling]\nsamples = 8192\n[fragility]\nthresholds_m = [0.15]\n[model]\naxes = 1\n");
  EXPECT_FALSE(now.two_axes());
  EXPECT_EQ(now.friction.values, std::vector{FrictionValue::as_drawn});
  EXPECT_EQ(now.orientation.choice, OrientationChoice::random);
}

TEST_F(OldGrammar, a_chart_of_one_component_stays_one_of_one_component) {
  const std::string levels = "[intensity]\nmeasure = \"ppa_g\"\nlevels = [0, 1]\n";
  const std::string old = head_ + levels + "[chart]\nslope_deg = [-7, 0, 7]\nmu = [0.1, 0.8]\n" +
                          "[orientation]\ncomponent = \"first\"\n[vertical]\nuse = \"none\"\n";
  EXPECT_THAT(keys(old), UnorderedElementsAre("chart.slope_deg", "chart.mu",
                                              "orientation.component", "model.axes"));
  expect_suggested(
      old, {"roof.slope_deg", "friction.mu", "orientation.choice = \"as_recorded\"", "axes = 1"});
  const StudyConfig now = read(
      head_ + levels + "[chart]\n[roof]\nslope_deg = [-7, 0, 7]\n[friction]\nmu = [0.1, 0.8]\n" +
      "[orientation]\nchoice = \"as_recorded\"\n[vertical]\nuse = \"none\"\n[model]\naxes = 1\n");
  EXPECT_FALSE(now.two_axes());
  EXPECT_EQ(now.orientation.choice, OrientationChoice::as_recorded);
}

TEST_F(OldGrammar, both_orientations_of_a_chart_are_all_permutations_not_random_ones) {
  const std::string old = head_ + levels_ + "[chart]\nslope_deg = [0, 7]\nmu = [0.1, 0.8]\n" +
                          "[orientation]\ncomponent = \"both\"\nsign = \"both\"\n";
  EXPECT_THAT(keys(old),
              UnorderedElementsAre("chart.slope_deg", "chart.mu", "orientation.component",
                                   "orientation.sign", "model.axes"));
  expect_suggested(old, {"leave it out", "all_permutations"});
  for (const Problem& p : problems(old))
    EXPECT_EQ(p.suggestion.find("random"), std::string::npos) << p.suggestion;
  EXPECT_EQ(read(head_ + levels_ + "[chart]\n[roof]\nslope_deg = [0, 7]\n[friction]\n" +
                 "mu = [0.1, 0.8]\n[model]\naxes = 1\n")
                .orientation.choice,
            OrientationChoice::all_permutations);
}

TEST_F(OldGrammar, a_clearance_study_is_answered_key_by_key_with_the_defaults_that_changed) {
  const std::string old = head_ +
                          "[clearance_study]\nperiod_s = [0.5]\nrise_in_12 = [0.25]\nmu = 0.47\n"
                          "vertical = [\"required\"]\nvertical_period_s = [0.1]\n"
                          "displacement = \"vector\"\norientations = \"sixteen\"\n";
  EXPECT_THAT(keys(old),
              UnorderedElementsAre("clearance_study", "clearance_study.period_s",
                                   "clearance_study.rise_in_12", "clearance_study.mu",
                                   "clearance_study.vertical", "clearance_study.vertical_period_s",
                                   "clearance_study.displacement", "clearance_study.orientations",
                                   "clearance_study.mass_ratio", "clearance_study.slope_axis",
                                   "clearance_study.fraction_of_mce"));
  expect_suggested(old, {"[clearance] orientation = \"median\"", "building.period_s",
                         "roof.rise_in_12", "friction.mu", "vertical.use", "vertical.period_s",
                         "model.displacement", "all_permutations", "building.mass_ratio = 0.05",
                         "orientation.slope_axis = [\"e_w\", \"n_s\"]", "intensity.levels"});
  EXPECT_THAT(keys(head_ + "[intensity]\nmeasure = \"mce_fraction\"\n"
                           "levels = [0.6666666666666666]\n[clearance]\norientation = \"median\"\n"
                           "[building]\nperiod_s = [0.5]\nmass_ratio = 0.05\n[roof]\n"
                           "rise_in_12 = [0.25]\n[friction]\nmu = 0.47\n[vertical]\n"
                           "use = [\"required\"]\nperiod_s = [0.1]\n[model]\n"
                           "displacement = \"vector\"\n[orientation]\n"
                           "choice = \"all_permutations\"\nslope_axis = [\"e_w\", \"n_s\"]\n"),
              IsEmpty());
}

}  // namespace
}  // namespace glissade
