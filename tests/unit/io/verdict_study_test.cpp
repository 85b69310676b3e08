// SPDX-License-Identifier: GPL-3.0-or-later
// [verdict] in study files.
#include "study_texts.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;

class VerdictStudy : public StudyFile {
 protected:
  static std::string with(const std::string& tables) {
    std::string text = needed;
    const std::size_t at = text.find("[fragility]");
    return text.substr(0, at) + tables;
  }
};
constexpr auto standards = "[standards]\ncompare = [\"asce7_16\"]\n";

TEST_F(VerdictStudy, stands_alone_beside_standards) {
  const StudyConfig study = read(with(std::string(standards) + "[verdict]\n"));
  ASSERT_TRUE(study.verdict);
  EXPECT_THAT(study.verdict->exceedance, ElementsAre(0.1, 0.05, 0.01));
  EXPECT_FALSE(study.fragility);
}

TEST_F(VerdictStudy, refuses_what_it_cannot_judge) {
  const std::string text = with(std::string(standards) + "[verdict]\nexceedance = ");
  refuses({{with("[verdict]\n"), "study.toml:11", {"[standards]"}},
           {text + "[0.05, 0.1]\n", "study.toml:14", {"verdict.exceedance"}},
           {text + "[0.05, 0.05]\n", "study.toml:14", {"verdict.exceedance"}},
           {text + "[1.0]\n", "study.toml:14", {"verdict.exceedance"}},
           {text + "[]\n", "study.toml:14", {"verdict.exceedance"}}});
}

TEST_F(VerdictStudy, is_of_slopes_and_periods_that_are_not_drawn) {
  const std::string text = with(std::string(standards) + "[verdict]\n");
  EXPECT_NO_THROW(read(text + "[roof]\nslope_deg = [0, 1]\n[building]\nperiod_s = [0.2, 0.5]\n"));
  for (const char* drawn :
       {"[roof]\nslope_deg = { distribution = \"uniform\", min = 0, max = 1 }\n",
        "[building]\nperiod_s = { distribution = \"uniform\", min = 0.2, max = 0.5 }\n"})
    refuses({{text + drawn, "study.toml:13", {"[verdict]"}}});
}

TEST_F(VerdictStudy, has_a_neighbour_on_a_facing_slope_where_there_are_both) {
  const std::string analyses = std::string(standards) + "[verdict]\n";
  const auto text = [&](const char* neighbour, const char* slope) {
    std::string all = with("neighbour_mu = " + std::string(neighbour) + "\n" + analyses);
    return all + "[roof]\nneighbour_slope = \"facing\"\nslope_deg = " + slope + "\n";
  };
  EXPECT_EQ(read(text("0.4", "[0, 2]")).neighbour_slope, NeighbourSlope::facing);
  EXPECT_EQ(read(with(analyses)).neighbour_slope, NeighbourSlope::same);
  refuses({{text("0", "[0, 2]"), "study.toml:16", {"roof.neighbour_slope", "neighbour_mu"}},
           {text("0.4", "0"), "study.toml:16", {"roof.neighbour_slope", "slope other than 0"}},
           {text("0.4\nneighbour_over_mu = 1", "[0, 2]"),
            "study.toml:12",
            {"friction.neighbour_mu", "friction.neighbour_over_mu"}}});
}

}  // namespace
}  // namespace glissade
