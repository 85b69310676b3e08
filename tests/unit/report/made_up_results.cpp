// SPDX-License-Identifier: GPL-3.0-or-later
#include "made_up_results.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "glissade/core/random.hpp"
#include "glissade/core/units.hpp"
#include "glissade/standards/prescriptive.hpp"
#include "glissade/study/analysis/impact.hpp"
#include "unit/study/by_rule.hpp"

namespace glissade {
namespace {

constexpr std::size_t records = 12, samples = 16;
constexpr double record_log_std = 0.35, sample_log_std = 0.20;
constexpr double exponent = 2.0, slip_at_capacity_m = 0.3;

double normal(std::uint64_t item, std::uint32_t index) {
  return keyed_normal(7, RandomPurpose::test, item, index);
}

double capacity_at_reference(double median_g, std::size_t record, std::size_t sample) {
  return median_g *
         std::exp(record_log_std * normal(record, 0) + sample_log_std * normal(sample, 1));
}

double percentile_of(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))];
}

Interval around(double value, double log_half_width) {
  return {value * std::exp(-log_half_width), value * std::exp(log_half_width)};
}

/// Peak displacement of a record and one of the run's samples.
double slip_m(const Results& results, const RunResults& run, std::size_t i, std::size_t j,
              std::size_t level) {
  return results.histories.displacement_m(i, run.first_case + j, level);
}

ThresholdFragility fragility_of(const Results& results, const RunResults& run, double median_g,
                                std::size_t t) {
  ThresholdFragility fragility;
  fragility.threshold_m = results.thresholds_m[t];
  FitSummary& fit = fragility.capacities;
  fit.status = FitStatus::maximum_likelihood;
  double mean_log = 0.0;
  for (std::size_t i = 0; i < records; ++i) {
    for (std::size_t j = 0; j < samples; ++j) {
      mean_log += std::log(capacity_at_reference(median_g, i, j)) / (records * samples);
    }
  }
  fit.curve = {std::exp(mean_log) * std::sqrt(fragility.threshold_m / slip_at_capacity_m),
               std::hypot(record_log_std, sample_log_std)};
  fit.median_interval = around(fit.curve.median, 1.96 * record_log_std / std::sqrt(records));
  fit.log_std_interval = around(fit.curve.log_std, 0.3);
  fit.method = "maximum likelihood on capacities";
  fit.interval_method = "variance between records (sandwich, chi-square)";
  fragility.stripes = fit;
  fragility.stripes.method = "probit maximum likelihood on stripes";
  double censored = 0.0;
  for (std::size_t i = 0; i < records; ++i) {
    for (std::size_t j = 0; j < samples; ++j)
      censored += std::isinf(results.histories.capacity(i, run.first_case + j, t)) ? 1.0 : 0.0;
  }
  fragility.censored_share = censored / (records * samples);
  fragility.recross_share = 0.012;
  fragility.record_recross.assign(records, 0.0);
  for (std::size_t l = 0; l < results.levels.size(); ++l) {
    double exceed = 0.0;
    for (std::size_t i = 0; i < records; ++i) {
      for (std::size_t j = 0; j < samples; ++j) {
        exceed += slip_m(results, run, i, j, l) >= fragility.threshold_m ? 1.0 : 0.0;
      }
    }
    const double share = exceed / (records * samples);
    fragility.probability.push_back(share);
    fragility.probability_interval.push_back(
        {std::max(0.0, share - 0.1), std::min(1.0, share + 0.1)});
  }
  for (const double x : run.band_intensities) {
    const double z = std::log(x / fit.curve.median) / fit.curve.log_std;
    const double half = 0.5;  // of a standard normal: 1.96 x 0.35 / sqrt(12) over 0.40
    fragility.capacities.band.push_back({0.5 * std::erfc(-(z - half) / std::sqrt(2.0)),
                                         0.5 * std::erfc(-(z + half) / std::sqrt(2.0))});
  }
  return fragility;
}

/// The histories of the run's cases, where the fields have their size.
void fill_histories(Results& results, const RunResults& run, double median_g) {
  HistoryTable& table = results.histories;
  for (std::size_t i = 0; i < records; ++i) {
    for (std::size_t j = 0; j < samples; ++j) {
      const std::size_t c = run.first_case + j;
      const double capacity = capacity_at_reference(median_g, i, j);
      for (std::size_t l = 0; l < results.levels.size(); ++l) {
        const double x = results.levels[l];
        table.fields.peak_displacement_m[table.at(i, c, l)] =
            x < 0.25 * capacity ? 0.0 : slip_at_capacity_m * std::pow(x / capacity, exponent);
      }
      for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
        const double reached = capacity * std::sqrt(results.thresholds_m[t] / slip_at_capacity_m);
        if (reached <= results.levels.back())
          table.fields.capacity[(i * table.cases + c) * table.thresholds + t] = reached;
      }
    }
  }
}

