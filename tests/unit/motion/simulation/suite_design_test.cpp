// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/simulation/suite_design.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "glissade/io/recipe_writer.hpp"
#include "glissade/io/suite_file.hpp"

namespace glissade {
namespace {

class SuiteDesign : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(level, SuiteDesign, testing::Range(0, 5));

// Gain, realizations and scales: the whole recipe, as text. Half a minute each.
TEST_P(SuiteDesign, gives_the_shipped_recipe) {
  if (GetParam() != 2 && std::getenv("GLISSADE_LONG") == nullptr)
    GTEST_SKIP() << "only with GLISSADE_LONG=1 (tests/README.md)";
  const SyntheticRecipe shipped =
      read_recipe(std::string(GLISSADE_SOURCE_DIR) + "/suites/synthetic_level" +
                  std::to_string(GetParam()) + ".toml");
  EXPECT_EQ(recipe_toml(design_suite(GetParam(), shipped.seed), {""}), recipe_toml(shipped, {""}));
}

}  // namespace
}  // namespace glissade
