// SPDX-License-Identifier: GPL-3.0-or-later
// [sensitivity] in study files.
#include "study_texts.hpp"

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

}  // namespace
}  // namespace glissade
