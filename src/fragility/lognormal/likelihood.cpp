// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/finite.hpp"
#include "lognormal/newton_maximum.hpp"

namespace glissade::fragility {
namespace {

/// ln Phi(z), with its derivative phi/Phi = `hazard` and minus its second derivative `curvature` =
/// hazard (z + hazard).
using LogPhi = LogShares::Part;
LogPhi log_phi(double z) {
  const double value = log_normal_cdf(z);
  const double log_density = -0.5 * z * z - 0.5 * std::log(2 * std::numbers::pi);
  const double hazard = std::exp(log_density - value);
  return {value, hazard, std::max(0.0, hazard * (z + hazard))};
}

/// ln of 1 / (1 + exp(-z)).
LogShares::Part log_logistic(double z) {
  const double rest = 1 / (1 + std::exp(z));
  return {z < 0 ? z - std::log1p(std::exp(z)) : -std::log1p(std::exp(-z)), rest, rest * (1 - rest)};
}

/// ln of 1 - exp(-w), w = exp(z).
LogShares::Part log_complementary(double z, double w) {
  if (w < 1e-300) return {z, 1, 0};
  const double hazard = w > 700 ? 0 : w / std::expm1(w);
  return {std::log(-std::expm1(-w)), hazard, std::max(0.0, hazard * (w / -std::expm1(-w) - 1))};
}

}  // namespace

LogShares log_shares(Link link, double z) {
  if (link == Link::probit) return {log_phi(z), log_phi(-z)};
  if (link == Link::logit) return {log_logistic(z), log_logistic(-z)};
  const double w = std::exp(std::min(z, 700.0));
  return {log_complementary(z, w), {-w, w, w}};
}

double share_at(Link link, double z) { return std::exp(log_shares(link, z).above.value); }

ProbitLine to_line(const FragilityCurve& curve, double center) {
  return {(center - std::log(curve.median)) / curve.log_std, 1 / curve.log_std};
}

FragilityCurve to_curve(const ProbitLine& line, double center) {
  return {std::exp(center - line[0] / line[1]), 1 / line[1]};
}

double hazard(double z) { return log_phi(z).hazard; }

std::optional<ProbitLine> maximise(const Objective& objective, const ProbitLine& start) {
  return newton_maximum(objective, start);
}

double stripe_log_likelihood(const StripeData& data, const ProbitLine& line) {
  double sum = 0;
  for (Eigen::Index j = 0; j < data.y.size(); ++j) {
    const double k = data.exceedances[j], rest = data.trials[j] - k;
    const double z = line.dot(Eigen::Vector2d{1, data.y[j]});
    if (k > 0) sum += k * log_normal_cdf(z);
    if (rest > 0) sum += rest * log_normal_cdf(-z);
  }
  return sum;
}

Evaluation stripe_likelihood(const StripeData& data, const ProbitLine& line, Link link) {
  Evaluation sum;
  for (Eigen::Index j = 0; j < data.y.size(); ++j) {
    const double k = data.exceedances[j], rest = data.trials[j] - k;
    const Eigen::Vector2d x{1, data.y[j]};
    const double z = line.dot(x);
    const auto [above, below] = log_shares(link, z);
    if (k > 0) sum.value += k * above.value;
    if (rest > 0) sum.value += rest * below.value;
    sum.gradient += (k * above.hazard - rest * below.hazard) * x;
    sum.information += (k * above.curvature + rest * below.curvature) * x * x.transpose();
  }
  return sum;
}

Evaluation stripe_jeffreys(const StripeData& data, const ProbitLine& line) {
  // Expected information per trial w = phi^2 / (Phi (1 - Phi)); d ln w / dz = -2 z - phi/Phi +
  // phi/(1 - Phi).
  Evaluation sum;
  for (Eigen::Index j = 0; j < data.y.size(); ++j) {
    const Eigen::Vector2d x{1, data.y[j]};
    const double z = line.dot(x);
    sum.information += data.trials[j] * log_phi(z).hazard * log_phi(-z).hazard * x * x.transpose();
  }
  const double determinant = sum.information.determinant();
  if (!(determinant > 0)) return {-infinity, sum.gradient, sum.information};
  const Eigen::Matrix2d covariance = sum.information.inverse();
  sum.value = 0.5 * std::log(determinant);
  for (Eigen::Index j = 0; j < data.y.size(); ++j) {
    const double k = data.exceedances[j], rest = data.trials[j] - k;
    const Eigen::Vector2d x{1, data.y[j]};
    const double z = line.dot(x);
    const LogPhi above = log_phi(z), below = log_phi(-z);
    if (k > 0) sum.value += k * above.value;
    if (rest > 0) sum.value += rest * below.value;
    const double leverage = data.trials[j] * above.hazard * below.hazard * x.dot(covariance * x);
    const double penalty = 0.5 * leverage * (-2 * z - above.hazard + below.hazard);
    sum.gradient += (k * above.hazard - rest * below.hazard + penalty) * x;
  }
  return sum;
}

namespace {

/// The likelihood is concave: its slope at the best line without one has the sign of b1 at the
/// maximum. There every level has the pooled share, and the slope is phi / (Phi (1 - Phi)) times
/// the sum below.
bool rises(const StripeData& data) {
  const double share = data.exceedances.sum() / data.trials.sum();
  const double slope = ((data.exceedances - share * data.trials) * data.y).sum();
  const double rounding = 1e-12 * (data.trials * data.y.abs()).sum();
  return slope > rounding;
}

}  // namespace

StripeShape shape_of(const StripeData& data) {
  double first_exceeded = infinity, last_exceeded = -infinity, first_held = infinity,
         last_held = -infinity;
  for (Eigen::Index j = 0; j < data.y.size(); ++j) {
    if (data.exceedances[j] > 0) {
      first_exceeded = std::min(first_exceeded, data.y[j]);
      last_exceeded = std::max(last_exceeded, data.y[j]);
    }
    if (data.exceedances[j] < data.trials[j]) {
      first_held = std::min(first_held, data.y[j]);
      last_held = std::max(last_held, data.y[j]);
    }
  }
  if (first_exceeded == infinity && first_held == infinity) return StripeShape::empty;
  if (first_exceeded == infinity) return StripeShape::none_exceeded;
  if (first_held == infinity) return StripeShape::all_exceeded;
  if (std::min(first_exceeded, first_held) == std::max(last_exceeded, last_held))
    return StripeShape::single_level;
  if (first_exceeded >= last_held) return StripeShape::separated;
  return rises(data) ? StripeShape::overlapping : StripeShape::not_rising;
}

Evaluation capacity_likelihood(const CapacityData& data, const ProbitLine& line) {
  // Each capacity: ln phi(z) + ln b1. Each censored history: ln Phi(-z) at the censoring intensity.
  const double b0 = line[0], b1 = line[1];
  Evaluation sum;
  if (!(b1 > 0)) return {-infinity, sum.gradient, sum.information};
  const double n = data.count, s = data.sum, ss = data.sum_squares;
  sum.value = n * std::log(b1) - 0.5 * (n * b0 * b0 + 2 * b0 * b1 * s + b1 * b1 * ss);
  sum.gradient = {-(n * b0 + b1 * s), n / b1 - (b0 * s + b1 * ss)};
  sum.information << n, s, s, ss + n / (b1 * b1);
  if (data.censored > 0) {
    const Eigen::Vector2d x{1, data.censored_at};
    const LogPhi below = log_phi(-line.dot(x));
    sum.value += data.censored * below.value;
    sum.gradient -= data.censored * below.hazard * x;
    sum.information += data.censored * below.curvature * x * x.transpose();
  }
  return sum;
}

}  // namespace glissade::fragility
