// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/plan.hpp"

#include <gtest/gtest.h>

#include "glissade/core/error.hpp"
#include "glissade/core/units.hpp"
#include "glissade/motion/intensity.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::small_config;
using test::small_suite;
constexpr double g = standard_gravity_mps2;

TEST(plan, covers_every_record_and_sample_once) {
  const Plan plan = make_plan(small_config(), small_suite());
  std::vector<std::vector<int>> seen(3, std::vector<int>(40, 0));
  for (const WorkUnit& unit : plan.units) {
    for (std::uint64_t i = 0; i < unit.sample_count; ++i)
      ++seen[unit.record][unit.first_sample + i];
  }
  for (const auto& record : seen) {
    for (const int times : record) EXPECT_EQ(times, 1);
  }
  EXPECT_EQ(plan.histories(), 3u * 40u * 8u * 2u);
}

TEST(plan, gives_a_sample_its_numbers_whatever_else_is_sampled) {
  StudyConfig config = small_config();
  const Plan plan = make_plan(config, small_suite());
  config.sampling.samples = 64;
  config.building.period_s = Fixed{0.3};
  const Plan other = make_plan(config, small_suite());
  for (std::size_t i = 0; i < 40; ++i) {
    EXPECT_EQ(plan.samples[i].friction, other.samples[i].friction);
    EXPECT_EQ(plan.samples[i].slope_deg, other.samples[i].slope_deg);
    EXPECT_EQ(plan.samples[i].sign, other.samples[i].sign);
  }
}

TEST(plan, scales_each_record_to_the_intensity_measure) {
  StudyConfig config = small_config();
  config.standards.compare.clear();
  const Suite suite = small_suite();
  const auto combined = HorizontalCombination::geometric_mean;

  config.intensity.measure = IntensityMeasure::pga_g;
  Plan plan = make_plan(config, suite);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(plan.factor_at_unit_level[i] * horizontal_pga_mps2(suite.motions[i], combined), g,
                1e-12 * g);
  }
  config.intensity.measure = IntensityMeasure::sa_g;
  config.intensity.sa_period_s = 0.3;
  plan = make_plan(config, suite);
  for (std::size_t i = 0; i < 3; ++i) {
    const double sa =
        horizontal_spectrum_mps2(suite.motions[i], std::vector<double>{0.3}, combined).front();
    EXPECT_NEAR(plan.factor_at_unit_level[i] * sa, g, 1e-12 * g);
  }
  config.intensity.measure = IntensityMeasure::avg_sa_g;
  config.intensity.avg_sa_periods_s = {0.2, 0.5, 1.0};
  plan = make_plan(config, suite);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(plan.factor_at_unit_level[i] *
                    average_sa_mps2(suite.motions[i], config.intensity.avg_sa_periods_s),
                g, 1e-12 * g);
  }
}

// Walters (2012): the average of the SRSS spectra is nowhere below the target from 0 to 2 s, and
// touches it.
TEST(plan, scales_the_suite_as_one_to_the_design_spectrum_of_each_sds) {
  const Suite suite = small_suite();
  const Plan plan = make_plan(small_config(), suite);
  EXPECT_NEAR(plan.factor_at_unit_level[2] / plan.factor_at_unit_level[0],
              suite.motions[2].scale / suite.motions[0].scale, 1e-12);
  const TargetSpectrum target(*suite.target);
  double least = 1e9;
  for (double period = 0.0; period <= 2.0; period += 0.05) {
    double average = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      average += plan.factor_at_unit_level[i] / g / 3 *
                 horizontal_spectrum_mps2(suite.motions[i], std::vector<double>{period},
                                          HorizontalCombination::srss)
                     .front();
    }
    least = std::min(least, average / (target.design_sa_g(period) / target.sds_g()));
  }
  EXPECT_GE(least, 1 - 1e-9);
  EXPECT_LE(least, 1.1);  // touches at a period of the finer list of suite_scaling.hpp
}

TEST(plan, has_another_hash_when_the_motions_or_the_study_change_and_the_same_when_not) {
  const Plan plan = make_plan(small_config(), small_suite());
  EXPECT_EQ(plan.hash, make_plan(small_config(), small_suite()).hash);
  Suite changed = small_suite();
  changed.motions[1].vertical_mps2[17] += 1e-12;
  EXPECT_NE(plan.hash, make_plan(small_config(), changed).hash);
  StudyConfig config = small_config();
  config.source_text += " ";
  EXPECT_NE(plan.hash, make_plan(config, small_suite()).hash);
}

TEST(plan, runs_the_design_friction_beside_unless_friction_is_one_number) {
  StudyConfig config = small_config();
  Plan plan = make_plan(config, small_suite());
  ASSERT_EQ(plan.runs.size(), 2u);
  EXPECT_DOUBLE_EQ(plan.runs[1].friction.front(), 0.3);  // 0.4 - 2 * 0.05 (Walters 2012)
  config.friction.mu = Fixed{0.4};
  plan = make_plan(config, small_suite());
  EXPECT_EQ(plan.runs.size(), 1u);
  EXPECT_FALSE(plan.skips.empty());
}

TEST(plan, tells_everything_in_which_study_and_suite_do_not_fit) {
  StudyConfig config = small_config();
  config.vertical.use = VerticalChoice::required;
  config.orientation.component = ComponentChoice::second;
  Suite suite = small_suite();
  suite.target.reset();
  suite.motions[0].vertical_mps2.clear();
  suite.motions[1].horizontal_mps2[1].clear();
  suite.motions[2].horizontal_mps2[0].assign(600, 0.0);
  suite.motions[2].horizontal_mps2[1].assign(600, 0.0);
  try {
    make_plan(config, suite);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.problems().size(), 4u) << error.what();
  }
}

TEST(plan, notes_records_that_lack_a_component) {
  Suite suite = small_suite();
  suite.motions[0].vertical_mps2.clear();
  suite.motions[1].horizontal_mps2[1].clear();
  StudyConfig config = small_config();
  config.standards.compare.clear();
  EXPECT_EQ(make_plan(config, suite).notes.size(), 2u);
}

TEST(plan, notes_samples_outside_the_range_of_the_prescriptive_value) {
  // Slope 4 degrees in a third of the samples, mu at or below 0.4 in half of them.
  EXPECT_EQ(make_plan(small_config(), small_suite()).notes.size(), 2u);  // both runs
  StudyConfig config = small_config();
  config.roof.slope_deg = Fixed{1.19};
  config.friction.mu = Fixed{0.45};
  EXPECT_TRUE(make_plan(config, small_suite()).notes.empty());
}

}  // namespace
}  // namespace glissade
