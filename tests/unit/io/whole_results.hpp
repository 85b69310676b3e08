// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <string>

#include "glissade/core/file.hpp"
#include "glissade/io/results_file.hpp"
#include "temporary_folder.hpp"

// Results of each analysis in which every field has a value of its own, and whose parts fit.
namespace glissade {

/// Every field that a study on so many axes keeps, of the size that the table has.
inline void fill_histories(HistoryTable& table, bool two_axes) {
  double x = 0.0;
  for_each_history_field([&](auto field) {
    auto& values = table.fields.*field.of;
    const std::string name = field.name;
    const bool across = name == "peak_vector_m" || name.find("_along") != std::string::npos ||
                        name.find("_across") != std::string::npos;
    values.clear();
    if (across && !two_axes) return;
    using T = std::remove_cvref_t<decltype(values.front())>;
    for (std::size_t i = 0; i < table.records * table.cases * table.depth(field.depth); ++i)
      values.push_back(std::is_same_v<T, double> ? static_cast<T>(std::sqrt(x += 1.0))
                                                 : static_cast<T>(i % 3 == 0));
  });
  if (table.thresholds == 0) return;
  table.fields.capacity[0] = std::numeric_limits<double>::infinity();
  table.fields.crossing_time_s[1] = table.fields.crossing_speed_mps[1] = std::nan("");
}

inline ThresholdFragility whole_fragility(double threshold_m, std::size_t levels,
                                          std::size_t records, std::size_t band) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const double nan_value = std::nan("");
  ThresholdFragility f;
  f.threshold_m = threshold_m;
  f.stripes = {FitStatus::jeffreys_penalised,
               {0.7, 0.4, 0.125},
               {0.6, nan_value},
               {0.3, 0.5},
               {0.1, 0.15},
               {0.55, 0.65},
               -12.5,
               "probit",
               "profile",
               "separated"};
  f.capacities = {
      FitStatus::lower_bound, {1.5, 0.2}, {1.5, infinity}, {}, {}, {}, nan_value, "", "", ""};
  for (std::size_t i = 0; i < levels; ++i) {
    f.probability.push_back(static_cast<double>(i) / 3);
    f.probability_interval.push_back({0.1, i == 2 ? nan_value : 0.4});
  }
  f.band.assign(band, {0.125, 0.5});
  f.recross_share = 0.01;
  f.record_recross.assign(records, 1.0);
  f.censored_share = 0.5;
  f.free_sliding_share = 0.02;
  f.lognormal = {0.001, 0.25, 0.5, -0.125, 0.75};
  return f;
}

/// Two records of a suite, three levels, two thresholds; sampled and design friction, four samples.
inline Results whole_results(bool two_axes = false) {
  Results r;
  r.study_name = "σχέδιο";  // UTF-8
  r.study_description = "every field";
  r.program_version = "0.1.0";
  r.plan_hash = "0123456789abcdef";
  r.study_text = "[study]\nname = \"σχέδιο\"\n";
  r.seed = 0xfedcba9876543210u;
  r.measure = *IntensityMeasure::named("avg_sa_g");
  r.intensity_label = "Sa,avg (g)";
  r.model = {"tables", "elastic", "Coulomb", "vector"};
  r.axes = two_axes ? SlidingAxes::two : SlidingAxes::one;
  r.displacement = DisplacementMeasure::vector;
  r.levels = {0.5, 1.0, 1.5};
  r.thresholds_m = {0.15, 0.3};
  r.suites = {{"suite",
               "of two",
               "ASCE 7-16, S_S 1.5 g",
               {{0.0, 0.5}, {{0.4, 0.9}, {0.3, 1.1}}, {0.35, 1.0}, {}, 1.3}}};
  r.records = {{0, "a", "event", "station", 6.9, 8.5, 380.0, 2.5, 1.7, 0.5, 0.4, 0.3, 12.5, 0.005,
                7671, true, false, 1},
               {0, "b", "", "", 0, 0, 0, 1, 0, 0, 0, 0, 0, 0.01, 1, false, true, 0}};
  r.cases.axes = {{"friction.value", "-", {0.0, 1.0}, {"sampled", "design"}}};
  r.cases.samples = 4;
  r.cases.cases.resize(8);
  double x = 0.0;
  for (Case& c : r.cases.cases) {
    for (const Parameter& p : parameters()) p.of(c) = std::cbrt(x += 1.0);
    c.support = x < 50 ? ArraySupport::isolated : ArraySupport::no_array;
    c.vertical = VerticalChoice::required;
    c.neighbour_slope = x < 50 ? NeighbourSlope::same : NeighbourSlope::facing;
    c.friction_value = x < 70 ? FrictionValue::as_drawn : FrictionValue::design;
    c.orientation = {SlopeAxis::n_s, 22.5, -1};
  }
  r.histories.records = 2;
  r.histories.cases = 8;
  r.histories.levels = 3;
  r.histories.thresholds = 2;
  fill_histories(r.histories, two_axes);
  r.warnings = {"one axis"};
  r.notes = {"5 of 22 records have no vertical", ""};
  r.warnings_of_run = r.notes_of_run = 1;
  return r;
}

