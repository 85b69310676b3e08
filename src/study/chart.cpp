// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/chart.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "glissade/core/quantile.hpp"
#include "glissade/core/units.hpp"
#include "glissade/fragility/bootstrap.hpp"
#include "pooled_level.hpp"

namespace glissade {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double walters_factor = 1.1;  // Walters et al. (2012): on the mean over the suite

std::vector<int> components_of(ComponentChoice choice) {
  if (choice == ComponentChoice::both) return {0, 1};
  return {choice == ComponentChoice::second ? 1 : 0};
}

std::vector<int> signs_of(SignChoice choice, double slope_deg) {
  if (choice == SignChoice::negative) return {-1};
  // On a flat roof the mirror image slides as far.
  if (choice == SignChoice::both && slope_deg != 0.0) return {1, -1};
  return {1};
}

/// Slip per record at one level, slope, friction and period: the largest of its orientations.
std::vector<double> slip_by_record(const RunResults& run, const std::vector<std::size_t>& samples,
                                   std::size_t level) {
  std::vector<double> slip(run.peak_displacement_m.rows, 0.0);
  for (std::size_t record = 0; record < slip.size(); ++record) {
    for (const std::size_t sample : samples)
      slip[record] = std::max(slip[record], run.peak_displacement_m(record, sample, level));
  }
  return slip;
}

ChartSlip statistics_of(std::vector<double> slip_by_record_m) {
  const double mean = std::accumulate(slip_by_record_m.begin(), slip_by_record_m.end(), 0.0) /
                      static_cast<double>(slip_by_record_m.size());
  std::sort(slip_by_record_m.begin(), slip_by_record_m.end());
  return {mean, quantile_of_sorted(slip_by_record_m, 0.84),
          quantile_of_sorted(slip_by_record_m, 0.95), slip_by_record_m.back()};
}

/// 95 % interval of the largest mean over periods. @param slip_m by period, then record
Interval interval_of_largest_mean(const std::vector<std::vector<double>>& slip_m,
                                  const BootstrapOptions& options) {
  const std::size_t records = slip_m.front().size();
  return bootstrap_interval(
      records,
      [&](const std::vector<double>& weights) {
        double largest = 0.0;
        for (const std::vector<double>& slip : slip_m) {
          largest = std::max(largest,
                             std::inner_product(weights.begin(), weights.end(), slip.begin(), 0.0) /
                                 static_cast<double>(records));
        }
        return largest;
      },
      options);
}

/// Share of the histories at a point that a flag is set for.
double share_of(const Array3<std::uint8_t>& flags,
                const std::vector<std::vector<std::size_t>>& samples, std::size_t level) {
  double set = 0.0, all = 0.0;
  for (std::size_t record = 0; record < flags.rows; ++record) {
    for (const std::vector<std::size_t>& of_period : samples) {
      for (const std::size_t sample : of_period) {
        set += flags(record, sample, level);
        ++all;
      }
    }
  }
  return all > 0.0 ? set / all : std::numeric_limits<double>::quiet_NaN();
}

/// One point of the chart. @param samples by period: its orientations
ChartPoint make_point(const Chart& chart, const RunResults& run,
                      const std::vector<std::vector<std::size_t>>& samples, std::size_t level,
                      ChartPoint point, const BootstrapOptions& options) {
  point.uplift_share = share_of(run.uplift, samples, level);
  point.tip_share = share_of(run.tips, samples, level);
  point.free_sliding = std::tan(point.slope_deg * rad_per_deg) >= point.mu;
  if (point.free_sliding) {
    point.largest = {infinity, infinity, infinity, infinity};
    point.clearance_m = infinity;
    point.governing_period_s = chart.period_s.front();
    point.by_period.assign(samples.size(), point.largest);
    return point;
  }
  std::vector<std::vector<double>> slip_m;
  for (const std::vector<std::size_t>& of_period : samples) {
    slip_m.push_back(slip_by_record(run, of_period, level));
    point.by_period.push_back(statistics_of(slip_m.back()));
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
  point.mean_interval = interval_of_largest_mean(slip_m, options);
  point.clearance_m = walters_factor * point.largest.mean_m;
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

}  // namespace

std::vector<SamplePoint> chart_samples(const StudyConfig& config) {
  const ChartConfig& chart = *config.chart;
  std::vector<SamplePoint> samples;
  SamplePoint s;
  s.damping = std::get<Fixed>(config.building.damping).value;
  s.mass_ratio = std::get<Fixed>(config.building.mass_ratio).value;
  for (const double period : chart.period_s) {
    s.period_s = period;
    for (const int component : components_of(config.orientation.component)) {
      s.component = component;
      for (const double slope : chart.slope_deg) {
        s.slope_deg = slope;
        for (const int sign : signs_of(config.orientation.sign, slope)) {
          s.sign = sign;
          for (const double mu : chart.mu) {
            s.friction = mu;
            // The other component's sign mirrors the history, and friction is round.
            if (config.model.axes == SlidingAxes::two) s.friction_across = mu;
            samples.push_back(s);
          }
        }
      }
    }
  }
  return samples;
}

Chart make_chart(const Plan& plan, const RunResults& run) {
  const ChartConfig& config = *plan.config.chart;
  const std::vector<double>& levels = plan.config.intensity.levels;
  const BootstrapOptions options{.seed = plan.config.seed,
                                 .replicates = plan.config.sampling.bootstrap_replicates};
  Chart chart{.mu = config.mu,
              .period_s = config.period_s,
              .shown_slope_deg = config.shown_slope_deg,
              .shown_mu = config.shown_mu,
              .shown_level = config.shown_level};
  std::copy_if(config.slope_deg.begin(), config.slope_deg.end(),
               std::back_inserter(chart.slope_deg), [](double slope) { return slope >= 0.0; });

  std::map<std::tuple<double, double, double>, std::vector<std::size_t>> orientations;
  for (std::size_t i = 0; i < plan.samples.size(); ++i) {
    const SamplePoint& s = plan.samples[i];
    orientations[{std::abs(s.slope_deg), s.friction, s.period_s}].push_back(i);
  }
  for (std::size_t level = 0; level < levels.size(); ++level) {
    for (const double slope : chart.slope_deg) {
      for (const double mu : chart.mu) {
        std::vector<std::vector<std::size_t>> samples;  // by period
        for (const double period : chart.period_s)
          samples.push_back(orientations.at({slope, mu, period}));
        chart.points.push_back(make_point(chart, run, samples, level,
                                          {.level = levels[level], .slope_deg = slope, .mu = mu},
                                          options));
      }
    }
  }
  for (const ChartQuestion& question : config.questions)
    chart.readings.push_back(read_off(chart, levels, question));
  chart.standards = prescriptions(plan.config.standards, levels);
  return chart;
}

}  // namespace glissade
