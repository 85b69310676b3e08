// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "glissade/motion/motion.hpp"
#include "glissade/motion/walters_level.hpp"

namespace glissade {

/// Permitted range of a number, both limits included; a missing limit is no limit.
struct Limits {
  std::optional<double> min, max;

  bool are_given() const { return min || max; }
  bool admit(double value) const { return !(min && value < *min) && !(max && value > *max); }
};

/// Treatment of a record without a value that is limited. If kept, all records without an event
/// count as records of one event.
enum class MissingMetadata { leaves_out, keeps };

/// Selection criteria. Defaults: seven records (Walters et al. 2012), of any earthquake and site.
struct SelectionCriteria {
  std::size_t count = 7;
  Limits magnitude, distance_km, vs30_mps;
  double max_scale = 4.0;                ///< largest factor on a record, > 0
  std::optional<std::size_t> per_event;  ///< largest number of records of one earthquake
  MissingMetadata missing = MissingMetadata::leaves_out;
};

/// Table 2 of Walters et al. (2012): the limits of the suite of an Intensity Level, its magnitudes
/// widened by 0.05 since they are rounded to 0.1. InputError for a level outside 0-4.
SelectionCriteria walters_criteria(int level, SiteGroup sites = SiteGroup::a_to_d);

enum class LeftOutFor {
  magnitude,
  distance,
  vs30,
  magnitude_missing,
  distance_missing,
  vs30_missing,
  event_missing,
  no_second_horizontal,
  no_motion,
  factor  ///< of a selection at one period
};
/// "magnitude outside the limits", "no magnitude given" ...
const char* to_string(LeftOutFor reason);

/// A record of the library that is not a candidate, with all reasons.
struct LeftOutRecord {
  std::size_t record = 0;  ///< index in the library
  std::vector<LeftOutFor> reasons;
};

struct SelectedRecord {
  std::size_t record = 0;  ///< index in the library
  double scale = 0.0;      ///< on its three components; four decimals
  double misfit = 0.0;     ///< root mean square of ln(scale x Sa / target) over the periods
};

/// Average of the suite divided by the target, at a period.
struct RatioAtPeriod {
  double ratio = 0.0;
  double period_s = 0.0;
};

struct RecordSelection {
  std::vector<SelectedRecord> records;  ///< smallest misfit first
  std::size_t candidates = 0;
  std::vector<LeftOutRecord> left_out;  ///< in the order of the library
  RatioAtPeriod lowest, highest;        ///< of the average of the selected records
  /// Below 1 if the average is below the target with every record at max_scale.
  bool reaches_target() const { return lowest.ratio >= 1.0 - 1e-9; }
};

/// Selects and scales records by the criteria of Walters et al. (2012), 'Ground motion selection
/// and scaling': within limits on magnitude, distance, V_S30 and factor, SRSS spectra close to the
/// target, their average nowhere below it, small factors. The search is not published:
///
/// - Candidates are the records with two horizontals within the limits. `Motion::scale` is ignored.
/// - The factors of a set are those of scale_suite_to_target: each record as close to the target as
///   possible, then one common factor until the average is nowhere below the target, none above
///   max_scale. A set whose average stays below the target has all its records at max_scale.
/// - The better of two sets is the one whose average is less far below the target; if neither is
///   below it, the one with the smaller mean over its records of
///   misfit^2 + 0.01 (ln max(scale, 1))^2: a factor of 4 has the weight of a misfit of 0.14.
/// - The search starts from the `count` records that are closest individually, and makes the best
///   exchange of one record until none improves the set. That no other set is better is not proved.
///
/// The result depends on the records only, not on the order of the library.
///
/// `target_sa_g` gives g, > 0, at each of `periods_s` (>= 0, one at least). Throws InputError if
/// criteria contradict each other (`where` is the criterion: "count", "max_scale", "magnitude"...)
/// and if there are fewer candidates than required, with the limits that excluded the others.
RecordSelection select_records(const Suite& library,
                               const std::function<double(double)>& target_sa_g,
                               const std::vector<double>& periods_s,
                               const SelectionCriteria& criteria);

}  // namespace glissade