/// Adds a run of the next cases.
void add_run(Results& results, const std::string& label, const std::string& friction,
             double median_g) {
  RunResults run;
  run.label = label;
  run.friction = friction;
  run.first_case = results.runs.size() * samples;
  run.cases = samples;
  fill_histories(results, run, median_g);
  for (int i = 1; i <= 60; ++i) run.band_intensities.push_back(results.levels.back() * i / 60.0);
  for (std::size_t t = 0; t < results.thresholds_m.size(); ++t) {
    run.fragilities.push_back(fragility_of(results, run, median_g, t));
  }
  for (std::size_t l = 0; l < results.levels.size(); ++l) {
    std::vector<double> all;
    double sum = 0.0;
    for (std::size_t i = 0; i < records; ++i) {
      for (std::size_t j = 0; j < samples; ++j) {
        all.push_back(slip_m(results, run, i, j, l));
        sum += all.back();
      }
    }
    SlipStatistics slip;
    slip.level = results.levels[l];
    slip.median_m = percentile_of(all, 0.5);
    slip.p84_m = percentile_of(all, 0.84);
    slip.p95_m = percentile_of(all, 0.95);
    slip.mean_m = sum / static_cast<double>(all.size());
    slip.median_interval = around(slip.median_m, 0.6);
    slip.p84_interval = around(slip.p84_m, 0.6);
    slip.mean_interval = around(slip.mean_m, 0.6);
    run.slip.push_back(slip);
    for (const Standard standard : {Standard::seaoc_pv1_2012, Standard::asce7_16}) {
      StandardComparison comparison;
      comparison.standard = standard;
      comparison.sds_g = slip.level;
      comparison.prescribed =
          standard == Standard::asce7_16
              ? asce7_16_displacement(slip.level, 1.0)
              : seaoc_pv1_2012_displacement(slip.level, SeismicDesignCategory::d);
      const auto above = std::count_if(all.begin(), all.end(),
                                       [&](double s) { return s > comparison.prescribed.value_m; });
      comparison.exceedance_probability =
          static_cast<double>(above) / static_cast<double>(all.size());
      comparison.exceedance_interval = {std::max(0.0, comparison.exceedance_probability - 0.1),
                                        std::min(1.0, comparison.exceedance_probability + 0.1)};
      run.standards.push_back(comparison);
    }
  }
  std::stable_sort(run.standards.begin(), run.standards.end(),
                   [](const auto& a, const auto& b) { return a.standard < b.standard; });
  results.runs.push_back(run);
}

/// A code-like shape with a corner at 0.6 s, in units of S_DS.
double spectral_shape(double period_s) {
  if (period_s < 0.12) return 0.4 + 0.6 * period_s / 0.12;
  return period_s < 0.6 ? 1.0 : 0.6 / period_s;
}

SuiteSpectra spectra_of(std::size_t record_count) {
  SuiteSpectra spectra;
  spectra.reference_level = 1.0;
  for (int p = 0; p <= 60; ++p) spectra.periods_s.push_back(0.05 * p);
  spectra.average_g.assign(spectra.periods_s.size(), 0.0);
  for (std::size_t i = 0; i < record_count; ++i) {
    std::vector<double>& record = spectra.records_g.emplace_back();
    for (std::size_t p = 0; p < spectra.periods_s.size(); ++p) {
      const double wave = 0.25 * std::sin(9.0 * spectra.periods_s[p] + static_cast<double>(i));
      record.push_back(1.15 * spectral_shape(spectra.periods_s[p]) *
                       std::exp(0.4 * normal(i, 2) + wave));
      spectra.average_g[p] += record.back() / static_cast<double>(record_count);
    }
  }
  for (const double period_s : spectra.periods_s)
    spectra.target_g.push_back(spectral_shape(period_s));
  return spectra;
}

