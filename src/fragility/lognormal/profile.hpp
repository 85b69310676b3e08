// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "lognormal/likelihood.hpp"

namespace glissade::fragility {

using LogLikelihood = std::function<double(const ProbitLine&)>;

/// Profile-likelihood intervals at 95 %: {v : 2 [max - max over the other parameter] <=
/// chi-square(1; 0.95)} (Venzon & Moolgavkar 1988, Applied Statistics 37(1):87-94). A side that has
/// no end within a factor of 1e6 of the maximum is 0 or infinite.
struct ProfileIntervals {
  Interval median, log_std;
};
ProfileIntervals profile_intervals(const LogLikelihood& log_likelihood, const ProbitLine& maximum,
                                   double center);

/// Median at which an outcome has a probability of 5 % for a given log_std, its log probability
/// being monotone in the median: the one-sided 95 % bound given by "none of the trials exceeded" or
/// "all of them did".
double median_bound(const LogLikelihood& log_outcome_probability, double log_std, double center);

}  // namespace glissade::fragility
