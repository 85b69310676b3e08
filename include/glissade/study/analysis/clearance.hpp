// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/analysis/conditions/suite_mean.hpp"
#include "glissade/study/run/history_table.hpp"

// Required clearance after Walters et al. (2012): the mean of the suite for each building period,
// the largest over the periods, and a factor on that.
namespace glissade {

/// The clearance that Walters et al. (2012) recommend: a factor on the suite's mean displacement,
/// the largest over the building periods.
struct ClearanceConfig {
  double factor = 1.1;  ///< >= 1
  OrientationRule orientation = OrientationRule::largest;
  bool without_target = false;  ///< also of a suite that does not meet its target
};

/// At one condition but the period.
struct RequiredClearance {
  SuiteMean largest;                       ///< displacement in m, the largest over the periods
  double clearance_m = 0.0;                ///< the one of these that the rule takes
  double median_m = 0.0, highest_m = 0.0;  ///< the factor on its median and highest
};

struct ClearanceResults {
  double factor = 1.1;
  OrientationRule orientation = OrientationRule::largest;
  std::vector<RequiredClearance> required;  ///< by (suite, sliding_conditions(largest))
  std::vector<SuiteMean> by_period;         ///< by (suite, sliding_conditions(one)), m
};

ClearanceResults required_clearance(const Results& results, const ClearanceConfig& config);

struct ClearanceAnalysis {
  struct InStudy {
    std::optional<ClearanceConfig> clearance;
  };
  struct InResults {
    std::optional<ClearanceResults> clearance;
  };
  static ClearanceResults find(const StudyConfig& study, const Results& results);
  static constexpr auto keeps = &KeptFields::by_axis;
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
