// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace glissade::block_detail {

/// A vector in the roof's plane: s where the surface falls, y across.
struct Vector {
  double s = 0.0, y = 0.0;
};

inline Vector operator+(Vector a, Vector b) { return {a.s + b.s, a.y + b.y}; }
inline Vector operator-(Vector a, Vector b) { return {a.s - b.s, a.y - b.y}; }
inline Vector operator*(double c, Vector a) { return {c * a.s, c * a.y}; }
inline Vector scaled(Vector a, Vector by) { return {a.s * by.s, a.y * by.y}; }
inline double dot(Vector a, Vector b) { return a.s * b.s + a.y * b.y; }
inline double cross(Vector a, Vector b) { return a.s * b.y - a.y * b.s; }
inline double length(Vector a) { return std::sqrt(dot(a, a)); }

}  // namespace glissade::block_detail
