// SPDX-License-Identifier: GPL-3.0-or-later
#include "block/slip_record/two_axis_extremes.hpp"

namespace glissade::block_detail {
namespace {

/// The largest sign * displacement along one axis, at most `reach` from the path's begin.
double largest_along(const Path& path, double Vector::*axis, double sign, double reach,
                     double so_far) {
  const double begin = sign * (path.begin.*axis);
  if (begin + reach <= so_far) return so_far;
  const double largest = std::max(so_far, sign * (path.end.*axis));
  // Beyond the ends only where the velocity changes sign, and so its coefficients do.
  const auto [slowest, fastest] = std::minmax({sign * (path.v[0].*axis), sign * (path.v[1].*axis),
                                               sign * (path.v[2].*axis), sign * (path.v[3].*axis)});
  if (slowest >= 0.0 || fastest <= 0.0) return largest;
  if (begin + path.length_s * fastest <= largest) return largest;
  double on_path = largest;
  raise_to_largest(path.displacement_points(), on_path, [&](Vector d) { return sign * (d.*axis); });
  return on_path;
}

}  // namespace

Vector Path::velocity(double t) const {
  const double u = 1.0 - t;
  return (u * u * u) * v[0] + (3.0 * u * u * t) * v[1] + (3.0 * u * t * t) * v[2] +
         (t * t * t) * v[3];
}

Vector Path::displacement(double t) const {
  const double u = 1.0 - t;
  const Vector c1 = v[0], c2 = c1 + v[1], c3 = c2 + v[2], c4 = c3 + v[3];
  return begin + (0.25 * length_s) * ((4.0 * u * u * u * t) * c1 + (6.0 * u * u * t * t) * c2 +
                                      (4.0 * u * t * t * t) * c3 + (t * t * t * t) * c4);
}

std::array<Vector, 5> Path::displacement_points() const {
  std::array<Vector, 5> points{begin, begin, begin, begin, end};
  Vector sum;
  for (std::size_t k = 0; k < 3; ++k) {
    sum = sum + v[k];
    points[k + 1] = begin + (0.25 * length_s) * sum;
  }
  return points;
}

double Path::path_length() const {
  const Vector middle = 0.125 * (v[0] + v[3] + 3.0 * (v[1] + v[2]));
  return length_s / 6.0 * (length(v[0]) + 4.0 * length(middle) + length(v[3]));
}

void set_peaks(const Extremes& extremes, SlipPeak& slip) {
  const Vector ahead = extremes.ahead(), back = extremes.back();
  slip.peak_displacement_m = extremes.displacement();
  slip.peak_by_axis = {std::max(ahead.s, back.s), std::max(ahead.y, back.y)};
  slip.peak_downslope_m = ahead.s;
  slip.peak_upslope_m = back.s;
}

void Extremes::at(Vector displacement) {
  displacement_ = std::max(displacement_, length(displacement));
  const Vector d = displacement;
  ahead_ = {std::max(ahead_.s, d.s), std::max(ahead_.y, d.y)};
  back_ = {std::max(back_.s, -d.s), std::max(back_.y, -d.y)};
}

void Extremes::along(const Path& path) {
  double fastest2 = 0.0;
  for (const Vector& v : path.v) fastest2 = std::max(fastest2, dot(v, v));
  const double fastest = std::sqrt(fastest2), reach = path.length_s * fastest;
  for (double Vector::*axis : {&Vector::s, &Vector::y}) {
    ahead_.*axis = largest_along(path, axis, 1.0, reach, ahead_.*axis);
    back_.*axis = largest_along(path, axis, -1.0, reach, back_.*axis);
  }
  const auto size = [](Vector of) { return length(of); };
  if (length(path.begin) + reach > displacement_)
    raise_to_largest(path.displacement_points(), displacement_, size);
  if (fastest > speed_) raise_to_largest(path.v, speed_, size);
}

}  // namespace glissade::block_detail
