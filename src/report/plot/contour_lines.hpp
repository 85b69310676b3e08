// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace glissade {

struct PlanePoint {
  double x = 0.0, y = 0.0;
};
using Polyline = std::vector<PlanePoint>;

/// Values at the nodes of a rectangular grid.
struct GridValues {
  std::vector<double> x, y;  ///< two or more each, strictly increasing
  std::vector<double> z;     ///< by (y, x), x fastest
};

/// The lines along which z, linear in x and in y within a cell, equals `value`: straight within
/// each of 4 x 4 parts of the cell, exact on its sides. A cell with a corner that is not finite has
/// none. A closed line ends with the point it begins with.
std::vector<Polyline> contour_lines(const GridValues& grid, double value);

}  // namespace glissade
