// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"
#include "glissade/fragility/goodness_of_fit.hpp"
#include "glissade/motion/suite_scaling.hpp"
#include "glissade/study/analysis/base_shear.hpp"
#include "glissade/study/analysis/clearance.hpp"
#include "glissade/study/analysis/condition_table.hpp"
#include "glissade/study/analysis/hazard.hpp"
#include "glissade/study/analysis/intensity_measures.hpp"
#include "glissade/study/analysis/rare.hpp"
#include "glissade/study/analysis/sampling_error.hpp"
#include "glissade/study/analysis/sensitivity.hpp"
#include "glissade/study/analysis/shape.hpp"
#include "glissade/study/analysis/tipping.hpp"
#include "glissade/study/analysis/verdict.hpp"
#include "glissade/study/cases/case_set.hpp"
#include "glissade/study/config.hpp"
#include "glissade/study/run/history_table.hpp"

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
  GoodnessOfFit lognormal;             ///< of the capacities
};

/// Slip at one level over records and samples, plan metres.
struct SlipStatistics {
  double level = 0.0;
  double median_m = 0.0, p84_m = 0.0, p95_m = 0.0, mean_m = 0.0;
  Interval mean_interval, median_interval, p84_interval;  ///< 95 %, bootstrap over records
  double uplift_share = 0.0;
  double mean_vector_m = std::numeric_limits<double>::quiet_NaN();  ///< mean of the longest
                                                                    ///< displacement vectors; NaN:
                                                                    ///< one axis
};

/// How the array first gets a threshold's distance from where it lay, at one level: over those
/// records' samples that reach it (percentiles by Hyndman & Fan 1996, type 7; NaN where none
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

/// The fragility of one combination of what the study lists, over records x samples x levels.
struct RunResults {
  std::string label;                 ///< "sampled", "design", "design_period_s_0.5": a file's name
  std::string friction_description;  ///< "normal, mean 0.55, std 0.04", "mean - 2 std = 0.47"
  std::uint64_t first_case = 0, cases = 0;      ///< of the histories
  std::vector<ThresholdFragility> fragilities;  ///< by threshold
  std::vector<double> band_intensities;
  std::vector<SlipStatistics> slip;           ///< by level
  std::vector<StandardComparison> standards;  ///< by (standard, level); empty unless sds_g
  std::vector<ImpactStatistics> impact;       ///< by (threshold, level); empty where not required
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

struct RecordSummary {
  std::uint64_t suite = 0;  ///< position of its suite
  std::string id, event, station;
  double magnitude = 0.0, distance_km = 0.0, vs30_mps = 0.0;  ///< 0 where not given
  double suite_scale = 1.0;                                   ///< the suite file's factor
  double factor_at_unit_level = 0.0;  ///< factor on the record at intensity 1 (0 for ppa_g: depends
                                      ///< on the roof)
  double pga_g = 0.0, pgv_mps = 0.0, pgd_m = 0.0;  ///< geometric means of the horizontals, as
                                                   ///< recorded
  double duration_s = 0.0;                         ///< D5-95 of both horizontals together
  double dt_s = 0.0;
  std::uint64_t samples = 0;
  bool has_second = false, has_vertical = false;
  std::uint64_t stronger = 0;  ///< the component with the larger integral of a^2: 0 or 1
  /// As recorded, geometric means of the horizontals; NaN or empty in files of earlier versions.
  double arias_mps = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> sa_g, roof_velocity_mps;  ///< 5 % damped, at Results::record_periods_s
};

/// 5 % spectra of the suite, scaled to `reference_level` (sds_g) or by the suite's own factors
/// (else).
struct SuiteSpectra {
  std::vector<double> periods_s;
  std::vector<std::vector<double>> srss_g;  ///< [record][period]
  std::vector<double> average_srss_g;       ///< [period]
  std::vector<double> target_g;             ///< [period]; empty without a target
  double reference_level = 0.0;             ///< 0: as scaled in the suite file
  SpectralRatios to_target;                 ///< of the average, 0 to 2 s; NaN without a target
};

/// The model in sentences, empty where there is nothing to report, and the earthquakes it is under.
struct ModelText {
  std::string kernel;        ///< what computed the histories
  std::string building;      ///< how it yields
  std::string friction;      ///< what differs from Coulomb's law
  std::string displacement;  ///< of two axes: what a history's displacement is
  double dbe_level = 0.0;    ///< S_DS of the one design target of a study by sds_g; else 0
};

struct SuiteSummary {
  std::string name, description;
  std::string target;  ///< "ASCE 7-16, S_S 1.5 g, S_1 0.6 g, site class D"; empty without one
  SuiteSpectra spectra;
};

/// Everything a study found, and nothing about when, where or on how many ranks.
/// What the analyses found, each where the study has its table.
struct AnalysisResults {
  std::optional<ConditionTable> conditions;  ///< of a study with [clearance] or [base_shear]
  std::vector<RunResults> runs;              ///< fragility, by combination of the cases
  std::optional<Chart> chart;
  std::optional<ClearanceResults> clearance;
  std::optional<BaseShearResults> base_shear;
  std::optional<TippingResults> tipping;
  std::optional<HazardResults> hazard;
  std::optional<VerdictResults> verdict;
  std::optional<SensitivityResults> sensitivity;
  std::optional<ShapeResults> shape;
  std::optional<RareResults> rare;
  std::vector<SamplingErrorRow> sampling_errors;  ///< of the fragility; of two scrambles or more
  std::optional<std::vector<RankedMeasure>> intensity_measures;
};

struct Results : AnalysisResults {
  std::string study_name, study_description, program_version, plan_hash, study_text;
  std::uint64_t seed = 0;
  UnitSystem units = UnitSystem::si;  ///< what stands first in the report
  IntensityMeasure measure = IntensityMeasure::sds_g;
  std::string intensity_label;  ///< for axes: "S_DS (g)", "Sa(1.0 s) (g)" ...
  std::vector<SuiteSummary> suites;
  ModelText model;
  SlidingAxes axes = SlidingAxes::one;
  DisplacementMeasure displacement = DisplacementMeasure::srss;  ///< of two axes
  std::vector<double> levels, thresholds_m;
  CaseSet cases;
  std::vector<RecordSummary> records;           ///< those of one suite together
  std::vector<double> record_periods_s;         ///< of their spectra as recorded
  HistoryTable histories;                       ///< by (record, case)
  std::optional<ReachedTarget> reached_target;  ///< with sampling.target_error
  std::vector<std::string> warnings;            ///< shown before the results
  std::vector<std::string> notes;               ///< remarks on the results
};

/// The histories of some cases in a row.
struct CaseSlice {
  std::size_t first = 0, count = 0;
};
inline CaseSlice slice_of(const RunResults& run) { return {run.first_case, run.cases}; }

/// Mean of a field over the histories of some cases at a level; NaN where the field is not kept. Of
/// flags: the share that is set.
template <class T>
double mean_of(const HistoryTable& histories, const std::vector<T>& field, CaseSlice cases,
               std::size_t level) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (std::size_t record = 0; record < histories.records; ++record) {
    for (std::size_t i = 0; i < cases.count; ++i)
      sum += field[histories.at(record, cases.first + i, level)];
  }
  return sum / static_cast<double>(histories.records * cases.count);
}

inline bool slides_on_two_axes(const Results& results) { return results.axes == SlidingAxes::two; }

}  // namespace glissade
