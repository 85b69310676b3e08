// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "glissade/study/plan/plan.hpp"
#include "glissade/study/run/history_table.hpp"
#include "glissade/study/run/roof_store.hpp"
#include "glissade/study/run/work_count.hpp"

namespace glissade {

/// What one work unit found, by the unit's cases in their order.
struct UnitResult {
  std::uint64_t unit = 0;  ///< its index in Plan::units
  HistoryFields fields;
  WorkCount count;
};

/// Runs one unit. What it finds is a free function of the plan and the unit: no clock, no files;
/// any rank, any order. `roofs` only remembers.
UnitResult execute(const Plan& plan, std::size_t unit, RoofStore& roofs);

/// The same by itself.
UnitResult execute(const Plan& plan, std::size_t unit, Skipping skipping = Skipping::all);

}  // namespace glissade
