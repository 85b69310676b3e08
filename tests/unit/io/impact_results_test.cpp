// SPDX-License-Identifier: GPL-3.0-or-later
#include <gmock/gmock.h>

#include <bit>
#include <cmath>

#include "glissade/core/error.hpp"
#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "temporary_folder.hpp"

namespace glissade {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Two records, three samples, two levels, one threshold.
Results make_results() {
  Results r;
  r.levels = {0.5, 1.0};
  r.thresholds_m = {0.15};
  r.samples.resize(3);
  r.records.resize(2);
  r.spectra.srss_g.resize(2);
  RunResults& run = r.runs.emplace_back();
  run.label = "sampled";
  run.peak_displacement_m = Array3<double>(2, 3, 2, 0.2);
  run.uplift = Array3<std::uint8_t>(2, 3, 2);
  run.capacity = Array3<double>(2, 3, 1, 1.0);
  run.slip.resize(2);
  ThresholdFragility& f = run.fragilities.emplace_back();
  f.probability.resize(2);
  f.probability_interval.resize(2);
  f.record_recross.resize(2);
  return r;
}

Results with_impact() {
  Results r = make_results();
  RunResults& run = r.runs[0];
  for (int i = 0; i < 12; ++i) {
    run.crossing_time_s.push_back(i % 5 == 0 ? std::nan("") : std::sqrt(i));
    run.crossing_speed_mps.push_back(i % 5 == 0 ? std::nan("") : std::cbrt(i));
  }
  run.impact = {{0.5, 0.15, 0.25, {0.1, 0.4}, 1, 2, 3, 4, {5, 6}, {7, 8}, 9, 10, 11}, {}};
  run.impact[1].speed_median_mps = std::nan("");
  return r;
}

bool same_bits(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

TEST(impact_results, come_back_to_the_last_bit) {
  const TemporaryFolder folder;
  const Results written = with_impact();
  write_results(folder.path() / "a.h5", written);
  const Results read = read_results(folder.path() / "a.h5");
  write_results(folder.path() / "b.h5", read);
  EXPECT_EQ(read_text_file(folder.path() / "a.h5"), read_text_file(folder.path() / "b.h5"));
  const RunResults &a = read.runs[0], &b = written.runs[0];
  ASSERT_EQ(a.crossing_time_s.size(), 12u);
  ASSERT_EQ(a.crossing_speed_mps.size(), 12u);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_TRUE(same_bits(a.crossing_time_s[i], b.crossing_time_s[i]));
    EXPECT_TRUE(same_bits(a.crossing_speed_mps[i], b.crossing_speed_mps[i]));
  }
  ASSERT_EQ(a.impact.size(), 2u);
  const ImpactStatistics& s = a.impact[0];
  EXPECT_THAT(
      (std::vector<double>{s.level, s.threshold_m, s.reached_share, s.reached_interval.low,
                           s.reached_interval.high, s.speed_median_mps, s.speed_p84_mps,
                           s.speed_p95_mps, s.speed_largest_mps, s.speed_median_interval.low,
                           s.speed_median_interval.high, s.speed_p84_interval.low,
                           s.speed_p84_interval.high, s.time_median_s, s.time_p16_s, s.time_p84_s}),
      testing::ElementsAre(0.5, 0.15, 0.25, 0.1, 0.4, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
  EXPECT_TRUE(std::isnan(a.impact[1].speed_median_mps));
  EXPECT_TRUE(std::isnan(a.impact[1].reached_interval.low));
}

TEST(impact_results, are_absent_from_the_file_where_they_are_not_asked_for) {
  const TemporaryFolder folder;
  write_results(folder.path() / "a.h5", make_results());
  EXPECT_THAT(read_text_file(folder.path() / "a.h5"), Not(HasSubstr("impact")));
  EXPECT_TRUE(read_results(folder.path() / "a.h5").runs[0].impact.empty());
  write_results(folder.path() / "b.h5", with_impact());
  EXPECT_THAT(read_text_file(folder.path() / "b.h5"), HasSubstr("impact"));
}

TEST(impact_results, that_do_not_fit_the_rest_are_refused) {
  const TemporaryFolder folder;
  const auto refusal = [&](void (*spoil)(RunResults&)) -> std::string {
    Results results = with_impact();
    spoil(results.runs[0]);
    write_results(folder.path() / "a.h5", results);
    try {
      read_results(folder.path() / "a.h5");
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([](RunResults&) {}), "");
  EXPECT_THAT(refusal([](RunResults& r) { r.impact.pop_back(); }),
              HasSubstr("cannot fit impact to the levels and thresholds"));
  EXPECT_THAT(refusal([](RunResults& r) { r.crossing_time_s.clear(); }),
              HasSubstr("cannot fit crossing_time_s to the records"));
  EXPECT_THAT(refusal([](RunResults& r) { r.crossing_speed_mps.resize(24); }),
              HasSubstr("cannot fit crossing_speed_mps to the records"));
}

}  // namespace
}  // namespace glissade
