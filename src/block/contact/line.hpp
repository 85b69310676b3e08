// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

namespace glissade::block_detail {

/// The time, or fraction of a piece, of an event that is not in it.
constexpr double never = std::numeric_limits<double>::infinity();

/// A function linear in time over what is left of a piece of a sample interval.
struct Line {
  double value = 0.0, rate = 0.0;
  double end = 0.0;  ///< at the piece's end, exactly
  double at(double t) const { return value + rate * t; }
};

/// When a speed u0 >= 0 under the acceleration `drive` first returns to zero within `length`, or
/// never: the smaller positive root of u0 + value t + rate t^2 / 2, where the speed is falling.
inline double time_to_stop(double u0, const Line& drive, double length) {
  const double n = drive.value, k = drive.rate;
  const double discriminant = n * n - 2.0 * k * u0;
  const bool turns_inside =
      k > 0.0 && n < 0.0 && -n < k * length;  // the speed has its minimum inside
  if (turns_inside ? discriminant <= 0.0 : u0 + length * (n + 0.5 * k * length) > 0.0) return never;
  if (n >= 0.0 && k >= 0.0) return never;  // does not slow down
  if (u0 == 0.0 && n <= 0.0) return 0.0;   // it was about to start, and sticks after all
  const double root = std::sqrt(std::max(discriminant, 0.0));
  const double t =
      n <= 0.0 ? 2.0 * u0 / (root - n) : (root + n) / -k;  // the form without cancellation
  return std::min(t, length);
}

}  // namespace glissade::block_detail
