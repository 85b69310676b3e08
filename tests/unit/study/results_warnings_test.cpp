// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "facts.hpp"
#include "glissade/study/config.hpp"
#include "words/results_notes.hpp"

namespace glissade {
namespace {

using test::states;

std::vector<std::string> warnings_on(const Results& r, const StudyConfig& config) {
  std::vector<std::string> warnings = texts_of(remarks_on_run(r, config).warnings);
  std::ranges::move(texts_of(remarks_on_analyses(r, config).warnings),
                    std::back_inserter(warnings));
  return warnings;
}

/// One run of two thresholds with these tests of the lognormal.
Results tested(const GoodnessOfFit& first, const GoodnessOfFit& second) {
  Results r;
  r.levels = {0.5, 1.0};
  RunResults& run = r.runs.emplace_back();
  for (const GoodnessOfFit& fit : {first, second}) {
    ThresholdFragility& fragility = run.fragilities.emplace_back();
    fragility.threshold_m = 0.25 * static_cast<double>(run.fragilities.size());
    fragility.lognormal = fit;
  }
  return r;
}

TEST(results_warnings, of_fragilities_that_are_not_lognormal_alone) {
  const GoodnessOfFit good{0.001, 0.4, 0.5, 0.08, 1.0}, far{0.01, 0.01, 0.5, -0.12, 0.75},
      tiny{0.001, 0.01, 0.5, 0.02, 1.0};
  EXPECT_TRUE(warnings_on(tested(good, tiny), {}).empty());
  EXPECT_TRUE(warnings_on(tested({}, {}), {}).empty());
  const std::vector<std::string> warnings = warnings_on(tested(good, far), {});
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0], states("1 of 2", "0.5 m", "0.12"));
  Results several = tested(good, far);
  several.cases.axes = {{"building.period_s", "s", {0.8586, 1.02}, {}}};
  several.cases.samples = 1;
  several.runs.push_back({.label = "period_s_1_02"});
  EXPECT_THAT(warnings_on(several, {}).at(0), states("0.859 s", "0.5 m"));
}

TEST(results_notes, say_how_far_the_suite_is_scaled) {
  Results r;
  r.measure = IntensityMeasure::sds_g;
  SuiteSpectra spectra;
  spectra.to_target = {{1.0, 1.9}, {1.5, 0.2}};
  r.suites = {{"suite", "of four", "", spectra}};
  StudyConfig config;
  EXPECT_THAT(remarks_on_run(r, config).notes.at(0), testing::Not(states("scaled_to_s")));
  config.intensity.scaled_to_s = 3.0;
  EXPECT_THAT(remarks_on_run(r, config).notes.at(0), states("3 s", "scaled_to_s"));
}

TEST(results_warnings, of_annual_rates_that_rest_on_shaking_above_the_levels) {
  const auto of_share = [](double beyond_share) {
    Results r;
    r.levels = {0.5, 1.0};
    ThresholdRate& rate = r.hazard.emplace().runs.emplace_back().thresholds.emplace_back();
    rate.threshold_m = 0.254;
    rate.beyond_share = beyond_share;
    StudyConfig config;
    config.units = UnitSystem::us_customary;
    return warnings_on(r, config);
  };
  EXPECT_TRUE(of_share(0.19).empty());
  ASSERT_EQ(of_share(0.53).size(), 1u);
  EXPECT_THAT(of_share(0.53)[0], states("53 %", "10 in"));
}

// One record scaled by 50 for the others by 1.
TEST(results_warnings, of_a_record_that_is_most_of_the_average) {
  Results r = tested({}, {});
  r.records = {{.id = "a"}, {.id = "b"}, {.id = "c"}, {.id = "d"}};
  SuiteSpectra spectra{.periods_s = {0.2, 1.0},
                       .records_g = {{1.0, 1.0}, {2.0, 1.0}, {1.0, 3.0}, {1.0, 1.0}},
                       .average_g = {1.25, 1.5}};
  r.suites = {{"suite", "of four", "", spectra}};
  EXPECT_TRUE(warnings_on(r, {}).empty());
  for (double& sa : spectra.records_g[1]) sa *= 50.0;
  spectra.average_g = {25.75, 13.75};
  r.suites.front().spectra = spectra;
  EXPECT_THAT(warnings_on(r, {}), testing::ElementsAre(states("record b", "94 %")));
}

}  // namespace
}  // namespace glissade
