// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/improbable.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "facts.hpp"
namespace glissade {
namespace {

using test::states;
using testing::ElementsAre;
using testing::IsEmpty;

/// 5 s of a sine of 2 Hz; nothing about it is improbable.
Motion plausible(double amplitude_mps2 = 3.0) {
  Motion motion;
  motion.dt_s = 0.01;
  std::vector<double> samples;
  for (int n = 0; n < 500; ++n)
    samples.push_back(amplitude_mps2 * std::sin(4.0 * std::numbers::pi * 0.01 * n));
  motion.horizontal_mps2[0] = samples;
  return motion;
}

TEST(improbable_values, of_a_plausible_motion_are_none) {
  EXPECT_THAT(improbable_values(plausible()), IsEmpty());
}

TEST(improbable_values, name_what_no_recorded_motion_has_shown) {
  EXPECT_THAT(improbable_values(plausible(40.0)),
              ElementsAre(states("PGA"), states("PGV"), states("PGD")));
  EXPECT_THAT(improbable_values(plausible(0.001)), ElementsAre(states("PGA")));
  Motion fast = plausible();
  fast.dt_s = 0.0005;  // and ends after 0.25 s
  EXPECT_THAT(improbable_values(fast), ElementsAre(states("D5-95"), states("time step")));
  Motion up = plausible();
  up.vertical_mps2 = {50.0};
  EXPECT_THAT(improbable_values(up), ElementsAre(states("vertical PGA")));
  Motion drifts = plausible();
  std::vector<double> offset = drifts.horizontal_mps2[0].copy();
  for (double& a : offset) a += 1.0;  // 5 m/s and 12 m after 5 s
  drifts.horizontal_mps2[0] = offset;
  EXPECT_THAT(improbable_values(drifts), ElementsAre(states("PGV"), states("PGD")));
}

TEST(improbable_values, name_a_component_without_a_change_of_sign) {
  Motion spectrum = plausible();
  std::vector<double> positive = spectrum.horizontal_mps2[0].copy();
  for (double& a : positive) a = std::abs(a);
  spectrum.horizontal_mps2[0] = positive;
  EXPECT_THAT(
      improbable_values(spectrum),
      ElementsAre(states("first component", "below 0", "spectrum"), states("PGV"), states("PGD")));
}

TEST(improbable_values, name_a_factor_that_no_selection_gives) {
  Motion scaled = plausible();
  scaled.scale = 6.0;
  EXPECT_THAT(improbable_values(scaled), IsEmpty());
  for (const double scale : {100.0, 0.001}) {
    scaled.scale = scale;
    EXPECT_THAT(improbable_values(scaled), ElementsAre(states("scale")));
  }
}

TEST(improbable_values, name_one_motion_as_both_horizontals) {
  Motion twins = plausible();
  twins.horizontal_mps2[1] = twins.horizontal_mps2[0];
  EXPECT_THAT(improbable_values(twins), ElementsAre(states("both")));
  Motion upward = plausible();
  upward.vertical_mps2 = upward.horizontal_mps2[0];
  EXPECT_THAT(improbable_values(upward), ElementsAre(states("vertical", "horizontal")));
}

TEST(improbable_values, name_horizontals_whose_pga_differ_as_units_do) {
  Motion motion = plausible();
  motion.horizontal_mps2[1] = plausible(0.8).horizontal_mps2[0];
  EXPECT_THAT(improbable_values(motion), IsEmpty());
  motion.horizontal_mps2[1] = plausible(3.0 / 9.80665).horizontal_mps2[0];
  EXPECT_THAT(improbable_values(motion), ElementsAre(states("two")));
}

DesignTarget target(AsceEdition edition, double ss_g, double s1_g, SiteClass site) {
  DesignTarget t;
  t.edition = edition;
  t.ss_g = ss_g;
  t.s1_g = s1_g;
  t.site_classes = {site};
  return t;
}

TEST(improbable_values, of_a_target_are_s1_above_ss_and_no_known_site) {
  EXPECT_THAT(improbable_values(target(AsceEdition::asce7_10, 1.5, 0.6, SiteClass::d)), IsEmpty());
  EXPECT_THAT(improbable_values(target(AsceEdition::asce7_10, 1.0, 1.5, SiteClass::d)),
              ElementsAre(states("S_1")));
  EXPECT_THAT(improbable_values(target(AsceEdition::asce7_10, 150.0, 0.6, SiteClass::d)),
              ElementsAre(states("150 g")));
}

TEST(improbable_values, of_a_target_name_the_sites_of_asce7_16_11_4_8) {
  const auto count = [](double ss_g, double s1_g, SiteClass site) {
    return improbable_values(target(AsceEdition::asce7_16, ss_g, s1_g, site)).size();
  };
  EXPECT_EQ(count(1.5, 0.19, SiteClass::d), 0u);
  EXPECT_EQ(count(1.5, 0.2, SiteClass::d), 1u);
  EXPECT_EQ(count(1.5, 0.6, SiteClass::c), 0u);
  EXPECT_EQ(count(0.9, 0.1, SiteClass::e), 0u);
  EXPECT_EQ(count(1.0, 0.1, SiteClass::e), 1u);
  DesignTarget stated = target(AsceEdition::asce7_16, 1.5, 0.2, SiteClass::d);
  stated.exceptions = {2};
  EXPECT_THAT(improbable_values(stated), IsEmpty());
  // Of another class (recalled: 1 and 3 are of class E).
  stated.exceptions = {1};
  EXPECT_THAT(improbable_values(stated), ElementsAre(states("exception 1 of 11.4.8")));
  stated.exceptions = {1, 3};
  EXPECT_THAT(improbable_values(stated), ElementsAre(states("exceptions 1, 3 of 11.4.8")));
}

}  // namespace
}  // namespace glissade
