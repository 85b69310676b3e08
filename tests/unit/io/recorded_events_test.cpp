// SPDX-License-Identifier: GPL-3.0-or-later
#include "recorded_motions.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

class RecordedEvents : public RecordedMotions {};

double log_width(const Interval& interval) { return std::log(interval.high / interval.low); }

// 22 records of 14 events (FEMA P-695, table A-4A), of which eight have two: as 22^2/38 = 12.7
// events of as many records (Kish 1965). Where none exceeds a share is below 1 - 0.025^(1/12.7) =
// 0.25.
TEST_F(RecordedEvents, of_the_far_field_set_are_14_and_widen_its_shares) {
  Suite suite = load("fema_p695_far_field.toml");
  StudyConfig config = test::small_config();
  config.intensity.measure = IntensityMeasure::pga_g;
  config.intensity.levels = {0.1, 0.8, 1.6};
  config.quantities.at("building", "period_s") = test::drawn(Uniform{0.2, 1.0});
  config.sampling.samples = 4;
  config.fragility->thresholds_m = {0.1};
  config.standards.compare.clear();
  const Results by_event = test::run(make_plan(config, {suite}));
  for (Motion& motion : suite.motions) motion.event.clear();
  const Results by_record = test::run(make_plan(config, {suite}));
  EXPECT_EQ(by_event.histories.units(), 14u);
  EXPECT_EQ(by_record.histories.units(), 22u);
  const auto at = [](const Results& r) -> const ThresholdFragility& {
    return r.runs.front().fragilities.front();
  };
  EXPECT_EQ(at(by_event).capacities.curve.median, at(by_record).capacities.curve.median);
  EXPECT_EQ(at(by_event).probability, at(by_record).probability);
  EXPECT_EQ(at(by_event).probability[0], 0.0);
  EXPECT_NEAR(at(by_event).probability_interval[0].high, 1.0 - std::pow(0.025, 38.0 / 484.0), 1e-9);
  EXPECT_NEAR(at(by_record).probability_interval[0].high, 1.0 - std::pow(0.025, 1.0 / 22.0), 1e-9);
  // Two records of one of these events resist hardly more alike than any two: of the median the
  // intervals are about the same.
  const double ratio = log_width(at(by_event).capacities.median_interval) /
                       log_width(at(by_record).capacities.median_interval);
  EXPECT_NE(ratio, 1.0);
  EXPECT_NEAR(ratio, 1.0, 0.25);
}

}  // namespace
}  // namespace glissade
