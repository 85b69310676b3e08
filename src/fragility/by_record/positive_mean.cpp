// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numeric>

#include "glissade/core/contract.hpp"
#include "glissade/core/distributions.hpp"
#include "glissade/core/finite.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {
namespace {

/// Of lognormal values with mean 1: Cox's interval of ln mean (Olsson 2005, J. Statistics Education
/// 13(1)).
Interval cox_interval(const std::vector<double>& values, double t) {
  const auto n = static_cast<double>(values.size());
  double mean = 0.0, variance = 0.0;
  for (const double v : values) mean += std::log(v) / n;
  for (const double v : values) variance += std::pow(std::log(v) - mean, 2) / (n - 1);
  const double reach = t * std::sqrt(variance / n + variance * variance / (2 * (n - 1)));
  return {mean + 0.5 * variance - reach, mean + 0.5 * variance + reach};
}

}  // namespace

Interval positive_mean_interval(const std::vector<double>& values, double level) {
  GLISSADE_EXPECTS(std::ranges::all_of(values, [](double v) { return v >= 0; }));
  if (values.size() < 2 || std::ranges::count(values, infinity) > 0) return {};
  const auto [least, largest] = std::ranges::minmax(values);
  if (least == largest) return {least, least};
  const auto n = static_cast<double>(values.size());
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / n;
  std::vector<double> scaled, excess;
  double squares = 0.0;
  for (const double v : values) {
    scaled.push_back(v / mean);
    excess.push_back((v - least) / mean);
    squares += std::pow(v / mean - 1.0, 2);
  }
  const auto t = [&](double freedom) { return student_quantile(freedom, 0.5 + 0.5 * level); };
  const double error = std::sqrt(squares / (n - 1) / n), fixed = least / mean,
               reach = t(std::max(2.0, effective_number(excess) - 1)) * error;
  double low = -reach, high = std::log(fixed + (1.0 - fixed) * std::exp(reach / (1.0 - fixed)));
  if (fixed > 1e-6 && n > 4 && std::ranges::count(values, least) == 1) {
    const Interval cox = cox_interval(scaled, t(n - 1));
    low = std::min(low, std::max(cox.low, 3.0 * low));
    high = std::max(high, std::min(cox.high, 3.0 * high));
  }
  return {mean * std::exp(low), mean * std::exp(high)};
}

}  // namespace glissade
