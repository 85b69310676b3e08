// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped recipes, suites/synthetic_level*.toml, against what they promise.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>

#include "glissade/core/error.hpp"
#include "glissade/io/recipe_writer.hpp"
#include "glissade/io/suite_file.hpp"
#include "glissade/motion/intensity.hpp"
#include "glissade/motion/simulation/suite_design.hpp"
#include "glissade/motion/suite_scaling.hpp"

namespace glissade {
namespace {

class BuiltInSuite : public testing::TestWithParam<int> {
 protected:
  const WaltersLevel& limits = walters_level(GetParam());
  const SyntheticRecipe recipe =
      read_recipe(std::string(GLISSADE_SOURCE_DIR) + "/suites/synthetic_level" +
                  std::to_string(GetParam()) + ".toml");
};
INSTANTIATE_TEST_SUITE_P(level, BuiltInSuite, testing::Range(0, 5));

// Walters et al. (2012), Table 1, and seven motions as they.
TEST_P(BuiltInSuite, has_seven_motions_for_the_mapped_values_of_its_level) {
  EXPECT_EQ(recipe.motions.size(), 7u);
  for (const SyntheticMotion& motion : recipe.motions) EXPECT_GT(motion.scale, 0.0);
  EXPECT_EQ(recipe.max_scale, limits.max_scale);
  EXPECT_EQ(recipe.target.ss_g, limits.ss_g);
  EXPECT_EQ(recipe.target.s1_g, limits.s1_g);
  EXPECT_EQ(recipe.target.edition, AsceEdition::asce7_10);
  EXPECT_EQ(recipe.target.site_classes,
            (std::vector{SiteClass::a, SiteClass::b, SiteClass::c, SiteClass::d}));
}

// Walters: the average of the SRSS spectra exceeds the MCE spectrum from 0 to 2 s; ours touches it
// to four digits.
TEST_P(BuiltInSuite, has_an_average_above_the_MCE_that_touches_it) {
  const TargetSpectrum target(recipe.target);
  const double factor = suite_average_factor(
      simulate_suite(recipe), [&](double period_s) { return target.mce_sa_g(period_s); },
      walters_periods_s());
  EXPECT_LE(factor, 1.0);
  EXPECT_GT(factor, 0.999);
}

TEST_P(BuiltInSuite, begins_and_ends_without_a_jump) {
  for (const Motion& motion : simulate_suite(recipe).motions)
    for (const auto& a :
         {motion.horizontal_mps2[0], motion.horizontal_mps2[1], motion.vertical_mps2}) {
      double peak = 0.0;
      for (const double x : a) peak = std::max(peak, std::abs(x));
      EXPECT_LT(std::abs(a.front()), 1e-3 * peak) << motion.id;
      EXPECT_LT(std::abs(a.back()), 1e-3 * peak) << motion.id;
    }
}

TEST_P(BuiltInSuite, has_distinct_motions_that_do_not_depend_on_one_another) {
  const Suite suite = simulate_suite(recipe);
  std::set<std::uint64_t> realizations;
  std::set<std::string> ids;
  for (std::size_t i = 0; i < recipe.motions.size(); ++i) {
    realizations.insert(recipe.motions[i].realization);
    ids.insert(suite.motions[i].id);
    EXPECT_EQ(suite.motions[i].horizontal_mps2[0].size(), suite.motions[i].vertical_mps2.size());
  }
  EXPECT_EQ(realizations.size(), 7u);
  EXPECT_EQ(ids.size(), 7u);
  EXPECT_EQ(simulate_motion(recipe, recipe.motions.back()).horizontal_mps2,
            suite.motions.back().horizontal_mps2);
}

TEST_P(BuiltInSuite, is_written_as_it_is_read) {
  const std::string path = testing::TempDir() + "recipe_" + std::to_string(GetParam()) + ".toml";
  const std::string text = recipe_toml(recipe, {"a test"});
  std::ofstream(path) << text;
  EXPECT_EQ(recipe_toml(read_recipe(path), {"a test"}), text);
}

TEST(walters_level, is_refused_outside_0_to_4) {
  EXPECT_THROW(walters_level(5), InputError);
  EXPECT_THROW(walters_level(-1), InputError);
}

}  // namespace
}  // namespace glissade
