// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/fragility/hazard.hpp"
#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/analysis/standards.hpp"

// How often: annual rates of displacements, and what adds up over the design life. Displacements
// are in plan. Records are the independent unit of all intervals (95 %).
namespace glissade {

/// How often the site has shaking of each intensity, and for how long the array stands there.
struct HazardConfig {
  HazardCurve curve;                          ///< in the study's intensity measure
  std::string source;                         ///< "hazard.csv", "1e-4 x^-2.5"
  double design_life_years = 0.0;             ///< > 0
  std::vector<double> target_rates_per_year;  ///< > 0, falling
  double sds_g = 0.0;                         ///< of the site, where stated; else 0
  bool is_assumed = false;                    ///< from sds_g: no site's curve
};

/// Exceedance of one threshold. The rate is the mean of the hazard curve over the capacities, that
/// is the integral of the share that has reached the threshold over the hazard, without a fit and
/// without interpolation between levels. A history that the highest level does not bring to the
/// threshold counts as if any shaking above that level did.
struct ThresholdRate {
  double threshold_m = 0.0;
  Estimate annual_rate;  ///< infinite where a history slides freely
  double effective_records = std::numeric_limits<double>::quiet_NaN();  ///< that carry the rate
  double beyond_share = 0.0;    ///< part of the rate that comes from histories so counted
  double fit_rate = 0.0;        ///< of the lognormal fit; NaN without one
  Estimate life_probability;    ///< of one exceedance or more in the design life
  double half_intensity = 0.0;  ///< half of the rate is of stronger shaking (theory.md, 6.5)

  /// Most of the rate is that assumption: an upper bound, without an interval.
  bool is_mostly_assumed() const { return beyond_share > 0.5; }
};

/// The annual rate of a displacement: as of a threshold, with the capacity of each history
/// interpolated between levels and thresholds, linear in the root of its displacement. What happens
/// below the levels is not known: a history that exceeds the displacement at the lowest one counts
/// from there on, so that the rate is a lower bound, without an interval.
struct DisplacementRate {
  double displacement_m = 0.0;
  Estimate annual_rate;
  double below_share = 0.0;  ///< of the histories, so counted
};

/// The displacement that is exceeded at a given annual rate. Infinite where the levels do not reach
/// so rare shaking, NaN where they begin above such frequent shaking; the lowest displacement of
/// the curve where it is that or less.
struct TargetDisplacement {
  double annual_rate = 0.0;
  Estimate displacement_m;
  double intensity = 0.0;    ///< that shaking exceeds at this rate
  double below_share = 0.0;  ///< as of DisplacementRate; above 0: the displacement is a lower bound
};

/// How often what a standard prescribes at the site's S_DS is exceeded: as of a displacement.
struct PrescribedRate {
  Standard standard = Standard::seaoc_pv1_2012;
  double sds_g = 0.0;
  Prescription prescribed;
  Estimate annual_rate;
  double below_share = 0.0;  ///< as of DisplacementRate
};

enum class LifeQuantity {
  single,       ///< the largest peak displacement in one earthquake
  accumulated,  ///< distance at the end of the life from the first place, never put back
  farthest      ///< the largest, at any time: distance before an earthquake plus its peak
};
/// Over many design lives; infinite where shaking beyond the highest level decides it.
struct LifeDisplacement {
  LifeQuantity quantity = LifeQuantity::single;
  Estimate median_m, p84_m, p95_m;
};

/// The displacement that a quantity stays below in a part of the design lives.
struct LifeQuantile {
  LifeQuantity quantity = LifeQuantity::single;
  double probability = 0.0, displacement_m = 0.0;
};

/// Of one combination of what the study lists.
struct HazardRun {
  std::string label;  ///< that of its fragility
  std::vector<ThresholdRate> thresholds;
  std::vector<DisplacementRate> curve;  ///< displacements rise
  std::vector<TargetDisplacement> targets;
  std::vector<LifeDisplacement> life;  ///< by LifeQuantity
  double events = 0.0;                 ///< expected earthquakes in a life above `from_intensity`
  double from_intensity = 0.0;         ///< below it none is counted
  double moving_share = 0.0;  ///< of histories that slide at `from_intensity` already; above 0:
                              ///< slip over the life is a lower bound
  std::vector<PrescribedRate> prescribed;  ///< empty where the study compares with none, or S_DS of
                                           ///< the site is not known
  std::vector<LifeQuantile> life_distribution;
};

struct HazardResults {
  std::string source;                             ///< of the hazard curve
  std::vector<double> intensity, intensity_rate;  ///< its points
  double design_life_years = 0.0;
  double beyond_rate = 0.0;       ///< annual rate of shaking above the highest level
  bool residual_vectors = false;  ///< kept (two axes); else every peak counts as slip down the
                                  ///< slope
  std::vector<HazardRun> runs;    ///< as Results::runs
};

/// By the run's curve, linear in logarithms; without an interval and the intensity.
TargetDisplacement target_displacement(double annual_rate, const HazardRun& run);

/// Of rates that no site has, most probably no annual ones; "" of others. For intensities in g.
std::string improbable_rates(const HazardCurve& curve);

struct HazardAnalysis {
  struct InStudy {
    std::optional<HazardConfig> hazard;
  };
  struct InResults {
    std::optional<HazardResults> hazard;
  };
  /// From the fragility runs and the histories.
  static HazardResults find(const StudyConfig& study, const Results& results);
  static std::vector<std::string> plan_warnings(const StudyOutline& study);
  static std::vector<std::string> plan_notes(const StudyOutline& study);
  static std::vector<std::string> warnings(const Results& results, const StudyConfig& study);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
