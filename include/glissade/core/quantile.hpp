// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

namespace glissade {

// Quantiles of a sample: linear between order statistics (Hyndman & Fan 1996, The American
// Statistician 50(4):361-365, type 7); the probability is in [0, 1]. Of values on either side of a
// place the larger, where it is infinite. NaN without values.

double quantile_of_sorted(std::span<const double> sorted, double probability);
double quantile_of(std::vector<double> values, double probability);  ///< in any order, no NaN

}  // namespace glissade
