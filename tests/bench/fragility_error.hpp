// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "glissade/sampling/point_set.hpp"

namespace glissade::bench {

struct FragilityErrorOptions {
  int least_log2 = 4, most_log2 = 13;  ///< samples: 2^least, ..., 2^most
  int replicates = 32;                 ///< of seed or scrambling, >= 2
  int threads = 2;                     ///< replicates side by side, each on one core
};

/// Root mean square of the relative errors of the replicates, and its 95 % interval (chi-square:
/// the errors are near normal).
struct RmsError {
  double rms = 0.0, low = 0.0, high = 0.0;
};

/// What the fragility is fitted on.
enum class FittedOn { counts, capacities };

/// How a fragility is estimated. Plain Monte Carlo: independent samples, counts at the levels.
struct Estimator {
  SamplingMethod method = SamplingMethod::monte_carlo;
  FittedOn fitted_on = FittedOn::counts;
  std::string name() const;
  bool operator==(const Estimator&) const = default;
};

/// One number of samples, by one estimator.
struct FragilityErrorRow {
  Estimator estimator;
  int log2_samples = 0;
  double histories = 0.0;  ///< at the levels, and those of the search for capacities where needed
  /// On one core, median of the replicates: of make_plan and execute (the search included); of
  /// reduce.
  double histories_s = 0.0, fit_s = 0.0;
  int fitted = 0;  ///< replicates whose fit converged
  RmsError median, log_std;
};

/// The truth of a fit: mean of the largest Sobol replicates, with its relative standard errors.
struct FragilityTruth {
  double median_pga_g = 0.0, log_std = 0.0, median_uncertainty = 0.0, log_std_uncertainty = 0.0;
};

struct FragilityError {
  std::string study;  ///< a sentence
  std::vector<FragilityErrorRow> rows;
  FragilityTruth of_counts, of_capacities;
};

/// Those of this estimator.
std::vector<FragilityErrorRow> rows_of(const FragilityError& measured, const Estimator& estimator);
/// Plain Monte Carlo first.
std::vector<Estimator> estimators();

/// Histories at which the rms error of the median falls to `error`: on the line in logarithms
/// between the first row below it and the row before. NaN where no row is.
double histories_for(const std::vector<FragilityErrorRow>& rows, double error);

/// A small study through make_plan, execute and reduce, over and over. Its motions are fixed: this
/// is what sampling leaves of friction, slope, period and orientation, and not how records differ.
FragilityError fragility_error(const std::filesystem::path& suites,
                               const FragilityErrorOptions& options);

}  // namespace glissade::bench
