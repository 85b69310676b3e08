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

/// What a number may be, both ends included; an end that is not asked for is absent.
struct Limits {
  std::optional<double> min, max;

  bool are_asked() const { return min || max; }
  bool admit(double value) const { return !(min && value < *min) && !(max && value > *max); }
};

/// What to do with a record that does not tell what a limit is on. Kept, those that tell no event
/// count as of one.
enum class UntoldMetadata { leaves_out, keeps };

/// Which records are looked for. Defaults: seven (Walters et al. 2012), of any earthquake and site.
struct SelectionCriteria {
  std::size_t count = 7;
  Limits magnitude, distance_km, vs30_mps;
  double max_scale = 4.0;                ///< largest factor on a record, > 0
  std::optional<std::size_t> per_event;  ///< at most so many of one earthquake
  UntoldMetadata untold = UntoldMetadata::leaves_out;
};

/// Table 2 of Walters et al. (2012): the limits of a level's suite, its magnitudes widened by the
/// half tenth they are rounded to. InputError for a level outside 0-4.
SelectionCriteria walters_criteria(int level, SiteGroup sites = SiteGroup::a_to_d);

enum class LeftOutFor {
  magnitude,
  distance,
  vs30,
  magnitude_untold,
  distance_untold,
  vs30_untold,
  event_untold,
  no_second_horizontal,
  no_motion
};
/// "magnitude outside the limits", "no magnitude told" ...
const char* to_string(LeftOutFor reason);

/// A record of the library that is not a candidate, with all reasons.
struct LeftOutRecord {
  std::size_t record = 0;  ///< place in the library
  std::vector<LeftOutFor> reasons;
};

struct SelectedRecord {
  std::size_t record = 0;  ///< place in the library
  double scale = 0.0;      ///< on its three components; four decimals
  double misfit = 0.0;     ///< root mean square of ln(scale x Sa / target) over the periods
};

/// The suite's average over the target at a period.
struct RatioAtPeriod {
  double ratio = 0.0;
  double period_s = 0.0;
};

struct RecordSelection {
  std::vector<SelectedRecord> records;  ///< smallest misfit first
  std::size_t candidates = 0;
  std::vector<LeftOutRecord> left_out;  ///< in the library's order
  RatioAtPeriod lowest, highest;        ///< of the selected records' average
  /// Below 1 where every record at max_scale still leaves the average below the target.
  bool reaches_target() const { return lowest.ratio >= 1.0 - 1e-9; }
};

/// Selects and scales records as Walters et al. (2012), 'Ground motion selection and scaling',
/// asks: within limits on magnitude, distance, V_S30 and factor, SRSS spectra close to the target,
/// their average nowhere below it, small factors. How the set is found is ours:
///
/// - Candidates are the records with two horizontals that keep the limits. `Motion::scale` is not
///   looked at.
/// - The factors of a set are those of scale_suite_to_target: each as close as a factor can bring
///   it, then one common factor until the average is nowhere below the target, none above
///   max_scale. A set that max_scale keeps below the target has all its records there.
/// - The better of two sets is the one whose average falls less far below the target; where
///   neither does, the one with the smaller mean over its records of
///   misfit^2 + 0.01 (ln max(scale, 1))^2: a factor of 4 counts like a misfit of 0.14.
/// - From the `count` records that are closest by themselves, single records are exchanged for the
///   better, the best exchange first, until none helps. So no one exchange betters the set; that
///   no other set does is not proved.
///
/// The result depends on the records only, not on the order of the library.
///
/// `target_sa_g` gives g, > 0, at each of `periods_s` (>= 0, one at least). Throws InputError where
/// criteria contradict themselves (`where` is the criterion: "count", "max_scale", "magnitude"...)
/// and where fewer candidates are left than asked for, told with the limits that left them out.
RecordSelection select_records(const Suite& library,
                               const std::function<double(double)>& target_sa_g,
                               const std::vector<double>& periods_s,
                               const SelectionCriteria& criteria);

}  // namespace glissade
