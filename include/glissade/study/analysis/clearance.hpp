// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/study/analysis/suite_mean.hpp"

// Required clearance after Walters et al. (2012): the mean of the suite for each building period,
// the largest over the periods, and a factor on that.
namespace glissade {

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

}  // namespace glissade
