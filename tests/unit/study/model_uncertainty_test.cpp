// SPDX-License-Identifier: GPL-3.0-or-later
// What the premises of a study change, beside studies and fits of the ends alone.
#include "glissade/study/analysis/model_uncertainty.hpp"

#include <gmock/gmock.h>

#include <algorithm>

#include "glissade/study/results.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::drawn;
using test::fixed;
using test::listed;
using test::small_config;
using test::small_plan;
using testing::HasSubstr;

/// Two frictions are listed, the slope is drawn.
StudyConfig config_of(const std::vector<double>& frictions) {
  StudyConfig config = small_config();
  config.quantities.at("building", "period_s") = fixed(0.3);
  config.quantities.at("roof", "slope_deg") = drawn(Uniform{0.0, 5.0});
  config.quantities.at("friction", "mu") = listed(frictions);
  config.orientation.choice = OrientationChoice::as_recorded;
  config.fragility = FragilityConfig{.thresholds_m = {0.02, 0.1}};
  config.sampling.samples = 10;
  config.sampling.bootstrap_replicates = 100;
  return config;
}

const PremiseEffect& effect_of(const Results& results, const std::string& premise) {
  const auto& effects = results.uncertainties.front().effects;
  return *std::ranges::find(effects, premise, &PremiseEffect::name);
}

double p50(const Results& results) {
  return results.runs.front().fragilities.front().capacities.curve.intensity_at(0.5);
}
/// At S_DS = 1 g, that of the suite's target, the fourth level.
double probability_at_dbe(const Results& results) {
  return results.runs.front().fragilities.front().probability.at(3);
}

// (4 - 1)/2; what does not move does not change, and what is not known is not known.
TEST(model_uncertainty, change_is_the_largest_less_the_smallest_over_that_as_calculated) {
  EXPECT_EQ((AtEnds{1.0, 2.0, 4.0}.change()), 1.5);
  EXPECT_EQ((AtEnds{3.0, 2.0, 2.5}.change()), 0.5);
  EXPECT_EQ((AtEnds{0.0, 0.0, 0.0}.change()), 0.0);
  EXPECT_TRUE(std::isinf(AtEnds{infinity, 2.0, 1.0}.change()));
  EXPECT_TRUE(std::isnan(AtEnds{nan, 2.0, 1.0}.change()));
  std::vector<PremiseEffect> effects{{"not known", "", "", 0, 1, {nan, 1.0, 1.0}},
                                     {"small", "", "", 0, 1, {1.0, 1.0, 1.1}},
                                     {"large", "", "", 0, 1, {1.0, 1.0, 2.0}}};
  sort_by_change(effects);
  EXPECT_EQ(effects.front().premise, "large");
  EXPECT_EQ(effects.back().premise, "not known");
}

TEST(model_uncertainty, ends_of_a_list_are_studies_of_these_values_alone) {
  const Results results = test::run(small_plan(config_of({0.25, 0.3, 0.4})));
  const PremiseEffect& friction = effect_of(results, "friction");
  const Results low = test::run(small_plan(config_of({0.25}))),
                high = test::run(small_plan(config_of({0.4})));
  EXPECT_EQ(friction.low, 0.25);
  EXPECT_EQ(friction.high, 0.4);
  EXPECT_EQ(friction.result.low, p50(low));
  EXPECT_EQ(friction.result.high, p50(high));
  EXPECT_EQ(friction.probability.low, probability_at_dbe(low));
  EXPECT_EQ(friction.probability.high, probability_at_dbe(high));
  EXPECT_EQ(friction.result.calculated, p50(low));  // exceeds most often
  EXPECT_GT(friction.result.high, friction.result.low);
}

// Of ten samples the third is four.
TEST(model_uncertainty, of_what_is_drawn_is_the_fit_of_the_lower_and_the_upper_third) {
  const Results results = test::run(small_plan(config_of({0.3})));
  const PremiseEffect& slope = effect_of(results, "slope, deg");
  std::vector<std::pair<double, std::size_t>> by_slope;
  for (std::size_t i = 0; i < 10; ++i) by_slope.emplace_back(results.cases.cases[i].slope_deg, i);
  std::ranges::sort(by_slope);
  const auto expect_third = [&](std::size_t first, double intensity, double probability) {
    std::vector<Bracket> rows;
    double exceeding = 0.0;
    for (std::size_t record = 0; record < 3; ++record)
      for (std::size_t k = first; k < first + 4; ++k) {
        const double capacity = results.histories.capacity(record, by_slope[k].second, 0);
        rows.push_back({std::min(capacity, 4.0), capacity, 1.0, record});
        exceeding += results.histories.displacement_m(record, by_slope[k].second, 3) >= 0.02;
      }
    EXPECT_EQ(intensity, fit_brackets(rows, Independent::records).curve.intensity_at(0.5));
    EXPECT_EQ(probability, exceeding / 12.0);
  };
  expect_third(0, slope.result.low, slope.probability.low);
  expect_third(6, slope.result.high, slope.probability.high);
  EXPECT_EQ(slope.low, by_slope[2].first);
  EXPECT_EQ(slope.high, by_slope[8].first);
  EXPECT_EQ(slope.result.calculated, p50(results));
}

TEST(model_uncertainty, of_the_records_is_the_interval_of_the_fragility) {
  const Results results = test::run(small_plan(config_of({0.3})));
  const PremiseEffect& records = effect_of(results, "records");
  const ThresholdFragility& of = results.runs.front().fragilities.front();
  EXPECT_TRUE(records.is_of_records);
  EXPECT_EQ(records.result.low, of.capacities.p50_interval.low);
  EXPECT_EQ(records.result.high, of.capacities.p50_interval.high);
  EXPECT_EQ(records.probability.high, of.probability_interval.at(3).high);
}

TEST(model_uncertainty, names_what_is_not_varied_where_it_has_an_effect) {
  StudyConfig config = config_of({0.25, 0.3});
  EXPECT_EQ(test::run(small_plan(config)).uncertainties.front().not_varied,
            "building period 0.3 s, building damping 0.05, mass ratio 0");
  config.quantities.at("building", "period_s") = fixed(0.0);  // rigid: damping has none
  EXPECT_EQ(test::run(small_plan(config)).uncertainties.front().not_varied, "building period 0 s");
}

}  // namespace
}  // namespace glissade
