// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/analyses.hpp"

namespace glissade {

std::vector<AnalysisReport> analyses_in(const Results& results) {
  std::vector<AnalysisReport> analyses = {clearance_report(),
                                          base_shear_report(),
                                          fragility_report(),
                                          impact_report(),
                                          shape_report(),
                                          hazard_report(),
                                          chart_report(),
                                          tipping_report(),
                                          verdict_report(),
                                          sensitivity_report(),
                                          sampling_error_report(),
                                          rare_report(),
                                          intensity_measures_report()};
  std::erase_if(analyses, [&](const AnalysisReport& a) { return !a.is_in(results); });
  return analyses;
}

}  // namespace glissade
