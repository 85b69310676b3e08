// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/motion/design_spectrum.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "glissade/core/error.hpp"

namespace glissade {
namespace {

using enum AsceEdition;
using enum SiteClass;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

DesignTarget target(AsceEdition edition, double ss_g, double s1_g,
                    std::vector<SiteClass> site_classes) {
  return {.edition = edition,
          .ss_g = ss_g,
          .s1_g = s1_g,
          .site_classes = std::move(site_classes),
          .tl_s = 8.0};
}

TEST(site_coefficients, are_linear_between_columns) {
  EXPECT_NEAR(site_coefficient_fa(asce7_10, d, 0.6), 1.32, 1e-14);  // 1.4 to 1.2 over 0.5 to 0.75
}

TEST(site_coefficients, of_class_e_beyond_the_table_of_asce7_16_are_input_errors) {
  EXPECT_EQ(site_coefficient_fa(asce7_16, e, 0.1), 2.4);
  EXPECT_THROW(site_coefficient_fa(asce7_16, e, 0.76), InputError);
  EXPECT_EQ(site_coefficient_fv(asce7_16, e, 0.1), 4.2);
  EXPECT_THROW(site_coefficient_fv(asce7_16, e, 0.11), InputError);
  EXPECT_EQ(site_coefficient_fa(asce7_10, e, 2.0), 0.9);
}

TEST(site_coefficients, of_values_that_are_not_positive_are_input_errors) {
  for (const double bad : {0.0, -0.5, nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_THROW(site_coefficient_fa(asce7_10, d, bad), InputError);
    EXPECT_THROW(site_coefficient_fv(asce7_16, d, bad), InputError);
  }
}

TEST(design_spectrum, is_continuous_at_its_corners) {
  const DesignSpectrum spectrum{.sds_g = 1.0, .sd1_g = 0.6, .tl_s = 8.0};
  for (const double corner_s : {spectrum.t0_s(), spectrum.ts_s(), spectrum.tl_s}) {
    EXPECT_NEAR(spectrum.sa_g(std::nextafter(corner_s, 0.0)), spectrum.sa_g(corner_s), 1e-14);
    EXPECT_NEAR(spectrum.sa_g(std::nextafter(corner_s, 99.0)), spectrum.sa_g(corner_s), 1e-14);
  }
}

TEST(target_spectrum, is_the_largest_of_its_classes_at_every_period) {
  const DesignTarget all = target(asce7_10, 1.5, 0.6, {a, b, c, d});
  const TargetSpectrum envelope(all);
  for (const double period_s : {0.0, 0.05, 0.1, 0.3, 0.6, 1.0, 3.0, 12.0}) {
    double largest = 0.0;
    for (const SiteClass site : all.site_classes) {
      largest = std::max(largest,
                         TargetSpectrum(target(asce7_10, 1.5, 0.6, {site})).design_sa_g(period_s));
    }
    EXPECT_EQ(envelope.design_sa_g(period_s), largest) << period_s;
    EXPECT_EQ(envelope.mce_sa_g(period_s), 1.5 * largest) << period_s;
  }
}

TEST(target_spectrum, tells_all_problems_at_once) {
  try {
    TargetSpectrum spectrum(
        DesignTarget{.ss_g = -1.0, .s1_g = 0.4, .site_classes = {d}, .tl_s = nan});
    FAIL() << "nothing thrown";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 2u) << error.what();
  }
  EXPECT_THROW(TargetSpectrum(target(asce7_10, 1.0, 0.4, {})), InputError);
}

TEST(target_spectrum, needs_a_long_period_transition_above_ts) {
  DesignTarget short_tl = target(asce7_10, 1.0, 0.4, {d});
  short_tl.tl_s = 0.5;  // T_S = 0.64 / 1.1 s
  EXPECT_THROW(TargetSpectrum{short_tl}, InputError);
}

TEST(site_class_and_edition, read_what_they_write) {
  for (const SiteClass site : {a, b, c, d, e}) EXPECT_EQ(parse_site_class(to_string(site)), site);
  for (const AsceEdition edition : {asce7_10, asce7_16}) {
    EXPECT_EQ(parse_asce_edition(to_string(edition)), edition);
  }
  EXPECT_EQ(to_string(c), "C");
  EXPECT_THROW(parse_site_class("F"), InputError);
  EXPECT_THROW(parse_site_class("G"), InputError);
  EXPECT_THROW(parse_asce_edition("7-16"), InputError);
}

TEST(site_coefficient_fa, of_an_unknown_site_is_at_least_1_2_in_asce_7_16) {
  EXPECT_EQ(site_coefficient_fa(asce7_16, unknown, 2.0), 1.2);
  EXPECT_EQ(site_coefficient_fa(asce7_16, unknown, 0.5), 1.4);
  EXPECT_EQ(site_coefficient_fa(asce7_10, unknown, 2.0), 1.0);
  EXPECT_EQ(site_coefficient_fv(asce7_16, unknown, 0.6), 1.7);
}

// A permit calculation of 2023: S_S 1.313 g, S_1 0.471 g, default site class.
TEST(target_spectrum, of_the_default_site_class_is_that_of_a_published_calculation) {
  const TargetSpectrum spectrum(target(asce7_16, 1.313, 0.471, {unknown}));
  EXPECT_NEAR(1.5 * spectrum.sds_g(), 1.576, 5e-4);
  EXPECT_NEAR(1.5 * spectrum.sd1_g(), 0.861, 5e-4);
  EXPECT_NEAR(spectrum.sds_g(), 1.050, 5e-4);
  EXPECT_NEAR(spectrum.sd1_g(), 0.574, 5e-4);
}

TEST(target_spectrum, of_design_values_is_that_of_the_class_they_come_from) {
  const TargetSpectrum mapped(target(asce7_16, 1.5, 0.6, {d}));
  const TargetSpectrum given(
      {.edition = asce7_16, .sds_g = mapped.sds_g(), .sd1_g = mapped.sd1_g()});
  for (const double period : {0.0, 0.05, 0.3, 1.0, 3.0, 12.0})
    EXPECT_EQ(given.design_sa_g(period), mapped.design_sa_g(period)) << period;
}

TEST(target_spectrum, by_points_is_linear_between_them) {
  DesignTarget points{.edition = asce7_16};
  points.period_s = {0.01, 0.2, 1.0, 5.0};
  points.design_sa_g = {0.4, 1.0, 0.6, 0.12};
  const TargetSpectrum spectrum(points);
  EXPECT_EQ(spectrum.design_sa_g(0.0), 0.4);
  EXPECT_NEAR(spectrum.design_sa_g(0.6), 0.8, 1e-15);
  EXPECT_NEAR(spectrum.design_sa_g(10.0), 0.06, 1e-15);
  EXPECT_NEAR(spectrum.sds_g(), 0.9, 1e-15);  // 90 % of the largest from 0.2 s on
  // S_a T of the points from 1 s to 5 s.
  EXPECT_NEAR(spectrum.sd1_g(), 0.6, 1e-15);
}

}  // namespace
}  // namespace glissade
