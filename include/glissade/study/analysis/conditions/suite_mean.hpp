// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "glissade/fragility/fit.hpp"
#include "glissade/study/analysis/conditions/condition_grid.hpp"

// What is read from the histories by condition: means over a suite, what is largest over the
// building periods, and what the orientations make of it. Records are the independent unit.
namespace glissade {

/// Which of the orientations of the records a required clearance is of: the largest, or the median,
/// as Walters et al. (2012) take it.
enum class OrientationRule { largest, median };
/// "largest", "median".
const char* to_string(OrientationRule rule);

enum class HistoryNumber {
  displacement,  ///< m, by the study's DisplacementMeasure
  vector_peak,   ///< m, the largest length of the displacement, whatever the measure
  base_shear,    ///< over the building's weight without the array
};

/// Of which histories.
struct MeanQuestion {
  std::size_t suite = 0;
  HistoryNumber number = HistoryNumber::displacement;
  std::optional<SlopeAxis> slope_axis;  ///< nothing: both
};

double number_of(HistoryNumber number, const ConditionHistory& history);

/// Positions of the suite's records and of the orientations required.
std::vector<std::size_t> records_of(const Results& results, std::size_t suite);
std::vector<std::size_t> orientations_of(const Results& results, const MeanQuestion& question);

/// The suite's mean at one condition, all records in one orientation.
double suite_mean(const Results& results, const MeanQuestion& question, std::size_t orientation,
                  const Condition& at);

/// One building period, or the largest suite mean over all of them.
enum class Periods { one, largest };

/// The suite's mean, in each orientation of all records alike: one number by orientation, in the
/// order of orientations_of().
std::vector<double> means_by_orientation(const Results& results, const MeanQuestion& question,
                                         const Condition& at, Periods periods);

/// What a rule takes of the means by orientation.
double mean_by(OrientationRule rule, const std::vector<double>& means);

struct OrientationRange {
  double lowest = 0.0, median = 0.0, highest = 0.0;
  Interval interval;          ///< 95 % of the median, over records; NaN for one record
  Interval highest_interval;  ///< the same of the highest

  double of(OrientationRule rule) const {
    return rule == OrientationRule::largest ? highest : median;
  }
  const Interval& interval_of(OrientationRule rule) const {
    return rule == OrientationRule::largest ? highest_interval : interval;
  }
};
/// Those, summed up.
OrientationRange over_orientations(const Results& results, const MeanQuestion& question,
                                   const Condition& at, Periods periods);

/// Where on the period axis the suite's mean, by the rule, is largest.
std::size_t governing_period(const Results& results, const MeanQuestion& question,
                             const Condition& at, OrientationRule rule);

/// The suite's mean with the orientation chosen record by record: no choice gives less or more.
struct PerRecordBounds {
  double lowest = 0.0, highest = 0.0;
};
PerRecordBounds per_record_bounds(const Results& results, const MeanQuestion& question,
                                  const Condition& at, Periods periods);

/// All of that at one condition, or of the largest over the periods, as tables and the results file
/// give it.
struct SuiteMean {
  std::size_t suite = 0;
  Condition at;  ///< the condition, or that at the governing period
  OrientationRange range;
  PerRecordBounds bounds;
  double largest = 0.0;                ///< of all records and orientations
  std::vector<double> by_orientation;  ///< the mean with all records in the same
};
/// By (suite, place); of the largest over the periods at the place, where the rule has them.
std::vector<SuiteMean> suite_means(const Results& results, HistoryNumber number,
                                   const std::vector<Condition>& places, Periods periods,
                                   OrientationRule rule);
/// The conditions in which the array may slide: at every building period, or at the first where the
/// largest over the periods is taken.
std::vector<Condition> sliding_conditions(const ConditionGrid& grid, Periods periods);

/// Suite means of 10,000 draws in which each record has any of its orientations, equally likely
/// (and the roof falls along either axis), in rising order: what to compare a published number with
/// whose orientations are not stated.
std::vector<double> per_record_means(const Results& results, const MeanQuestion& question,
                                     const Condition& at, Periods periods);

/// Of sorted values: the share below a value, ties counting half.
double share_below(const std::vector<double>& sorted, double value);

/// The suite's mean with each record's stronger component (the larger integral of a^2) along the
/// slope, by its sign: as recorded, and reversed. Walters et al. (2012) call that conservative.
/// NaN where the study did not run these orientations.
struct StrongerAlong {
  double as_recorded = 0.0, reversed = 0.0;
};
StrongerAlong stronger_along(const Results& results, const MeanQuestion& question,
                             const Condition& at, Periods periods);

/// Shares of the study's isolated histories, all conditions: in which the array lifts off.
double uplift_share(const Results& results);

}  // namespace glissade
