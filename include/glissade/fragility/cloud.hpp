// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

#include "glissade/fragility/two_part.hpp"

namespace glissade {

struct CloudPoint {
  double intensity = 0.0, displacement = 0.0;  ///< > 0; 0 or more; infinite: collapse
  double weight = 1.0;
  std::size_t record = 0;
};

/// A displacement's fragility by a cloud: the intensity at which half exceed it, or collapse.
struct CloudMedian {
  double threshold = 0.0, p50 = std::numeric_limits<double>::quiet_NaN();
  Interval p50_interval;
};

/// Intervals are over records (theory.md, 6.9): those of the size of slip by the jackknife, with
/// Student's t of the records that slip less 2; of any slip by the profile likelihood. They are NaN
/// where fewer than two records have weight, or one record decides the part.
struct CloudSummary {
  TwoPartFit fit;                      ///< of the rows that do not collapse
  std::optional<FitSummary> collapse;  ///< probability of an infinite displacement, where any is
  Interval any_median_interval, any_log_std_interval;
  Interval intercept_interval, slope_interval, log_std_interval;
  std::vector<CloudMedian> medians;
  double effective_records = std::numeric_limits<double>::quiet_NaN();
};

/// The two-part model of a cloud of points; thresholds > 0. Where displacements are infinite, which
/// exceeds every threshold, P = P(collapse) + (1 - P(collapse)) P(two parts), the first a lognormal
/// of all rows. Without a maximum of its likelihood there is no p50.
CloudSummary fit_cloud(const std::vector<CloudPoint>& points,
                       const std::vector<double>& thresholds);

}  // namespace glissade
