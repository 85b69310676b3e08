// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/conditions/condition_grid.hpp"

#include "glissade/core/contract.hpp"

namespace glissade {

Condition Condition::with(ConditionAxis axis, std::size_t place) const {
  Condition changed = *this;
  changed[axis] = place;
  return changed;
}

std::size_t ConditionGrid::size(ConditionAxis axis) const {
  switch (axis) {
    case ConditionAxis::listed:
      return listed.size();
    case ConditionAxis::support:
      return support.size();
    case ConditionAxis::vertical:
      return vertical.size();
    case ConditionAxis::response_modification:
      return response_modification.size();
    case ConditionAxis::mass:
      return mass_ratio.size();
    case ConditionAxis::slope:
      return slope_deg.size();
    case ConditionAxis::level:
      return level.size();
    case ConditionAxis::period:
      return period_s.size();
  }
  return 0;
}

std::size_t ConditionGrid::count() const {
  std::size_t count = 1;
  for (const ConditionAxis axis : condition_axes) count *= size(axis);
  return count;
}

std::size_t ConditionGrid::index(const Condition& position) const {
  std::size_t index = 0;
  for (const ConditionAxis axis : condition_axes) {
    GLISSADE_EXPECTS(position[axis] < size(axis));
    index = index * size(axis) + position[axis];
  }
  return index;
}

Condition ConditionGrid::position(std::size_t index) const {
  GLISSADE_EXPECTS(index < count());
  Condition position;
  for (std::size_t i = condition_axis_count; i > 0; --i) {
    const ConditionAxis axis = condition_axes[i - 1];
    position[axis] = index % size(axis);
    index /= size(axis);
  }
  return position;
}

std::vector<Condition> along(const ConditionGrid& grid, ConditionAxis axis,
                             const Condition& position) {
  std::vector<Condition> places;
  for (std::size_t i = 0; i < grid.size(axis); ++i) places.push_back(position.with(axis, i));
  return places;
}

std::vector<Condition> all_conditions(const ConditionGrid& grid) {
  std::vector<Condition> places;
  for (std::size_t i = 0; i < grid.count(); ++i) places.push_back(grid.position(i));
  return places;
}

std::vector<Condition> all_but(const ConditionGrid& grid, ConditionAxis axis) {
  std::vector<Condition> places = all_conditions(grid);
  std::erase_if(places, [&](const Condition& at) { return at[axis] != 0; });
  return places;
}

}  // namespace glissade