/// Every combination of the chart's slopes, frictions and periods, run once.
void list_chart_cases(Results& results) {
  const Chart& chart = *results.chart;
  results.cases = {};
  results.cases.axes = {{"building.period_s", "s", chart.period_s, {}},
                        {"roof.slope_deg", "deg", chart.slope_deg, {}},
                        {"friction.mu", "-", chart.mu, {}}};
  std::erase_if(results.cases.axes, [](const CaseAxis& axis) { return axis.size() < 2; });
  for (const double period_s : chart.period_s) {
    for (const double slope_deg : chart.slope_deg) {
      for (const double mu : chart.mu)
        results.cases.cases.push_back(
            {.friction = mu, .friction_across = mu, .slope_deg = slope_deg, .period_s = period_s});
    }
  }
  test::size_histories(results);
}

std::vector<double> steps(int first, int last, double step) {
  std::vector<double> axis;
  for (int i = first; i <= last; ++i) axis.push_back(i * step);
  return axis;
}

/// Of the factors by record.
struct RecordFactors {
  double mean = 1.0, p84 = 1.306, p95 = 1.405, largest = 1.45;
};

ChartSlip times(double slip_m, const RecordFactors& factors) {
  return {factors.mean * slip_m, factors.p84 * slip_m, factors.p95 * slip_m,
          factors.largest * slip_m};
}

ChartPoint chart_point(ChartPoint point, const std::vector<double>& factor_by_period,
                       const RecordFactors& factors) {
  const double yield_g = point.mu - std::tan(point.slope_deg * rad_per_deg);
  point.free_sliding = yield_g <= 0.0;
  const double over_g = std::max(0.0, point.level - yield_g);
  const double slip_m = point.free_sliding ? infinity : 0.25 * over_g * over_g / yield_g;
  for (const double factor : factor_by_period)
    point.by_period.push_back(times(factor * slip_m, factors));
  point.largest = times(slip_m, factors);
  if (!point.free_sliding) {
    point.mean_interval = {0.8 * point.largest.mean_m, 1.2 * point.largest.mean_m};
  }
  point.clearance_m = 1.1 * point.largest.mean_m;
  return point;
}

void fill_chart(Results& results, const std::vector<double>& factor_by_period,
                const RecordFactors& factors, double governing_period_s) {
  Chart& chart = *results.chart;
  for (const double level : results.levels) {
    for (const double slope_deg : chart.slope_deg) {
      for (const double mu : chart.mu) {
        ChartPoint point;
        point.level = level;
        point.slope_deg = slope_deg;
        point.mu = mu;
        point.governing_period_s = governing_period_s;
        chart.points.push_back(chart_point(point, factor_by_period, factors));
      }
    }
  }
}

}  // namespace

Results made_up_chart_results() {
  Results results = made_up_results();
  results.study_name = "made_up_chart";
  results.records.resize(10);
  results.suites[0].spectra = spectra_of(10);
  results.levels = {0.5, 1.0, 1.5};
  results.thresholds_m.clear();
  results.runs.clear();
  results.notes.clear();
  Chart& chart = results.chart.emplace();
  chart.slope_deg = steps(0, 14, 0.5);
  chart.mu = steps(2, 16, 0.05);
  chart.period_s = {0.2, 0.5, 1.0};
  chart.shown_slope_deg = 2.0;
  chart.shown_mu = 0.5;
  chart.shown_level = 1.0;
  fill_chart(results, {0.7, 1.0, 0.4}, {}, 0.5);
  list_chart_cases(results);
  ChartReading displacement;  // as if read off: the report shows what it is given
  displacement.question.level = 1.0;
  displacement.question.slope_deg = 2.0;
  displacement.question.mu = 0.5;
  displacement.mean = 0.25;
  displacement.clearance = 0.275;
  displacement.p84 = 0.3;
  displacement.p95 = 0.35;
  displacement.envelope = 0.4;
  ChartReading friction = displacement;
  friction.question.mu.reset();
  friction.question.displacement_m = 0.5;
  friction.mean = 0.1;
  friction.clearance = 0.45;
  friction.envelope = infinity;
  chart.readings = {displacement, friction};
  for (const double level : results.levels) {
    chart.standards.push_back({Standard::seaoc_pv1_2012, level,
                               seaoc_pv1_2012_displacement(level, SeismicDesignCategory::d)});
  }
  for (const double level : results.levels)
    chart.standards.push_back({Standard::asce7_16, level, asce7_16_displacement(level, 1.0)});
  return results;
}

