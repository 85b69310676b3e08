// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "glissade/fragility/fit.hpp"

namespace glissade::fragility {

using CurveObjective = std::function<double(const LognormalCurve&)>;

/// Profile-likelihood intervals at 95 %: {v : 2 [max - max over the other parameter] <= chi-square(1; 0.95)}
/// (Venzon & Moolgavkar 1988, Applied Statistics 37(1):87-94). A side without an end is 0 or infinite.
struct ProfileIntervals { Interval median, log_std; };
ProfileIntervals profile_intervals(const CurveObjective& objective, const LognormalCurve& maximum);

/// Median at which an outcome has a probability of 5 %, its log probability being monotone in the median: the one-sided
/// 95 % bound given by "none of the trials exceeded" or "all of them did".
double median_bound(const CurveObjective& log_outcome_probability, const LognormalCurve& start);

/// Assumed by one-sided bounds: a usual dispersion of sliding capacities, rather wide than narrow.
inline constexpr double assumed_log_std = 0.4;

}  // namespace glissade::fragility
