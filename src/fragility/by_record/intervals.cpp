// SPDX-License-Identifier: GPL-3.0-or-later
#include "by_record/intervals.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/distributions.hpp"

namespace glissade::fragility {

Eigen::MatrixXd cluster_sandwich(const Eigen::MatrixXd& scores,
                                 const Eigen::MatrixXd& information) {
  const auto n = static_cast<double>((scores.array() != 0).rowwise().any().count());
  const Eigen::MatrixXd inverse = information.inverse();
  return n / (n - 1) * inverse * (scores.transpose() * scores) * inverse;
}

double effective_number(const Eigen::VectorXd& weights) {
  return weights.sum() * weights.sum() / weights.squaredNorm();
}

Interval t_interval(double value, double standard_error, double effective) {
  const double reach = student_quantile(std::max(1.0, effective - 1), 0.975) * standard_error;
  return {value - reach, value + reach};
}

Interval chi_square_interval(double log_std, double freedom) {
  return {log_std * std::sqrt(freedom / chi_squared_quantile(freedom, 0.975)),
          log_std * std::sqrt(freedom / chi_squared_quantile(freedom, 0.025))};
}

Interval exponentials(const Interval& logs) { return {std::exp(logs.low), std::exp(logs.high)}; }

}  // namespace glissade::fragility
