// SPDX-License-Identifier: GPL-3.0-or-later
// [rare] and sampling.scrambles in study files.
#include "study_texts.hpp"

namespace glissade {
namespace {

using testing::ElementsAre;

class RareStudy : public StudyFile {
 protected:
  static std::string with(const std::string& tables) { return without_fragility + tables; }
};

constexpr auto rare = "[rare]\nthresholds_m = [0.1, 0.2]\n";

TEST_F(RareStudy, stands_alone_with_scrambles) {
  const StudyConfig study = read(with(std::string(rare) + "[sampling]\nscrambles = 16\n"));
  ASSERT_TRUE(study.rare);
  EXPECT_THAT(study.rare->thresholds_m, ElementsAre(0.1, 0.2));
  EXPECT_EQ(study.rare->widening, 3.0);
  EXPECT_EQ(study.sampling.scrambles, 16u);
}

TEST_F(RareStudy, refuses_what_it_cannot_weigh) {
  const std::string sampling = "[sampling]\nscrambles = 16\n";
  refuses({{with(rare), "study.toml:11", {"sampling.scrambles", "8"}},
           {with(rare + sampling + fragility_part), "study.toml:11", {"[fragility]"}},
           {study_part + suite_part + intensity_part + "[friction]\nmu = 0.5\n" + rare + sampling,
            "study.toml:11",
            {"bounds"}}});
}

TEST_F(RareStudy, refuses_scrambles_that_do_not_divide_the_samples) {
  const std::string samples = needed + "[sampling]\nsamples = 64\nscrambles = ";
  refuses({{samples + "3\n", "study.toml:15", {"sampling.scrambles = 3"}},
           {samples + "128\n", "study.toml:15", {"sampling.scrambles = 128"}}});
}

TEST_F(RareStudy, a_target_error_ends_scrambles_of_a_fragility) {
  const std::string sampling = "[sampling]\nsamples = 64\ntarget_error = 0.01\nscrambles = ";
  const StudyConfig study = read(with(sampling + "16\n" + fragility_part));
  ASSERT_TRUE(study.sampling.target);
  EXPECT_EQ(study.sampling.target->error, 0.01);
  EXPECT_EQ(study.sampling.target->most_scrambles, 16u);
  const std::string least = "[sampling]\nleast_scrambles = 12\nsamples = 64\nscrambles = ";
  EXPECT_EQ(
      read(with(least + "16\ntarget_error = 0.01\n" + fragility_part)).sampling.scrambles_to_target,
      12u);
  refuses({{with(least + "8\ntarget_error = 0.01\n" + fragility_part),
            "study.toml:12",
            {"sampling.least_scrambles", "as many or more"}},
           {with(least + "16\n" + fragility_part),
            "study.toml:12",
            {"sampling.least_scrambles", "sampling.target_error"}}});
  refuses(
      {{with(sampling + "4\n" + fragility_part),
        "study.toml:13",
        {"sampling.target_error", "sampling.scrambles", "8"}},
       {with(sampling + "16\n" + rare), "study.toml:13", {"sampling.target_error", "[fragility]"}},
       {with(sampling + "16\n[sensitivity]\n" + fragility_part),
        "study.toml:13",
        {"sampling.target_error", "[sensitivity]"}}});
  EXPECT_THAT(
      faults(study_part + suite_part + intensity_part +
             "[friction]\nmu = 0.5\n[orientation]\nchoice = \"as_recorded\"\n" + sampling + "16\n" +
             fragility_part),
      ElementsAre("14 sampling.samples", "16 sampling.scrambles", "15 sampling.target_error"));
}

}  // namespace
}  // namespace glissade
