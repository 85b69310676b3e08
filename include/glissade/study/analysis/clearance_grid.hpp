// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "glissade/study/cases/case.hpp"

// What a clearance study varies (Walters et al. 2012): its conditions, and how the ground's
// components are placed on the roof.
namespace glissade {

struct VerticalCondition {
  VerticalChoice use = VerticalChoice::if_available;
  double period_s = 0.0;  ///< 0: the roof goes up and down with the ground
  bool operator==(const VerticalCondition&) const = default;
};

/// The axes of the grid of conditions, the first varying slowest.
enum class ClearanceAxis {
  listed,  ///< every other quantity of which the study lists several values, together
  support,
  vertical,
  response_modification,
  mass,
  slope,
  level,
  period
};
inline constexpr std::size_t clearance_axis_count = 8;
inline constexpr std::array<ClearanceAxis, clearance_axis_count> clearance_axes = {
    ClearanceAxis::listed,   ClearanceAxis::support,
    ClearanceAxis::vertical, ClearanceAxis::response_modification,
    ClearanceAxis::mass,     ClearanceAxis::slope,
    ClearanceAxis::level,    ClearanceAxis::period};

/// A place on every axis.
class ClearancePosition {
 public:
  std::size_t& operator[](ClearanceAxis axis) { return at_[static_cast<std::size_t>(axis)]; }
  std::size_t operator[](ClearanceAxis axis) const { return at_[static_cast<std::size_t>(axis)]; }
  /// The same but for one axis.
  ClearancePosition with(ClearanceAxis axis, std::size_t place) const;

 private:
  std::array<std::size_t, clearance_axis_count> at_{};
};

/// Every combination of these is run. NaN: drawn, and not listed.
struct ClearanceGrid {
  std::vector<std::string> listed = {""};  ///< "friction.mu = 0.4, building.damping = 0.02"
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
  std::vector<double> period_s;  ///< of the building, along both axes; 0: rigid

  std::size_t size(ClearanceAxis axis) const;
  std::size_t count() const;  ///< of all combinations
  std::size_t index(const ClearancePosition& position) const;
  ClearancePosition position(std::size_t index) const;
};

/// Every place along one axis, the others where `position` has them.
std::vector<ClearancePosition> along(const ClearanceGrid& grid, ClearanceAxis axis,
                                     const ClearancePosition& position = {});
/// Every place on all axes but one, which stays at its first.
std::vector<ClearancePosition> all_but(const ClearanceGrid& grid, ClearanceAxis axis);

}  // namespace glissade
