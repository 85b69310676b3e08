// SPDX-License-Identifier: GPL-3.0-or-later
// Annual rates and slip over a design life of histories that can be followed by hand.
#include "glissade/study/analysis/hazard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "glissade/core/normal.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/results.hpp"

namespace glissade {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct ByHand {
  StudyConfig config;
  Results results;

  /// One run of all cases; no history slides.
  ByHand(std::size_t records, std::size_t cases, std::vector<double> levels,
         std::vector<double> thresholds_m) {
    config.sampling.bootstrap_replicates = 200;
    hazard(1e-3, 2.0, 50.0);
    results.levels = std::move(levels);
    results.thresholds_m = std::move(thresholds_m);
    results.cases.samples = cases;
    results.cases.cases.resize(cases);
    for (Case& c : results.cases.cases) c.friction = c.friction_across = 0.5;
    HistoryTable& table = results.histories;
    table = {records, cases, results.levels.size(), results.thresholds_m.size(), {}};
    table.fields.peak_displacement_m.assign(records * cases * table.levels, 0.0);
    table.fields.capacity.assign(records * cases * table.thresholds, infinity);
    RunResults run;
    run.label = "sampled";
    run.cases = cases;
    for (const double threshold_m : results.thresholds_m) {
      run.fragilities.emplace_back().threshold_m = threshold_m;
      run.fragilities.back().censored_share = 0.5;
    }
    results.runs = {run};
  }

