// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace glissade {

/// A lognormal fragility: P(exceed | x) = Phi(ln(x / median) / log_std). NaN until fitted.
struct LognormalCurve {
  double median = std::numeric_limits<double>::quiet_NaN();   ///< > 0, in the unit of the intensity
  double log_std = std::numeric_limits<double>::quiet_NaN();  ///< > 0
  double probability(double intensity) const;                 ///< 0 at intensity <= 0
  double intensity_at(double probability) const;              ///< inverse, probability in (0, 1)
};

/// ln Phi(z), finite (|z| < 1e150) and accurate to a few parts in 1e15 in both tails.
double log_normal_cdf(double z);

}  // namespace glissade
