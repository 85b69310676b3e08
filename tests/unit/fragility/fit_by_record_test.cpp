// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "glissade/core/finite.hpp"
#include "glissade/core/random.hpp"
#include "glissade/fragility/fit.hpp"

namespace glissade {
namespace {

// The simulation of theory.md, 6.3: ln capacity = a(record) + e(record, sample), median 1,
// deviations 0.35 and 0.20, 50 samples, 8 stripes from 0.4 to 2.5 medians.
constexpr double between = 0.35, within = 0.20;
const double total_log_std = std::hypot(between, within);
constexpr std::size_t samples = 50;

std::vector<double> intensities() {
  std::vector<double> x;
  for (int j = 0; j < 8; ++j) x.push_back(0.4 * std::pow(2.5 / 0.4, j / 7.0));
  return x;
}

/// 50 capacities of each record, in order.
std::vector<Bracket> simulated_capacities(std::size_t records, std::uint64_t seed) {
  std::vector<Bracket> rows;
  for (std::size_t i = 0; i < records; ++i) {
    const double a = between * keyed_normal(seed, RandomPurpose::test, i, 0);
    for (std::uint32_t s = 1; s <= samples; ++s) {
      const double c = std::exp(a + within * keyed_normal(seed, RandomPurpose::test, i, s));
      rows.push_back({c, c, 1.0, i});
    }
  }
  return rows;
}

/// The counts of one record's capacities at some levels.
std::vector<Stripe> counted(const std::vector<Bracket>& capacities, std::size_t record,
                            const std::vector<double>& at) {
  std::vector<Stripe> rows;
  for (const double x : at) {
    Stripe& row = rows.emplace_back(Stripe{x, samples, 0.0, 1.0, record});
    for (const Bracket& of : capacities)
      if (of.record == record && of.high < x) ++row.exceedances;
  }
  return rows;
}

std::vector<Stripe> simulated_stripes(std::size_t records, std::uint64_t seed) {
  const std::vector<Bracket> capacities = simulated_capacities(records, seed);
  std::vector<Stripe> rows;
  for (std::size_t i = 0; i < records; ++i)
    for (const Stripe& row : counted(capacities, i, intensities())) rows.push_back(row);
  return rows;
}

/// The same counts of each of some records at some levels.
std::vector<Stripe> alike(std::size_t records, const std::vector<Stripe>& of_one) {
  std::vector<Stripe> rows;
  for (std::size_t i = 0; i < records; ++i)
    for (const Stripe& row : of_one)
      rows.push_back({row.intensity, row.trials, row.exceedances, 1.0, i});
  return rows;
}

/// Histories of each record that are all not reached by the intensity 1, and that slide freely.
std::vector<Bracket> not_reached(std::size_t records, int histories, int free = 0) {
  std::vector<Bracket> rows;
  for (std::size_t i = 0; i < records; ++i) {
    rows.insert(rows.end(), static_cast<std::size_t>(histories), {1.0, infinity, 1.0, i});
    rows.insert(rows.end(), static_cast<std::size_t>(free), {0.0, 0.0, 1.0, i});
  }
  return rows;
}

bool covers(const Interval& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

struct Coverage {
  double median, log_std, naive_median;
};
Coverage stripe_coverage(int records, int studies, int naive_studies) {
  Coverage share{0, 0, 0};
  for (int study = 0; study < studies; ++study) {
    const auto data = simulated_stripes(records, 1000 + study);
    const FitSummary fit = fit_stripes(data, Independent::records);
    share.median += covers(fit.median_interval, 1.0) ? 1.0 / studies : 0;
    share.log_std += covers(fit.log_std_interval, total_log_std) ? 1.0 / studies : 0;
    if (study < naive_studies) {
      share.naive_median += covers(fit_stripes(data, Independent::rows).median_interval, 1.0)
                                ? 1.0 / naive_studies
                                : 0;
    }
  }
  ::testing::Test::RecordProperty("coverage_median", std::to_string(share.median));
  ::testing::Test::RecordProperty("coverage_log_std", std::to_string(share.log_std));
  ::testing::Test::RecordProperty("coverage_naive", std::to_string(share.naive_median));
  return share;
}

// Were the coverage 95 %, that of 600 studies would leave [0.92, 0.98] with probability 8e-4
// (binomial, 3.4 sigma).
TEST(fit_by_record, covers_the_median_in_95_percent_of_studies_of_20_records) {
  const Coverage share = stripe_coverage(20, 600, 100);
  EXPECT_GE(share.median, 0.92);
  EXPECT_LE(share.median, 0.98);
  EXPECT_GE(share.log_std, 0.92);
  EXPECT_LE(share.log_std, 0.98);
  EXPECT_LT(share.naive_median, 0.40);  // independent trials: the trap this method is for
}

TEST(fit_by_record, covers_the_median_in_95_percent_of_studies_of_7_records) {
  const Coverage share = stripe_coverage(7, 600, 0);
  EXPECT_GE(share.median, 0.92);
  EXPECT_LE(share.median, 0.98);
  EXPECT_GE(share.log_std, 0.92);
}

// Multiple stripes: twenty records at each of five levels, the last five of them at the next too.
TEST(fit_by_record, covers_the_median_in_95_percent_of_studies_by_multiple_stripes) {
  const std::vector<double> at{0.5, 0.7, 1.0, 1.4, 2.0};
  constexpr std::size_t apart = 15, of_level = 20;
  constexpr int studies = 600;
  double median = 0, log_std = 0;
  for (int study = 0; study < studies; ++study) {
    const std::size_t records = 4 * apart + of_level;
    const std::vector<Bracket> capacities =
        simulated_capacities(records, 9000 + static_cast<std::uint64_t>(study));
    std::vector<Stripe> data;
    for (std::size_t i = 0; i < records; ++i) {
      std::vector<double> levels;
      for (std::size_t j = 0; j < at.size(); ++j)
        if (i >= j * apart && i < j * apart + of_level) levels.push_back(at[j]);
      for (const Stripe& row : counted(capacities, i, levels)) data.push_back(row);
    }
    const FitSummary fit = fit_stripes(data, Independent::records);
    median += covers(fit.median_interval, 1.0) ? 1.0 / studies : 0;
    log_std += covers(fit.log_std_interval, total_log_std) ? 1.0 / studies : 0;
  }
  RecordProperty("coverage_median", std::to_string(median));
  RecordProperty("coverage_log_std", std::to_string(log_std));
  EXPECT_GE(median, 0.92);
  EXPECT_LE(median, 0.98);
  EXPECT_GE(log_std, 0.92);
  EXPECT_LE(log_std, 0.98);
}

TEST(fit_by_record, covers_the_median_in_95_percent_of_studies_of_12_records) {
  double share = 0;
  for (int study = 0; study < 600; ++study) {
    const FitSummary fit =
        fit_brackets(simulated_capacities(12, 5000 + study), Independent::records);
    share += covers(fit.median_interval, 1.0) ? 1 / 600.0 : 0;
  }
  RecordProperty("coverage_median", std::to_string(share));
  EXPECT_GE(share, 0.92);
  EXPECT_LE(share, 0.98);
}

TEST(fit_by_record, has_the_curve_of_the_pooled_stripes) {
  const auto data = simulated_stripes(20, 1);
  const FitSummary by_record = fit_stripes(data, Independent::records);
  const FitSummary pooled = fit_stripes(data, Independent::rows);
  EXPECT_NEAR(by_record.curve.median, pooled.curve.median, 1e-12);
  EXPECT_NEAR(by_record.curve.log_std, pooled.curve.log_std, 1e-12);
  EXPECT_NEAR(by_record.log_likelihood, pooled.log_likelihood, 1e-8);
}

// Samples of one record are no new evidence: counting each of them ten times changes next to
// nothing (the variance within records is known better).
TEST(fit_by_record, does_not_gain_by_repeating_the_samples_of_its_records) {
  const auto data = simulated_stripes(12, 3);
  auto repeated = data;
  for (Stripe& row : repeated) row.trials *= 10, row.exceedances *= 10;
  const FitSummary once = fit_stripes(data, Independent::records);
  const FitSummary ten_times = fit_stripes(repeated, Independent::records);
  EXPECT_NEAR(once.median_interval.low, ten_times.median_interval.low, 1e-4);
  EXPECT_NEAR(once.log_std_interval.high, ten_times.log_std_interval.high, 1e-3);
}

TEST(fit_by_record, gives_a_band_that_holds_the_curve_and_agrees_with_the_interval_of_the_median) {
  const auto data = simulated_stripes(20, 4);
  const std::vector<double> at = {0.3, 0.6, 1.0, 1.5, 3.0};
  const FitSummary fit = fit_stripes(data, Independent::records, at);
  ASSERT_EQ(fit.band.size(), at.size());
  for (std::size_t i = 0; i < at.size(); ++i) {
    EXPECT_GT(fit.band[i].low, 0.0);
    EXPECT_LT(fit.band[i].high, 1.0);
    EXPECT_TRUE(covers(fit.band[i], fit.curve.probability(at[i]))) << at[i];
  }
  // At an end of the interval of the median, one half is at an end of the band.
  const std::vector<Interval> ends =
      fit_stripes(data, Independent::records, {fit.median_interval.low, fit.median_interval.high})
          .band;
  EXPECT_NEAR(ends[0].high, 0.5, 1e-9);
  EXPECT_NEAR(ends[1].low, 0.5, 1e-9);
}

/// Capacities of a clearance `ratio` times as strong, known up to the intensity 2.
std::vector<Bracket> cut_at_two(std::vector<Bracket> rows, double ratio) {
  for (Bracket& row : rows) {
    row.low = std::min(2.0, ratio * row.low);
    row.high = row.low < 2.0 ? row.low : infinity;
  }
  return rows;
}

// 40 studies of 7 records: three clearances, of which the last is rarely reached.
TEST(fit_by_record, bands_rise_with_intensity_and_keep_the_order_of_their_curves) {
  std::vector<double> at;
  for (int i = 0; i < 200; ++i) at.push_back(0.02 * (i + 1));
  for (int study = 0; study < 40; ++study) {
    const auto first = simulated_capacities(7, 300 + study);
    std::vector<Interval> lower;
    FragilityCurve lower_curve;
    for (const double ratio : {1.0, 1.3, 1.9}) {
      const FitSummary fit = fit_brackets(cut_at_two(first, ratio), Independent::records, at);
      const std::vector<Interval>& band = fit.band;
      if (fit.status != FitStatus::maximum_likelihood) continue;
      for (std::size_t i = 0; i < at.size(); ++i) {
        const double p = fit.curve.probability(at[i]);
        EXPECT_TRUE(covers(band[i], p)) << study << " " << ratio << " " << at[i];
        if (i == 0) continue;
        EXPECT_GE(band[i].low, band[i - 1].low) << study << " " << ratio << " " << at[i];
        EXPECT_GE(band[i].high, band[i - 1].high) << study << " " << ratio << " " << at[i];
      }
      for (std::size_t i = 0; i < lower.size(); ++i) {
        const double p = fit.curve.probability(at[i]);
        if (at[i] > 2.0 || p < 0.02 || lower_curve.probability(at[i]) - p < 0.05) continue;
        EXPECT_LE(band[i].low, lower[i].low + 0.01) << study << " " << ratio << " " << at[i];
        EXPECT_LE(band[i].high, lower[i].high + 0.01) << study << " " << ratio << " " << at[i];
      }
      lower = band;
      lower_curve = fit.curve;
    }
  }
}

TEST(fit_by_record, bounds_with_one_trial_per_record_where_nothing_exceeded) {
  const FitSummary one_each = fit_stripes({{0.5, 7, 0}, {1.0, 7, 0}}, Independent::rows);
  const FitSummary counts =
      fit_stripes(alike(7, {{0.5, 1000, 0}, {1.0, 1000, 0}}), Independent::records);
  EXPECT_EQ(counts.status, FitStatus::lower_bound);
  EXPECT_NEAR(counts.curve.median, one_each.curve.median, 1e-12);
  const FitSummary capacities = fit_brackets(not_reached(7, 1000), Independent::records);
  EXPECT_EQ(capacities.status, FitStatus::lower_bound);
  EXPECT_NEAR(capacities.curve.median, fit_stripes({{1.0, 7, 0}}, Independent::rows).curve.median,
              1e-12);
}

// Only one of seven records exceeds: the interval reaches far beyond the levels.
TEST(fit_by_record, leaves_the_median_uncertain_where_one_record_exceeds) {
  std::vector<Stripe> rows = alike(7, {{0.5, 10, 0}, {1.0, 10, 0}, {2.0, 10, 0}});
  for (Stripe& row : rows)
    if (row.record == 3) row.exceedances = 3 * row.intensity;
  const FitSummary fit = fit_stripes(rows, Independent::records);
  EXPECT_EQ(fit.status, FitStatus::extrapolated);
  EXPECT_GT(fit.median_interval.high, 2.0 * fit.curve.median);
  EXPECT_GT(fit.curve.median, 2.0);
}

TEST(fit_by_record, penalises_separated_records_and_says_so) {
  const FitSummary fit = fit_stripes(
      alike(7, {{0.4, 20, 0}, {0.6, 20, 0}, {0.8, 20, 20}, {1.0, 20, 20}}), Independent::records);
  EXPECT_EQ(fit.status, FitStatus::jeffreys_penalised);
  EXPECT_NE(fit.note.find("no interval"), std::string::npos);
  EXPECT_TRUE(std::isnan(fit.median_interval.low) && std::isnan(fit.log_std_interval.high));
  EXPECT_GT(fit.curve.median, 0.6);
  EXPECT_LT(fit.curve.median, 0.8);
}

// A sixth slides freely, in every record: the fit of the rest is untouched, and what is read off
// the curve contains the floor.
TEST(fit_by_record, contains_a_floor_that_all_records_share) {
  const auto rest = simulated_capacities(12, 3);
  auto data = rest;
  for (std::size_t i = 0; i < 12; ++i) data.insert(data.end(), samples / 5, {0.0, 0.0, 1.0, i});
  const std::vector<double> at = {1e-3, 0.5, 1.0, 2.0, 1e3};
  const FitSummary fit = fit_brackets(data, Independent::records, at);
  const FitSummary without = fit_brackets(rest, Independent::records, at);
  EXPECT_NEAR(fit.curve.floor, 1.0 / 6, 1e-15);
  EXPECT_EQ(fit.curve.median, without.curve.median);
  EXPECT_EQ(fit.median_interval.low, without.median_interval.low);
  EXPECT_EQ(without.p50_interval.low, without.median_interval.low);
  EXPECT_TRUE(std::isnan(fit.floor_interval.low));
  EXPECT_LT(fit.p50_interval.high, fit.median_interval.high);
  EXPECT_TRUE(covers(fit.p50_interval, fit.curve.intensity_at(0.5)));
  const double floor = fit.curve.floor;
  for (std::size_t i = 0; i < at.size(); ++i) {
    EXPECT_NEAR(fit.band[i].low, floor + (1 - floor) * without.band[i].low, 1e-12);
    EXPECT_NEAR(fit.band[i].high, floor + (1 - floor) * without.band[i].high, 1e-12);
    EXPECT_TRUE(covers(fit.band[i], fit.curve.probability(at[i]))) << at[i];
  }
}

// The floor of a record is uniform from 0 to 0.3: its mean over records is 0.15.
std::vector<Bracket> with_varying_floors(std::size_t records, std::uint64_t seed) {
  std::vector<Bracket> rows = simulated_capacities(records, seed);
  for (std::size_t i = 0; i < records; ++i) {
    const double floor = 0.3 * keyed_uniform(seed, RandomPurpose::test, i, samples + 1);
    const auto free = static_cast<std::size_t>(std::round(samples * floor));
    for (std::size_t s = samples - free; s < samples; ++s)
      rows[samples * i + s] = {0.0, 0.0, 1.0, i};
  }
  return rows;
}

// 600 studies, 4 sigma below 95 %. What has both the floor's interval and the curve's is wider.
TEST(fit_by_record, covers_a_floor_that_differs_from_record_to_record) {
  const FragilityCurve truth{1.0, total_log_std, 0.15};
  double floor = 0, p50 = 0, probability = 0;
  for (int study = 0; study < 600; ++study) {
    const FitSummary fit =
        fit_brackets(with_varying_floors(12, 9000 + study), Independent::records, {0.6});
    floor += covers(fit.floor_interval, 0.15) ? 1 / 600.0 : 0;
    p50 += covers(fit.p50_interval, truth.intensity_at(0.5)) ? 1 / 600.0 : 0;
    probability += covers(fit.band[0], truth.probability(0.6)) ? 1 / 600.0 : 0;
  }
  RecordProperty("coverage_floor", std::to_string(floor));
  RecordProperty("coverage_p50", std::to_string(p50));
  RecordProperty("coverage_probability", std::to_string(probability));
  for (const double share : {floor, p50, probability}) {
    EXPECT_GE(share, 0.91);
    EXPECT_LE(share, 0.998);
  }
}

TEST(fit_by_record, has_the_same_floor_as_capacities_and_the_curve_of_the_rest) {
  auto data = simulated_stripes(12, 3);
  const FitSummary rest = fit_stripes(data, Independent::records);
  for (std::size_t i = 0; i < 12; ++i) data.push_back({0.0, 10.0, 10.0, 1.0, i});
  const FitSummary fit = fit_stripes(data, Independent::records);
  EXPECT_NEAR(fit.curve.floor, 10.0 / 60.0, 1e-15);
  EXPECT_EQ(fit.curve.median, rest.curve.median);
  EXPECT_EQ(fit.log_std_interval.high, rest.log_std_interval.high);
}

TEST(fit_by_record, always_exceeds_where_every_history_slides_freely) {
  for (const FitSummary& fit : {fit_brackets(not_reached(7, 0, 10), Independent::records),
                                fit_stripes(alike(7, {{0.0, 10, 10}}), Independent::records)}) {
    EXPECT_EQ(fit.status, FitStatus::always_exceeds);
    EXPECT_EQ(fit.curve.floor, 1.0);
  }
}

TEST(fit_by_record, keeps_the_floor_beside_a_bound) {
  const FitSummary fit = fit_brackets(not_reached(7, 30, 10), Independent::records);
  EXPECT_EQ(fit.status, FitStatus::lower_bound);
  EXPECT_DOUBLE_EQ(fit.curve.floor, 0.25);
  EXPECT_DOUBLE_EQ(fit.p50_interval.low, fit.curve.intensity_at(0.5));  // below the median's bound
  EXPECT_LT(fit.p50_interval.low, fit.median_interval.low);
}

TEST(fit_by_record, has_no_curve_where_the_share_does_not_rise) {
  const FitSummary fit =
      fit_stripes(alike(7, {{0.5, 20, 5}, {1.0, 20, 5}, {2.0, 20, 5}}), Independent::records);
  EXPECT_EQ(fit.status, FitStatus::no_trend);
  EXPECT_TRUE(std::isnan(fit.curve.median));
}

TEST(fit_by_record, gives_no_interval_for_one_record) {
  const FitSummary fit = fit_stripes(simulated_stripes(1, 1), Independent::records);
  EXPECT_EQ(fit.status, FitStatus::maximum_likelihood);
  EXPECT_TRUE(std::isnan(fit.median_interval.low));
  EXPECT_NE(fit.note, "");
}

}  // namespace
}  // namespace glissade
