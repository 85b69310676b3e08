// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "glissade/core/independent_units.hpp"
#include "glissade/core/paged_memory.hpp"
#include "glissade/fragility/share.hpp"

namespace glissade {

struct StudyConfig;

/// Values of all histories, or of those of a unit: HistoryAssembly stores them in pages.
template <class T>
using HistoryValues = std::vector<T, PagedAllocator<T>>;

/// What is kept of histories: for each (record, case) as many values as `Depth` says. A field that
/// the study does not need is empty. Displacements are in plan.
struct HistoryFields {
  HistoryValues<double> peak_displacement_m;
  HistoryValues<double> peak_vector_m;
  HistoryValues<double> peak_along_m, peak_across_m, residual_along_m, residual_across_m;
  HistoryValues<double> closing_along_m, closing_across_m;
  HistoryValues<double> shear_along, shear_across;
  HistoryValues<std::uint8_t> uplift, tips, failed;
  HistoryValues<double> capacity;
  HistoryValues<std::uint8_t> search_failed;
  HistoryValues<double> crossing_time_s, crossing_speed_mps;
};

/// How many values of a field there are for a record and case: one a level, one a threshold, or one
/// a level and threshold (the latter fastest).
enum class Depth { levels, thresholds, levels_and_thresholds };

/// Which fields a study keeps, beside those that every study has.
struct KeptFields {
  bool two_axes = false, by_axis = false, closing = false, base_shear = false, tips = false,
       crossings = false, capacities = true;
  explicit KeptFields(const StudyConfig& config);
  bool has(const auto& field) const { return field.kept_with == nullptr || this->*field.kept_with; }
};

/// A field of HistoryFields.
template <class T>
struct HistoryField {
  using Values = HistoryValues<T>;
  const char* name;
  const char* unit;  ///< empty: that of the intensity measure
  const char* description;
  Depth depth;
  Values HistoryFields::*of;
  bool KeptFields::*kept_with = nullptr;  ///< null: always kept
};

/// Every field, in order: messages, assembly and the results file go through this list.
template <class Visit>
void for_each_history_field(Visit visit) {
  using Number = HistoryField<double>;
  using Flag = HistoryField<std::uint8_t>;
  visit(Number{"peak_displacement_m", "m",
               "peak displacement in plan; inf: beyond the largest threshold and not run "
               "(stop_at_largest), or not converged",
               Depth::levels, &HistoryFields::peak_displacement_m});
  visit(Number{"peak_vector_m", "m", "two axes: longest displacement vector in plan", Depth::levels,
               &HistoryFields::peak_vector_m, &KeptFields::two_axes});
  visit(Number{"peak_along_m", "m", "two axes: largest |displacement| along the slope",
               Depth::levels, &HistoryFields::peak_along_m, &KeptFields::by_axis});
  visit(Number{"peak_across_m", "m", "two axes: largest |displacement| across the slope",
               Depth::levels, &HistoryFields::peak_across_m, &KeptFields::by_axis});
  visit(Number{"residual_along_m", "m", "two axes: where it comes to rest, positive down the slope",
               Depth::levels, &HistoryFields::residual_along_m, &KeptFields::two_axes});
  visit(Number{"residual_across_m", "m", "two axes: the same across the slope", Depth::levels,
               &HistoryFields::residual_across_m, &KeptFields::two_axes});
  visit(Number{"closing_along_m", "m",
               "by how much the gap to a neighbour below, or across a valley, closes at most, in "
               "plan; inf: not converged",
               Depth::levels, &HistoryFields::closing_along_m, &KeptFields::closing});
  visit(Number{"closing_across_m", "m", "the same of a neighbour across the slope", Depth::levels,
               &HistoryFields::closing_across_m, &KeptFields::closing});
  visit(Number{"shear_along", "-",
               "peak base shear along the building's first axis, over the building's weight "
               "without the array",
               Depth::levels, &HistoryFields::shear_along, &KeptFields::base_shear});
  visit(Number{"shear_across", "-", "the same along its second axis", Depth::levels,
               &HistoryFields::shear_across, &KeptFields::base_shear});
  visit(Flag{"uplift", "-", "1 where the array lifts off", Depth::levels, &HistoryFields::uplift});
  visit(Flag{"tips", "-", "1 where the body begins to tip", Depth::levels, &HistoryFields::tips,
             &KeptFields::tips});
  visit(Flag{"failed", "-", "1 where the history did not converge", Depth::levels,
             &HistoryFields::failed});
  visit(Number{"capacity", "",
               "lowest intensity that reaches the threshold; inf: not reached; 0: slides freely",
               Depth::thresholds, &HistoryFields::capacity, &KeptFields::capacities});
  visit(Flag{"search_failed", "-",
             "1 where a history in search of the capacity did not converge: it counts as one that "
             "reaches the threshold",
             Depth::thresholds, &HistoryFields::search_failed, &KeptFields::capacities});
  visit(Number{
      "crossing_time_s", "s",
      "time of the first crossing of the threshold from the record's begin; nan: not reached",
      Depth::levels_and_thresholds, &HistoryFields::crossing_time_s, &KeptFields::crossings});
  visit(Number{
      "crossing_speed_mps", "m/s", "speed then, in plan and relative to the roof; nan: not reached",
      Depth::levels_and_thresholds, &HistoryFields::crossing_speed_mps, &KeptFields::crossings});
}

/// By record: the number of its event, from 0 by their first records, by name without case and
/// blanks. A record that states none is an event of its own. Empty where no record states one.
std::vector<std::size_t> event_units(const std::vector<std::string>& events);

/// Histories by (record, case).
struct HistoryTable {
  std::size_t records = 0, cases = 0, levels = 0, thresholds = 0;  ///< levels of each record
  HistoryFields fields;
  /// Of multiple stripes: by record, the one level that it has. Else empty: each has all levels.
  std::vector<std::size_t> stripe_of = {};
  /// By record: its independent unit, as event_units() numbers events. Empty: each record is one.
  std::vector<std::size_t> unit_of = {};

