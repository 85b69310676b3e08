// SPDX-License-Identifier: GPL-3.0-or-later
// The conditions of both standards, as recalled in issue 34.
#include "glissade/standards/conditions.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "glissade/core/units.hpp"

namespace glissade {
namespace {

constexpr Standard both[] = {Standard::asce7_16, Standard::seaoc_pv1_2012};

/// An array that meets all conditions.
ArrayFacts accepted() {
  return {.slope_deg = 1.2,
          .friction = 0.5,
          .risk = RiskCategory::ii,
          .storeys = 2.0,
          .centre_of_mass_m = 0.4,
          .support_spacing_m = 1.0,
          .interconnection = 0.2,
          .sds_g = 1.2};
}

TEST(conditions, of_an_array_that_meets_all_are_met) {
  for (const Standard standard : both) {
    const auto rows = conditions_of(standard, accepted());
    EXPECT_EQ(rows.size(), 6u);
    for (const CodeCondition& c : rows) {
      EXPECT_EQ(c.is_met, true) << c.text();
      EXPECT_EQ(c.provenance, Provenance::recalled);
      EXPECT_FALSE(c.clause.empty());
    }
    EXPECT_EQ(not_met_text(rows), "");
  }
}

TEST(conditions, end_at_their_limits) {
  struct Limit {
    void (*set)(ArrayFacts&, double);
    double met, not_met;
  };
  const Limit limits[] = {
      {[](ArrayFacts& a, double mu) { a.friction = mu; }, 0.4, 0.3999},
      {[](ArrayFacts& a, double n) { a.storeys = n; }, 6.0, 7.0},
      {[](ArrayFacts& a, double m) { a.centre_of_mass_m = m; }, 0.499, 0.5},  // half of 1 m
      {[](ArrayFacts& a, double m) {
         a.centre_of_mass_m = m;
         a.support_spacing_m = 4.0;
       },
       36.0 * inch_m, 36.1 * inch_m},
      {[](ArrayFacts& a, double f) { a.interconnection = f; }, 0.133 * 1.2, 0.159},
      {[](ArrayFacts& a, double f) {
         a.interconnection = f;
         a.sds_g = 0.5;  // 0.133 x 0.5 is below 0.1
       },
       0.1, 0.0999}};
  for (const Standard standard : both) {
    for (const Limit& limit : limits) {
      ArrayFacts array = accepted();
      limit.set(array, limit.met);
      EXPECT_TRUE(is_within(standard, array)) << limit.met;
      limit.set(array, limit.not_met);
      EXPECT_FALSE(is_within(standard, array)) << limit.not_met;
    }
    ArrayFacts essential = accepted();
    essential.risk = RiskCategory::iv;
    EXPECT_THAT(not_met_text(conditions_of(standard, essential)),
                testing::HasSubstr("risk category: IV, required I, II or III"));
  }
}

// Friction of 0.4 or more counts where its tests are stated to be by ASTM G115.
TEST(conditions, of_friction_are_of_its_tests_too) {
  for (const Standard standard : both) {
    const auto met = [&](double mu, std::optional<std::string> test_standard) {
      const auto rows = conditions_of(standard, {.friction = mu, .test_standard = test_standard});
      return std::ranges::find(rows, "coefficient of friction", &CodeCondition::what)->is_met;
    };
    EXPECT_EQ(met(0.5, "ASTM G115-10"), true);
    EXPECT_EQ(met(0.5, "not by ASTM G115"), false);
    EXPECT_EQ(met(0.5, "in-house drag test"), false);
    EXPECT_EQ(met(0.5, ""), std::nullopt);
    EXPECT_EQ(met(0.3, ""), false);
    EXPECT_EQ(met(0.3, "ASTM G115"), false);
    EXPECT_EQ(met(0.5, std::nullopt), true);  // of charts, which know no tests
  }
}

// SEAOC PV1-2012: 3 degrees or less; ASCE 7-16: 1 in 20 or less, also as a rise in 12.
TEST(conditions, of_slope_include_the_limit_on_a_slope_of_either_sign) {
  EXPECT_TRUE(is_within(Standard::seaoc_pv1_2012, {.slope_deg = -3.0, .friction = 0.4}));
  EXPECT_FALSE(is_within(Standard::seaoc_pv1_2012, {.slope_deg = -3.01}));
  EXPECT_TRUE(is_within(Standard::asce7_16, {.slope_deg = std::atan(0.6 / 12.0) / rad_per_deg}));
  EXPECT_FALSE(is_within(Standard::asce7_16, {.slope_deg = 3.0}));
}

TEST(conditions, that_are_not_stated_are_neither_met_nor_not) {
  for (const CodeCondition& c : conditions_of(Standard::asce7_16, {})) {
    EXPECT_FALSE(c.is_met.has_value());
    EXPECT_EQ(c.found, "not stated");
  }
  ArrayFacts array = accepted();
  array.support_spacing_m.reset();
  EXPECT_THAT(not_met_text(conditions_of(Standard::asce7_16, array)),
              testing::HasSubstr("spacing not stated"));
  EXPECT_EQ(not_met_text(conditions_of(Standard::asce7_16, array), /*unknown=*/false), "");
}

TEST(analysis_provision, of_SEAOC_PV1_is_of_roof_motions) {
  EXPECT_THAT(analysis_provision(Standard::seaoc_pv1_2012),
              testing::AllOf(testing::HasSubstr("AC156"), testing::HasSubstr("30 s"),
                             testing::HasSubstr("3 or more")));
}

}  // namespace
}  // namespace glissade
