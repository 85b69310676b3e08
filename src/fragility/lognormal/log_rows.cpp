// SPDX-License-Identifier: GPL-3.0-or-later
#include "lognormal/log_rows.hpp"

#include <algorithm>
#include <cmath>

#include "glissade/core/finite.hpp"

namespace glissade::fragility {

void LogRows::add_counts(double y, double exceeding, double held) {
  CutWeight& cut = cuts[y];
  cut.exceeding += exceeding;
  cut.held += held;
}

void LogRows::add_bracket(double low, double high, double weight) {
  if (low == high) {
    exact.count += weight;
    exact.sum += weight * low;
    exact.sum_squares += weight * low * low;
    exact.least = std::min(exact.least, low);
    exact.greatest = std::max(exact.greatest, low);
  } else if (std::isinf(low)) {
    add_counts(high, weight, 0.0);
  } else if (std::isinf(high)) {
    add_counts(low, 0.0, weight);
  } else {
    between[{low, high}] += weight;
  }
}

void LogRows::scale(double factor) {
  for (double* of : {&exact.count, &exact.sum, &exact.sum_squares}) *of *= factor;
  for (auto& [y, cut] : cuts) cut = {factor * cut.exceeding, factor * cut.held};
  for (auto& [ends, weight] : between) weight *= factor;
}

LogRows& LogRows::operator+=(const LogRows& other) {
  exact.count += other.exact.count;
  exact.sum += other.exact.sum;
  exact.sum_squares += other.exact.sum_squares;
  exact.least = std::min(exact.least, other.exact.least);
  exact.greatest = std::max(exact.greatest, other.exact.greatest);
  for (const auto& [y, cut] : other.cuts) add_counts(y, cut.exceeding, cut.held);
  for (const auto& [ends, weight] : other.between) between[ends] += weight;
  return *this;
}

double LogRows::highest_low() const {
  double highest = exact.greatest;
  for (const auto& [y, cut] : cuts)
    if (cut.held > 0) highest = std::max(highest, y);
  for (const auto& [ends, weight] : between) highest = std::max(highest, ends.first);
  return highest;
}

double LogRows::lowest_high() const {
  double lowest = exact.least;
  for (const auto& [y, cut] : cuts)
    if (cut.exceeding > 0) lowest = std::min(lowest, y);
  for (const auto& [ends, weight] : between) lowest = std::min(lowest, ends.second);
  return lowest;
}

Interval LogRows::range() const {
  Interval range{exact.least, exact.greatest};
  const auto widen = [&](double low, double high) {
    range = {std::min(range.low, low), std::max(range.high, high)};
  };
  for (const auto& [y, cut] : cuts) widen(y, y);
  for (const auto& [ends, weight] : between) widen(ends.first, ends.second);
  return range;
}

double mean_log(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += std::log(value);
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

}  // namespace glissade::fragility
