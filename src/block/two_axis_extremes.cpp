// SPDX-License-Identifier: GPL-3.0-or-later
#include "two_axis_extremes.hpp"

namespace glissade::block_detail {
namespace {

/// The largest value on a piece of a function with the given rate (or any multiple of it that is
/// not negative). A maximum is where the rate falls through zero; it is looked for between four
/// points, and its place to 1e-6 of the piece: the value is off by the square of that.
template <class Value, class Rate>
double largest_on_piece(const Value& value, const Rate& rate) {
  constexpr int parts = 4;
  double largest = std::max(value(0.0), value(1.0));
  double from = 0.0, rate_from = rate(0.0);
  for (int i = 1; i <= parts; ++i) {
    const double to = static_cast<double>(i) / parts, rate_to = rate(to);
    if (rate_from > 0.0 && rate_to < 0.0) {
      double low = from, high = to;
      for (int bisection = 0; bisection < 18; ++bisection) {
        const double middle = 0.5 * (low + high);
        (rate(middle) > 0.0 ? low : high) = middle;
      }
      largest = std::max(largest, value(low));
    }
    from = to;
    rate_from = rate_to;
  }
  return largest;
}

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
  return std::max(largest,
                  largest_on_piece([&](double t) { return sign * (path.displacement(t).*axis); },
                                   [&](double t) { return sign * (path.velocity(t).*axis); }));
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

double Path::path_length() const {
  const Vector middle = 0.125 * (v[0] + v[3] + 3.0 * (v[1] + v[2]));
  return length_s / 6.0 * (length(v[0]) + 4.0 * length(middle) + length(v[3]));
}

void tell_peaks(const Extremes& extremes, TwoAxisResult& result) {
  const Vector ahead = extremes.ahead(), back = extremes.back();
  result.peak_downslope_m = ahead.s;
  result.peak_upslope_m = back.s;
  result.peak_by_axis = {std::max(ahead.s, back.s), std::max(ahead.y, back.y)};
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
  if (length(path.begin) + reach > displacement_) {
    displacement_ = std::max(
        displacement_,
        largest_on_piece([&](double t) { return length(path.displacement(t)); },
                         [&](double t) { return dot(path.displacement(t), path.velocity(t)); }));
  }
  if (fastest > speed_) {
    const auto acceleration = [&](double t) {
      const double u = 1.0 - t;
      return (u * u) * (path.v[1] - path.v[0]) + (2.0 * u * t) * (path.v[2] - path.v[1]) +
             (t * t) * (path.v[3] - path.v[2]);
    };
    speed_ = std::max(
        speed_, largest_on_piece([&](double t) { return length(path.velocity(t)); },
                                 [&](double t) { return dot(path.velocity(t), acceleration(t)); }));
  }
}

}  // namespace glissade::block_detail
