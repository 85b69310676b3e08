// SPDX-License-Identifier: GPL-3.0-or-later
// [sensitivity] in study files and results files.
#include "misfits.hpp"
#include "study_texts.hpp"
#include "whole_results.hpp"

namespace glissade {
namespace {

class SensitivityStudy : public StudyFile {
 protected:
  static std::string with(const std::string& tables) { return std::string(needed) + tables; }
};

TEST_F(SensitivityStudy, is_read_beside_a_fragility_of_something_drawn) {
  EXPECT_TRUE(read(with("[sensitivity]\n")).sensitivity);
  EXPECT_FALSE(read(needed).sensitivity);
  std::string alone = needed;
  alone.replace(alone.find("[fragility]"), std::string::npos, "[sensitivity]\n[base_shear]\n");
  refuses({{alone, "study.toml:11", {"[sensitivity]", "[fragility]"}}});
}

TEST_F(SensitivityStudy, refuses_several_orientations_of_a_sample) {
  for (const char* orientation :
       {"choice = \"all_permutations\"", "slope_axis = [\"e_w\", \"n_s\"]"})
    refuses({{with(std::string("[sensitivity]\n[orientation]\n") + orientation + "\n"),
              "study.toml:13",
              {"[sensitivity]", "orientation"}}});
}

TEST(sensitivity_results_file, comes_back_to_the_last_bit) {
  const TemporaryFolder folder;
  write_results(folder.path() / "results.h5", with_all());
  const Results read = read_results(folder.path() / "results.h5");
  ASSERT_TRUE(read.sensitivity);
  const SensitivityResults &found = *read.sensitivity, made = *with_all().sensitivity;
  EXPECT_EQ(found.factors, made.factors);
  EXPECT_EQ(found.samples, made.samples);
  ASSERT_EQ(found.rows.size(), made.rows.size());
  EXPECT_TRUE(found.rows[0].is_capacity());
  EXPECT_EQ(found.rows[1].level, 1.5);
  EXPECT_EQ(found.rows[1].total, made.rows[1].total);
  EXPECT_EQ(found.rows[1].total_interval[1].high, 0.9);
  EXPECT_TRUE(std::isnan(found.rows[1].first[2]));
  EXPECT_EQ(found.rows[1].record_error, made.rows[1].record_error);
  ASSERT_EQ(found.design_friction.size(), made.design_friction.size());
  EXPECT_EQ(found.design_friction[1].design_mean_m, 1.5);
  EXPECT_EQ(found.design_friction[1].above_mean.interval.low, 0.025);
}

TEST(sensitivity_results_file, refuses_rows_that_do_not_fit) {
  Results results = with_all();
  EXPECT_EQ(misfit_in(results), "");
  results.sensitivity->rows[0].first_case = results.cases.size();
  EXPECT_EQ(misfit_in(results), "first_case");
  results = with_all();
  results.sensitivity->factors.push_back("slope");
  EXPECT_EQ(misfit_in(results), "first and total");
}

}  // namespace
}  // namespace glissade
