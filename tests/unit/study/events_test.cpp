// SPDX-License-Identifier: GPL-3.0-or-later
// Events as the independent unit: two components of a record that are run as two records are one.

#include <gmock/gmock.h>

#include "facts.hpp"
#include "glissade/core/error.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

constexpr std::size_t motions = 8;

/// Every motion `times`, each under another name; its event is the motion, where events are stated.
Suite repeated_suite(std::size_t times, bool states_events) {
  Suite suite;
  suite.name = "repeated";
  for (unsigned i = 0; i < motions; ++i)
    for (std::size_t copy = 0; copy < times; ++copy) {
      Motion m;
      m.id = "motion" + std::to_string(i) + std::string(copy, 'b');
      if (states_events) m.event = "event" + std::to_string(i);
      m.dt_s = 0.01;
      m.horizontal_mps2 = {test::made_up_record(400, 10 * i + 1, 3.0 + 0.3 * i),
                           test::made_up_record(400, 10 * i + 2, 2.0)};
      suite.motions.push_back(std::move(m));
    }
  return suite;
}

StudyConfig events_config() {
  StudyConfig config = test::small_config();
  config.intensity.measure = IntensityMeasure::pga_g;
  config.intensity.levels = {0.5, 1.0, 2.0};
  config.standards.compare.clear();
  config.fragility->thresholds_m = {0.02, 0.1};
  config.quantities.at("friction", "mu") = test::fixed(0.3);
  config.quantities.at("roof", "slope_deg") = test::fixed(1.19);
  config.sampling.method = SamplingMethod::sobol;
  config.sampling.samples = 8;
  config.sensitivity = true;
  config.hazard = HazardConfig{HazardCurve::power_law(1e-3, 2.0), "", 50.0, {1e-4}};
  return config;
}

Results run_of(std::size_t times, bool states_events) {
  return test::run(make_plan(events_config(), {repeated_suite(times, states_events)}));
}

/// Widths of intervals, of the kinds of numbers that a study has.
std::vector<double> widths_of(const Results& results) {
  const RunResults& run = results.runs.front();
  const ThresholdFragility& fragility = run.fragilities.front();
  const HazardRun& hazard = results.hazard->runs.front();
  std::vector<double> widths;
  for (const Interval& interval :
       {fragility.probability_interval[1], run.slip[1].mean_interval, run.slip[1].median_interval,
        hazard.thresholds[0].annual_rate.interval})
    widths.push_back(interval.high - interval.low);
  return widths;
}

TEST(events, numbers_are_those_of_their_first_records) {
  EXPECT_EQ(event_units({"b", "a", "", "b", ""}), (std::vector<std::size_t>{0, 1, 2, 0, 3}));
  EXPECT_TRUE(event_units(std::vector<std::string>{"", " "}).empty());
  EXPECT_EQ(event_units({"Northridge-01 1994", " northridge-01  1994 ", "Northridge 1994"}),
            (std::vector<std::size_t>{0, 0, 1}));
}

// Of units with equal records the number of records has no effect: every interval is that of one
// record of each event. Without events the same records count as twice as many.
TEST(events, give_the_intervals_of_one_record_each) {
  const Results once = run_of(1, false), by_event = run_of(2, true), by_record = run_of(2, false);
  EXPECT_EQ(by_event.histories.units(), motions);
  EXPECT_EQ(by_record.histories.units(), 2 * motions);
  const std::vector<double> expected = widths_of(once), found = widths_of(by_event),
                            narrow = widths_of(by_record);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(found[i], expected[i], 1e-9 * expected[i]) << i;
    EXPECT_LT(narrow[i], 0.9 * expected[i]) << i;
  }
  const auto& fit = [](const Results& r) -> const FitSummary& {
    return r.runs.front().fragilities.front().capacities;
  };
  const auto width = [&](const Results& r) {
    return std::log(fit(r).median_interval.high / fit(r).median_interval.low);
  };
  // The scores of both records of an event are equal, so that the variance between events is the
  // same; the parts of rows and records in the allowance are not.
  EXPECT_NEAR(fit(by_event).curve.median, fit(once).curve.median, 1e-6);
  EXPECT_NEAR(width(by_event) / width(once), 1.0, 0.1);
  EXPECT_LT(width(by_record), 0.85 * width(once));
  const ThresholdRate &one = once.hazard->runs.front().thresholds[0],
                      &two = by_event.hazard->runs.front().thresholds[0];
  EXPECT_NEAR(two.effective_records, one.effective_records, 1e-9);
  const SpreadRow &spread_once = once.sensitivity->rows[0], &spread = by_event.sensitivity->rows[0],
                  &spread_narrow = by_record.sensitivity->rows[0];
  // Less the scatter of the samples, which is estimated over records: n - 1 of them are 15, not 7.
  EXPECT_NEAR(spread.record_error / spread_once.record_error, 1.0, 0.08);
  EXPECT_LT(spread_narrow.record_error, 0.8 * spread_once.record_error);
}

TEST(events, of_one_record_each_change_no_bit) {
  const Results stated = run_of(1, true), none = run_of(1, false);
  EXPECT_EQ(widths_of(stated), widths_of(none));
  EXPECT_EQ(stated.runs.front().fragilities[0].capacities.median_interval.high,
            none.runs.front().fragilities[0].capacities.median_interval.high);
}

TEST(events, that_stand_in_two_suites_are_one) {
  StudyConfig config = events_config();
  config.suite_files = {"a.toml", "b.toml"};
  Suite other = repeated_suite(1, true);
  for (Motion& motion : other.motions) motion.id += " of the other";
  const Results results = test::run(make_plan(config, {repeated_suite(1, true), other}));
  EXPECT_EQ(results.histories.units(), motions);
}

TEST(events, that_are_not_stated_of_some_records_are_warned_of) {
  Suite suite = repeated_suite(1, true);
  suite.motions[2].event.clear();
  const Plan plan = make_plan(events_config(), {suite});
  EXPECT_THAT(plan.warnings,
              testing::Contains(test::states("not of 1 record", "motion2", "event of its own")));
  EXPECT_THAT(make_plan(events_config(), {repeated_suite(1, false)}).warnings,
              testing::Not(testing::Contains(test::states("event of its own"))));
}

TEST(events, of_fewer_than_three_are_refused_with_sensitivity) {
  Suite suite = repeated_suite(1, true);
  for (std::size_t i = 2; i < motions; ++i) suite.motions[i].event = "event1";
  EXPECT_THROW(make_plan(events_config(), {suite}), InputError);
}

// Two motions of one event in a stripe, and one in the other: the share that slides freely is that
// of the samples, a half.
TEST(events, in_stripes_have_the_floor_of_the_samples) {
  StudyConfig config = events_config();
  config.sensitivity = false;
  config.hazard.reset();
  config.by_stripes = true;
  config.intensity.levels = {0.5, 1.5};
  config.suite_files = {"low.toml", "high.toml"};
  config.quantities.at("friction", "mu") = test::fixed(0.1);
  config.quantities.at("roof", "slope_deg") = test::drawn(Discrete{{1.0, 8.0}, {1.0, 1.0}});
  config.sampling.samples = 16;
  Suite low = repeated_suite(1, true), high = low;
  low.motions[1].event = low.motions[0].event;
  const Results results = test::run(make_plan(config, {low, high}));
  EXPECT_NEAR(results.runs.front().fragilities.front().stripes.curve.floor, 0.5, 1e-12);
}

}  // namespace
}  // namespace glissade
