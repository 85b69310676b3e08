// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "glissade/study/cases/case_set.hpp"
#include "glissade/study/run/history_table.hpp"

// The cases and histories of results by condition, as required clearance and base shear are read
// from them: one axis for each quantity of Walters et al. (2012), one for all others.
namespace glissade {

struct Results;

/// The axes of the grid of conditions, the first varying slowest.
enum class ConditionAxis {
  listed,  ///< every other quantity of which the study lists several values, together
  support,
  vertical,  ///< whether it acts, and where it does the roof's vertical period
  response_modification,
  mass,
  slope,
  level,
  period
};
inline constexpr std::size_t condition_axis_count = 8;
inline constexpr std::array<ConditionAxis, condition_axis_count> condition_axes = {
    ConditionAxis::listed,   ConditionAxis::support,
    ConditionAxis::vertical, ConditionAxis::response_modification,
    ConditionAxis::mass,     ConditionAxis::slope,
    ConditionAxis::level,    ConditionAxis::period};
/// The quantity of an axis; null of choices, levels and several quantities together.
const Parameter* parameter_of(ConditionAxis axis);

/// A place on every axis.
class Condition {
 public:
  std::size_t& operator[](ConditionAxis axis) { return at_[static_cast<std::size_t>(axis)]; }
  std::size_t operator[](ConditionAxis axis) const { return at_[static_cast<std::size_t>(axis)]; }
  /// The same but for one axis.
  Condition with(ConditionAxis axis, std::size_t place) const;

 private:
  std::array<std::size_t, condition_axis_count> at_{};
};

/// The histories of a record in one orientation at a condition: of a number of theirs the mean over
/// the samples.
struct ConditionHistory {
  const Results& results;
  std::size_t record, first_case, level;  ///< the case is of the first sample

  double mean(HistoryValues<double> HistoryFields::*field) const;  ///< NaN where it is not kept
  double displacement_m() const;  ///< by the study's measure; infinite: it slides freely
  double peak_m() const;          ///< largest length of the displacement, likewise
  /// SRSS of the peaks along both axes, as displacements are taken.
  double base_shear() const;
  bool lifts_off() const;  ///< of any sample
};

/// What the cases and levels of results are as a grid; every combination of places is run. Of
/// friction that is drawn the design value counts (mean - 2 std) where the study has it.
class ConditionGrid {
 public:
  explicit ConditionGrid(const Results& results);
  explicit ConditionGrid(const Results&& temporary) = delete;

  const Results& results() const { return results_; }
  std::size_t size(ConditionAxis axis) const { return steps(axis).size(); }
  bool has_several(ConditionAxis axis) const { return size(axis) > 1; }
  std::size_t count() const;                ///< of all combinations
  Condition position(std::size_t i) const;  ///< of these
  /// The first of its cases, which are in a row.
  std::size_t first_case(const Condition& at) const;
  const Case& case_at(const Condition& at) const;
  /// The level, or the value of the axis's quantity; NaN where that is drawn.
  double value(ConditionAxis axis, std::size_t place) const;
  double value(ConditionAxis axis, const Condition& at) const { return value(axis, at[axis]); }
  /// Of the axis `listed`: "friction 0.4, building damping 0.02", without one key.
  std::string listed_text(std::size_t place, const std::string& without = "") const;
  ConditionHistory history(std::size_t record, std::size_t orientation, const Condition& at) const;

 private:
  using Steps = std::vector<std::size_t>;
  Steps& steps(ConditionAxis axis) { return steps_[static_cast<std::size_t>(axis)]; }
  const Steps& steps(ConditionAxis axis) const { return steps_[static_cast<std::size_t>(axis)]; }

  const Results& results_;
  std::size_t first_ = 0;  ///< combination of the cases at the first place on every axis
  /// By axis, then place: what it adds to the number of that combination.
  std::array<Steps, condition_axis_count> steps_;
};

/// Every place along one axis, the others where `position` has them.
std::vector<Condition> along(const ConditionGrid& grid, ConditionAxis axis,
                             const Condition& position = {});
std::vector<Condition> all_conditions(const ConditionGrid& grid);
/// Every place on all axes but one, which stays at its first.
std::vector<Condition> all_but(const ConditionGrid& grid, ConditionAxis axis);

/// One of the orientations of the records.
const Orientation& orientation_at(const Results& results, std::size_t i);
/// By orientation: the first whose histories are the same.
std::vector<CaseNumber> same_orientations(const Results& results);

}  // namespace glissade
