// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/chart.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "analysis/pooled_level.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/core/quantile.hpp"
#include "glissade/core/units.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {
namespace {

/// The values along an axis of the chart: what the study lists, or, where it draws, the mean alone.
std::vector<double> chart_axis(const Quantity& quantity) {
  if (quantity.is_drawn()) return {stated_mean(*quantity.drawn)};
  return quantity.values;
}

/// The cases at one point of the chart: by period, then sample, those over which the largest slip
/// of a record is taken.
using PointCases = std::vector<std::vector<std::vector<std::size_t>>>;

/// By record, then sample: the largest of the orientations.
std::vector<std::vector<double>> slips_of(const Results& results,
                                          const std::vector<std::vector<std::size_t>>& cases,
                                          std::size_t level) {
  std::vector<std::vector<double>> slips(results.records.size());
  for (std::size_t record = 0; record < slips.size(); ++record) {
    for (const std::vector<std::size_t>& of_sample : cases) {
      double largest = 0.0;
      for (const std::size_t i : of_sample)
        largest = std::max(largest, displacement_m(results, record, i, level));
      slips[record].push_back(largest);
    }
  }
  return slips;
}

double mean_of(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

std::vector<double> means_by_record(const std::vector<std::vector<double>>& slips) {
  std::vector<double> means;
  for (const std::vector<double>& of_record : slips) means.push_back(mean_of(of_record));
  return means;
}

ChartSlip statistics_of(const std::vector<std::vector<double>>& slips) {
  std::vector<double> all;
  for (const std::vector<double>& of_record : slips)
    all.insert(all.end(), of_record.begin(), of_record.end());
  std::sort(all.begin(), all.end());
  return {mean_of(means_by_record(slips)), quantile_of_sorted(all, 0.84),
          quantile_of_sorted(all, 0.95), all.back()};
}

/// Share of the histories at a point in which the array lifts off.
double uplift_share(const HistoryTable& table, const PointCases& cases, std::size_t level) {
  double set = 0.0, all = 0.0;
  for (std::size_t record = 0; record < table.records; ++record) {
    for (const auto& of_period : cases) {
      for (const auto& of_sample : of_period) {
        for (const std::size_t i : of_sample) {
          set += table.fields.uplift[table.at(record, i, level)];
          ++all;
        }
      }
    }
  }
  return set / all;
}

/// One point of the chart.
ChartPoint make_point(const Chart& chart, const Results& results, const PointCases& cases,
                      std::size_t level, ChartPoint point, double factor) {
  point.uplift_share = uplift_share(results.histories, cases, level);
  point.free_sliding = std::tan(point.slope_deg * rad_per_deg) >= point.mu;
  if (point.free_sliding) {
    point.largest = {infinity, infinity, infinity, infinity};
    point.clearance_m = infinity;
    point.governing_period_s = chart.period_s.front();
    point.by_period.assign(cases.size(), point.largest);
    return point;
  }
  std::vector<Interval> mean_intervals;
  for (const auto& of_period : cases) {
    const std::vector<std::vector<double>> slips = slips_of(results, of_period, level);
    mean_intervals.push_back(
        positive_mean_interval(results.histories.by_unit(means_by_record(slips))));
    point.by_period.push_back(statistics_of(slips));
  }
  const auto largest = [&](double ChartSlip::*which) {
    return *std::max_element(
        point.by_period.begin(), point.by_period.end(),
        [&](const ChartSlip& a, const ChartSlip& b) { return a.*which < b.*which; });
  };
  point.largest = {largest(&ChartSlip::mean_m).mean_m, largest(&ChartSlip::p84_m).p84_m,
                   largest(&ChartSlip::p95_m).p95_m, largest(&ChartSlip::envelope_m).envelope_m};
  const auto governing =
      std::find_if(point.by_period.begin(), point.by_period.end(),
                   [&](const ChartSlip& s) { return s.mean_m == point.largest.mean_m; });
  point.governing_period_s =
      chart.period_s[static_cast<std::size_t>(governing - point.by_period.begin())];
  point.mean_interval =
      mean_intervals[static_cast<std::size_t>(governing - point.by_period.begin())];
  point.clearance_m = factor * point.largest.mean_m;
  return point;
}

std::vector<ChartPrescription> prescriptions(const StandardsConfig& standards,
                                             const std::vector<double>& levels) {
  std::vector<ChartPrescription> all;
  for (const Standard standard : standards.compare) {
    for (const double level : levels)
      all.push_back({standard, level, prescribed_displacement(standard, level, standards)});
  }
  return all;
}

/// The cases at each (slope, friction) of the chart, from their places in the case grid. A negative
/// slope counts for its mirror image; of friction that is drawn the samples count, not the design
/// value.
std::vector<PointCases> cases_of_points(const Chart& chart, const CaseSet& set) {
  const PointCases none(chart.period_s.size(), std::vector<std::vector<std::size_t>>(set.samples));
  std::vector<PointCases> points(chart.slope_deg.size() * chart.mu.size(), none);
  for (std::size_t combination = 0; combination < set.combinations(); ++combination) {
    const Case& first = set.cases[set.index(combination, 0, 0)];
    if (first.friction_value == FrictionValue::design || first.support != ArraySupport::isolated)
      continue;
    const std::vector<std::size_t> places = set.places(combination);
    const auto place_in = [&](const std::vector<double>& of_chart, const char* key) {
      const std::size_t axis = set.axis(key);
      if (axis == set.axes.size()) return std::size_t{0};  // one value, or drawn
      const double value = std::abs(set.axes[axis].values[places[axis]]);
      return static_cast<std::size_t>(std::ranges::find(of_chart, value) - of_chart.begin());
    };
    const std::size_t slope = place_in(chart.slope_deg, "roof.slope_deg"),
                      mu = place_in(chart.mu, "friction.mu"),
                      period = place_in(chart.period_s, "building.period_s");
    auto& of_samples = points[slope * chart.mu.size() + mu][period];
    for (std::size_t sample = 0; sample < set.samples; ++sample)
      for (std::size_t orientation = 0; orientation < set.orientations; ++orientation)
        of_samples[sample].push_back(set.index(combination, sample, orientation));
  }
  return points;
}

}  // namespace

Chart ChartAnalysis::find(const StudyConfig& config, const Results& results) {
  const ChartConfig& chart_config = *config.chart;
  const std::vector<double>& levels = results.levels;
  Chart chart{.mu = chart_axis(config.quantities.at("friction", "mu")),
              .period_s = chart_axis(config.quantities.at("building", "period_s")),
              .shown_slope_deg = chart_config.shown_slope_deg,
              .shown_mu = chart_config.shown_mu,
              .shown_level = chart_config.shown_level};
  for (const double slope : chart_axis(config.quantities.at("roof", "slope_deg"))) {
    if (slope >= 0.0) chart.slope_deg.push_back(slope);
  }
  const double factor = config.clearance.value_or(ClearanceConfig{}).factor;
  const std::vector<PointCases> points = cases_of_points(chart, results.cases);
  for (std::size_t level = 0; level < levels.size(); ++level) {
    auto cases = points.begin();
    for (const double slope : chart.slope_deg)
      for (const double mu : chart.mu)
        chart.points.push_back(make_point(chart, results, *cases++, level,
                                          {.level = levels[level], .slope_deg = slope, .mu = mu},
                                          factor));
  }
  for (const ChartQuestion& question : chart_config.questions)
    chart.readings.push_back(read_off(chart, levels, question));
  chart.standards = prescriptions(config.standards, levels);
  return chart;
}

}  // namespace glissade