inline void add_fragility(Results& r) {
  for (const char* label : {"sampled", "design"}) {
    RunResults run;
    run.label = label;
    run.friction_description = "normal, mean 0.55, std 0.04";
    run.first_case = r.runs.empty() ? 0 : 4;
    run.cases = 4;
    run.fragilities = {whole_fragility(0.15, 3, 2, 2),
                       whole_fragility(0.3, 3, 2, 0)};  // the second has no band
    run.band_intensities = {0.5, 1.0};
    run.slip = {{0.5, 0.1, 0.2, 0.3, 0.15, {0.1, 0.2}, {0.05, 0.15}, {0.15, 0.25}, 0.0},
                {1.0, 1, 2, 3, 4, {5, 6}, {7, 8}, {9, 10}, 0.5, 11},
                {}};
    if (r.runs.empty())
      run.standards = {{Standard::asce7_16,
                        1.0,
                        {0.55, Provenance::recalled, "5 I_e (S_DS - 0.4)^2 ft"},
                        0.1,
                        {0.05, 0.2}}};
    r.runs.push_back(run);
  }
}

inline void add_impact(Results& r) {
  for (RunResults& run : r.runs) {
    run.impact.resize(r.levels.size() * r.thresholds_m.size());
    run.impact[0] = {0.5, 0.15, {0.25, {0.1, 0.4}}, {1, {5, 6}}, {2, {7, 8}}, 3, 4, 9, 10, 11};
    run.impact[1].speed_median_mps.value = std::nan("");
  }
}

/// Two slopes, two frictions, two periods.
inline void add_chart(Results& r) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Chart& chart = r.chart.emplace();
  chart.slope_deg = {0.0, 2.0};
  chart.mu = {0.3, 0.5};
  chart.period_s = {0.2, 1.0};
  chart.shown_slope_deg = 2.0;
  chart.shown_mu = 0.5;
  chart.shown_level = r.levels.back();
  for (std::size_t i = 0; i < 4 * r.levels.size(); ++i) {
    const double x = std::sqrt(1.0 + static_cast<double>(i));
    chart.points.push_back({.level = r.levels[i / 4],
                            .slope_deg = chart.slope_deg[i / 2 % 2],
                            .mu = chart.mu[i % 2],
                            .free_sliding = i == 3,
                            .largest = {x, 2 * x, 3 * x, i == 3 ? infinity : 4 * x},
                            .mean_interval = {x / 2, i == 3 ? std::nan("") : x * 2},
                            .governing_period_s = chart.period_s[i % 2],
                            .clearance_m = 1.1 * x,
                            .uplift_share = x / 10,
                            .by_period = {{x, x, x, x}, {0.1, 0.2, 0.3, infinity}}});
  }
  chart.readings = {{{1.5, 1.19, 0.47, std::nullopt}, 1.0, 1.1, 2.0, 3.0, 4.0},
                    {{1.5, 1.19, std::nullopt, 0.6}, 0.4, 0.5, 0.6, 0.7, infinity}};
  chart.standards = {{Standard::seaoc_pv1_2012, 1.5, {1.23, Provenance::checked, "60 (...)"}}};
}

inline Results with_fragility() {
  Results r = whole_results();
  add_fragility(r);
  return r;
}

/// Means of one suite, every number of its own.
inline std::vector<SuiteMean> whole_means(const Results& r, std::size_t count, double x) {
  std::vector<SuiteMean> means;
  for (std::size_t i = 0; i < count; ++i, x += 1.0) {
    means.push_back(
        {.suite = 0,
         .first_case = i % r.cases.size(),
         .condition = "mu = " + std::to_string(i),
         .level = x + 0.01,
         .period_s = i == 0 ? std::nan("") : x + 0.02,
         .range = {x + 0.03, x + 0.04, x + 0.05, {x + 0.06, x + 0.07}, {x + 0.12, x + 0.13}},
         .bounds = {x + 0.08, x + 0.09},
         .largest = x + 0.1,
         .by_orientation = std::vector(r.cases.orientations, x + 0.11)});
  }
  return means;
}

