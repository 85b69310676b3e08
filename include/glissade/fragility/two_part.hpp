// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade {

/// Displacements at one intensity: their number, how many are not 0, and of these the sums of ln D
/// and of its square. Weights make all of them fractional.
struct SlipSums {
  double intensity = 0.0, trials = 0.0, moved = 0.0, sum_log = 0.0, sum_log_squares = 0.0;

  void add(double displacement, double weight = 1.0);
};

/// A two-part model of displacement (Duan, Manning, Morris & Newhouse 1983, J. Business & Economic
/// Statistics 1(2):115-126): a probit line in ln x for any slip at all, and for the size given slip
/// a regression ln D = intercept + slope ln x + log_std e, e standard normal (the cloud of Cornell,
/// Jalayer, Hamburger & Foutch 2002, J. Struct. Eng. 128(4):526-533).
struct TwoPartFit {
  FitStatus any_status = FitStatus::failed;  ///< upper_bound: every history slips, P(any) = 1
  FragilityCurve any;                        ///< probability of any slip, where it has a curve
  FitStatus size_status = FitStatus::failed;
  double intercept = std::numeric_limits<double>::quiet_NaN();
  double slope = std::numeric_limits<double>::quiet_NaN();
  double log_std = std::numeric_limits<double>::quiet_NaN();

  bool has_curve() const;
  /// That displacement exceeds `threshold` > 0. Expects has_curve().
  double probability(double intensity, double threshold) const;
};

/// Maximum likelihood of the first part, least squares of the second with log_std over n - 2.
/// size_status: maximum_likelihood, one_level (all that slip have one intensity), no_trend (the
/// slope is not above 0) or failed (fewer than three slip, or all of them on one line, but for
/// rounding).
TwoPartFit fit_two_part(const std::vector<SlipSums>& rows);

}  // namespace glissade
