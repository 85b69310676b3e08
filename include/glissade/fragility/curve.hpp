// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace glissade {

/// A fragility with a floor: P(exceed | x) = floor + (1 - floor) Phi(ln(x / median) / log_std). The
/// share `floor` exceeds at every intensity, even without shaking; median and log_std are those of
/// the rest, NaN until fitted. Where floor is 0 this is the usual lognormal fragility.
struct FragilityCurve {
  double median = std::numeric_limits<double>::quiet_NaN();   ///< > 0, in the unit of the intensity
  double log_std = std::numeric_limits<double>::quiet_NaN();  ///< > 0
  double floor = 0.0;                                         ///< in [0, 1]
  double probability(double intensity) const;                 ///< `floor` at intensity <= 0
  /// The lowest intensity at which it is reached, 0 if `floor` reaches it; in (0, 1).
  double intensity_at(double probability) const;
};

/// ln Phi(z), finite (|z| < 1e150) and accurate to a few parts in 1e15 in both tails.
double log_normal_cdf(double z);
/// ln[Phi(high) - Phi(low)], low < high, in the tail where both are small; `low` may be -infinity.
double log_normal_between(double low, double high);

}  // namespace glissade
