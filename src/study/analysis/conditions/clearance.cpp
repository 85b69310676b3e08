// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/clearance.hpp"

#include "glissade/study/results.hpp"

namespace glissade {

ClearanceResults required_clearance(const Results& results, const ClearanceConfig& config) {
  const auto means = [&](Periods periods) {
    return suite_means(results, HistoryNumber::displacement,
                       sliding_conditions(ConditionGrid(results), periods), periods,
                       config.orientation);
  };
  ClearanceResults clearance{.factor = config.factor,
                             .orientation = config.orientation,
                             .required = {},
                             .by_period = means(Periods::one)};
  for (SuiteMean& mean : means(Periods::largest)) {
    const OrientationRange range = mean.range;
    clearance.required.push_back({std::move(mean), config.factor * range.of(config.orientation),
                                  config.factor * range.median, config.factor * range.highest});
  }
  return clearance;
}

ClearanceResults ClearanceAnalysis::find(const StudyConfig& study, const Results& results) {
  return required_clearance(results, *study.clearance);
}

}  // namespace glissade
