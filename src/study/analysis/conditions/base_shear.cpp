// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/base_shear.hpp"

#include "glissade/study/results.hpp"

namespace glissade {

BaseShearResults BaseShearAnalysis::find(const StudyConfig&, const Results& results) {
  return {suite_means(results, HistoryNumber::base_shear, all_conditions(ConditionGrid(results)),
                      Periods::one, OrientationRule::median)};
}

}  // namespace glissade
