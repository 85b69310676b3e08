// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace glissade {

struct StudyConfig;
struct Results;

/// Standard errors of ln median of the fit on capacities: of the number of records, which samples
/// do not reduce, and of the samples.
struct SamplingErrorRow {
  std::string label;  ///< of the run
  double threshold_m = 0.0, median = 0.0;
  double record_error = 0.0;    ///< the bootstrap interval of ln median (95 %) over 3.92
  double sampling_error = 0.0;  ///< from the scrambles; NaN where a part has no fit
};

/// By (run, threshold). None with one scramble, or without [fragility].
std::vector<SamplingErrorRow> sampling_error_rows(const StudyConfig& config,
                                                  const Results& results);

}  // namespace glissade
