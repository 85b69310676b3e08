// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/chart.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "glissade/block/slide.hpp"
#include "glissade/block/tipping.hpp"
#include "glissade/building/roof_motion.hpp"
#include "glissade/core/units.hpp"
#include "glissade/study/analysis/conditions/condition_grid.hpp"
#include "unit/study/small_study.hpp"

namespace glissade {
namespace {

using test::drawn;
using test::fixed;
using test::listed;
using test::run;
using test::small_config;
using test::small_plan;

constexpr double infinity = std::numeric_limits<double>::infinity();

StudyConfig chart_config() {
  StudyConfig config = small_config();
  config.fragility.reset();
  config.standards.compare = {Standard::seaoc_pv1_2012};
  config.intensity.levels = {0.0, 0.5, 2.0};
  config.orientation.choice = OrientationChoice::all_permutations;
  config.quantities.at("roof", "slope_deg") = listed({0.0, 2.0, 10.0});
  config.quantities.at("friction", "mu") = listed({0.15, 0.3, 0.5});
  config.quantities.at("building", "period_s") = listed({0.0, 0.3});
  config.chart = ChartConfig{.shown_slope_deg = 2.0, .shown_mu = 0.3, .shown_level = 2.0};
  return config;
}

Results run(const StudyConfig& config) { return run(small_plan(config)); }

/// A history by itself, in the readable scheme, the ring-down followed to silence.
double slip_by_hand(const Plan& plan, std::size_t record, const Case& c, double level) {
  const test::CaseGround ground = test::ground_of(plan, record, c, level);
  const RoofMotion roof =
      roof_motion(ground.motion, {{c.period_s, c.damping}, {}}, {.quiet_horizontal_mps2 = 1e-4});
  return slide({roof.dt_s, roof.horizontal_mps2, roof.vertical_mps2, ground.factors.horizontal[0],
                ground.factors.vertical},
               {.friction = c.friction, .slope_rad = c.slope_deg * rad_per_deg})
      .peak_displacement_m;
}

TEST(chart, has_the_mean_over_records_of_each_records_largest_orientation) {
  const Plan plan = small_plan(chart_config());
  const Chart chart = *run(plan).chart;
  int slid = 0;
  for (std::size_t level = 0; level < 3; ++level) {
    for (std::size_t slope = 0; slope < 2; ++slope) {
      for (std::size_t mu = 0; mu < 3; ++mu) {
        const ChartPoint& point = chart.at(level, slope, mu);
        for (std::size_t period = 0; period < 2; ++period) {
          double sum = 0.0, largest = 0.0;
          for (std::size_t record = 0; record < 3; ++record) {
            double of_record = 0.0;
            for (const double azimuth : {0.0, 90.0, 180.0, 270.0}) {
              Case c;
              c.friction = chart.mu[mu];
              c.slope_deg = chart.slope_deg[slope];
              c.period_s = chart.period_s[period];
              c.orientation.ground_azimuth_deg = azimuth;
              of_record = std::max(
                  of_record, slip_by_hand(plan, record, c, plan.config.intensity.levels[level]));
            }
            sum += of_record;
            largest = std::max(largest, of_record);
          }
          const double uplift = point.uplift_share > 0.0 ? 1e-3 : 2e-5;
          EXPECT_NEAR(point.by_period[period].mean_m, sum / 3.0, uplift * sum + 2e-6);
          EXPECT_NEAR(point.by_period[period].envelope_m, largest, uplift * largest + 2e-6);
          slid += sum > 0.0;
        }
        EXPECT_EQ(point.largest.mean_m,
                  std::max(point.by_period[0].mean_m, point.by_period[1].mean_m));
        EXPECT_EQ(point.clearance_m, 1.1 * point.largest.mean_m);
      }
    }
  }
  EXPECT_GT(slid, 12);
}

TEST(chart, has_the_6960_runs_of_the_paper) {
  // Rodriguez-Nikl et al. (2019): 29 slopes x 15 frictions x 16 intensities.
  StudyConfig config = chart_config();
  config.orientation.choice = OrientationChoice::as_recorded;
  std::vector<double> slopes, frictions;
  for (int i = -14; i <= 14; ++i) slopes.push_back(0.5 * i);
  for (int i = 0; i < 15; ++i) frictions.push_back(0.1 + 0.05 * i);
  config.quantities.at("roof", "slope_deg") = listed(slopes);
  config.quantities.at("friction", "mu") = listed(frictions);
  config.quantities.at("building", "period_s") = fixed(0.0);
  EXPECT_EQ(small_plan(config).order.size() * 16, 6960u);
  // The same grid as slopes under both signs of the motion: a flat roof needs one.
  slopes.erase(slopes.begin(), slopes.begin() + 14);
  config.quantities.at("roof", "slope_deg") = listed(slopes);
  config.orientation.choice = OrientationChoice::all_permutations;
  EXPECT_EQ(small_plan(config).order.size() * 16, 2 * 6960u);  // with both components
}

TEST(chart, takes_negative_slopes_for_the_mirror_image_of_the_motion) {
  StudyConfig both_signs = chart_config(), both_slopes = chart_config();
  both_slopes.quantities.at("roof", "slope_deg") = listed({-10.0, -2.0, 0.0, 2.0, 10.0});
  const Chart a = *run(both_signs).chart, b = *run(both_slopes).chart;
  EXPECT_EQ(a.slope_deg, b.slope_deg);
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    EXPECT_EQ(a.points[i].largest.mean_m, b.points[i].largest.mean_m);
    EXPECT_EQ(a.points[i].largest.envelope_m, b.points[i].largest.envelope_m);
  }
}

TEST(chart, shows_where_friction_cannot_stop_the_array) {
  const Results results = run(chart_config());
  const Chart& chart = *results.chart;
  // tan(10 deg) = 0.176: more than 0.15 and less than 0.3. Without shaking too.
  for (const std::size_t level : {0u, 2u}) {
    EXPECT_TRUE(chart.at(level, 2, 0).free_sliding);
    EXPECT_EQ(chart.at(level, 2, 0).clearance_m, infinity);
    EXPECT_EQ(chart.at(level, 2, 0).by_period.size(), 2u);
    EXPECT_FALSE(chart.at(level, 2, 1).free_sliding);
    EXPECT_TRUE(std::isfinite(chart.at(level, 2, 1).clearance_m));
  }
  EXPECT_EQ(chart.at(0, 2, 1).clearance_m, 0.0);  // no shaking
  // What it slid by the record's end is kept with the histories.
  const CaseSet& set = results.cases;
  std::vector<std::size_t> at(set.axes.size(), 0);
  at[set.axis("roof.slope_deg")] = 2;
  EXPECT_GT(results.histories.displacement_m(0, set.index(set.combination(at), 0, 0), 0), 1.0);
}

TEST(chart, gives_the_same_bits_when_nothing_is_skipped) {
  StudyConfig config = chart_config();
  config.tipping = RigidBase{0.4, 0.3};
  const Plan plan = small_plan(config);
  EXPECT_EQ(test::bits_of(run(plan).histories), test::bits_of(run(plan, Skipping::none).histories));
}

TEST(chart, makes_each_roof_of_a_record_once) {
  const Plan plan = small_plan(chart_config());
  RoofStore roofs(plan, Skipping::all);
  for (std::size_t u = 0; u < plan.units.size(); ++u) execute(plan, u, roofs);
  EXPECT_EQ(roofs.roofs_made(), 3u * 2u * 2u);  // records x components x periods
}

TEST(chart, flags_histories_in_which_the_body_begins_to_tip) {
  StudyConfig config = chart_config();
  config.tipping = RigidBase{.centre_of_mass_height_m = 1.0, .width_m = 0.5};  // from 0.25 of N on
  config.vertical = {VerticalChoice::none};
  const Plan plan = small_plan(config);
  const Results results = run(plan);
  int tipped = 0, stood = 0;
  test::for_each_history(
      results.histories, [&](std::size_t record, std::size_t i, std::size_t level) {
        const Case c = plan.cases[i];
        if (c.period_s != 0.0 || c.slope_deg != 0.0) return;
        double peak = 0.0;
        for (const double a : test::ground_of(plan, record, c, plan.config.intensity.levels[level])
                                  .motion.horizontal_mps2)
          peak = std::max(peak, std::abs(a));
        const double a = test::factor_of(plan, record, plan.config.intensity.levels[level]) * peak;
        const bool tipping = c.friction > 0.25 && a > 0.25 * standard_gravity_mps2;
        EXPECT_EQ(results.histories.fields.tips[results.histories.at(record, i, level)],
                  tipping ? 1 : 0);
        (tipping ? tipped : stood) += 1;
      });
  EXPECT_GT(tipped, 10);
  EXPECT_GT(stood, 10);
  // 10 deg alone (tan 0.176) does not tip it; with friction 0.15 it slides first.
  double where_it_slides = 0.0, elsewhere = 0.0;
  for (const TippingShare& row : results.tipping->shares) {
    double& share =
        results.cases.cases[row.first_case].friction < 0.25 ? where_it_slides : elsewhere;
    share = std::max(share, row.share);
  }
  EXPECT_EQ(where_it_slides, 0.0);
  EXPECT_GT(elsewhere, 0.0);
}

TEST(chart, has_no_tipping_results_without_the_tipping_check) {
  EXPECT_FALSE(run(chart_config()).tipping);
}

TEST(chart, gives_the_mean_an_interval_that_holds_it) {
  const Chart chart = *run(chart_config()).chart;
  const ChartPoint& point = chart.at(2, 1, 0);
  ASSERT_GT(point.largest.mean_m, 0.0);
  EXPECT_LT(point.mean_interval.low, point.largest.mean_m);
  EXPECT_GT(point.mean_interval.high, point.largest.mean_m);
  EXPECT_LT(point.mean_interval.high, 100.0 * point.largest.mean_m);
}

TEST(chart, puts_what_is_prescribed_beside_each_level) {
  const Chart chart = *run(chart_config()).chart;
  ASSERT_EQ(chart.standards.size(), 3u);
  EXPECT_EQ(chart.standards[2].sds_g, 2.0);
  EXPECT_NEAR(chart.standards[2].prescribed.value_m, 60.0 * 1.6 * 1.6 * 0.0254, 1e-12);
}

TEST(chart, counts_every_record_and_sample_of_friction_that_is_drawn) {
  StudyConfig config = chart_config();
  config.quantities.at("friction", "mu") = drawn(Normal{0.4, 0.05});
  config.quantities.at("roof", "slope_deg") = listed({2.0});
  config.sampling.samples = 5;
  const Results results = run(config);
  const Chart& chart = *results.chart;
  EXPECT_EQ(chart.mu, std::vector{0.4});
  ASSERT_EQ(chart.points.size(), 3u);
  const CaseSet& set = results.cases;
  ASSERT_EQ(set.combinations(), 4u);  // sampled and design friction, two periods
  for (const std::size_t period : {0u, 1u}) {
    double sum = 0.0, largest = 0.0;
    for (std::size_t record = 0; record < 3; ++record) {
      for (std::size_t sample = 0; sample < 5; ++sample) {
        double of_sample = 0.0;
        for (std::size_t o = 0; o < set.orientations; ++o)
          of_sample = std::max(
              of_sample, results.histories.displacement_m(record, set.index(period, sample, o), 2));
        sum += of_sample;
        largest = std::max(largest, of_sample);
      }
    }
    EXPECT_GT(sum, 0.0);
    EXPECT_NEAR(chart.at(2, 0, 0).by_period[period].mean_m, sum / 15, 1e-14);
    EXPECT_EQ(chart.at(2, 0, 0).by_period[period].envelope_m, largest);
  }
}

TEST(chart, of_one_study_with_fragility_and_clearance_agrees_with_them) {
  StudyConfig config = chart_config();
  config.model.axes = SlidingAxes::two;
  config.intensity.measure = IntensityMeasure::mce_fraction;
  config.intensity.levels = {1.0, 3.0};
  config.standards.compare.clear();
  config.orientation.choice = OrientationChoice::as_recorded;
  config.quantities.at("roof", "slope_deg") = listed({2.0});
  config.quantities.at("building", "period_s") = listed({0.2, 0.5});
  config.quantities.at("friction", "mu") = drawn(Normal{0.3, 0.05});
  config.sampling.samples = 3;
  config.fragility = FragilityConfig{.thresholds_m = {0.05}};
  config.chart->shown_level = 3.0;
  config.clearance = ClearanceConfig{.without_target = true};
  const Results results = run(config);
  ASSERT_EQ(results.runs.size(), 4u);
  EXPECT_EQ(results.runs[1].label, "sampled_period_s_0_5");
  EXPECT_EQ(results.runs[2].label, "design_period_s_0_2");
  const ConditionGrid clearance(results);
  EXPECT_NEAR(clearance.case_at({}).friction, 0.2, 1e-15);
  ASSERT_EQ(clearance.count(), 4u);  // levels, periods
  for (std::size_t level = 0; level < 2; ++level) {
    for (std::size_t period = 0; period < 2; ++period) {
      // Chart and fragility: over records and samples. Clearance: at the design friction.
      EXPECT_NEAR(results.chart->at(level, 0, 0).by_period[period].mean_m,
                  results.runs[period].slip[level].mean_m, 1e-14);
      double sum = 0.0;
      for (std::size_t record = 0; record < 3; ++record)
        sum +=
            clearance.history(record, 0, clearance.position(2 * level + period)).displacement_m();
      EXPECT_NEAR(sum / 3, results.runs[2 + period].slip[level].mean_m, 1e-14);
      EXPECT_GT(sum / 3, results.runs[period].slip[level].mean_m);
    }
  }
}

// -- reading off, on a chart whose slips are known: bilinear in slope and friction

/// mean = 1 + slope - mu in metres on slopes 0, 2, 4 and frictions 0.2, 0.4, 0.8; p95 twice that;
/// the envelope infinite at slope 4 with friction 0.2.
Chart made_up_chart() {
  Chart chart{.slope_deg = {0.0, 2.0, 4.0}, .mu = {0.2, 0.4, 0.8}, .period_s = {0.0}};
  for (const double slope : chart.slope_deg)
    for (const double mu : chart.mu) {
      ChartPoint p{.level = 1.0, .slope_deg = slope, .mu = mu};
      const double slip = 1.0 + slope - mu;
      p.largest = {slip, 0.0, 2.0 * slip, slope == 4.0 && mu == 0.2 ? infinity : slip};
      p.clearance_m = 1.1 * slip;
      chart.points.push_back(p);
    }
  return chart;
}

TEST(chart_reading, is_linear_between_the_points) {
  const ChartReading r =
      read_off(made_up_chart(), {1.0}, {.level = 1.0, .slope_deg = 1.5, .mu = 0.5});
  EXPECT_NEAR(r.mean, 2.0, 1e-15);
  EXPECT_NEAR(r.clearance, 2.2, 1e-15);
  EXPECT_NEAR(r.p95, 4.0, 1e-15);
  EXPECT_EQ(r.p84, 0.0);
}

TEST(chart_reading, gives_the_charts_own_values_at_its_points) {
  const Chart chart = made_up_chart();
  for (std::size_t s = 0; s < 3; ++s)
    for (std::size_t m = 0; m < 3; ++m)
      EXPECT_EQ(
          read_off(chart, {1.0}, {.level = 1.0, .slope_deg = chart.slope_deg[s], .mu = chart.mu[m]})
              .mean,
          chart.at(0, s, m).largest.mean_m);
}

TEST(chart_reading, finds_the_friction_that_keeps_slip_within_a_displacement) {
  const auto needed = [](double slope, double displacement) {
    return read_off(made_up_chart(), {1.0},
                    {.level = 1.0, .slope_deg = slope, .displacement_m = displacement});
  };
  EXPECT_NEAR(needed(1.0, 1.5).mean, 0.5, 1e-15);        // 1 + 1 - mu = 1.5
  EXPECT_NEAR(needed(1.0, 1.65).clearance, 0.5, 1e-15);  // 1.1 (2 - mu) = 1.65
  EXPECT_EQ(needed(1.0, 0.5).mean, infinity);            // more than 0.8
  EXPECT_EQ(needed(1.0, 10.0).mean, 0.2);                // the least there is
  EXPECT_EQ(needed(1.0, 0.0001).p84, 0.2);
}

TEST(chart_reading, is_on_the_safe_side_beside_free_sliding) {
  const auto read = [](double slope, double mu) {
    return read_off(made_up_chart(), {1.0}, {.level = 1.0, .slope_deg = slope, .mu = mu}).envelope;
  };
  EXPECT_EQ(read(4.0, 0.2), infinity);
  EXPECT_EQ(read(3.0, 0.3), infinity);
  EXPECT_NEAR(read(4.0, 0.4), 4.6, 1e-15);
  EXPECT_EQ(read(2.0, 0.2), 2.8);
  EXPECT_EQ(
      read_off(made_up_chart(), {1.0}, {.level = 1.0, .slope_deg = 4.0, .displacement_m = 50.0})
          .envelope,
      0.4);
}

}  // namespace
}  // namespace glissade
