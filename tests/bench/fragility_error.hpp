// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/sampling/point_set.hpp"

namespace glissade::bench {

struct FragilityErrorOptions {
  int least_log2 = 6, most_log2 = 16;  ///< samples: 2^least, ..., 2^most
  int replicates = 32;                 ///< of seed or scrambling, >= 2
  int threads = 2;                     ///< replicates side by side, each on one core
};

/// Root mean square of the relative errors of the replicates, and its 95 % interval (chi-square:
/// the errors are near normal).
struct RmsError {
  double rms = 0.0, low = 0.0, high = 0.0;
};

/// One number of samples, by one way of sampling.
struct FragilityErrorRow {
  SamplingMethod method = SamplingMethod::sobol;
  int log2_samples = 0;
  /// On one core, median of the replicates: of make_plan and execute; of reduce.
  double histories_s = 0.0, fit_s = 0.0;
  int fitted = 0;            ///< replicates whose fit converged
  RmsError median, log_std;  ///< of the fit on capacities
};

struct FragilityError {
  std::string study;  ///< a sentence
  std::vector<FragilityErrorRow> rows;
  double median_pga_g = 0.0, log_std = 0.0;  ///< the truth: mean of the largest Sobol replicates
  double median_uncertainty = 0.0,
         log_std_uncertainty = 0.0;  ///< relative standard errors of the truth
};

/// A small study through make_plan, execute and reduce, over and over. Its two motions are fixed:
/// this is what sampling leaves of friction, slope, period and orientation, and not how records
/// differ.
FragilityError fragility_error(const std::filesystem::path& suites,
                               const FragilityErrorOptions& options);

}  // namespace glissade::bench
