// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "glissade/study/cases/case.hpp"

namespace glissade {

/// The values of a parameter that are probable, ends included; beyond them it is possible.
struct ProbableRange {
  const char *table, *key;
  double least, most;
  const char* reason;
};
std::span<const ProbableRange> probable_ranges();

/// What stands beside a result where a value is outside of its probable range: "vertical period 3 s
/// is above 1 s: ..."; "" of others, and of the usual value of a Case.
std::string improbable_value(const Parameter& parameter, double value);

/// Those of improbable_modes(), and of the damping that the modes have of their own.
std::vector<std::string> improbable_modes(std::span<const Mode> modes, bool has_own_damping);
/// That a shear building of so many storeys hardly has this first period, s; "" of others.
std::string improbable_storeys(std::size_t storeys, double period_s);

/// The first periods of a building along its axes, s, over all cases.
struct PeriodsByAxis {
  std::array<double, 2> shortest_s{std::numeric_limits<double>::infinity(),
                                   std::numeric_limits<double>::infinity()},
      longest_s{};
  void take(const Case& c);
};
/// Both, of a building, and its period along the second axis where that is another one.
std::vector<std::string> improbable_building(const BuildingModel& model,
                                             const PeriodsByAxis& periods, bool two_axes);

}  // namespace glissade
