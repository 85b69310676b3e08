// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/intensity_measure.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "glissade/core/units.hpp"
#include "glissade/study/config.hpp"

namespace glissade {
namespace {

/// Two components: a triangular pulse of 2 m/s2 and 0.2 s, and one of half of that.
Suite two_pulses() {
  Motion motion;
  motion.id = "pulse";
  motion.scale = 3.0;
  motion.dt_s = 0.1;
  motion.horizontal_mps2 = {std::vector<double>{0.0, 2.0, 0.0}, std::vector<double>{0.0, 1.0, 0.0}};
  Suite suite;
  suite.motions = {motion};
  return suite;
}

double factor(const char* key, double level) {
  const IntensityMeasure measure = *IntensityMeasure::named(key);
  return measure.factors_at_unit_level({}, two_pulses(), {}).front() *
         measure.factor_of_level(level);
}

TEST(IntensityMeasure, pgv_is_reached_at_the_factor) {
  // Each pulse's velocity is its area: 0.2 and 0.1 m/s; geometric mean sqrt(0.02).
  EXPECT_NEAR(factor("pgv_mps", 0.6) * std::sqrt(0.02), 0.6, 1e-14);
}

TEST(IntensityMeasure, arias_goes_with_the_square_of_the_motion) {
  // Of a triangle of height h and base b the integral of a^2 is b h^2 / 3.
  const double unit = std::numbers::pi / (2.0 * standard_gravity_mps2) * 0.2 / 3.0;
  const double arias_mps = std::sqrt(unit * 4.0 * unit * 1.0);
  for (const double level : {0.1, 1.0, 7.0}) {
    const double f = factor("arias_mps", level);
    EXPECT_NEAR(f * f * arias_mps, level, 1e-13 * level);
  }
}

TEST(IntensityMeasure, mce_fraction_keeps_the_factors_of_the_suite) {
  EXPECT_EQ(factor("mce_fraction", 0.5), 1.5);
}

TEST(IntensityMeasure, factor_leaves_the_motions_of_the_suite_alone_at_1) {
  EXPECT_EQ(factor("factor", 1.0), 3.0);  // as the suite's file has it
  EXPECT_FALSE(IntensityMeasure::factor.is_of_design_spectrum());
}

TEST(IntensityMeasure, its_label_says_how_one_number_comes_from_a_record) {
  IntensityConfig config;
  config.measure = IntensityMeasure::sa_g;
  config.sa_period_s = 0.5;
  EXPECT_EQ(intensity_label(config), "Sa(0.5 s), geometric mean of both horizontals, 5 % (g)");
  for (const char* key : {"pga_g", "pgv_mps", "arias_mps", "avg_sa_g", "sa_g"})
    EXPECT_TRUE(IntensityMeasure::named(key)->meaning().find(
                    "geometric mean of both horizontals") != std::string::npos)
        << key;
}

TEST(IntensityMeasure, keys_and_units_name_each_other) {
  for (std::size_t i = 0; i < IntensityMeasure::count(); ++i) {
    const IntensityMeasure measure = IntensityMeasure::number(i);
    EXPECT_EQ(IntensityMeasure::named(measure.key()), measure);
    const std::string key = measure.key(), suffix = unit_suffix(measure.unit());
    if (!suffix.empty()) {
      EXPECT_TRUE(key.ends_with(suffix)) << key;
    }
  }
  EXPECT_FALSE(IntensityMeasure::named("pga"));
}

}  // namespace
}  // namespace glissade
