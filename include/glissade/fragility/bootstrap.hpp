// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade {

/// What one record (with all its samples and stripes) contributes. Records are the independent
/// unit.
struct RecordStripes {
  std::vector<double> exceedances;  ///< per level
  std::vector<double> trials;       ///< per level
  double free = 0.0;                ///< histories beside them that exceed without shaking
};
struct RecordCapacities {
  std::vector<double> capacities;  ///< > 0
  double censored = 0.0;
  double free = 0.0;  ///< histories beside them of capacity 0
};

struct BootstrapOptions {
  std::uint64_t seed = 1;
  int replicates = 1000;  ///< >= 100
  double level = 0.95;    ///< in (0, 1)
};

/// Pooled maximum likelihood. Intervals are ranges over the lines that the data allow, by the
/// likelihood scaled by the variance between records (theory.md, 6.3); with one history of each
/// record they are those of independent data. Separated data (the records do not show how much they
/// differ), identical records and one record: no interval (NaN). No exceedance in any record: a
/// bound with one trial per record and level. The share of `free` histories is the curve's floor,
/// with the interval of a share (share.hpp), or none where it is the same in all records (slope and
/// friction decide it, which records share); p50 and `band` are then wider than 95 %. `band` (if
/// not null) receives, per given intensity, the pointwise interval of the probability (NaN where
/// there is none): both ends rise with intensity, and cross 1/2 where p50_interval ends. Throws
/// InputError for counts or capacities out of range.
FitSummary fit_stripes_by_record(const std::vector<double>& intensities,
                                 const std::vector<RecordStripes>& records,
                                 const std::vector<double>& band_intensities = {},
                                 std::vector<Interval>* band = nullptr);

/// The same for capacities; the point estimate is that of fit_capacities() on all of them.
FitSummary fit_capacities_by_record(const std::vector<RecordCapacities>& records,
                                    double censored_at,
                                    const std::vector<double>& band_intensities = {},
                                    std::vector<Interval>* band = nullptr);

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

/// Interval of the mean of records' values, 0 or more and finite, that may be skewed as rates are:
/// from the lowest end to the highest of the expanded percentile interval, Cox's of lognormal
/// values (Land 1972, Technometrics 14(1):145-158) and the bootstrap-t of the logarithm, the last
/// at most 1.5 times as far out as Cox's (theory.md, 6.5). NaN for fewer than two records.
Interval positive_mean_interval(const std::vector<double>& values, const BootstrapOptions& options);

}  // namespace glissade