  void hazard(double k0, double k, double years) {
    config.hazard = HazardConfig{HazardCurve::power_law(k0, k), "", years, {1.0 / 700, 1.0 / 2475}};
  }
  double& capacity(std::size_t record, std::size_t c, std::size_t threshold) {
    const HistoryTable& table = results.histories;
    return results.histories.fields
        .capacity[(record * table.cases + c) * table.thresholds + threshold];
  }
  double& peak_m(std::size_t record, std::size_t c, std::size_t level) {
    return results.histories.fields.peak_displacement_m[results.histories.at(record, c, level)];
  }
  /// Every history of a record slides as far at all levels, and stays there.
  void slide(std::size_t record, double along_m, double across_m) {
    HistoryFields& f = results.histories.fields;
    f.residual_along_m.resize(f.peak_displacement_m.size());
    f.residual_across_m.resize(f.peak_displacement_m.size());
    for (std::size_t c = 0; c < results.histories.cases; ++c) {
      for (std::size_t level = 0; level < results.levels.size(); ++level) {
        const std::size_t at = results.histories.at(record, c, level);
        f.peak_displacement_m[at] = std::hypot(along_m, across_m);
        f.residual_along_m[at] = along_m;
        f.residual_across_m[at] = across_m;
      }
    }
  }
  HazardRun run() const { return HazardAnalysis::find(config, results).runs.at(0); }
};

TEST(hazard, rate_is_the_mean_of_the_hazard_curve_over_the_capacities) {
  ByHand study(2, 2, {1.0, 2.0}, {0.3});
  study.capacity(0, 0, 0) = 0.5;
  study.capacity(0, 1, 0) = 1.0;
  study.capacity(1, 0, 0) = 2.0;  // the last is not reached: as if at 2
  const ThresholdRate row = study.run().thresholds.at(0);
  const double expected = 1e-3 * (4.0 + 1.0 + 0.25 + 0.25) / 4;
  EXPECT_NEAR(row.annual_rate.value, expected, 1e-17);
  EXPECT_NEAR(row.beyond_share, 0.25 / 5.5, 1e-15);
  EXPECT_NEAR(row.life_probability.value, 1.0 - std::exp(-50.0 * expected), 1e-15);
  EXPECT_LE(row.annual_rate.interval.low, expected);
  EXPECT_GE(row.annual_rate.interval.high, expected);
}

// Capacities at the middle of 400 equal parts of a lognormal; the closed form of the fit.
TEST(hazard, rate_of_lognormal_capacities_is_that_of_the_fit) {
  ByHand study(20, 20, {1e-3, 1e3}, {0.3});
  const FragilityCurve curve{0.5, 0.4};
  for (std::size_t i = 0; i < 400; ++i)
    study.capacity(i % 20, i / 20, 0) = curve.intensity_at((static_cast<double>(i) + 0.5) / 400);
  study.results.runs[0].fragilities[0].capacities.curve = curve;
  study.results.runs[0].fragilities[0].capacities.status = FitStatus::maximum_likelihood;
  const ThresholdRate row = study.run().thresholds.at(0);
  EXPECT_NEAR(row.fit_rate, 1e-3 * 4.0 * std::exp(0.5 * 0.64), 1e-14);
  EXPECT_NEAR(row.annual_rate.value / row.fit_rate, 1.0, 0.01);
}

// Of one capacity c, rate(x) = rate(c) / 2; of capacities 1 and 2, rate(1) + rate(2) = 1.25e-3, and
// above x from 1 to 2 there are rate(x) + 0.25e-3 = 0.625e-3.
TEST(hazard, half_of_the_rate_is_of_shaking_above_the_median_of_the_deaggregation) {
  ByHand one(1, 1, {0.1, 9.0}, {0.3});
  one.capacity(0, 0, 0) = 3.0;
  EXPECT_NEAR(one.run().thresholds.at(0).half_intensity, 3.0 * std::sqrt(2.0), 1e-14);
  ByHand two(2, 1, {0.1, 9.0}, {0.3});
  two.capacity(0, 0, 0) = 2.0;
  two.capacity(1, 0, 0) = 1.0;
  EXPECT_NEAR(two.run().thresholds.at(0).half_intensity, std::sqrt(1e-3 / 0.375e-3), 1e-14);
  two.capacity(0, 0, 0) = 1.1;  // above both: 2 rate(x) = (1 + 1 / 1.21) / 2 of 1e-3
  EXPECT_NEAR(two.run().thresholds.at(0).half_intensity, std::sqrt(4.0 / (1.0 + 1.0 / 1.21)),
              1e-14);
  two.capacity(0, 0, 0) = infinity;  // as if at the highest level: half is below it
  EXPECT_NEAR(two.run().thresholds.at(0).half_intensity, std::sqrt(1.0 / (0.5 - 0.5 / 81.0)),
              1e-14);
  two.capacity(1, 0, 0) = infinity;
  EXPECT_EQ(two.run().thresholds.at(0).half_intensity, infinity);
}

TEST(hazard, rates_double_with_the_hazard) {
  ByHand study(2, 1, {1.0, 2.0}, {0.3});
  study.capacity(0, 0, 0) = 0.7;
  study.peak_m(0, 0, 0) = 0.4;
  study.peak_m(0, 0, 1) = 0.8;
  const HazardRun once = study.run();
  study.hazard(2e-3, 2.0, 50.0);
  const HazardRun twice = study.run();
  EXPECT_NEAR(twice.thresholds[0].annual_rate.value / once.thresholds[0].annual_rate.value, 2.0,
              1e-12);
  EXPECT_NEAR(
      twice.thresholds[0].annual_rate.interval.high / once.thresholds[0].annual_rate.interval.high,
      2.0, 1e-12);
  for (std::size_t i = 0; i < once.curve.size(); ++i)
    EXPECT_NEAR(twice.curve[i].annual_rate.value / once.curve[i].annual_rate.value, 2.0, 1e-12);
}

TEST(hazard, of_a_history_that_slides_freely_has_no_rate) {
  ByHand study(2, 1, {1.0, 2.0}, {0.3});
  study.results.cases.cases[0].slope_deg = 40.0;
  study.capacity(0, 0, 0) = study.capacity(1, 0, 0) = 0.0;
  const HazardRun run = study.run();
  EXPECT_EQ(run.thresholds[0].annual_rate.value, infinity);
  EXPECT_EQ(run.thresholds[0].life_probability.value, 1.0);
  EXPECT_TRUE(std::isnan(run.thresholds[0].half_intensity));
  EXPECT_EQ(run.curve.back().annual_rate.value, infinity);
  EXPECT_EQ(run.life.at(0).median_m.value, infinity);
}

// The root of displacement is linear in intensity: capacity of d is sqrt(d), from the lowest level
// on, where 0.01 m is exceeded.
TEST(hazard, curve_falls_with_displacement_and_gives_the_displacement_of_a_rate) {
  ByHand study(3, 1, {0.1, 0.5, 1.0, 4.0}, {0.3});
  for (std::size_t record = 0; record < 3; ++record) {
    study.capacity(record, 0, 0) = std::sqrt(0.3);
    for (std::size_t level = 0; level < 4; ++level)
      study.peak_m(record, 0, level) = std::pow(study.results.levels[level], 2.0);
  }
  const HazardRun run = study.run();
  for (const DisplacementRate& row : run.curve) {
    const bool is_below = row.displacement_m < 0.01;
    EXPECT_EQ(row.below_share, is_below ? 1.0 : 0.0);
    EXPECT_TRUE(!is_below || std::isnan(row.annual_rate.interval.low));
    EXPECT_NEAR(row.annual_rate.value * std::max(row.displacement_m, 0.01), 1e-3, 1e-13);
  }
  EXPECT_TRUE(std::ranges::is_sorted(run.curve, std::greater<>(), [](const DisplacementRate& row) {
    return row.annual_rate.value;
  }));
  ASSERT_EQ(run.targets.size(), 2u);
  EXPECT_NEAR(run.targets[0].displacement_m.value, 0.7, 1e-12);
  EXPECT_NEAR(run.targets[1].displacement_m.value, 2.475, 1e-12);
  EXPECT_EQ(run.targets[1].below_share, 0.0);
  EXPECT_NEAR(run.targets[1].intensity, std::sqrt(2.475), 1e-13);
  EXPECT_NEAR(run.targets[1].displacement_m.interval.high, 2.475, 1e-12);
}

// One of three histories slides 0.2 m at the lowest level already: what it does in weaker shaking
// is not known, and nothing is read between there and no shaking.
TEST(hazard, rates_of_displacements_below_the_lowest_level_are_lower_bounds) {
  ByHand study(3, 1, {1.0, 2.0}, {0.3});
  study.peak_m(0, 0, 0) = 0.2;
  for (std::size_t record = 0; record < 3; ++record) study.peak_m(record, 0, 1) = 0.8;
  study.config.standards.compare = {Standard::asce7_16};
  study.config.hazard->sds_g = 1.0;
  study.config.hazard->target_rates_per_year = {0.01, 5e-4};
  const HazardRun run = study.run();
  const DisplacementRate& least = run.curve.front();  // 1 mm
  EXPECT_DOUBLE_EQ(least.below_share, 1.0 / 3.0);
  const double others = 1e-3 * std::pow(1.0 + std::sqrt(0.001 / 0.8), -2.0);
  EXPECT_NEAR(least.annual_rate.value, (1e-3 + 2.0 * others) / 3.0, 1e-16);
  EXPECT_TRUE(std::isnan(least.annual_rate.interval.high));
  EXPECT_EQ(run.curve.back().below_share, 0.0);
  EXPECT_TRUE(std::isnan(run.targets[0].displacement_m.value));
  EXPECT_GT(run.targets[0].below_share, 0.0);
  EXPECT_TRUE(std::isfinite(run.targets[1].displacement_m.value));
  EXPECT_EQ(run.prescribed.at(0).below_share, 0.0);
  EXPECT_DOUBLE_EQ(run.moving_share, 1.0 / 3.0);
}

TEST(hazard, displacement_of_a_rate_beyond_the_levels_is_infinite) {
  ByHand study(3, 1, {0.5, 1.0}, {0.3});  // shaking above 1 is more frequent than 1/2475
  const HazardRun run = study.run();
  EXPECT_EQ(run.targets[1].displacement_m.value, infinity);
  EXPECT_EQ(run.thresholds[0].beyond_share, 1.0);
  EXPECT_TRUE(std::isnan(run.thresholds[0].annual_rate.interval.low));
}

// A Poisson number of earthquakes with mean 3: quantiles 3, 5 and 6 (cumulative 0.647, 0.916,
// 0.966; 0.815 at 4). Shaking above the highest level: 3e-6 in a life.
TEST(design_life, slip_down_the_slope_adds_up) {
  ByHand study(2, 1, {1.0, 1000.0}, {0.3});
  study.hazard(3.0 / 50.0, 2.0, 50.0);
  study.slide(0, 0.1, 0.0);
  study.slide(1, 0.1, 0.0);
  const HazardRun run = study.run();
  EXPECT_NEAR(run.events, 3.0, 1e-12);
  EXPECT_EQ(run.moving_share, 1.0);
  ASSERT_EQ(run.life.size(), 3u);
  for (const LifeDisplacement& row : {run.life[1], run.life[2]}) {
    EXPECT_NEAR(row.median_m.value, 0.3, 1e-12);
    EXPECT_NEAR(row.p84_m.value, 0.5, 1e-12);
    EXPECT_NEAR(row.p95_m.value, 0.6, 1e-12);
    EXPECT_TRUE(std::isnan(row.p95_m.interval.high));  // they slide at the lowest level: a bound
  }
  EXPECT_NEAR(run.life[0].p95_m.value, 0.1, 1e-15);
}

// The mean of the square of a sum of N steps of either sign is N; of one sign it is N^2.
TEST(design_life, slip_to_either_side_partly_cancels) {
  ByHand study(2, 1, {1.0, 1000.0}, {0.3});
  study.hazard(20.0 / 50.0, 2.0, 50.0);
  study.slide(0, 0.0, 0.1);
  study.slide(1, 0.0, -0.1);
  const HazardRun run = study.run();
  EXPECT_LT(run.life[1].p95_m.value, 1.1);  // 2.8 in one direction; 1.96 sqrt(20) 0.1 = 0.88
  EXPECT_GT(run.life[1].p95_m.value, 0.7);
  EXPECT_GT(run.life[2].median_m.value, run.life[1].median_m.value);
}

// Two samples whose orientations are mirrored: each life keeps one, so that all its slip is to one
// side. A Poisson number of mean 20: median 20, 95th percentile 28 (cumulative 0.559, 0.966).
TEST(design_life, keeps_the_orientation_of_a_sample) {
  ByHand study(1, 2, {1.0, 1000.0}, {0.3});
  study.hazard(20.0 / 50.0, 2.0, 50.0);
  study.slide(0, 0.0, 0.1);
  HistoryFields& f = study.results.histories.fields;
  for (std::size_t level = 0; level < 2; ++level)
    f.residual_across_m[study.results.histories.at(0, 1, level)] = -0.1;
  const HazardRun run = study.run();
  EXPECT_NEAR(run.life[1].median_m.value, 2.0, 1e-12);
  EXPECT_NEAR(run.life[1].p95_m.value, 2.8, 1e-12);
}

TEST(design_life, without_residuals_every_peak_counts_as_slip_down_the_slope) {
  ByHand study(2, 1, {1.0, 1000.0}, {0.3});
  study.hazard(3.0 / 50.0, 2.0, 50.0);
  for (double& peak : study.results.histories.fields.peak_displacement_m) peak = 0.2;
  EXPECT_FALSE(HazardAnalysis::find(study.config, study.results).residual_vectors);
  EXPECT_NEAR(study.run().life[1].p84_m.value, 1.0, 1e-12);
}

TEST(design_life, is_zero_where_nothing_slides_and_without_bound_beyond_the_levels) {
  ByHand study(2, 1, {1.0, 2.0, 1000.0}, {0.3});
  const HazardRun still = study.run();
  EXPECT_EQ(still.life[2].p95_m.value, 0.0);
  EXPECT_EQ(still.moving_share, 0.0);
  EXPECT_EQ(still.from_intensity, 1000.0);
  study.hazard(1e6, 2.0, 50.0);  // 50 earthquakes above 1,000
  EXPECT_EQ(study.run().life[0].median_m.value, infinity);
}

// 5e9 earthquakes a life above the lowest level: those above the first level of at most 2,000
// count.
TEST(design_life, counts_a_bounded_number_of_earthquakes) {
  ByHand study(2, 1, {0.001, 10.0, 1000.0}, {0.3});
  study.slide(0, 0.001, 0.0);
  study.slide(1, 0.001, 0.0);
  study.hazard(100.0, 2.0, 50.0);
  const HazardRun run = study.run();
  EXPECT_EQ(run.from_intensity, 10.0);
  EXPECT_NEAR(run.events, 50.0, 1e-9);
  EXPECT_EQ(run.moving_share, 1.0);
  study.hazard(1e12, 2.0, 50.0);
  EXPECT_LE(study.run().events, 2000.0);
}

/// Records that reach 1 m at 0.5 and at 2: displacement rises from 0 at level 0.25.
ByHand two_records() {
  ByHand study(2, 1, {0.25, 0.5, 2.0, 4.0}, {1.0});
  study.capacity(0, 0, 0) = 0.5;
  study.capacity(1, 0, 0) = 2.0;
  for (const std::size_t record : {0, 1})
    for (const std::size_t level : {1, 2, 3})
      study.peak_m(record, 0, level) = record == 0 || level > 1 ? 1.0 : 0.0;
  return study;
}

TEST(design_life, is_the_same_each_time) {
  ByHand study = two_records();
  study.hazard(0.05, 3.0, 25.0);
  const HazardRun a = study.run(), b = study.run();
  for (std::size_t q = 0; q < a.life.size(); ++q) {
    EXPECT_EQ(a.life[q].p95_m.value, b.life[q].p95_m.value);
    EXPECT_EQ(a.life[q].p95_m.interval.high, b.life[q].p95_m.interval.high);
    EXPECT_LE(a.life[q].p95_m.interval.low, a.life[q].p95_m.value);
    EXPECT_GE(a.life[q].p95_m.interval.high, a.life[q].p95_m.value);
  }
}

TEST(hazard, gives_the_rate_of_what_standards_prescribe_at_the_s_ds_of_the_site) {
  ByHand study = two_records();
  EXPECT_TRUE(study.run().prescribed.empty());  // S_DS is not known
  study.config.standards.compare = {Standard::asce7_16};
  study.config.hazard->sds_g = 1.0;  // 5 (1 - 0.4)^2 ft = 1.8 ft = 0.549 m
  const HazardRun run = study.run();
  ASSERT_EQ(run.prescribed.size(), 1u);
  const PrescribedRate& row = run.prescribed[0];
  EXPECT_EQ(row.sds_g, 1.0);
  // It is not less than 24 in.
  EXPECT_NEAR(row.prescribed.value_m, 0.6096, 1e-12);
  // sqrt(D) is a line from 0 at the node before: at 0.25 and 0.5, at 0.5 and 2.
  const double share = std::sqrt(0.6096), k0 = 1e-3;
  const double first = k0 * std::pow(0.25 + 0.25 * share, -2.0),
               second = k0 * std::pow(0.5 + 1.5 * share, -2.0);
  EXPECT_NEAR(row.annual_rate.value / (0.5 * (first + second)), 1.0, 1e-12);
  study.config.hazard->sds_g = 0.0;
  study.results.model.dbe_level = 2.0;  // that of the design target
  EXPECT_EQ(study.run().prescribed.at(0).sds_g, 2.0);
}

TEST(hazard, gives_the_distribution_of_slip_over_the_design_life) {
  ByHand study = two_records();
  study.hazard(0.05, 2.0, 25.0);
  const HazardRun run = study.run();
  for (const LifeQuantity quantity :
       {LifeQuantity::single, LifeQuantity::accumulated, LifeQuantity::farthest}) {
    std::vector<LifeQuantile> rows;
    for (const LifeQuantile& row : run.life_distribution)
      if (row.quantity == quantity) rows.push_back(row);
    ASSERT_EQ(rows.size(), 21u);
    EXPECT_TRUE(std::ranges::is_sorted(rows, {}, &LifeQuantile::displacement_m));
    EXPECT_TRUE(std::ranges::is_sorted(rows, {}, &LifeQuantile::probability));
    const LifeDisplacement& life = run.life[static_cast<std::size_t>(quantity)];
    EXPECT_EQ(rows[4].displacement_m, life.median_m.value);
    EXPECT_EQ(rows[10].displacement_m, life.p95_m.value);
  }
}

}  // namespace
}  // namespace glissade
