// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "glissade/study/plan.hpp"
#include "glissade/study/roof_store.hpp"
#include "glissade/study/work_count.hpp"

namespace glissade {

/// What one work unit found, per run: [run][sample in unit][level or threshold].
struct UnitResult {
  std::uint64_t unit = 0;  ///< its index in Plan::units
  struct Run {
    std::vector<double> peak_displacement_m;  ///< sample-major, levels fastest; +inf: beyond the
                                              ///< largest threshold, not asked
    std::vector<double> peak_vector_m;        ///< the same shape; two axes only
    std::vector<std::uint8_t> uplift;         ///< the same shape
    std::vector<std::uint8_t> tips;           ///< the same shape; empty where it is not asked for
    std::vector<double>
        capacity;  ///< sample-major, thresholds fastest; +inf not reached, 0 slides without shaking
    /// First crossings by sample, level and threshold, the latter fastest; NaN: none. Empty where
    /// they are not asked for.
    std::vector<double> crossing_time_s, crossing_speed_mps;
  };
  std::vector<Run> runs;
  WorkCount count;
};

/// Runs one unit. What it finds is a free function of the plan and the unit: no clock, no files;
/// any rank, any order. `roofs` only remembers.
UnitResult execute(const Plan& plan, std::size_t unit, RoofStore& roofs);

/// The same by itself.
UnitResult execute(const Plan& plan, std::size_t unit, Skipping skipping = Skipping::all);

}  // namespace glissade