  std::size_t unit(std::size_t record) const { return unit_at(unit_of, record); }
  std::size_t units() const { return unit_count(unit_of, records); }
  /// A number of each record, by the units of the intervals.
  UnitValues by_unit(const std::vector<double>& of_record) const {
    return unit_of.empty() ? UnitValues(of_record) : UnitValues(of_record, unit_of);
  }
  /// How often each record counts in a resample of the units.
  std::vector<double> record_weights(const std::vector<double>& of_units) const {
    std::vector<double> weights;
    for (std::size_t record = 0; record < records; ++record)
      weights.push_back(of_units[unit(record)]);
    return weights;
  }

  bool has(std::size_t record, std::size_t level) const {
    return stripe_of.empty() || stripe_of[record] == level;
  }
  std::size_t records_at(std::size_t level) const {
    if (stripe_of.empty()) return records;
    return static_cast<std::size_t>(std::ranges::count(stripe_of, level));
  }

  std::size_t depth(Depth depth) const {
    if (depth == Depth::levels) return levels;
    return depth == Depth::thresholds ? thresholds : levels * thresholds;
  }
  std::size_t at(std::size_t record, std::size_t c, std::size_t level) const {
    return (record * cases + c) * levels + (stripe_of.empty() ? level : 0);
  }
  double displacement_m(std::size_t record, std::size_t c, std::size_t level) const {
    return fields.peak_displacement_m[at(record, c, level)];
  }
  double capacity(std::size_t record, std::size_t c, std::size_t threshold) const {
    return fields.capacity[(record * cases + c) * thresholds + threshold];
  }
};

/// The histories of some cases in a row.
struct CaseSlice {
  std::size_t first = 0, count = 0;
};

/// Mean of a field over the histories of some cases at a level; NaN where the field is not kept. Of
/// flags: the share that is set.
template <class T>
double mean_of(const HistoryTable& histories, const HistoryValues<T>& field, CaseSlice cases,
               std::size_t level) {
  if (field.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0.0;
  for (std::size_t record = 0; record < histories.records; ++record) {
    for (std::size_t i = 0; histories.has(record, level) && i < cases.count; ++i)
      sum += field[histories.at(record, cases.first + i, level)];
  }
  return sum / static_cast<double>(histories.records_at(level) * cases.count);
}

/// Values of a field for each record and case.
std::size_t depth_of(const StudyConfig& config, Depth depth);

/// Bytes of the table that a study keeps.
double bytes_of(const StudyConfig& config, std::size_t records, std::size_t cases);

}  // namespace glissade
