// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade {

/// The interval of a probability from each record's share of the histories that exceed, by their
/// mean: that of Clopper & Pearson (1934) for as many independent trials as the variance between
/// records is worth, p (1 - p) / v, less Student's factor (z/t)^2 (Korn & Graubard 1998, Survey
/// Methodology 24(2):193-201). The degrees of freedom of v are few where few records exceed: those
/// of t are (sum s)^2 / sum s^2 of the shares s, or of 1 - s, at most n - 1. Without Student's
/// factor where that leaves fewer trials than records. The lower end is 0 where less than one of
/// these trials exceeds. Where all shares are equal the interval is that share; where they are all
/// 0 or 1 each record is one trial. NaN for fewer than two records.
Interval share_interval(const std::vector<double>& shares, double level = 0.95);

/// Widens intervals of shares, so that those of larger shares do not end lower.
void order_intervals(const std::vector<double>& shares, std::vector<Interval>& intervals);

/// The interval of a probability, at least as wide as a binomial's where none, or all, of as many
/// trials as there are records exceed (Clopper & Pearson 1934). Without an interval that of the
/// probability itself is widened.
Interval widened(const Interval& interval, double probability, std::size_t records);

}  // namespace glissade
