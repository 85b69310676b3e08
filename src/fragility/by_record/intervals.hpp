// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "glissade/fragility/fit.hpp"

namespace glissade::fragility {

/// n/(n - 1) A^-1 (sum s s^T) A^-1 with a row of weighted scores per cluster, n of them that are
/// not 0, and the observed information A (Liang & Zeger 1986, Biometrika 73(1):13-22).
Eigen::MatrixXd cluster_sandwich(const Eigen::MatrixXd& scores, const Eigen::MatrixXd& information);

/// (sum w)^2 / sum w^2 (Kish 1965, Survey Sampling).
double effective_number(const Eigen::VectorXd& weights);

/// value -+ t se at 95 %, Student's t of `effective` - 1 degrees of freedom, at least 1.
Interval t_interval(double value, double standard_error, double effective);

/// That of log_std whose square has a chi-square distribution of `freedom`.
Interval chi_square_interval(double log_std, double freedom);

/// Of the logarithms' interval.
Interval exponentials(const Interval& logs);

}  // namespace glissade::fragility
