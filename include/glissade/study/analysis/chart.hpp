// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/analysis/standards.hpp"

namespace glissade {

/// A number to be read off a chart.
struct ChartQuestion {
  double level = 0.0, slope_deg = 0.0;  ///< within the chart's axes
  std::optional<double> mu;             ///< given: the displacement is required
  std::optional<double>
      displacement_m;  ///< given: the friction that keeps the slip within it is required
};

/// A chart of displacement over the study's slopes, frictions and building periods.
struct ChartConfig {
  double shown_slope_deg = 0.0, shown_mu = 0.0, shown_level = 0.0;  ///< where figures cut through
  std::vector<ChartQuestion> questions;
  bool without_target = false;  ///< also of a suite that does not meet its target
};

/// How far an array slides at one point of a chart, over the suite's records, in plan. A record
/// counts once, with the largest of its orientations.
struct ChartSlip {
  double mean_m = 0.0, p84_m = 0.0, p95_m = 0.0;  ///< percentiles by Hyndman & Fan (1996) type 7
  double envelope_m = 0.0;                        ///< the largest record
};

/// A chart at one level, slope and friction. Where friction cannot stop the array (tan(slope) >=
/// mu) every slip is +inf.
struct ChartPoint {
  double level = 0.0, slope_deg = 0.0, mu = 0.0;
  bool free_sliding = false;
  ChartSlip largest;                ///< over the building periods, each number by itself
  Interval mean_interval;           ///< 95 % of largest.mean_m, over records
  double governing_period_s = 0.0;  ///< where the mean is largest
  double clearance_m = 0.0;         ///< factor x largest mean, after Walters et al. (2012)
  double uplift_share = 0.0;        ///< of the histories at this point
  std::vector<ChartSlip> by_period;
};

/// What was read off a chart by linear interpolation in slope and friction: displacements in
/// metres, or coefficients of friction (+inf: more than the chart's largest).
struct ChartReading {
  ChartQuestion question;
  double mean = 0.0, clearance = 0.0, p84 = 0.0, p95 = 0.0, envelope = 0.0;
};

/// A prescriptive value at one level of a chart.
struct ChartPrescription {
  Standard standard = Standard::seaoc_pv1_2012;
  double sds_g = 0.0;
  Prescription prescribed;
};

/// A design chart: slip over slope and friction at every level, for a range of building periods.
struct Chart {
  std::vector<double> slope_deg, mu, period_s;  ///< slopes are >= 0
  double shown_slope_deg = 0.0, shown_mu = 0.0, shown_level = 0.0;
  std::vector<ChartPoint> points;  ///< by (level, slope, mu), mu fastest
  std::vector<ChartReading> readings;
  std::vector<ChartPrescription> standards;  ///< by (standard, level); empty unless sds_g

  const ChartPoint& at(std::size_t level, std::size_t slope, std::size_t friction) const {
    return points[(level * slope_deg.size() + slope) * mu.size() + friction];
  }
};

/// The answer to a question, by linear interpolation in slope and friction. Of a friction: the
/// least from which on slip stays within the displacement; +inf where it does not on this chart,
/// the chart's least friction where that does already. Next to a point that slides freely, the next
/// friction that does not.
/// @param levels the chart's; the question's level is one of them, slope and friction are within
/// the axes
ChartReading read_off(const Chart& chart, const std::vector<double>& levels,
                      const ChartQuestion& question);

struct ChartAnalysis {
  struct InStudy {
    std::optional<ChartConfig> chart;
  };
  struct InResults {
    std::optional<Chart> chart;
  };
  /// The chart of a study's histories. A record and sample counts once at each point, with the
  /// largest of its orientations.
  static Chart find(const StudyConfig& study, const Results& results);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
