// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/likelihood.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "glissade/core/finite.hpp"

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

Evaluation of_exact(const ExactRows& rows, const ProbitLine& line) {
  const double b0 = line[0], b1 = line[1];
  const double n = rows.count, s = rows.sum, ss = rows.sum_squares;
  Evaluation of;
  of.value = n * std::log(b1) - 0.5 * (n * b0 * b0 + 2 * b0 * b1 * s + b1 * b1 * ss);
  of.gradient = {-(n * b0 + b1 * s), n / b1 - (b0 * s + b1 * ss)};
  of.information << n, s, s, ss + n / (b1 * b1);
  return of;
}

/// Of a bracket of y with two ends.
Evaluation of_bracket(double y_low, double y_high, const ProbitLine& line) {
  const Eigen::Vector2d at_low{1, y_low}, at_high{1, y_high};
  const double low = line.dot(at_low), high = line.dot(at_high);
  Evaluation of;
  of.value = log_normal_between(low, high);
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

Evaluation likelihood(const LogRows& rows, const ProbitLine& line, Link link) {
  Evaluation sum;
  if (!rows.has_only_cuts() && !(line[1] > 0)) {
    sum.value = -infinity;
    return sum;
  }
  if (rows.exact.count > 0) sum = of_exact(rows.exact, line);
  for (const auto& [y, cut] : rows.cuts) {
    const Eigen::Vector2d x{1, y};
    const auto [above, below] = log_shares(link, line.dot(x));
    if (cut.exceeding > 0) sum.value += cut.exceeding * above.value;
    if (cut.held > 0) sum.value += cut.held * below.value;
    sum.gradient += (cut.exceeding * above.hazard - cut.held * below.hazard) * x;
    sum.information +=
        (cut.exceeding * above.curvature + cut.held * below.curvature) * x * x.transpose();
  }
  for (const auto& [ends, weight] : rows.between) {
    const Evaluation one = of_bracket(ends.first, ends.second, line);
    sum.value += weight * one.value;
    sum.gradient += weight * one.gradient;
    sum.information += weight * one.information;
  }
  return sum;
}

LogRows summed(const LogRows& rows, const ProbitLine& line) {
  constexpr std::size_t many = 2000;
  constexpr double width = 0.01, far = 4;  // where z is large the cells are wider
  if (rows.cuts.size() + rows.between.size() <= many) return rows;
  const auto cell = [&](double y) {
    return std::floor(far / width * std::asinh((line[0] + line[1] * y) / far));
  };
  struct Sum {
    CutWeight weight;
    double low = 0, high = 0;
  };
  std::map<std::pair<double, double>, Sum> cuts, between;
  for (const auto& [y, cut] : rows.cuts) {
    Sum& sum = cuts[{cell(y), 0}];
    sum.weight.exceeding += cut.exceeding;
    sum.weight.held += cut.held;
    sum.low += cut.trials() * y;
  }
  for (const auto& [ends, weight] : rows.between) {
    Sum& sum = between[{cell(ends.first), cell(ends.second)}];
    sum.weight.held += weight;
    sum.low += weight * ends.first;
    sum.high += weight * ends.second;
  }
  LogRows all{rows.center, rows.exact};
  for (const auto& [at, sum] : cuts)
    all.add_counts(sum.low / sum.weight.trials(), sum.weight.exceeding, sum.weight.held);
  for (const auto& [at, sum] : between)
    all.add_bracket(sum.low / sum.weight.held, sum.high / sum.weight.held, sum.weight.held);
  return all;
}

Evaluation jeffreys_likelihood(const LogRows& rows, const ProbitLine& line) {
  // Expected information per trial w = phi^2 / (Phi (1 - Phi)); d ln w / dz = -2 z - phi/Phi +
  // phi/(1 - Phi).
  Evaluation sum = likelihood(rows, line);
  const auto information_at = [&](double z) { return hazard(z) * hazard(-z); };
  sum.information.setZero();
  for (const auto& [y, cut] : rows.cuts) {
    const Eigen::Vector2d x{1, y};
    sum.information += cut.trials() * information_at(line.dot(x)) * x * x.transpose();
  }
  const double determinant = sum.information.determinant();
  if (!(determinant > 0)) {
    sum.value = -infinity;
    return sum;
  }
  const Eigen::Matrix2d covariance = sum.information.inverse();
  sum.value += 0.5 * std::log(determinant);
  for (const auto& [y, cut] : rows.cuts) {
    const Eigen::Vector2d x{1, y};
    const double z = line.dot(x);
    const double leverage = cut.trials() * information_at(z) * x.dot(covariance * x);
    sum.gradient += 0.5 * leverage * (-2 * z - hazard(z) + hazard(-z)) * x;
  }
  return sum;
}

namespace {

/// The likelihood is concave: its slope at the best line without one has the sign of b1 at the
/// maximum. There every level has the pooled share, and the slope is phi / (Phi (1 - Phi)) times
/// the sum below.
bool rises(const std::map<double, CutWeight>& cuts) {
  double exceeding = 0, trials = 0, slope = 0, size = 0;
  for (const auto& [y, cut] : cuts) {
    exceeding += cut.exceeding;
    trials += cut.trials();
    size += cut.trials() * std::abs(y);
  }
  for (const auto& [y, cut] : cuts)
    slope += (cut.exceeding - exceeding / trials * cut.trials()) * y;
  return slope > 1e-12 * size;  // but for rounding
}

}  // namespace

RowsShape shape_of(const LogRows& rows) {
  const double held = rows.highest_low(), exceeded = rows.lowest_high();
  if (std::isinf(held) && std::isinf(exceeded)) return RowsShape::empty;
  if (std::isinf(exceeded)) return RowsShape::none_exceeded;
  if (std::isinf(held)) return RowsShape::all_exceeded;
  if (rows.is_exact()) return RowsShape::exact;
  if (!rows.has_only_cuts())
    return held <= exceeded ? RowsShape::separated : RowsShape::overlapping;
  const auto levels =
      std::ranges::count_if(rows.cuts, [](const auto& at) { return at.second.trials() > 0; });
  if (levels == 1) return RowsShape::single_level;
  if (held <= exceeded) return RowsShape::separated;
  return rises(rows.cuts) ? RowsShape::overlapping : RowsShape::not_rising;
}

}  // namespace glissade::fragility
