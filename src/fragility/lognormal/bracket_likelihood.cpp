// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/bracket_likelihood.hpp"

#include <cmath>
#include <numbers>

#include "glissade/core/finite.hpp"

namespace glissade::fragility {
namespace {

Evaluation exact(double y, const ProbitLine& line) {
  const Eigen::Vector2d x{1, y};
  const double z = line.dot(x), b1 = line[1];
  Evaluation of;
  if (!(b1 > 0)) return {-infinity, of.gradient, of.information};
  of.value = std::log(b1) - 0.5 * z * z - 0.5 * std::log(2 * std::numbers::pi);
  of.gradient = -z * x + Eigen::Vector2d{0, 1 / b1};
  of.information = x * x.transpose();
  of.information(1, 1) += 1 / (b1 * b1);
  return of;
}

/// ln[Phi(high) - Phi(low)], in the tail where both are small.
double log_between(double low, double high) {
  if (low > 0) return log_between(-high, -low);
  const double above = log_normal_cdf(high), below = log_normal_cdf(low);
  return above + std::log1p(-std::exp(below - above));
}

}  // namespace

Evaluation bracket_likelihood(const LogBracket& bracket, const ProbitLine& line) {
  if (bracket.low == bracket.high) return exact(bracket.low, line);
  const bool has_low = std::isfinite(bracket.low), has_high = std::isfinite(bracket.high);
  if (!has_low && !has_high) return {};
  const Eigen::Vector2d at_low{1, has_low ? bracket.low : 0},
      at_high{1, has_high ? bracket.high : 0};
  Evaluation of;
  if (!has_low || !has_high) {
    const Eigen::Vector2d x = has_high ? at_high : Eigen::Vector2d(-at_low);
    const LogShares::Part part = log_shares(Link::probit, line.dot(x)).above;
    return {part.value, part.hazard * x, part.curvature * x * x.transpose()};
  }
  const double low = line.dot(at_low), high = line.dot(at_high);
  if (!(low < high)) return {-infinity, of.gradient, of.information};
  of.value = log_between(low, high);
  const auto density_over = [&](double z) {
    return std::exp(-0.5 * z * z - 0.5 * std::log(2 * std::numbers::pi) - of.value);
  };
  const double d_low = density_over(low), d_high = density_over(high);
  of.gradient = d_high * at_high - d_low * at_low;
  of.information = d_high * high * at_high * at_high.transpose() -
                   d_low * low * at_low * at_low.transpose() +
                   of.gradient * of.gradient.transpose();
  return of;
}

}  // namespace glissade::fragility
