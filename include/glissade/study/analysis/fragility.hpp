// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/bootstrap.hpp"
#include "glissade/fragility/goodness_of_fit.hpp"
#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/analysis/impact.hpp"
#include "glissade/study/analysis/standards.hpp"

namespace glissade {

struct FragilityConfig {
  std::vector<double> thresholds_m;  ///< > 0, strictly increasing
  /// Levels above the one at which a history reaches the largest threshold are not run: slip there
  /// is reported as infinite.
  bool stop_at_largest = false;
};

/// A lognormal fragility for one clearance threshold, with what it rests on.
struct ThresholdFragility {
  double threshold_m = 0.0;
  FitSummary stripes;     ///< fitted on counts at the levels
  FitSummary capacities;  ///< fitted on first-crossing capacities, censored at the highest level
  /// Of multiple stripes, whose records have no capacities: neither have what follows from these.
  bool on_stripes = false;
  const FitSummary& curve_fit() const { return on_stripes ? stripes : capacities; }
  std::vector<double> probability;             ///< observed share exceeding, per level
  std::vector<Interval> probability_interval;  ///< 95 %, over records, per level
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

/// The fragility of one combination of what the study lists, over records x samples x levels.
struct RunResults {
  std::string label;     ///< "sampled", "design", "design_period_s_0.5": a file's name
  std::string friction;  ///< "normal, mean 0.55, std 0.04", "mean - 2 std = 0.47"
  std::uint64_t first_case = 0, cases = 0;      ///< of the histories
  std::vector<ThresholdFragility> fragilities;  ///< by threshold
  std::vector<double> band_intensities;         ///< of the bands of curve_fit()
  std::vector<SlipStatistics> slip;             ///< by level
  std::vector<StandardComparison> standards;    ///< by (standard, level); empty unless sds_g
  std::vector<ImpactStatistics> impact;         ///< by (threshold, level); empty where not required
};
inline CaseSlice slice_of(const RunResults& run) { return {run.first_case, run.cases}; }
/// The friction of a combination in full, from one of its cases: RunResults::friction.
std::string friction_text(const StudyConfig& config, const Case& c);

struct FragilityAnalysis {
  struct InStudy {
    std::optional<FragilityConfig> fragility;
  };
  struct InResults {
    std::vector<RunResults> runs;  ///< by combination of the cases
  };
  /// Fragilities, slip, comparison with standards and impact, for each combination of what the
  /// study lists.
  static std::vector<RunResults> find(const StudyConfig& study, const Results& results);
  static std::vector<std::string> plan_warnings(const Plan& plan);
  static std::vector<std::string> plan_notes(const Plan& plan);
  static std::vector<std::string> warnings_of_curves(const Results& results,
                                                     const StudyConfig& study);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
