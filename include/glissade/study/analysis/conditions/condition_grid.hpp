// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "glissade/study/cases/case.hpp"

// What a study varies, as Walters et al. (2012) present it: one axis for each quantity of theirs,
// one for all others.
namespace glissade {

struct VerticalCondition {
  VerticalChoice use = VerticalChoice::if_available;
  double period_s = 0.0;  ///< 0: the roof goes up and down with the ground
  bool operator==(const VerticalCondition&) const = default;
};

/// The axes of the grid of conditions, the first varying slowest.
enum class ConditionAxis {
  listed,  ///< every other quantity of which the study lists several values, together
  support,
  vertical,
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

/// Every combination of these is run. NaN: drawn, and not listed.
struct ConditionGrid {
  std::vector<std::string> listed = {""};  ///< "friction.mu = 0.4, building.damping = 0.02"
  std::vector<std::string> listed_but_friction = {""};  ///< where the friction is stated beside
  std::vector<ArraySupport> support = {ArraySupport::isolated};
  std::vector<VerticalCondition> vertical = {{}};
  /// R: the building yields at its elastic demand under the design spectrum over R; 0: it stays
  /// elastic.
  std::vector<double> response_modification = {0.0};
  std::vector<double> mass_ratio = {0.05};  ///< m/M, [0, 1]
  std::vector<double> slope_deg;            ///< [0, 45]
  std::vector<double> level = {2.0 / 3};
  std::string level_symbol;  ///< "S_DS"; empty: levels are fractions of the suite scaled to MCE
  std::string level_unit = "-";
  double dbe_level = 2.0 / 3;    ///< of `level`; 0: not known
  std::vector<double> period_s;  ///< of the building, along both axes; 0: rigid

  std::size_t size(ConditionAxis axis) const;
  std::size_t count() const;  ///< of all combinations
  std::size_t index(const Condition& position) const;
  Condition position(std::size_t index) const;
};

/// Every place along one axis, the others where `position` has them.
std::vector<Condition> along(const ConditionGrid& grid, ConditionAxis axis,
                             const Condition& position = {});
/// Every place, as index() numbers them.
std::vector<Condition> all_conditions(const ConditionGrid& grid);
/// Every place on all axes but one, which stays at its first.
std::vector<Condition> all_but(const ConditionGrid& grid, ConditionAxis axis);

}  // namespace glissade