inline void add_clearance(Results& r, double factor) {
  r.conditions = condition_table(r);
  const auto places = [&](Periods periods) {
    return sliding_conditions(r.conditions->grid, periods).size();
  };
  ClearanceResults& clearance =
      r.clearance.emplace(ClearanceResults{factor, OrientationRule::median, {}, {}});
  for (const SuiteMean& mean : whole_means(r, places(Periods::largest), 1.0))
    clearance.required.push_back(
        {mean, mean.largest + 10.0, mean.largest + 20.0, mean.largest + 40.0});
  clearance.by_period = whole_means(r, places(Periods::one), 100.0);
}

inline void add_base_shear(Results& r) {
  r.conditions = condition_table(r);
  r.base_shear = {whole_means(r, r.conditions->grid.count(), 200.0)};
}

inline void add_tipping(Results& r) {
  TippingResults& tipping = r.tipping.emplace(TippingResults{{0.5, 0.75}, 0.625, {}});
  for (std::size_t i = 0; i < r.cases.combinations() * r.levels.size(); ++i) {
    const double x = 1.0 / (2.0 + static_cast<double>(i));
    tipping.shares.push_back({i % r.cases.size(), "at " + std::to_string(i), x, x / 2,
                              std::vector(r.records.size(), x / 3)});
  }
}

inline void add_hazard(Results& r) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  HazardResults& hazard = r.hazard.emplace();
  hazard = {"hazard.csv", {0.1, 1.0}, {0.01, 1e-4}, 25.0, 1e-5, r.axes == SlidingAxes::two, {}};
  for (const RunResults& of : r.runs) {
    HazardRun run{of.label, {}, {}, {}, {}, 3.5, 0.25, 0.125, {}, {}};
    run.prescribed = {{Standard::seaoc_pv1_2012,
                       1.25,
                       {0.5, Provenance::recalled, "equation"},
                       {1e-3, {5e-4, 2e-3}}}};
    run.life_distribution = {{LifeQuantity::single, 0.5, 0.1},
                             {LifeQuantity::farthest, 0.99, infinity}};
    double x = of.first_case == 0 ? 1.0 : 2.0;
    for (const double threshold_m : r.thresholds_m) {
      run.thresholds.push_back(
          {threshold_m, {1e-3 * x, {5e-4, 2e-3}}, 0.1 / x, std::nan(""), {0.02 * x, {0.01, 0.05}}});
      x += 1.0;
    }
    run.curve = {
        {0.001, {1e-2, {5e-3, 2e-2}}}, {0.1, {1e-3, {}}}, {1.0, {1e-4 * x, {1e-5, infinity}}}};
    run.targets = {{1.0 / 700, {0.25 * x, {0.125, 0.5}}, 0.9}, {4e-4, {infinity, {}}, 1.1}};
    run.life = {
        {LifeQuantity::single, {0.1, {0.05, 0.15}}, {0.2, {0.1, 0.3}}, {0.3 * x, {0.2, 0.4}}},
        {LifeQuantity::accumulated, {0.2, {0.1, 0.3}}, {0.4, {0.2, 0.6}}, {infinity, {}}},
        {LifeQuantity::farthest, {0.3, {0.2, 0.4}}, {0.6, {0.3, 0.9}}, {infinity, {}}}};
    hazard.runs.push_back(run);
  }
}

inline void add_shape(Results& r) {
  ShapeResults& shape = r.shape.emplace();
  for (const RunResults& of : r.runs) {
    ShapeRun run{of.label, {}, {}, {}, 0.3, {0.25, 0.5}};
    double x = of.first_case == 0 ? 1.0 : 2.0;
    for (const double threshold_m : r.thresholds_m) {
      ThresholdShape t{threshold_m, ComparisonStatus::no_overlap, {}, {}, {}, {}, {}};
      t.recrossed.assign(r.levels.size(), 0.125 * x);
      if (x == 1.0) {
        t.status = ComparisonStatus::compared;
        t.score.assign(shape_model_count, -0.5 * x);
        t.difference.assign(shape_model_count, 0.25 * x);
        t.standard_error.assign(shape_model_count, std::nan(""));
        t.probability.assign(shape_model_count * r.levels.size(), 0.75);
      }
      run.thresholds.push_back(t);
      run.surface.push_back({threshold_m, 0.5 * x, {0.25 * x, x}});
      x += 1.0;
    }
    run.crossings = {{r.thresholds_m[0], r.thresholds_m[1], 0.5 * x, 0.25, x > 3.5}};
    shape.runs.push_back(run);
  }
}

