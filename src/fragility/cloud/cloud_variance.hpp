// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "glissade/fragility/cloud.hpp"

namespace glissade::fragility {

/// Both parts of those that do not collapse, and the probability of collapse where any does.
struct CloudFit {
  TwoPartFit parts;
  std::optional<FragilityCurve> collapse = std::nullopt;

  double probability(double intensity, double threshold) const {
    const double of_parts = parts.probability(intensity, threshold);
    if (!collapse) return of_parts;
    const double of_collapse = collapse->probability(intensity);
    return of_collapse + (1 - of_collapse) * of_parts;
  }
};

/// (b0, b1) of any slip with y = ln x; intercept, slope and log_std of its size; (b0, b1) of
/// collapse.
using CloudParameters = Eigen::Matrix<double, 7, 1>;
CloudParameters parameters_of(const CloudFit& fit);

/// How uncertain the two parts of a cloud are, with records as the unit (theory.md, 6.9).
struct CloudVariance {
  /// The jackknife over records, sum d d^T of what leaving out each one changes (Bell & McCaffrey
  /// 2002, Survey Methodology 28(2):169-181); of log_std that of its degrees of freedom. NaN where
  /// one record decides a part.
  Eigen::Matrix<double, 7, 7> covariance;
  double freedom;          ///< records that slip less 2, by their weights; at least 1
  double log_std_freedom;  ///< of the chi-square distribution of log_std^2
  double any_freedom;      ///< records less 2, by their weights; at least 1
  /// Variance between records over that of independent rows, of ln median and ln log_std of any
  /// slip.
  double median_design_effect = 1.0, log_std_design_effect = 1.0;
};

/// @param points with weights that sum to as many as they are worth
CloudVariance cloud_variance(const std::vector<CloudPoint>& points, const CloudFit& fit);

/// The weights of the records that have any.
Eigen::VectorXd record_weights(const std::vector<CloudPoint>& points);

}  // namespace glissade::fragility
