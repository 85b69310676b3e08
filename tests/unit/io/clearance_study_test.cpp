// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <cmath>

#include "glissade/core/units.hpp"
#include "glissade/io/study_file.hpp"
#include "problems.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;

const std::string study_text = R"([study]
name = "c"
[suite]
file = "suite.toml"
[intensity]
measure = "mce_fraction"
levels = [0.5, 1]
[model]
axes = 2
displacement = "vector"
[building]
period_s = [0.2, 1.0]
mass_ratio = [0, 0.05]
response_modification = [0, 4]
hardening_ratio = 0.02
[roof]
rise_in_12 = [0.25, 1]
[friction]
mu = { mean = 0.5, std = 0.02 }
across_mu = 0.6
[array]
support = ["no_array", "isolated"]
[vertical]
use = ["none", "if_available"]
period_s = [0, 0.3]
[orientation]
choice = "azimuths"
slope_axis = ["n_s"]
[clearance]
factor = 1.2
orientation = "median"
[base_shear]
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

class ClearanceStudy : public testing::Test {
 protected:
  ClearanceStudy() { folder_.write("suite.toml", ""); }
  StudyConfig read(const std::string& text) const {
    return read_study(folder_.write("study.toml", text));
  }
  TemporaryFolder folder_;
};

TEST_F(ClearanceStudy, is_read_as_it_is_written) {
  const StudyConfig c = read(study_text);
  ASSERT_TRUE(c.clearance);
  EXPECT_EQ(c.clearance->factor, 1.2);
  EXPECT_EQ(c.clearance->orientation, OrientationRule::median);
  EXPECT_EQ(c.intensity.measure, IntensityMeasure::mce_fraction);
  EXPECT_THAT(c.intensity.levels, ElementsAre(0.5, 1.0));
  EXPECT_EQ(c.model.displacement, DisplacementMeasure::vector);
  EXPECT_THAT(c.quantities.at("building", "period_s").values, ElementsAre(0.2, 1.0));
  EXPECT_THAT(c.quantities.at("building", "response_modification").values, ElementsAre(0.0, 4.0));
  ASSERT_EQ(c.quantities.at("roof", "slope_deg").values.size(), 2u);
  EXPECT_DOUBLE_EQ(12.0 * std::tan(c.quantities.at("roof", "slope_deg").values[0] * rad_per_deg),
                   0.25);
  EXPECT_THAT(c.support, ElementsAre(ArraySupport::isolated, ArraySupport::no_array));
  EXPECT_THAT(c.vertical, ElementsAre(VerticalChoice::none, VerticalChoice::if_available));
  EXPECT_THAT(c.quantities.at("vertical", "period_s").values, ElementsAre(0.0, 0.3));
  EXPECT_DOUBLE_EQ(design_friction(*c.quantities.at("friction", "mu").drawn), 0.46);
  EXPECT_TRUE(c.quantities.at("friction", "across_mu").is_always(0.6));
  EXPECT_THAT(c.orientation.slope_axis, ElementsAre(SlopeAxis::n_s));
  EXPECT_EQ(c.orientation.choice, OrientationChoice::azimuths);
  EXPECT_TRUE(c.base_shear);
}

TEST_F(ClearanceStudy, what_is_left_out_is_walterss_but_for_the_orientation) {
  const StudyConfig c = read(R"([study]
name = "c"
[suite]
file = "suite.toml"
[intensity]
measure = "mce_fraction"
levels = [1]
[model]
axes = 2
[friction]
mu = { mean = 0.55, std = 0.04 }
[clearance]
)");
  EXPECT_EQ(c.clearance->factor, 1.1);
  EXPECT_EQ(c.clearance->orientation, OrientationRule::largest);
  EXPECT_THAT(c.friction.values, ElementsAre(FrictionValue::design));
  EXPECT_FALSE(c.draws());
  EXPECT_EQ(c.orientation.choice, OrientationChoice::all_permutations);
  EXPECT_EQ(c.model.displacement, DisplacementMeasure::srss);
  EXPECT_TRUE(c.quantities.at("building", "damping").is_always(0.05));
}

