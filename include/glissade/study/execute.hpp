// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glissade/study/plan.hpp"

namespace glissade {

/// What one work unit found, per run: [run][sample in unit][level or threshold].
struct UnitResult {
  std::uint64_t unit = 0;  ///< its index in Plan::units
  struct Run {
    std::vector<double> peak_displacement_m;  ///< sample-major, levels fastest
    std::vector<std::uint8_t> uplift;         ///< the same shape
    std::vector<double>
        capacity;  ///< sample-major, thresholds fastest; +inf not reached, 0 slides without shaking
  };
  std::vector<Run> runs;
  std::uint64_t integrated = 0;  ///< histories at the levels, integrated
  std::uint64_t searched = 0;    ///< histories run in search of capacities, on top
  std::uint64_t held = 0;  ///< histories not integrated: the roof's peak stays in the stick range
};

/// Runs one unit. A free function of the plan: no state, no clock, no files; any rank, any order.
UnitResult execute(const Plan& plan, std::size_t unit);

}  // namespace glissade
