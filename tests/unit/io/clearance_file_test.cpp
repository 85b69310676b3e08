// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/io/clearance_file.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "glissade/core/file.hpp"
#include "glissade/core/units.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::HasSubstr;

const std::string study_text = R"([study]
name = "c"
seed = 5
[suite]
file = "suite.toml"
[clearance_study]
fraction_of_mce = [0.5, 1]
period_s = [0.2, 1.0]
rise_in_12 = [0.25, 1]
mass_ratio = [0, 0.05]
response_modification = [1, 4]
hardening_ratio = 0.02
mu_e_w = { mean = 0.5, std = 0.02 }
mu_n_s = 0.6
slope_axis = ["n_s"]
support = ["no_array", "isolated"]
vertical = ["none", "if_available"]
vertical_period_s = [0, 0.3]
orientations = "azimuths"
displacement = "vector"
[[paper]]
about = "mce"
where = "Fig. 18"
says = "close"
[[paper]]
about = "period"
where = "Fig. 13"
says = "10.21 inches"
displacement_in = 10.21
period_s = 1.0
)";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

class ClearanceStudyFile : public testing::Test {
 protected:
  ClearanceStudyFile() { folder_.write("suite.toml", "[suite]\nname = \"s\"\n"); }
  std::string problems_of(const std::string& text) const {
    try {
      read_clearance_study(folder_.write("study.toml", text));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }
  TemporaryFolder folder_;
};

TEST_F(ClearanceStudyFile, is_read_as_it_is_written) {
  const auto file = folder_.write("study.toml", study_text);
  EXPECT_TRUE(is_clearance_study(file));
  const ClearanceConfig c = read_clearance_study(file);
  EXPECT_EQ(c.seed, 5u);
  EXPECT_EQ(c.grid.fraction_of_mce, (std::vector<double>{0.5, 1.0}));
  EXPECT_EQ(c.grid.period_s, (std::vector<double>{0.2, 1.0}));
  ASSERT_EQ(c.grid.slope_deg.size(), 2u);
  EXPECT_DOUBLE_EQ(12.0 * std::tan(c.grid.slope_deg[0] * rad_per_deg), 0.25);
  EXPECT_EQ(c.grid.support, (std::vector<ArraySupport>{ArraySupport::isolated,  // first: shown
                                                       ArraySupport::no_array}));
  EXPECT_EQ(c.grid.vertical, (std::vector<VerticalCondition>{{VerticalChoice::none, 0.0},
                                                             {VerticalChoice::if_available, 0.0},
                                                             {VerticalChoice::if_available, 0.3}}));
  EXPECT_DOUBLE_EQ(c.friction[0].design(), 0.46);
  EXPECT_DOUBLE_EQ(c.friction[1].design(), 0.6);
  EXPECT_EQ(c.slope_axes, std::vector<SlopeAxis>{SlopeAxis::n_s});
  EXPECT_EQ(c.orientation, OrientationChoice::azimuths);
  EXPECT_EQ(c.displacement, DisplacementMeasure::vector);
  EXPECT_EQ(c.hardening_ratio, 0.02);
  ASSERT_EQ(c.statements.size(), 2u);
  EXPECT_TRUE(std::isnan(c.statements[0].displacement_m));
  EXPECT_DOUBLE_EQ(c.statements[1].displacement_m, 10.21 * 0.0254);
}

TEST_F(ClearanceStudyFile, what_is_left_out_is_walterss) {
  const ClearanceConfig c = read_clearance_study(folder_.write("study.toml", R"([study]
name = "c"
[suite]
files = ["suite.toml", "suite.toml"]
[clearance_study]
period_s = [0.2]
slope_deg = [1.2]
mu = 0.47
)"));
  EXPECT_EQ(c.suite_files.size(), 2u);
  EXPECT_EQ(c.grid.fraction_of_mce, std::vector<double>{2.0 / 3});
  EXPECT_EQ(c.grid.mass_ratio, std::vector<double>{0.05});
  EXPECT_EQ(c.grid.response_modification, std::vector<double>{1.0});
  EXPECT_EQ(c.orientation, OrientationChoice::sixteen);
  EXPECT_EQ(c.displacement, DisplacementMeasure::srss);
  EXPECT_EQ(c.slope_axes.size(), 2u);
  EXPECT_EQ(c.clearance_factor, 1.1);
  EXPECT_EQ(c.damping, 0.05);
}

TEST_F(ClearanceStudyFile, what_is_wrong_is_told_with_its_line) {
  struct Case {
    const char *from, *to, *told;
  };
  for (const Case& c : {
           Case{"[0, 0.05]", "[-0.1]", "study.toml:10: clearance_study.mass_ratio = -0.1 is not"},
           Case{"[0, 0.05]", "[0.5, 1.5]", "mass_ratio = 1.5 is not from 0 to 1"},
           Case{"[1, 4]", "[0.5, 2]", "response_modification = 0.5 is not 1 or more"},
           Case{"[0.2, 1.0]", "[0, 1.0]", "rigid building (period 0) cannot yield"},
           Case{"[0.2, 1.0]", "{ from = 0.1, to = 2, count = 10000 }",
                "clearance_study asks for 960000 conditions"},
           Case{"[0.2, 1.0]", "[-1, 1.0]", "period_s = -1 is not 0 or more"},
           Case{"rise_in_12 = [0.25, 1]", "slope_deg = [-1, 2]", "slope_deg = -1 is not in deg"},
           Case{"rise_in_12 = [0.25, 1]", "slope_deg = [1, 90]", "slope_deg = 90 is not in deg"},
           Case{"[0.25, 1]", "[0.25, 7.3]", "a friction of 0.6 does not hold the array at rest"},
           Case{"mu_n_s = 0.6", "mu_n_s = 0", "mu_n_s = 0 is not above 0"},
           Case{"mu_n_s = 0.6", "", "clearance_study.mu_n_s is missing"},
           Case{"mu_n_s = 0.6", "mu = 0.6", "mu_e_w and mu are both given"},
           Case{"std = 0.02", "std = 0.3", "leaves no friction to design with"},
           Case{"[\"no_array\", \"isolated\"]", "[\"anchored\"]", "leaves out \"isolated\""},
           Case{"[\"none\", \"if_available\"]", "[\"none\", \"none\"]", "names one twice"},
           Case{"\"azimuths\"", "\"azimut\"", "did you mean \"azimuths\""},
           Case{"period_s = 1.0\n", "period_s = 0.9\n", "a period of 0.9 s, which is not among"},
           Case{"about = \"mce\"\n", "", "paper.about is missing"},
           Case{"seed = 5", "sed = 5", "study.sed is not a known key"},
           Case{"hardening_ratio", "hardening", "clearance_study.hardening is not a known key"},
           Case{"\"suite.toml\"", "\"sweet.toml\"", "there is no suite"},
           Case{"file = \"suite.toml\"", "files = []", "suite.files is empty"},
           Case{"file = \"suite.toml\"", "file = \"suite.toml\"\nfiles = [\"suite.toml\"]",
                "goes with neither file nor records"},
       }) {
    EXPECT_THAT(problems_of(replaced(study_text, c.from, c.to)), HasSubstr(c.told)) << c.to;
  }
}

TEST_F(ClearanceStudyFile, all_that_is_wrong_is_told_at_once) {
  const std::string told = problems_of(
      replaced(replaced(study_text, "[0, 0.05]", "[2]"), "mu_n_s = 0.6", "mu_n_s = -1"));
  EXPECT_THAT(told, HasSubstr("mass_ratio = 2"));
  EXPECT_THAT(told, HasSubstr("mu_n_s = -1"));
}

TEST(clearance_studies, that_come_with_glissade_are_walterss) {
  const std::filesystem::path studies = std::filesystem::path(GLISSADE_SOURCE_DIR) / "studies";
  const ClearanceConfig example = read_clearance_study(studies / "14_walters_example.toml");
  // Walters et al. (2012): "Building Type and Modal Behavior", "Specific Application Example".
  EXPECT_EQ(example.grid.period_s, (std::vector<double>{0.2, 0.4, 0.7, 1.0, 1.5, 2.0}));
  EXPECT_EQ(example.grid.mass_ratio, (std::vector<double>{0.05, 0.10}));
  EXPECT_EQ(example.friction[0].design(), 0.47);
  EXPECT_EQ(example.friction[1].design(), 0.47);
  for (const char* name :
       {"15_walters_level_threshold", "16_walters_yielding", "17_walters_base_shear",
        "18_walters_slope", "19_walters_mce", "20_walters_permutations", "21_walters_vertical"}) {
    const ClearanceConfig c = read_clearance_study(studies / (std::string(name) + ".toml"));
    EXPECT_NEAR(c.grid.slope_deg.front(), 1.19, 0.01) << name;  // 1/4:12
    EXPECT_FALSE(c.statements.empty()) << name;
  }
}

ClearanceResults made_up() {
  ClearanceResults r;
  r.study_name = "made up";
  r.study_text = study_text;
  r.program_version = "0.0";
  r.plan_hash = "abc";
  r.seed = 9;
  r.grid.support = {ArraySupport::isolated, ArraySupport::anchored};
  r.grid.vertical = {{VerticalChoice::none, 0.0}, {VerticalChoice::if_available, 0.3}};
  r.grid.slope_deg = {1.0 / 3};
  r.grid.period_s = {0.2};
  r.orientations = {{SlopeAxis::e_w, 0.0, 1}, {SlopeAxis::n_s, 22.5, -1}};
  r.same_as = {0, 1};
  r.suites = {{"one", "d", {{0.0, 1.0}, {{1.0, 2.0}}, {1.0, 2.0}, {0.9, 1.9}, 0.0}},
              {"two", "", {{0.0, 1.0}, {{1.0, 2.0}, {3.0, 4.0}}, {2.0, 3.0}, {}, 0.0}}};
  r.records = {{.suite = 0, .id = "a", .scale = 2.5, .dt_s = 0.005, .has_vertical = true},
               {.suite = 1, .id = "b", .stronger = 1},
               {.suite = 1, .id = "c", .magnitude = 6.7}};
  r.friction = {0.47, 0.5};
  r.displacement = DisplacementMeasure::vector;
  r.statements = {{ClearanceTopic::mce, "Fig. 18", "close", std::nan(""), 0.2},
                  {ClearanceTopic::mass, "here", "5 %", 0.259, std::nan("")}};
  for (std::size_t i = 0; i < 3 * 2 * r.grid.count(); ++i) {
    const double x = std::sqrt(static_cast<double>(i));
    r.histories.push_back(
        {x, x + 1, x + 2, -x, x - 3, x + 4, x + 5, static_cast<std::uint8_t>(i % 2)});
  }
  return r;
}

TEST(clearance_file, gives_back_every_bit) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.h5";
  const ClearanceResults written = made_up();
  write_clearance(file, written);
  EXPECT_TRUE(is_clearance_results(file));
  const ClearanceResults read = read_clearance(file);
  EXPECT_EQ(read.grid.vertical, written.grid.vertical);
  EXPECT_EQ(read.grid.support, written.grid.support);
  EXPECT_EQ(read.seed, 9u);
  EXPECT_EQ(read.displacement, DisplacementMeasure::vector);
  EXPECT_EQ(read.orientations[1].azimuth_deg, 22.5);
  EXPECT_EQ(read.orientations[1].across_sign, -1);
  EXPECT_EQ(read.suites[1].spectra.srss_g, written.suites[1].spectra.srss_g);
  EXPECT_EQ(read.records[2].magnitude, 6.7);
  EXPECT_TRUE(read.records[0].has_vertical);
  EXPECT_EQ(read.statements[1].displacement_m, 0.259);
  ASSERT_EQ(read.histories.size(), written.histories.size());
  for (std::size_t i = 0; i < read.histories.size(); ++i) {
    const ClearanceHistory &a = read.histories[i], &b = written.histories[i];
    EXPECT_EQ(a.peak_m, b.peak_m);
    EXPECT_EQ(a.peak_along_m, b.peak_along_m);
    EXPECT_EQ(a.peak_across_m, b.peak_across_m);
    EXPECT_EQ(a.residual_along_m, b.residual_along_m);
    EXPECT_EQ(a.residual_across_m, b.residual_across_m);
    EXPECT_EQ(a.shear_along, b.shear_along);
    EXPECT_EQ(a.shear_across, b.shear_across);
    EXPECT_EQ(a.uplift, b.uplift);
  }
  write_clearance(folder.path() / "again.h5", read);
  EXPECT_EQ(read_text_file(folder.path() / "again.h5"), read_text_file(file));
}

TEST(clearance_file, results_whose_parts_do_not_fit_are_refused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "results.h5";
  const auto refused = [&](const std::function<void(ClearanceResults&)>& spoil) {
    ClearanceResults results = made_up();
    spoil(results);
    write_clearance(file, results);
    EXPECT_THROW(read_clearance(file), InputError);
  };
  refused([](ClearanceResults& r) { r.same_as = {0}; });
  refused([](ClearanceResults& r) { r.same_as = {0, 2}; });
  refused([](ClearanceResults& r) { r.records[0].suite = 7; });
  refused([](ClearanceResults& r) { r.records[1].stronger = 2; });
  refused([](ClearanceResults& r) { r.friction = {0.5}; });
  refused([](ClearanceResults& r) { r.statements[0].period_s = 0.3; });
  refused([](ClearanceResults& r) { r.suites[0].spectra.target_g = {1.0}; });
  refused([](ClearanceResults& r) {
    r.grid.period_s.clear();
    r.histories.clear();
  });
}

TEST(clearance_file, cut_anywhere_is_refused) {
  const TemporaryFolder folder;
  write_clearance(folder.path() / "results.h5", made_up());
  const std::string whole = read_text_file(folder.path() / "results.h5");
  for (std::size_t length = 0; length < whole.size(); length += whole.size() / 50)
    EXPECT_THROW(read_clearance(folder.write("cut.h5", whole.substr(0, length))), InputError);
}

}  // namespace
}  // namespace glissade
