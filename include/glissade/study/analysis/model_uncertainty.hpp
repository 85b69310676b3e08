// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "glissade/core/finite.hpp"
#include "glissade/study/analysis/analysis.hpp"

namespace glissade {

/// A result at the low end of a premise, as calculated, and at the high end.
struct AtEnds {
  double low = nan, calculated = nan, high = nan;

  /// (Largest - smallest) over that as calculated; NaN where one is not known.
  double change() const;
};

/// What a premise changes, all else as calculated; or the records, of which the ends are the 95 %
/// interval.
struct PremiseEffect {
  std::string premise, unit;     ///< no unit: ""
  std::string ends;              ///< what they are: "listed"
  double low = nan, high = nan;  ///< of the premise; NaN: it is no number
  /// Intensity at which half of the histories reach the threshold; of a project the displacement,
  /// m.
  AtEnds result;
  AtEnds probability = {};  ///< of reaching it at DBE; NaN where the study has no such level
  bool is_of_records = false;

  std::string name() const;  ///< with the unit: "building period, s"
};

struct ModelUncertainty {
  double threshold_m = 0.0;            ///< of a fragility
  std::vector<PremiseEffect> effects;  ///< the largest change first, those not known last
  std::string not_varied;              ///< "building damping 0.05, slope 1.19 deg"
};
/// The largest change first.
void sort_by_change(std::vector<PremiseEffect>& effects);

struct ModelUncertaintyAnalysis {
  struct InStudy {};
  struct InResults {
    std::vector<ModelUncertainty> uncertainties;  ///< by threshold
  };
  /// Of governing_run(): what is listed, each at both ends with all else as in that run; what is
  /// drawn, by the lower and the upper third of its samples. No history is run for it.
  static std::vector<ModelUncertainty> find(const StudyConfig& study, const Results& results);
  static AnalysisInFiles in_files();
  static AnalysisReport in_report();
};

}  // namespace glissade
