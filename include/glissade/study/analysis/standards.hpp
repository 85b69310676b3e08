// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/standards/prescriptive.hpp"
#include "glissade/study/analysis/analysis.hpp"

namespace glissade {

struct StandardsConfig {
  std::vector<Standard> compare;  ///< only with sds_g
  SeismicDesignCategory category = SeismicDesignCategory::d;
  double importance = 1.0;
};

/// What a standard prescribes at an S_DS.
Prescription prescribed_displacement(Standard standard, double sds_g,
                                     const StandardsConfig& standards);

/// A prescriptive value beside what came out at one S_DS.
struct StandardComparison {
  Standard standard = Standard::seaoc_pv1_2012;
  double sds_g = 0.0;
  Prescription prescribed;
  double exceedance_probability = 0.0;  ///< share of histories with slip above it
  Interval exceedance_interval;         ///< 95 %, over records
};

/// Found with each RunResults and Chart.
struct StandardsAnalysis {
  struct InStudy {
    StandardsConfig standards;
  };
  struct InResults {};
  static std::vector<std::string> plan_notes(const StudyOutline& study);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
