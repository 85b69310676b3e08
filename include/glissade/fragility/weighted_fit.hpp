// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/fragility/two_part.hpp"

// Fits of rows that have a weight each (importance sampling) and belong to records, the clusters.
// The weighted likelihood sum w l is maximised, with weights that sum to the effective number of
// rows, (sum w)^2 / sum w^2 (Kish 1965, Survey Sampling): the unit of the weights has no effect, and
// equal weights give the fit without weights. Intervals as without weights, of as many records as
// their weights are worth. Rows of weight 0 play no part. All throw InputError for weights that are
// negative or all 0, and for counts or capacities out of range.
namespace glissade {

struct WeightedStripe {
  Stripe stripe;
  double weight = 1.0;
  std::size_t record = 0;
};

/// A capacity above `low` and not above `high`; exact where they are equal. low = 0: reached by the
/// first level; high infinite: not reached by `low`, the highest level of this record. Both 0: the
/// history slides freely.
struct CapacityBracket {
  double low = 0.0, high = std::numeric_limits<double>::infinity();
  double weight = 1.0;
  std::size_t record = 0;
};

struct CloudPoint {
  double intensity = 0.0, displacement = 0.0;  ///< > 0; 0 or more
  double weight = 1.0;
  std::size_t record = 0;
};

/// `summary.effective_records` is (sum W)^2 / sum W^2 over the records' weights W, where weights
/// differ.
FitSummary fit_weighted_stripes(const std::vector<WeightedStripe>& rows);

/// Lognormal maximum likelihood with ln[Phi(z_high) - Phi(z_low)] of each bracket; where all are
/// exact, log_std has n - 1 below the line. `independent`: each row is a record of its own. All
/// above: lower_bound. All not above: upper_bound. All exact and equal: one_capacity, the median.
/// Else one_level, where one intensity is in every bracket, so that log_std would be 0. Rows from 0
/// to infinity say nothing: they are left out, and the note counts them; no_information if no others
/// are left.
FitSummary fit_brackets(const std::vector<CapacityBracket>& rows, bool independent);

/// A displacement's fragility by a cloud: the intensity at which half exceed it.
struct CloudMedian {
  double threshold = 0.0, p50 = std::numeric_limits<double>::quiet_NaN();
  Interval p50_interval;
};

/// Intervals are over records (theory.md, 6.9): those of the size of slip by the jackknife, with
/// Student's t of the records that slip less 2; of any slip by the profile likelihood. They are NaN
/// where fewer than two records have weight, or one record decides the part.
struct CloudSummary {
  TwoPartFit fit;
  Interval any_median_interval, any_log_std_interval;
  Interval intercept_interval, slope_interval, log_std_interval;
  std::vector<CloudMedian> medians;
  double effective_records = std::numeric_limits<double>::quiet_NaN();
};

/// The two-part model of a cloud of points; thresholds > 0.
CloudSummary fit_cloud(const std::vector<CloudPoint>& points,
                       const std::vector<double>& thresholds);

}  // namespace glissade
