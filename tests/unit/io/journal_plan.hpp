// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "glissade/io/journal.hpp"

namespace glissade::test {

/// A plan of three units of one or two cases, two levels and a threshold; only what a journal
/// needs.
inline Plan journal_plan() {
  Plan plan;
  plan.config.file = "study.toml";
  plan.config.source_text = "[study]\nname = \"a\"\nseed = 1\n";
  plan.config.intensity.levels = {1.0, 2.0};
  plan.config.model.axes = SlidingAxes::one;
  plan.config.fragility = FragilityConfig{.thresholds_m = {0.1}};
  plan.units = {{0, 0, 2}, {0, 2, 1}, {1, 0, 2}};
  plan.hash = "0123456789abcdef";
  return plan;
}

/// A result that fits a unit of the plan, its numbers different from those of the others.
inline UnitResult journal_unit(const Plan& plan, std::uint64_t unit) {
  UnitResult result{.unit = unit, .fields = {}, .count = {.integrated = 10 + unit}};
  const std::size_t cases = plan.units[unit].count;
  for (std::size_t i = 0; i < 2 * cases; ++i)
    result.fields.peak_displacement_m.push_back(0.1 * static_cast<double>(i + 10 * unit));
  result.fields.uplift.assign(2 * cases, 0);
  result.fields.failed.assign(2 * cases, 1);
  result.fields.capacity.assign(cases, 0.7);
  result.fields.search_failed.assign(cases, 0);
  return result;
}

}  // namespace glissade::test
