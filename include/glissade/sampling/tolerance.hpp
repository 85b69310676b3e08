// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace glissade {

/// A bound from a sample: share of a normal population on its side, and confidence.
struct ToleranceBound {
  std::size_t sample_size;  ///< >= 2
  double coverage;          ///< share of the population, (0, 1)
  double confidence;        ///< (0, 1)
};

/// k of the bound mean - k s (or mean + k s), with mean and standard deviation s (n - 1) of a
/// sample: the `confidence` quantile of the noncentral t with n - 1 degrees of freedom and
/// noncentrality z sqrt(n), over sqrt(n), where Phi(z) = coverage. Exact for normal populations
/// (Hahn & Meeker 1991, Statistical Intervals, ch. 4; NIST/SEMATECH e-Handbook 7.2.6.3). To 1e-9 of
/// itself, by Boost.Math.
double one_sided_tolerance_factor(const ToleranceBound& bound);

}  // namespace glissade
