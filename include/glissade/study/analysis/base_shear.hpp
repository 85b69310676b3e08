// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "glissade/study/analysis/analysis.hpp"
#include "glissade/study/analysis/conditions/suite_mean.hpp"
#include "glissade/study/run/history_table.hpp"

namespace glissade {

/// Peak base shear of the building over its weight without the array: the SRSS of the peaks along
/// both axes.
struct BaseShearResults {
  std::vector<SuiteMean> means;  ///< by (suite, condition)
};

struct BaseShearAnalysis {
  struct InStudy {
    bool base_shear = false;
  };
  struct InResults {
    std::optional<BaseShearResults> base_shear;
  };
  static BaseShearResults find(const StudyConfig& study, const Results& results);
  static constexpr auto keeps = &KeptFields::base_shear;
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
