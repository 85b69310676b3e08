// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>
#include <functional>
#include <optional>

#include "glissade/fragility/fit.hpp"

// The likelihoods in probit form, z = b0 + b1 y with y = ln x - center, in which they are concave;
// so b0 = (center - ln median) / log_std and b1 = 1 / log_std. The center only conditions the
// numbers.
namespace glissade::fragility {

using ProbitLine = Eigen::Vector2d;  ///< (b0, b1)

ProbitLine to_line(const FragilityCurve& curve, double center);
FragilityCurve to_curve(const ProbitLine& line, double center);  ///< b1 > 0

/// An objective at a line, its gradient, and a positive definite matrix for the Newton step.
struct Evaluation {
  double value = 0.0;  ///< up to a constant of the data
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d information = Eigen::Matrix2d::Zero();
};
using Objective = std::function<Evaluation(const ProbitLine&)>;

/// Newton's method with step halving. Empty if the objective has no maximum at a finite line.
std::optional<ProbitLine> maximise(const Objective& objective, const ProbitLine& start);

double hazard(double z);  ///< phi(z) / Phi(z), the derivative of ln Phi

/// The share that exceeds at z: Phi(z), 1 / (1 + exp(-z)), 1 - exp(-exp(z)).
enum class Link { probit, logit, complementary_log_log };
double share_at(Link link, double z);

/// ln of the share that exceeds and of the share that does not, each with its derivative away from
/// 0 and minus its second derivative. Both are concave.
struct LogShares {
  struct Part {
    double value, hazard, curvature;
  } above, below;
};
LogShares log_shares(Link link, double z);

/// Binomial stripes. `exceedances` and `trials` are per level, beside `y`.
struct StripeData {
  Eigen::ArrayXd y, trials, exceedances;
  double center = 0.0;
};

/// Log likelihood without ln C(n, k), of the probit.
double stripe_log_likelihood(const StripeData& data, const ProbitLine& line);
/// The same; observed information.
Evaluation stripe_likelihood(const StripeData& data, const ProbitLine& line,
                             Link link = Link::probit);
/// ... plus half the log determinant of the expected information, which is the information given
/// (Firth 1993, Biometrika 80(1):27-38).
Evaluation stripe_jeffreys(const StripeData& data, const ProbitLine& line);

/// What stripes allow (Silvapulle 1981, JRSS B 43(3):310-313: a maximum exists if and only if they
/// overlap). Not rising: the slope of the probit line would not be above 0.
enum class StripeShape {
  overlapping,
  separated,
  none_exceeded,
  all_exceeded,
  not_rising,
  single_level,
  empty
};
StripeShape shape_of(const StripeData& data);

/// Lognormal capacities with right-censoring, by their sufficient statistics: count, sum and sum of
/// squares of y.
struct CapacityData {
  double count = 0.0, sum = 0.0, sum_squares = 0.0;
  double censored = 0.0, censored_at = 0.0;  ///< the latter as y
  double center = 0.0;
};
/// Log likelihood without the constants of the data -sum(ln x) - count/2 ln(2 pi); observed
/// information.
Evaluation capacity_likelihood(const CapacityData& data, const ProbitLine& line);

}  // namespace glissade::fragility
