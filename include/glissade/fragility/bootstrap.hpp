// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade {

struct BootstrapOptions {
  std::uint64_t seed = 1;
  int replicates = 1000;  ///< >= 100
  double level = 0.95;    ///< in (0, 1)
};

/// Interval of any statistic of records: `statistic(weights)` with weights[i] = how often record i
/// was drawn. Expanded percentile: widened for few records (Hesterberg 2015, The American
/// Statistician 69(4):371-386). Infinite values are allowed, NaNs left out. NaN for fewer than two
/// records.
Interval bootstrap_interval(std::size_t records,
                            const std::function<double(const std::vector<double>&)>& statistic,
                            const BootstrapOptions& options);

/// Those of `count` statistics from the same resamples: the same intervals, one pass.
std::vector<Interval> bootstrap_intervals(
    std::size_t records, std::size_t count,
    const std::function<std::vector<double>(const std::vector<double>&)>& statistics,
    const BootstrapOptions& options);

}  // namespace glissade
