// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// The slips of all records and samples at one level. Records are the independent unit of the
/// intervals (95 %).
class PooledLevel {
 public:
  /// @param slips_m by record, then by sample; every record has as many samples, but for quantiles,
  /// to which a record may bring any number or none
  explicit PooledLevel(std::vector<std::vector<double>> slips_m);

  double quantile_m(double probability) const;  ///< of all slips; Hyndman & Fan (1996) type 7
  double mean_m() const;
  double share_above(double slip_m) const;

  Interval mean_interval() const;
  Interval share_interval(double slip_m) const;
  /// Of share_above, never narrower than that of a binomial with one trial for each record.
  Interval wide_share_interval(double slip_m) const;
  /// Of the slip that is exceeded with a probability: the slips of which that probability is
  /// within wide_share_interval. Infinite at its end where the records are too few to bound it: of
  /// the 84th percentile fewer than 22, of the median fewer than 6.
  Interval exceeded_interval(double probability) const;

 private:
  std::vector<double> sorted_;
  std::vector<double> record_means_;
  std::vector<std::vector<double>> by_record_;  // sorted; those that have any
};

/// The displacements of some cases at a level, or another field of the histories.
PooledLevel pooled_at(
    const HistoryTable& histories, CaseSlice cases, std::size_t level,
    HistoryValues<double> HistoryFields::*field = &HistoryFields::peak_displacement_m);

}  // namespace glissade
