// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {

namespace {

/// Where a quantile lies among n sorted values (Hyndman & Fan 1996, type 7).
struct SortedPlace {
  std::size_t below;
  double share;
};

SortedPlace place_of(std::size_t n, double probability) {
  const double position = probability * static_cast<double>(n - 1);
  const auto below = static_cast<std::size_t>(position);
  return {below, position - static_cast<double>(below)};
}

double between(double low, double high, double share) {
  return std::isinf(high) ? high : low + share * (high - low);
}

}  // namespace

double quantile_of_sorted(std::span<const double> sorted, double probability) {
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto [below, share] = place_of(sorted.size(), probability);
  return share == 0.0 ? sorted[below] : between(sorted[below], sorted[below + 1], share);
}

double quantile_of(std::vector<double> values, double probability) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto [below, share] = place_of(values.size(), probability);
  const auto low = values.begin() + static_cast<std::ptrdiff_t>(below);
  std::nth_element(values.begin(), low, values.end());
  return share == 0.0 ? *low : between(*low, *std::min_element(low + 1, values.end()), share);
}

}  // namespace glissade
