// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "lognormal/likelihood.hpp"

namespace glissade::fragility {

using LogLikelihood = std::function<double(const ProbitLine&)>;

/// The rising lines whose log likelihood is not more than half of `allowed` below its maximum; a
/// constant `allowed` gives profile likelihood intervals (Venzon & Moolgavkar 1988, Applied
/// Statistics 37(1):87-94). As every line of the region rises, so do both ends of the range of a
/// probability over intensity, and the range of P = 1/2 ends where that of the median does.
class LineRegion {
 public:
  /// @param allowed by the line. @param scale of the region: its columns are two half-axes of about
  /// the right length and any independent direction.
  LineRegion(LogLikelihood log_likelihood, const ProbitLine& maximum, const Eigen::Matrix2d& scale,
             LogLikelihood allowed);

  /// From the least to the greatest of a quantity that has both on the boundary: of P at an
  /// intensity, of the median, of log_std. Infinite where the region reaches a level line, on which
  /// the median and log_std are infinite.
  Interval range(const std::function<double(const ProbitLine&)>& quantity) const;

 private:
  ProbitLine boundary(double angle) const;

  LogLikelihood log_likelihood_, allowed_;
  ProbitLine maximum_;
  double greatest_;
  Eigen::Matrix2d scale_;
  std::vector<ProbitLine> boundary_;  // at equal steps of the angle
};

/// y at the median of a line, infinite of a level one.
inline double log_median(const ProbitLine& line) { return -line[0] / line[1]; }
inline double log_std(const ProbitLine& line) { return 1 / line[1]; }

/// Median at which an outcome has a probability of 5 % for a given log_std, its log probability
/// being monotone in the median: the one-sided 95 % bound given by "none of the trials exceeded" or
/// "all of them did".
double median_bound(const LogLikelihood& log_outcome_probability, double log_std, double center);

}  // namespace glissade::fragility