TEST_F(ClearanceStudy, orientations_do_not_depend_on_other_analyses) {
  const std::string text =
      replaced(replaced(study_text, "choice = \"azimuths\"\n", ""), "[base_shear]",
               "[fragility]\nthresholds_m = [0.1]\n[base_shear]");
  EXPECT_EQ(read(text).orientation.choice, OrientationChoice::all_permutations);
}

TEST_F(ClearanceStudy, what_is_wrong_is_reported_with_its_line) {
  struct Fault {
    const char *from, *to, *where;
    std::vector<std::string> facts;
  };
  for (const auto& [from, to, where, facts] :
       {Fault{"[0, 0.05]", "[-0.1]", "study.toml:13", {"building.mass_ratio", "-0.1"}},
        {"[0, 0.05]", "[0.5, 1.5]", "study.toml:13", {"building.mass_ratio", "1.5"}},
        {"across_mu = 0.6", "across_mu = 0", "study.toml:20", {"friction.across_mu"}},
        {"factor = 1.2", "factor = 0.9", "study.toml:30", {"clearance.factor = 0.9", "1"}},
        {"\"median\"", "\"mean\"", "study.toml:31", {"clearance.orientation", "largest, median"}},
        {"\"azimuths\"", "\"as_recorded\"", "study.toml:31", {"clearance.orientation"}},
        {"across_mu = 0.6", "value = \"sampled\"", "study.toml:20", {"friction.value"}},
        {"mu = { mean = 0.5, std = 0.02 }",
         "value = \"design\"\nmu = 0.5",
         "study.toml:19",
         {"friction.value"}},
        {"across_mu = 0.6",
         "value = [\"sampled\", \"design\"]",
         "study.toml:20",
         {"\"sampled\"", "friction.value"}},
        {"[clearance]",
         "[sampling]\nbootstrap_replicates = 200\n[clearance]",
         "study.toml:30",
         {"sampling.bootstrap_replicates"}},
        {"[clearance]",
         "[sampling]\nsamples = 4\n[clearance]",
         "study.toml:30",
         {"sampling.samples"}},
        {"hardening_ratio", "hardening", "study.toml:15", {"building.hardening"}},
        {"axes = 2\ndisplacement = \"vector\"", "axes = 1", "study.toml:31", {"[base_shear]"}}}) {
    EXPECT_THAT(problems_of([&] { read(replaced(study_text, from, to)); }),
                testing::Contains(is_problem(where, facts)))
        << to;
  }
}

TEST_F(ClearanceStudy, a_suite_that_is_scaled_to_its_target_needs_no_leave) {
  const std::string by_sds = replaced(study_text, "\"mce_fraction\"", "\"sds_g\"");
  EXPECT_EQ(read(by_sds).intensity.measure, IntensityMeasure::sds_g);
  EXPECT_THAT(problems_of([&] { read(replaced(by_sds, "factor = 1.2", "without_target = true")); }),
              one_problem("study.toml:30", "clearance.without_target"));
}

TEST(clearance_studies, that_come_with_glissade_are_walterss) {
  const std::filesystem::path studies = std::filesystem::path(GLISSADE_SOURCE_DIR) / "studies";
  const StudyConfig example = read_study(studies / "14_walters_example.toml");
  // Walters et al. (2012): "Building Type and Modal Behavior", "Specific Application Example".
  EXPECT_THAT(example.quantities.at("building", "period_s").values,
              ElementsAre(0.2, 0.4, 0.7, 1.0, 1.5, 2.0));
  EXPECT_THAT(example.quantities.at("building", "mass_ratio").values, ElementsAre(0.05, 0.10));
  EXPECT_TRUE(example.quantities.at("friction", "mu").is_always(0.47));
  EXPECT_FALSE(example.friction.across_is_given);
  for (const char* name :
       {"15_walters_level_threshold", "16_walters_yielding", "17_walters_base_shear",
        "18_walters_slope", "19_walters_mce", "20_walters_permutations", "21_walters_vertical"}) {
    const StudyConfig c = read_study(studies / (std::string(name) + ".toml"));
    EXPECT_TRUE(c.clearance && c.two_axes()) << name;
    EXPECT_EQ(c.clearance->orientation, OrientationRule::median) << name;
    EXPECT_NEAR(c.quantities.at("roof", "slope_deg").values.front(), 1.19, 0.01) << name;  // 1/4:12
  }
}

}  // namespace
}  // namespace glissade
