// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <vector>

namespace glissade {

/// Variance of an estimate from its values without one of n parts each: (n - 1)/n of the sum of
/// their squared departures from their mean (Efron & Stein 1981). Two parts or more; NaN where a
/// value is.
inline double jackknife_variance(const std::vector<double>& without) {
  const auto n = static_cast<double>(without.size());
  double mean = 0.0, sum = 0.0;
  for (const double value : without) mean += value / n;
  for (const double value : without) sum += (value - mean) * (value - mean);
  return sum * (n - 1.0) / n;
}

}  // namespace glissade
