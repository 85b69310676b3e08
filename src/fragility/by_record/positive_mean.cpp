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
/// 13(1)). @param parts of the values in the mean, times their number
Interval cox_interval(const std::vector<double>& values, const std::vector<double>& parts,
                      double t) {
  const auto n = static_cast<double>(values.size());
  double mean = 0.0, variance = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) mean += parts[i] * std::log(values[i]) / n;
  for (std::size_t i = 0; i < values.size(); ++i)
    variance += parts[i] * std::pow(std::log(values[i]) - mean, 2) / (n - 1);
  const double worth = effective_number(parts);
  const double reach = t * std::sqrt(variance / worth + variance * variance / (2 * (worth - 1)));
  return {mean + 0.5 * variance - reach, mean + 0.5 * variance + reach};
}

}  // namespace

Interval positive_mean_interval(const std::vector<double>& values, double level) {
  return positive_mean_interval(UnitValues(values), level);
}

Interval positive_mean_interval(const UnitValues& units, double level) {
  const std::vector<double>& values = units.means;
  GLISSADE_EXPECTS(std::ranges::all_of(values, [](double v) { return v >= 0; }));
  if (values.size() < 2 || std::ranges::count(values, infinity) > 0) return {};
  const auto [least, largest] = std::ranges::minmax(values);
  if (least == largest) return {least, least};
  const auto n = static_cast<double>(values.size());
  const double records = std::accumulate(units.records.begin(), units.records.end(), 0.0);
  std::vector<double> parts, scaled, excess;
  for (const double of_unit : units.records) parts.push_back(of_unit / (records / n));
  const double mean = std::inner_product(parts.begin(), parts.end(), values.begin(), 0.0) / n;
  double squares = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    scaled.push_back(values[i] / mean);
    excess.push_back(parts[i] * (values[i] - least) / mean);
    squares += std::pow(parts[i] * (values[i] / mean - 1.0), 2);
  }
  const auto t = [&](double freedom) { return student_quantile(freedom, 0.5 + 0.5 * level); };
  const double error = std::sqrt(squares / (n - 1) / n), fixed = least / mean,
               reach = t(std::max(2.0, effective_number(excess) - 1)) * error;
  double low = -reach, high = std::log(fixed + (1.0 - fixed) * std::exp(reach / (1.0 - fixed)));
  if (fixed > 1e-6 && n > 4 && std::ranges::count(values, least) == 1) {
    const Interval cox = cox_interval(scaled, parts, t(effective_number(parts) - 1));
    low = std::min(low, std::max(cox.low, 3.0 * low));
    high = std::max(high, std::min(cox.high, 3.0 * high));
  }
  return {mean * std::exp(low), mean * std::exp(high)};
}

}  // namespace glissade