Results made_up_one_record_chart() {
  Results results = made_up_chart_results();
  results.study_name = "made_up_one_record";
  results.records.resize(1);
  results.suites[0].spectra = {};
  results.levels = steps(0, 15, 0.1);
  results.measure = IntensityMeasure::ppa_g;
  results.intensity_label = "PPA (g)";
  results.intensity_symbol = "PPA";
  Chart& chart = *results.chart;
  chart.points.clear();
  chart.standards.clear();
  chart.period_s = {0.0};
  chart.shown_slope_deg = 1.0;
  chart.shown_level = results.levels.back();
  fill_chart(results, {1.0}, {1.0, 1.0, 1.0, 1.0}, 0.0);
  list_chart_cases(results);
  return results;
}

Results made_up_impact_results() {
  Results results = made_up_results();
  HistoryTable& table = results.histories;
  for (std::size_t i = 0; i < table.records; ++i) {
    for (std::size_t c = 0; c < table.cases; ++c) {
      for (std::size_t l = 0; l < table.levels; ++l) {
        for (const double threshold_m : results.thresholds_m) {
          // As if what is left of the slip were lost at 0.5 m/s2.
          const double left_m = table.displacement_m(i, c, l) - threshold_m;
          const double time_s = 5.0 + static_cast<double>(i) + threshold_m / results.levels[l];
          const double nowhere = std::numeric_limits<double>::quiet_NaN();
          table.fields.crossing_time_s.push_back(left_m >= 0.0 ? time_s : nowhere);
          table.fields.crossing_speed_mps.push_back(left_m >= 0.0 ? std::sqrt(2.0 * 0.5 * left_m)
                                                                  : nowhere);
        }
      }
    }
  }
  for (RunResults& run : results.runs)
    run.impact = impact_statistics(table, slice_of(run), results.levels, results.thresholds_m);
  return results;
}

Results made_up_results() {
  Results results;
  results.study_name = "made_up";
  results.program_version = "0.1.0";
  results.plan_hash = "0123456789abcdef";
  results.study_text = "[study]\nname = \"made_up\"   # a <test> & nothing more\nseed = 20260101\n";
  results.seed = 20260101;
  results.measure = IntensityMeasure::sds_g;
  results.intensity_label = "S_DS (g)";
  results.intensity_symbol = "S_DS";
  for (int l = 1; l <= 20; ++l) results.levels.push_back(l / 10.0);
  results.thresholds_m = {0.15, 0.3, 0.6, 1.2};
  results.cases.axes = {{"friction.value",
                         "-",
                         {0.0, 1.0},
                         {"sampled", "design"},
                         {"sampled friction", "design friction"}}};
  results.cases.samples = samples;
  for (const FrictionValue value : {FrictionValue::as_drawn, FrictionValue::design}) {
    for (std::size_t j = 0; j < samples; ++j) {
      const double u = (static_cast<double>(j) + 0.5) / samples;
      Case c;
      c.friction_value = value;
      c.friction = value == FrictionValue::design ? 0.47 : 0.55 + 0.04 * normal(j, 3);
      c.friction_across = c.friction;
      c.slope_deg = j % 2 == 0 ? 1.19 : 2.39;
      c.period_s = 0.2 + 1.8 * u;
      c.orientation = quarter_turn({static_cast<int>(j % 2), j % 4 < 2 ? 1 : -1}, 1);
      results.cases.cases.push_back(c);
    }
  }
  for (std::size_t i = 0; i < records; ++i) {
    RecordSummary record;
    record.id = "rec_" + std::to_string(i + 1);
    record.event = i % 2 == 0 ? "Northfield, 1994" : "Kobold <1995>";
    record.station = "Station " + std::to_string(i + 1);
    record.magnitude = 6.5 + 0.05 * static_cast<double>(i);
    record.distance_km = 3.0 + static_cast<double>(i);
    record.vs30_mps = 300.0 + 10.0 * static_cast<double>(i);
    record.suite_scale = 1.0 + 0.1 * static_cast<double>(i);
    record.factor_at_unit_level = 1.3 * record.suite_scale;
    record.pga_g = 0.4;
    record.pgv_mps = 0.5;
    record.dt_s = 0.005;
    record.samples = 8000;
    record.has_second = true;
    record.has_vertical = i != 3;
    results.records.push_back(record);
  }
  results.suites = {{"made_up_suite", "Twelve records that never were.", "", spectra_of(records)}};
  test::size_histories(results);
  add_run(results, "sampled", "normal, mean 0.55, std 0.04", 0.9);
  add_run(results, "design", "mean - 2 std = 0.47", 0.72);
  results.notes = {"1 of 12 records has no vertical: run with horizontals only"};
  return results;
}

}  // namespace glissade
