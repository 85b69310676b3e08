// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Dense>

#include "lognormal/log_rows.hpp"

// The likelihoods in probit form, z = b0 + b1 y with y = ln x - center, in which they are concave;
// so b0 = (center - ln median) / log_std and b1 = 1 / log_std.
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

/// Log likelihood of rows, up to a constant of theirs: k ln Phi(z) + (n - k) ln Phi(-z) of counts,
/// ln(b1) - z^2/2 of a capacity that is known exactly, ln[Phi(z_high) - Phi(z_low)] of a bracket
/// (concave: Burridge 1981, J. Royal Statistical Society B 43(1):41-45). Observed information. Of a
/// link other than the probit counts alone.
Evaluation likelihood(const LogRows& rows, const ProbitLine& line, Link link = Link::probit);

/// Of more than 2,000 rows those whose z differ by less than about 0.01 at `line` are summed at
/// their mean. Near the line, differences of the likelihood are kept to about 1e-5 of a standard
/// error for each root of their number: for intervals, whose time then does not grow with the rows.
LogRows summed(const LogRows& rows, const ProbitLine& line);

/// That of counts, plus half the log determinant of the expected information, which is the
/// information given (Firth 1993, Biometrika 80(1):27-38).
Evaluation jeffreys_likelihood(const LogRows& rows, const ProbitLine& line);

/// What rows allow (Silvapulle 1981, JRSS B 43(3):310-313: a maximum exists if and only if they
/// overlap). Separated: one intensity is in every bracket. Not rising: the slope of the probit line
/// of counts would not be above 0.
enum class RowsShape {
  overlapping,
  exact,
  separated,
  none_exceeded,
  all_exceeded,
  not_rising,
  single_level,
  empty
};
RowsShape shape_of(const LogRows& rows);

}  // namespace glissade::fragility