inline void add_verdict(Results& r) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  VerdictResults& verdict = r.verdict.emplace();
  verdict.exceedance = {0.1, 0.01};
  for (const Standard standard : {Standard::seaoc_pv1_2012, Standard::asce7_16}) {
    const double x = standard == Standard::asce7_16 ? 0.5 : 0.25;
    verdict.rows.push_back({standard,
                            x,
                            {2.0 * x, Provenance::recalled, "clause"},
                            r.cases.size() - 1,
                            "at " + std::to_string(x),
                            x / 2,
                            7.0 * x,
                            x < 0.4,
                            {x / 3, {0.0, x}, 1.0 + x},
                            {x / 4, {}, 2.0 + x},
                            {x, infinity},
                            {{0.1 * x, 2.0 * x}, {x, infinity}}});
    verdict.separations.push_back({verdict.rows.size() - 1,
                                   "between " + std::to_string(x),
                                   x,
                                   3.0 * x,
                                   {x / 5, {0.0, x / 2}, 3.0 + x},
                                   {x / 6, {}, 4.0 + x}});
  }
}

inline void add_sensitivity(Results& r) {
  SensitivityResults& found = r.sensitivity.emplace();
  found.factors = {"records", "all that is drawn", "friction"};
  found.samples = 2;
  for (const double x : {0.25, 0.5}) {
    SpreadRow row{.first_case = 4, .condition = "sampled friction", .threshold_m = x};
    if (x > 0.3) row.level = 1.5;
    row.mean = -x;
    row.std = 2.0 * x;
    row.share_below = x / 8.0;
    row.share_above = x / 4.0;
    row.first = {x, -0.01 * x, std::nan("")};
    row.total = {x + 0.1, x + 0.2, x + 0.3};
    row.first_interval = {{0.0, x}, {x, 1.0}, {}};
    row.total_interval = {{0.1, x}, {x, 0.9}, {0.2, 0.3}};
    row.record_error = x / 16.0;
    row.sample_error = x / 32.0;
    found.rows.push_back(row);
    found.design_friction.push_back(
        {4, "flat", x, 0.02, {0.01, 0.03}, 0.004 * x, 3.0 * x, 0.1, {0.05 * x, 0.2}, 0.03});
  }
}

inline void add_rare(Results& r) {
  RareResults& rare = r.rare.emplace();
  rare.widening = 3.0;
  rare.weights = {0.5, 3.0};
  for (const double x : {0.25, 0.5})
    rare.rows.push_back(
        {4, "flat", x, 2.0 * x, 1e-5 * x, {0.0, 2e-5}, {1e-6, x}, 8.0 * x, 1e6 * x});
  r.sampling_errors = {{"sampled", 0.15, 1.25, 0.0625, 0.0078125}};
  r.reached_target = {0.02, 0.015625, 2, 4};
}

inline void add_intensity_measures(Results& r) {
  r.record_periods_s = {0.0, 0.5};
  for (RecordSummary& record : r.records) {
    record.arias_mps = 1.5;
    record.sa_g = {0.25, 0.5};
    record.roof_velocity_mps = {0.125, 0.75};
  }
  r.intensity_measures = {{0, 0.25, "PGV", 0, 0.5, {0.25, 1.0}, 0.75, 0.1, 0.2, -0.3, 0.4, 2},
                          {0, 0.25, "PGA and PGV", 1, 0.75, {}, 0.25}};
}

/// Every analysis of one study.
inline Results with_all() {
  Results r = whole_results(true);
  add_fragility(r);
  add_impact(r);
  add_chart(r);
  add_clearance(r, 1.2);
  add_base_shear(r);
  add_tipping(r);
  add_hazard(r);
  add_verdict(r);
  add_sensitivity(r);
  add_shape(r);
  add_rare(r);
  add_intensity_measures(r);
  return r;
}

/// Every double the same bits, nan included: the writer's bytes are a function of the content.
inline std::string bytes_of(const Results& results, const TemporaryFolder& folder,
                            const std::string& name) {
  write_results(folder.path() / name, results);
  return read_text_file(folder.path() / name);
}

}  // namespace glissade
