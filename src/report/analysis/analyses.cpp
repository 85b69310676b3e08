// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/analyses.hpp"

namespace glissade {

std::vector<AnalysisReport> analyses_in(const Results& results) {
  std::vector<AnalysisReport> analyses;
  for (const auto& in_report : Analyses::in_report) {
    const AnalysisReport analysis = in_report();
    if (analysis.is_in != nullptr && analysis.is_in(results)) analyses.push_back(analysis);
  }
  return analyses;
}

}  // namespace glissade
