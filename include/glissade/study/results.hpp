// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"
#include "glissade/study/config.hpp"

namespace glissade {

/// Dense rows x columns x depth, last index fastest.
template <class T>
struct Array3 {
  std::size_t rows = 0, columns = 0, depth = 0;
  std::vector<T> data;
  Array3() = default;
  Array3(std::size_t r, std::size_t c, std::size_t d, T fill = T{})
      : rows(r), columns(c), depth(d), data(r * c * d, fill) {}
  T& operator()(std::size_t i, std::size_t j, std::size_t k) {
    return data[(i * columns + j) * depth + k];
  }
  const T& operator()(std::size_t i, std::size_t j, std::size_t k) const {
    return data[(i * columns + j) * depth + k];
  }
};

/// One Monte Carlo sample of everything uncertain, by (seed, sample, dimension).
struct SamplePoint {
  double friction = 0.0;
  double slope_deg = 0.0;
  double period_s = 0.0;
  double damping = 0.0;
  int component = 0;  ///< 0 or 1: which horizontal acts along the slope (two axes: along the
                      ///< building's first axis)
  int sign = 1;       ///< +1 or -1, of that component
  double mass_ratio = 0.0;
  // Of two axes:
  double friction_across = 0.0;
  double azimuth_deg = 0.0;
  int second_sign = 1;  ///< +1 or -1, of the other component
};

/// A lognormal fragility for one clearance threshold, with what it rests on.
struct ThresholdFragility {
  double threshold_m = 0.0;
  FitSummary stripes;     ///< fitted on counts at the levels
  FitSummary capacities;  ///< fitted on first-crossing capacities, censored at the highest level
  std::vector<double> probability;             ///< observed share exceeding, per level
  std::vector<Interval> probability_interval;  ///< 95 %, bootstrap over records, per level
  std::vector<Interval> band;  ///< 95 % band of the capacity fit at RunResults::band_intensities
  double recross_share =
      0.0;  ///< of (record, sample) that reached it: share falling below it again at a higher level
  std::vector<double> record_recross;  ///< 1 where any sample of the record recrosses
  double censored_share = 0.0;         ///< never reached it by the highest level
  double free_sliding_share = 0.0;     ///< slides with no shaking: no capacity
};

/// Slip at one level over records and samples, plan metres.
struct SlipStatistics {
  double level = 0.0;
  double median_m = 0.0, p84_m = 0.0, p95_m = 0.0, mean_m = 0.0;
  Interval mean_interval, median_interval, p84_interval;  ///< 95 %, bootstrap over records
  double uplift_share = 0.0;
  double tip_share = std::numeric_limits<double>::quiet_NaN();      ///< NaN: not asked for
  double mean_vector_m = std::numeric_limits<double>::quiet_NaN();  ///< mean of the longest
                                                                    ///< displacement vectors; NaN:
                                                                    ///< one axis
};

/// How the array first gets a threshold's distance from where it lay, at one level: over those
/// records' samples that get there (percentiles by Hyndman & Fan 1996, type 7; NaN where none
/// does). Speed is that of the array relative to the roof, in plan. Where fewer than three records
/// have any that does there is no interval.
struct ImpactStatistics {
  double level = 0.0, threshold_m = 0.0;
  double reached_share = 0.0;  ///< of all histories at the level
  Interval reached_interval;   ///< 95 %, bootstrap over records, as all here
  double speed_median_mps = 0.0, speed_p84_mps = 0.0, speed_p95_mps = 0.0, speed_largest_mps = 0.0;
  Interval speed_median_interval, speed_p84_interval;
  double time_median_s = 0.0, time_p16_s = 0.0, time_p84_s = 0.0;  ///< from the record's begin
};

/// A prescriptive value beside what came out at one S_DS.
struct StandardComparison {
  Standard standard = Standard::seaoc_pv1_2012;
  double sds_g = 0.0;
  Prescription prescribed;
  double exceedance_probability = 0.0;  ///< share of histories with slip above it
  Interval exceedance_interval;         ///< 95 %, bootstrap over records
};

/// One friction choice ("sampled" or "design") over records x samples x levels.
struct RunResults {
  std::string label;                   ///< "sampled", "design"
  std::string friction_description;    ///< "normal, mean 0.55, std 0.04", "mean - 2 std = 0.47"
  Array3<double> peak_displacement_m;  ///< (record, sample, level)
  Array3<double> peak_vector_m;        ///< likewise: two axes, the longest displacement vector;
                                       ///< empty on one
  Array3<std::uint8_t> uplift;         ///< (record, sample, level), 0 or 1
  Array3<std::uint8_t> tips;           ///< likewise; empty where the tipping check is not asked for
  Array3<double> capacity;  ///< (record, sample, threshold); +inf: not reached; 0: slides freely
  std::vector<ThresholdFragility> fragilities;  ///< by threshold
  std::vector<double> band_intensities;
  std::vector<SlipStatistics> slip;           ///< by level
  std::vector<StandardComparison> standards;  ///< by (standard, level); empty unless sds_g
  // Where the study asks for impact, else empty:
  std::vector<double> crossing_time_s;  ///< (record, sample, level, threshold), the last fastest;
                                        ///< NaN: not reached
  std::vector<double> crossing_speed_mps;  ///< likewise; in plan, relative to the roof
  std::vector<ImpactStatistics> impact;    ///< by (threshold, level)
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
  Interval mean_interval;           ///< 95 % of largest.mean_m, bootstrap over records
  double governing_period_s = 0.0;  ///< where the mean is largest
  double clearance_m = 0.0;         ///< 1.1 x largest mean, as Walters et al. (2012) recommend
  double uplift_share = 0.0;        ///< of the histories at this point
  double tip_share = std::numeric_limits<double>::quiet_NaN();  ///< likewise; NaN: not asked for
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

struct RecordSummary {
  std::string id, event, station;
  double magnitude = 0.0, distance_km = 0.0, vs30_mps = 0.0;
  double suite_scale = 1.0;  ///< the suite file's factor
  double factor_at_unit_level =
      0.0;  ///< factor on the record at intensity 1 (0 for ppa_g: depends on the sample)
  double pga_g = 0.0, pgv_mps = 0.0;  ///< geometric mean of the horizontals, as recorded
  double dt_s = 0.0;
  std::uint64_t samples = 0;
  bool has_second = false, has_vertical = false;
};

/// 5 % spectra of the suite, scaled to `reference_level` (sds_g) or by the suite's own factors
/// (else).
struct SuiteSpectra {
  std::vector<double> periods_s;
  std::vector<std::vector<double>> srss_g;  ///< [record][period]
  std::vector<double> average_srss_g;       ///< [period]
  std::vector<double> target_g;             ///< [period]; empty without a target
  double reference_level = 0.0;             ///< 0: as scaled in the suite file
};

/// What moved and what resisted, in sentences for a reader. Empty where there is nothing to tell.
struct ModelText {
  std::string kernel;        ///< what computed the histories
  std::string building;      ///< how it yields
  std::string friction;      ///< what differs from Coulomb's law
  std::string displacement;  ///< of two axes: what a history's displacement is
};

/// Everything a study found, and nothing about when, where or on how many ranks.
struct Results {
  std::string study_name, program_version, plan_hash, study_text;
  std::uint64_t seed = 0;
  IntensityMeasure measure = IntensityMeasure::sds_g;
  std::string intensity_label;  ///< for axes: "S_DS (g)", "Sa(1.0 s) (g)" ...
  std::string suite_name, suite_description;
  ModelText model;
  std::vector<double> levels, thresholds_m;
  std::vector<SamplePoint> samples;
  std::vector<RecordSummary> records;
  SuiteSpectra spectra;
  std::vector<RunResults> runs;  ///< "sampled" first, then "design" if there is one; of a chart
                                 ///< "chart" alone, without fragilities, slip and standards
  std::optional<Chart> chart;    ///< of a study with [chart]: samples are then its grid
  std::vector<std::string>
      notes;  ///< "5 of 22 records have no vertical: run with horizontals only"
};

inline bool slides_on_two_axes(const Results& results) {
  return !results.runs.empty() && !results.runs.front().peak_vector_m.data.empty();
}

}  // namespace glissade
