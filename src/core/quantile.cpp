// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/core/quantile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade {

double quantile_of_sorted(std::span<const double> sorted, double probability) {
  if (sorted.empty()) return std::numeric_limits<double>::quiet_NaN();
  const double position = probability * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(position);
  const double low = sorted[below], share = position - static_cast<double>(below);
  if (share == 0.0) return low;
  const double high = sorted[below + 1];
  return std::isinf(high) ? high : low + share * (high - low);
}

double quantile_of(std::vector<double> values, double probability) {
  std::sort(values.begin(), values.end());
  return quantile_of_sorted(values, probability);
}

}  // namespace glissade
