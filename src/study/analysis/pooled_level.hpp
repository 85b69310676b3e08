// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "glissade/fragility/share.hpp"
#include "glissade/study/results.hpp"

namespace glissade {

/// The slips of all records and samples at one level, by the independent units of the intervals
/// (95 %): events or records.
class PooledLevel {
 public:
  /// @param slips_m by unit, then by record and sample; every record has as many samples, but for
  /// quantiles, to which a record may bring any number or none
  /// @param units effective number, for wide_share_interval(); 0: all that have slips
  explicit PooledLevel(std::vector<std::vector<double>> slips_m, double units = 0.0);

  double quantile_m(double probability) const;  ///< of all slips; Hyndman & Fan (1996) type 7
  double mean_m() const;
  double share_above(double slip_m) const;

  Interval mean_interval() const;
  Interval share_interval(double slip_m) const;
  /// Of share_above, never narrower than that of a binomial with one trial for each unit.
  Interval wide_share_interval(double slip_m) const;
  /// Of the slip that is exceeded with a probability: the slips of which that probability is
  /// within wide_share_interval. Infinite at its end where the units are too few to bound it: of
  /// the 84th percentile fewer than 22, of the median fewer than 6.
  Interval exceeded_interval(double probability) const;

 private:
  double units_;
  std::vector<double> sorted_;
  UnitValues means_;  // with parts of all slips in place of numbers of records
  std::vector<std::vector<double>> by_unit_;  // sorted; those that have any
};

/// The displacements of some cases at a level, or another field of the histories.
PooledLevel pooled_at(
    const HistoryTable& histories, CaseSlice cases, std::size_t level,
    HistoryValues<double> HistoryFields::*field = &HistoryFields::peak_displacement_m);

}  // namespace glissade
