// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/sampling/normality.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <numbers>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/normal.hpp"

namespace glissade {
namespace {

double polynomial(std::initializer_list<double> rising_powers, double x) {
  double sum = 0.0;
  for (auto c = std::rbegin(rising_powers); c != std::rend(rising_powers); ++c) sum = sum * x + *c;
  return sum;
}

/// Blom's expected order statistics of n standard normal values.
std::vector<double> normal_scores(std::size_t n) {
  std::vector<double> scores(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double share = (static_cast<double>(i) + 0.625) / (static_cast<double>(n) + 0.25);
    scores[i] = normal_quantile(share);
  }
  return scores;
}

/// The weights a, which increase, sum to 0 and have unit length: scaled scores, except the
/// outermost one (n > 5: two) on either side, which are polynomials in 1/sqrt(n).
std::vector<double> weights(std::size_t n) {
  if (n == 3) return {-std::numbers::sqrt2 / 2, 0.0, std::numbers::sqrt2 / 2};
  std::vector<double> a = normal_scores(n);
  const double length = std::sqrt(std::inner_product(a.begin(), a.end(), a.begin(), 0.0));
  const double u = 1.0 / std::sqrt(static_cast<double>(n));
  std::vector<double> outermost{
      a[n - 1] / length + polynomial({0, 0.221157, -0.147981, -2.07119, 4.434685, -2.706056}, u)};
  if (n > 5) {
    outermost.push_back(a[n - 2] / length +
                        polynomial({0, 0.042981, -0.293762, -1.752461, 5.682633, -3.582633}, u));
  }
  double scores_left = length * length, weights_left = 1.0;
  for (std::size_t i = 0; i < outermost.size(); ++i) {
    scores_left -= 2.0 * a[i] * a[i];
    weights_left -= 2.0 * outermost[i] * outermost[i];
  }
  for (double& weight : a) weight *= std::sqrt(weights_left / scores_left);
  for (std::size_t i = 0; i < outermost.size(); ++i) {
    a[i] = -outermost[i];
    a[n - 1 - i] = outermost[i];
  }
  return a;
}

/// 1 - W: the part of the variance of the ordered values that is orthogonal to the weights.
double variance_off_the_line(const std::vector<double>& sorted) {
  const std::vector<double> a = weights(sorted.size());
  // Scaled to the range, so that neither origin nor scale loses digits.
  const double origin = sorted.front(), range = sorted.back() - sorted.front();
  double mean = 0.0;
  for (const double x : sorted) mean += (x - origin) / range / static_cast<double>(sorted.size());
  double along = 0.0, all = 0.0, length = 0.0;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    const double x = (sorted[i] - origin) / range - mean;
    along += a[i] * x;
    all += x * x;
    length += a[i] * a[i];
  }
  return std::max(0.0, 1.0 - along * along / (all * length));
}

double upper_tail(double z) { return normal_cdf(-z); }

double p_value(double one_minus_w, double n) {
  if (n == 3) {
    const double smallest = std::asin(std::sqrt(0.75));
    return std::max(0.0,
                    6.0 / std::numbers::pi * (std::asin(std::sqrt(1.0 - one_minus_w)) - smallest));
  }
  const double y = std::log(one_minus_w);
  if (n <= 11) {
    const double largest = polynomial({-2.273, 0.459}, n);
    if (y >= largest) return 0.0;
    const double mean = polynomial({0.544, -0.39978, 0.025054, -0.0006714}, n);
    const double std = std::exp(polynomial({1.3822, -0.77857, 0.062767, -0.0020322}, n));
    return upper_tail((-std::log(largest - y) - mean) / std);
  }
  const double x = std::log(n);
  const double mean = polynomial({-1.5861, -0.31082, -0.083751, 0.0038915}, x);
  const double std = std::exp(polynomial({-0.4803, -0.082676, 0.0030302}, x));
  return upper_tail((y - mean) / std);
}

}  // namespace

ShapiroWilk shapiro_wilk(std::vector<double> values) {
  GLISSADE_EXPECTS(values.size() >= 3 && values.size() <= 5000);
  std::sort(values.begin(), values.end());
  GLISSADE_EXPECTS(values.front() < values.back());
  const double one_minus_w = variance_off_the_line(values);
  return {1.0 - one_minus_w, p_value(one_minus_w, static_cast<double>(values.size()))};
}

}  // namespace glissade
