// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "analysis/conditions/columns.hpp"
#include "analysis/conditions/view.hpp"

// What the figures that show suite means as lines share.
namespace glissade {

inline constexpr auto period_label = "Period of the building (s)";

/// All places of two axes, the others as shown.
Places places_of(const ConditionGrid& grid, ConditionAxis slow, ConditionAxis fast);

/// Lines over an axis, one for each of some conditions: the rows of a table of suite means that are
/// at the condition but for the axis. The median over the orientations, with the range from the
/// lowest to the highest of them.
View medians_over(const Results& results, ConditionAxis x, const Table& table,
                  const Places& members, const std::function<std::string(const Condition&)>& name);

/// The y axis of displacements in metres and inches, or of numbers without a unit.
struct MeansAxis {
  std::string label = "Mean displacement";
  ColumnKind kind = ColumnKind::length;
  bool from_zero = true;
};
/// Lines of medians with their ranges where these can be seen.
Panel means_panel(const Results& results, const std::vector<View>& views,
                  const std::string& x_label, const std::vector<Rule>& rules = {},
                  const MeansAxis& y = {});
/// Suite, and every condition that is the same all over: those of `shown`, the building's period
/// and the support vary.
std::string below_text(const Results& results, std::vector<ConditionAxis> shown = {});
/// For captions: what a displacement is.
std::string what_is_averaged(const Results& results);

}  // namespace glissade
