// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/walters_level.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

TEST(walters_level, of_site_class_e_has_its_own_limits_and_the_same_mapped_values) {
  // Walters et al. (2012), Tables 1 and 2.
  const WaltersLevel& e = walters_level(2, SiteGroup::e);
  EXPECT_EQ(e.ss_g, 1.95);
  EXPECT_EQ(e.s1_g, 0.80);
  EXPECT_EQ(e.min_magnitude, 6.5);
  EXPECT_EQ(e.min_vs30_mps, 115);
  EXPECT_EQ(e.max_vs30_mps, 285);
  for (int level = 0; level <= 4; ++level) {
    EXPECT_EQ(walters_level(level, SiteGroup::e).ss_g, walters_level(level).ss_g);
    EXPECT_EQ(walters_level(level, SiteGroup::e).s1_g, walters_level(level).s1_g);
  }
  EXPECT_EQ(walters_level(4).max_scale, 6);
  EXPECT_EQ(walters_level(4, SiteGroup::e).max_scale, 5);
  EXPECT_THROW(walters_level(5, SiteGroup::e), InputError);
}

TEST(walters_target, envelopes_a_to_d_or_is_that_of_e) {
  using enum SiteClass;
  EXPECT_THAT(walters_target(1).site_classes, testing::ElementsAre(a, b, c, d));
  EXPECT_THAT(walters_target(1, SiteGroup::e).site_classes, testing::ElementsAre(e));
  // S_MS = F_a S_s: class D, F_a(0.70) = 1.4 - 0.2 * 0.8 = 1.24 (ASCE 7-10 table 11.4-1).
  EXPECT_NEAR(TargetSpectrum(walters_target(1)).mce_sa_g(0.2), 1.24 * 0.70, 1e-12);
  // Class E: 1.7 - 0.5 * 0.8 = 1.3.
  EXPECT_NEAR(TargetSpectrum(walters_target(1, SiteGroup::e)).mce_sa_g(0.2), 1.3 * 0.70, 1e-12);
}

TEST(intensity_level, is_the_lowest_whose_largest_values_are_not_exceeded) {
  EXPECT_EQ(intensity_level({.ss_g = 0.10, .s1_g = 0.05}), 0);
  EXPECT_EQ(intensity_level({.ss_g = 0.45, .s1_g = 0.18}), 0);
  EXPECT_EQ(intensity_level({.ss_g = 0.46, .s1_g = 0.18}), 1);
  EXPECT_EQ(intensity_level({.ss_g = 0.45, .s1_g = 0.80}), 2);  // S_1 decides
  EXPECT_EQ(intensity_level({.ss_g = 2.60, .s1_g = 0.10}), 3);  // S_s decides
  EXPECT_EQ(intensity_level({.ss_g = 3.70, .s1_g = 1.38}), 4);
}

TEST(intensity_level, is_none_beyond_level_4) {
  EXPECT_EQ(intensity_level({.ss_g = 3.71, .s1_g = 0.10}), std::nullopt);
  EXPECT_EQ(intensity_level({.ss_g = 0.10, .s1_g = 1.39}), std::nullopt);
}

}  // namespace
}  // namespace glissade
