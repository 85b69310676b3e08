// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade {

/// What one record (with all its samples and stripes) contributes. Records are the independent unit.
struct RecordStripes {
  std::vector<double> exceedances;  ///< per level
  std::vector<double> trials;       ///< per level
};
struct RecordCapacities {
  std::vector<double> capacities;   ///< > 0
  double censored = 0.0;
};

struct BootstrapOptions {
  std::uint64_t seed = 1;
  int replicates = 1000;   ///< >= 100
  double level = 0.95;
};

/// Pooled maximum likelihood, with intervals from resampling whole records: percentiles widened for few records
/// (Hesterberg 2015, The American Statistician 69(4):371-386, expanded percentile). The naive binomial interval would cover
/// a small fraction of its nominal level (statistics.md). `band` (if not null) receives, per given intensity, the
/// pointwise 95 % interval of the probability.
FitSummary fit_stripes_by_record(const std::vector<double>& intensities, const std::vector<RecordStripes>& records,
                                 const BootstrapOptions& options, const std::vector<double>& band_intensities = {},
                                 std::vector<Interval>* band = nullptr);

FitSummary fit_capacities_by_record(const std::vector<RecordCapacities>& records, double censored_at,
                                    const BootstrapOptions& options,
                                    const std::vector<double>& band_intensities = {},
                                    std::vector<Interval>* band = nullptr);

/// Interval of any statistic of records: `statistic(weights)` with weights[i] = how often record i was drawn.
Interval bootstrap_interval(std::size_t records, const std::function<double(const std::vector<double>&)>& statistic,
                            const BootstrapOptions& options);

}  // namespace glissade
