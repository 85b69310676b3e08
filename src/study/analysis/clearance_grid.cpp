// SPDX-License-Identifier: GPL-3.0-or-later
#include "glissade/study/analysis/clearance_grid.hpp"

#include "glissade/core/contract.hpp"

namespace glissade {

ClearancePosition ClearancePosition::with(ClearanceAxis axis, std::size_t place) const {
  ClearancePosition changed = *this;
  changed[axis] = place;
  return changed;
}

std::size_t ClearanceGrid::size(ClearanceAxis axis) const {
  switch (axis) {
    case ClearanceAxis::listed:
      return listed.size();
    case ClearanceAxis::support:
      return support.size();
    case ClearanceAxis::vertical:
      return vertical.size();
    case ClearanceAxis::response_modification:
      return response_modification.size();
    case ClearanceAxis::mass:
      return mass_ratio.size();
    case ClearanceAxis::slope:
      return slope_deg.size();
    case ClearanceAxis::level:
      return level.size();
    case ClearanceAxis::period:
      return period_s.size();
  }
  return 0;
}

std::size_t ClearanceGrid::count() const {
  std::size_t count = 1;
  for (const ClearanceAxis axis : clearance_axes) count *= size(axis);
  return count;
}

std::size_t ClearanceGrid::index(const ClearancePosition& position) const {
  std::size_t index = 0;
  for (const ClearanceAxis axis : clearance_axes) {
    GLISSADE_EXPECTS(position[axis] < size(axis));
    index = index * size(axis) + position[axis];
  }
  return index;
}

ClearancePosition ClearanceGrid::position(std::size_t index) const {
  GLISSADE_EXPECTS(index < count());
  ClearancePosition position;
  for (std::size_t i = clearance_axis_count; i > 0; --i) {
    const ClearanceAxis axis = clearance_axes[i - 1];
    position[axis] = index % size(axis);
    index /= size(axis);
  }
  return position;
}

std::vector<ClearancePosition> along(const ClearanceGrid& grid, ClearanceAxis axis,
                                     const ClearancePosition& position) {
  std::vector<ClearancePosition> places;
  for (std::size_t i = 0; i < grid.size(axis); ++i) places.push_back(position.with(axis, i));
  return places;
}

std::vector<ClearancePosition> all_but(const ClearanceGrid& grid, ClearanceAxis axis) {
  std::vector<ClearancePosition> places;
  for (std::size_t i = 0; i < grid.count(); ++i) {
    const ClearancePosition position = grid.position(i);
    if (position[axis] == 0) places.push_back(position);
  }
  return places;
}

}  // namespace glissade
