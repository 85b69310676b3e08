// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "glissade/core/contract.hpp"
#include "glissade/fragility/bootstrap.hpp"

namespace glissade::fragility {

/// How often each of `records` is drawn in one resample of as many.
std::vector<double> draw_records(std::size_t records, const BootstrapOptions& options,
                                 int replicate);

/// `statistic(weights)` of every resample, by how often each of `records` is drawn in it.
template <class Statistic>
auto resampled(std::size_t records, const BootstrapOptions& options, const Statistic& statistic) {
  GLISSADE_EXPECTS(options.replicates >= 100);
  GLISSADE_EXPECTS(options.level > 0 && options.level < 1);
  std::vector<decltype(statistic(std::vector<double>()))> found;
  for (int r = 0; r < options.replicates; ++r)
    found.push_back(statistic(draw_records(records, options, r)));
  return found;
}

/// A quantity and its standard error; the error is NaN where there is none.
struct EstimateWithError {
  double value, standard_error;
};

/// From the share `tail` of the values that is cut on either side, by order statistics and outward,
/// so that infinite values are allowed. NaNs are left out.
Interval percentile_interval(std::vector<double> values, double tail);

/// The tail of the expanded percentile interval (Hesterberg 2015, The American Statistician
/// 69(4):371-386, section 3.3): Phi(-sqrt(n/(n-1)) t) with Student's t of n - 1 degrees of freedom.
double expanded_tail(std::size_t records, double level);

/// Equal-tailed bootstrap-t (Efron & Tibshirani 1993, section 12.5). A replicate without a standard
/// error counts as an infinite t.
Interval t_interval(EstimateWithError estimate, const std::vector<EstimateWithError>& replicates,
                    double tail);

/// For ln log_std, whose estimate is biased low with few records: with few records the upper end of
/// t_interval() runs away, so neither end goes beyond the chi-square interval of a normal sample of
/// as many degrees of freedom as the standard error is worth, 1 / (2 se^2) (Satterthwaite 1946),
/// but at most n - 1.
Interval log_std_interval(EstimateWithError log_log_std,
                          const std::vector<EstimateWithError>& replicates, std::size_t records,
                          double level);

}  // namespace glissade::fragility
