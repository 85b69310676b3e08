// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include "whole_results.hpp"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(impact_results, come_back) {
  const TemporaryFolder folder;
  write_results(folder.path() / "a.h5", with_all());
  const RunResults a = read_results(folder.path() / "a.h5").runs[0];
  ASSERT_EQ(a.impact.size(), 6u);
  const ImpactStatistics& s = a.impact[0];
  EXPECT_THAT((std::vector<double>{
                  s.level, s.threshold_m, s.reached_share.value, s.reached_share.interval.low,
                  s.reached_share.interval.high, s.speed_median_mps.value, s.speed_p84_mps.value,
                  s.speed_p95_mps, s.speed_largest_mps, s.speed_median_mps.interval.low,
                  s.speed_median_mps.interval.high, s.speed_p84_mps.interval.low,
                  s.speed_p84_mps.interval.high, s.time_median_s, s.time_p16_s, s.time_p84_s}),
              testing::ElementsAre(0.5, 0.15, 0.25, 0.1, 0.4, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_TRUE(std::isnan(a.impact[1].speed_median_mps.value));
  EXPECT_TRUE(std::isnan(a.impact[1].reached_share.interval.low));
}

TEST(impact_results, are_absent_from_the_file_where_they_are_not_required) {
  const TemporaryFolder folder;
  Results results = with_fragility();
  results.histories.fields.crossing_time_s.clear();
  results.histories.fields.crossing_speed_mps.clear();
  const std::string bytes = bytes_of(results, folder, "a.h5");
  EXPECT_THAT(bytes, Not(testing::AnyOf(HasSubstr("impact"), HasSubstr("crossing_time_s"))));
  EXPECT_TRUE(read_results(folder.path() / "a.h5").runs[0].impact.empty());
  EXPECT_THAT(bytes_of(with_all(), folder, "b.h5"), HasSubstr("impact"));
}

}  // namespace
}  // namespace glissade
