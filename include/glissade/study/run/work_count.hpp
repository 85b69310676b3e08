// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace glissade {

/// What was computed, and what was not because a study does not need it. Histories at the levels
/// are integrated, below_yield, from_curve or beyond; those in search of capacities come on top.
struct WorkCount {
  std::uint64_t integrated = 0;   ///< histories at the levels, integrated
  std::uint64_t searched = 0;     ///< histories integrated in search of capacities
  std::uint64_t roofs = 0;        ///< roof motions made
  std::uint64_t below_yield = 0;  ///< histories not integrated: the roof's peak stays in the stick
                                  ///< range
  std::uint64_t from_curve =
      0;                      ///< points of a record's curve F(mu/lambda) that were computed before
  std::uint64_t beyond = 0;   ///< levels above the one that reaches the largest threshold
  std::uint64_t decided = 0;  ///< capacities that the levels give without a search
  std::uint64_t failed = 0;   ///< histories that did not converge

  bool operator==(const WorkCount&) const = default;
  WorkCount& operator+=(const WorkCount& other) {
    integrated += other.integrated;
    searched += other.searched;
    roofs += other.roofs;
    below_yield += other.below_yield;
    from_curve += other.from_curve;
    beyond += other.beyond;
    decided += other.decided;
    failed += other.failed;
    return *this;
  }
};

}  // namespace glissade
