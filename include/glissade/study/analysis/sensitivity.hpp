// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/analysis/analysis.hpp"

namespace glissade {

/// Where the spread of one number comes from. By factor: the records, all that is drawn together,
/// then each drawn quantity.
struct SpreadRow {
  std::uint64_t first_case = 0;  ///< of the histories' cases
  std::string condition;         ///< which combination of what the study lists
  double threshold_m = 0.0;
  /// Whether displacement reaches the threshold at this level (0 or 1); NaN: ln of the capacity,
  /// limited to the range of the levels.
  double level = std::numeric_limits<double>::quiet_NaN();
  double mean = 0.0, std = 0.0;
  double share_below = 0.0, share_above = 0.0;  ///< of capacities limited to the lowest level, to
                                                ///< the highest
  std::vector<double> first, total;             ///< Sobol indices
  std::vector<Interval> first_interval, total_interval;  ///< 95 %
  double record_error = 0.0, sample_error = 0.0;         ///< standard errors of `mean`

  bool is_capacity() const { return level != level; }
};

/// How conservative the design value of friction, mean - 2 std, is at a level.
struct DesignFrictionRow {
  std::uint64_t first_case = 0;  ///< of the sampled friction's
  std::string condition;
  double level = 0.0;
  /// Probability that the displacement with drawn friction exceeds that with design friction of the
  /// same record and sample.
  Estimate same_motion;            ///< interval over records and samples, as all here
  double same_motion_error = 0.0;  ///< standard error from the samples alone
  double design_mean_m = 0.0;      ///< mean displacement with design friction
  Estimate above_mean;  ///< probability that a displacement with drawn friction exceeds that
  double above_mean_error = 0.0;
};

struct SensitivityResults {
  std::vector<std::string> factors;  ///< "records", "all that is drawn", "friction" ...
  std::uint64_t samples = 0;         ///< of each matrix
  /// Of the pick-freeze design; 1: the samples of any study (given data), without total indices of
  /// what is drawn.
  std::uint64_t matrices = 1;
  std::vector<SpreadRow> rows;  ///< by (combination, threshold): capacity, then exceedance by level
  std::vector<DesignFrictionRow> design_friction;  ///< by (combination, level), where both are run
};

struct SensitivityAnalysis {
  struct InStudy {
    bool sensitivity = false;
  };
  struct InResults {
    std::optional<SensitivityResults> sensitivity;
  };
  /// Of histories that were run without [sensitivity] as given data. Throws InputError where they
  /// do not serve. Precondition: config.sensitivity, and [fragility] is computed.
  static SensitivityResults find(const StudyConfig& study, const Results& results);
  static void check(const StudyConfig& study, std::size_t units, ProblemList& problems);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
