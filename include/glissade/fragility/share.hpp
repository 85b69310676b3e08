// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "glissade/fragility/fit.hpp"

namespace glissade {

/// Values of records by their independent units (events, or the records themselves): the mean of
/// each unit, and how many records it has.
struct UnitValues {
  std::vector<double> means, records;

  UnitValues() = default;
  /// Each record is a unit.
  explicit UnitValues(const std::vector<double>& values)
      : means(values), records(values.size(), 1.0) {}
  /// @param unit_of by record
  UnitValues(const std::vector<double>& values, const std::vector<std::size_t>& unit_of);
};

/// The interval of a probability from each record's share of the histories that exceed, by their
/// mean: that of Clopper & Pearson (1934) for as many independent trials as the variance between
/// records is worth, p (1 - p) / v, less Student's factor (z/t)^2 (Korn & Graubard 1998, Survey
/// Methodology 24(2):193-201). The degrees of freedom of v are few where few records exceed: those
/// of t are (sum s)^2 / sum s^2 of the shares s, or of 1 - s, at most n - 1. Without Student's
/// factor where that leaves fewer trials than records. The lower end is 0 where less than one of
/// these trials exceeds. Where all shares are equal the interval is that share; where they are all
/// 0 or 1 each record is one trial. NaN for fewer than two records.
Interval share_interval(const std::vector<double>& shares, double level = 0.95);
/// Where units have different numbers of records, or records of histories, all above 0: of all.
Interval share_interval(const UnitValues& shares, double level = 0.95);

/// How many parts a sum effectively has, (sum p)^2 / sum p^2: n if all are equal, 1 if one is all
/// of it (Kish 1965, Survey Sampling). NaN where all are 0.
double effective_number(const std::vector<double>& parts);
double effective_number(const UnitValues& values);  ///< of the sums of units

/// Interval of the mean of records' values, 0 or more, that may be skewed: Student's t
/// of ln mean with the standard error s / sqrt(n), and with as many degrees of freedom as the
/// values less their least are effectively many, less 1, 2 at least. The upper end is that of the
/// values less their least. Either end is moved out to that of lognormal values (Cox's interval,
/// Land 1972, Technometrics 14(1):145-158), but to at most three times the distance from ln mean,
/// of five records or more of which one alone has the least value, above 1e-6 of the mean
/// (theory.md, 6.5). Covers 91 % or more of lognormal values up to a log standard deviation of 2.5
/// (7 records or more; verification manual, 5.2). NaN for fewer than two records, and where a value
/// is infinite.
Interval positive_mean_interval(const std::vector<double>& values, double level = 0.95);
/// Of the mean over records, whose units are independent: with s from the departures of the units,
/// each times its records over their mean number.
Interval positive_mean_interval(const UnitValues& values, double level = 0.95);

/// Widens intervals of shares, so that those of larger shares do not end lower.
void order_intervals(const std::vector<double>& shares, std::vector<Interval>& intervals);

/// From how many records on the value that is exceeded with a probability has an upper end: where
/// none exceeds it, that is 1 - 0.025^(1/n).
std::size_t records_that_bound(double probability);

/// The interval of a probability, at least as wide as a binomial's where none, or all, of as many
/// trials as there are (effective) units exceed (Clopper & Pearson 1934). Without an interval that
/// of the probability itself is widened.
Interval widened(const Interval& interval, double probability, double units);

}  // namespace glissade
